#pragma once

#include "app/model/plot_list.h"
#include "app/model/run_sampler.h"

#include <QObject>
#include <QSaveFile>
#include <QTimer>

#include <memory>

namespace app {

/// What a table of numbers holds: a column for the frame, one for each quantity, and the same quantities of the run as it
/// was before, if there is one.
struct NumberSheet
{
    std::vector<Quantity> quantities; ///< they name their bodies
    QStringList titles;               ///< a quantity each, with its unit
    sim::Script run;
    std::int64_t frames = 0; ///< the last one
    std::optional<sim::Script> old;
    std::int64_t oldFrames = 0;
    QString oldName; ///< "before: k 0.2"
};

/// Writes a sheet as a CSV file: 17 significant digits, every row. The run is computed anew for it, in slices of a few
/// milliseconds, as a plot need not keep every row. Nothing is in the file's place before all of it is written.
class NumberTable : public QObject
{
    Q_OBJECT

public:
    /// Begins to write; a short run is done at once. One signal tells the end, later than this returns.
    NumberTable(NumberSheet sheet, const QString &path, QObject *parent = nullptr);

    /// From 0 to 1.
    double done() const;
    /// Leaves it off: the file stays as it was before.
    void cancel();

signals:
    void progressed();
    void written(const QString &path);
    /// One sentence: why, and what helps.
    void failed(const QString &sentence);
    void cancelled();

private:
    /// One run on its way through its rows.
    struct Way
    {
        explicit Way(const sim::Script &script, std::int64_t frames);
        /// Goes on to the row at `frame`. Returns whether the run gets there.
        bool goTo(std::int64_t frame);
        void read(const std::vector<Quantity> &quantities, std::span<double> into);

        sim::Track track;
        std::int64_t frames;
        QuantityReader reader;
        std::optional<sim::State> before;
        bool isOver = false;
    };

    void writeTitles();
    void writeSlice();
    void writeRow();
    void append(Way &way);
    void end();

    NumberSheet m_sheet;
    QSaveFile m_file;
    QTimer m_later;
    std::unique_ptr<Way> m_run;
    std::unique_ptr<Way> m_old;
    QByteArray m_text; ///< what is not written to the file yet
    std::int64_t m_frame = 0;
    std::int64_t m_last = 0;
};

}
