#pragma once

#include "app/model/series/plot_list.h"
#include "app/model/series/run_sampler.h"

#include <QObject>
#include <QSaveFile>
#include <QTimer>

#include <memory>

namespace app {

/// The contents of a number table: a column for the frame and one per quantity. If there is a comparison run, its
/// quantities follow in further columns.
struct NumberSheet
{
    std::vector<Quantity> quantities; ///< each names its bodies
    QStringList titles;               ///< one per quantity, with its unit
    sim::Script run;
    std::int64_t frames = 0; ///< the last frame
    std::optional<sim::Script> comparison;
    std::int64_t comparisonFrames = 0;
    QString comparisonName; ///< "before: k 0.2"
};

/// Writes a sheet as a CSV file with 17 significant digits and every output step. A plot may not store every output
/// step, so the run is computed again, in slices of a few milliseconds. The file is replaced only after everything has
/// been written.
class NumberTable : public QObject
{
    Q_OBJECT

public:
    /// Starts to write. A short run is finished at once. One signal reports the end, always after the constructor has
    /// returned.
    NumberTable(NumberSheet sheet, const QString &path, QObject *parent = nullptr);

    /// Returns the progress, from 0 to 1.
    double done() const;
    /// Cancels the export: the old file stays as it was.
    void cancel();

signals:
    void progressed();
    void written(const QString &path);
    /// One sentence with the cause and the remedy.
    void failed(const QString &sentence);
    void cancelled();

private:
    /// Steps through the output steps of one run.
    struct SteppedRun
    {
        explicit SteppedRun(const sim::Script &script, std::int64_t frames);
        /// Advances to the output step at `frame`. Returns whether the run reaches it.
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
    void append(SteppedRun &run);
    void end();

    NumberSheet m_sheet;
    QSaveFile m_file;
    QTimer m_timer;
    std::unique_ptr<SteppedRun> m_run;
    std::unique_ptr<SteppedRun> m_comparison;
    QByteArray m_text; ///< text that is not written to the file yet
    std::int64_t m_frame = 0;
    std::int64_t m_last = 0;
};

}
