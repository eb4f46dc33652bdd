#pragma once

#include "sim/run/track.h"

#include <QDateTime>
#include <QString>

#include <memory>
#include <optional>

class QSettings;

namespace app {

/// What shows that a learner did something: the run that earned a tick, or the code that she wrote.
struct Proof
{
    QString run = {};      ///< an experiment in one line, see experiment_line.h; empty: none is needed
    sim::Cursor at = {};   ///< the moment of the run
    QString beside = {};   ///< the comparison run at that moment, likewise; empty: there was none
    std::int64_t fork = 0; ///< the first frame at which the two runs differ
    QString code = {};     ///< the text of a listing; empty: none is needed
    QDateTime when = {};   ///< UTC
    friend bool operator==(const Proof &, const Proof &) = default;
};

/// The proofs of the learner's ticks, the latest for each. They are kept between starts of the program, in a file of their
/// own beside the settings. Nothing is read before it is needed.
class Proofs
{
public:
    /// A proof with more characters is not kept.
    static constexpr qsizetype longest = 256 << 10;

    Proofs();
    ~Proofs();

    bool has(const QString &key) const;
    std::optional<Proof> find(const QString &key) const;
    /// Keeps `proof` in place of an earlier one, unless it is too long. Without a time, it gets the present one. The keys
    /// are those of Notes: "lesson/step/try:id", "lesson/step/code:id", "lesson/project/code:level", "lesson/recall:id".
    void keep(const QString &key, Proof proof);

private:
    QSettings &settings() const;

    mutable std::unique_ptr<QSettings> m_settings;
};

}
