#pragma once

#include "app/model/session/session.h"

#include <QObject>

#include <map>
#include <tuple>
#include <vector>

namespace app {

/// A step of a lesson, by the ids of both.
struct StepName
{
    QString lesson;
    QString step;
    friend bool operator==(const StepName &, const StepName &) = default;
    friend bool operator<(const StepName &a, const StepName &b)
    {
        return std::tie(a.lesson, a.step) < std::tie(b.lesson, b.step);
    }
};

/// The experiment files of a session: the file of each step's run, and whether that run has changed since it was
/// saved.
class Document : public QObject
{
    Q_OBJECT

public:
    /// `session` must outlive this object.
    explicit Document(Session &session, QObject *parent = nullptr);

    /// The saved state of a step's run.
    struct Saved
    {
        QString path;       ///< empty if there is no file
        sim::Script script; ///< as in the file, or the step's own script
        Branches branches = {};
        std::optional<QString> draft = {}; ///< see Experiment::draft
    };
    /// Returns the saved state of every step that was open.
    const std::map<StepName, Saved> &saved() const { return m_saved; }
    /// Takes over the saved states of another window's document.
    void setSaved(std::map<StepName, Saved> saved);

    /// Returns the open step.
    StepName name() const;
    /// Returns the file of the open step's experiment, or an empty path if there is none.
    QString path() const { return pathOf(name()); }
    QString pathOf(const StepName &name) const;
    /// Returns whether the open step's run differs from its file. Without a file, it is compared with the step's
    /// own run.
    bool isChanged() const { return isChanged(name()); }
    bool isChanged(const StepName &name) const;
    /// Returns all steps that were open and whose runs have unsaved changes.
    std::vector<StepName> changed() const;
    /// Returns the run of a step that is or was open.
    std::optional<Experiment> experimentOf(const StepName &name) const;

    /// Opens a file.
    /// @throws UserError or sim::Error: it cannot be opened, and nothing has changed
    void open(const QString &path);
    /// Opens an experiment without a file.
    /// @throws sim::Error: it cannot be opened, and nothing has changed
    void open(const Experiment &experiment);
    /// Starts the step's own run again, without a file. This can be undone.
    void startNew();
    /// Writes the open run to `path`, which becomes its file.
    /// @throws UserError: it could not be written
    void save(const QString &path) { save(name(), path); }
    void save(const StepName &name, const QString &path);
    /// Marks the current run of a step as not needing to be saved.
    void giveUp(const StepName &name);

signals:
    /// Emitted when the file of the open step changes, or when its run becomes changed or unchanged.
    void stateChanged();

private:
    void follow();
    void keep(const QString &path);
    void announce();

    Session &m_session;
    std::map<StepName, Saved> m_saved;
    QString m_toldPath;
    bool m_toldChanged = false;
};

}
