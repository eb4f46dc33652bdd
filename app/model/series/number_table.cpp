#include "app/model/series/number_table.h"

#include "app/model/text/csv.h"
#include "app/model/text/phrases.h"
#include "app/model/text/quoting.h"
#include "sim/base/error.h"

#include <QElapsedTimer>
#include <QFileInfo>

#include <cmath>

namespace app {

namespace {

constexpr qint64 tableSlice = 8;
constexpr std::size_t tableMemory = std::size_t{1} << 20; ///< bytes for keyframes: the run never goes back
constexpr qsizetype mostText = qsizetype{1} << 18;        ///< bytes that wait to be written

}

NumberTable::SteppedRun::SteppedRun(const sim::Script &script, std::int64_t last)
    : track(script, tableMemory), frames(last)
{
}

bool NumberTable::SteppedRun::goTo(std::int64_t frame)
{
    if (isOver || frame > frames)
        return false;
    if (frame > 0)
        before = track.state();
    track.seek({frame, 0});
    isOver = track.cursor().frame != frame;
    return !isOver;
}

void NumberTable::SteppedRun::read(const std::vector<Quantity> &quantities, std::span<double> into)
{
    if (reader.segment() != &track.interval())
        reader = QuantityReader(quantities, track.intervalPtr());
    reader.read({track.state(), before ? &*before : nullptr, static_cast<double>(track.framesPerOutput())},
                into);
}

NumberTable::NumberTable(NumberSheet sheet, const QString &path, QObject *parent)
    : QObject(parent), m_sheet(std::move(sheet)), m_file(path)
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(0);
    connect(&m_timer, &QTimer::timeout, this, &NumberTable::writeSlice);
    m_run = std::make_unique<SteppedRun>(m_sheet.run, m_sheet.frames);
    if (m_sheet.comparison && m_sheet.comparison->step.framesPerOutput == m_sheet.run.step.framesPerOutput)
        m_comparison = std::make_unique<SteppedRun>(*m_sheet.comparison, m_sheet.comparisonFrames);
    m_last = std::max(m_sheet.frames, m_comparison ? m_sheet.comparisonFrames : 0);
    writeTitles();
    m_timer.start();
}

double NumberTable::done() const
{
    return m_last > 0 ? std::min(1.0, static_cast<double>(m_frame) / static_cast<double>(m_last)) : 1.0;
}

void NumberTable::cancel()
{
    m_timer.stop();
    m_file.cancelWriting();
    emit cancelled();
}

void NumberTable::writeTitles()
{
    m_text += quotedField(frameHeading());
    for (const QString &title : m_sheet.titles)
        m_text += ',' + quotedField(title);
    if (m_comparison) {
        for (const QString &title : m_sheet.titles)
            m_text += ',' + quotedField(listed(title, m_sheet.comparisonName));
    }
    m_text += '\n';
}

void NumberTable::writeSlice()
{
    if (!m_file.isOpen() && !m_file.open(QIODevice::WriteOnly)) {
        end();
        return;
    }
    QElapsedTimer clock;
    clock.start();
    while (m_frame <= m_last && clock.elapsed() < tableSlice)
        writeRow();
    if (m_frame > m_last || m_text.size() >= mostText) {
        m_file.write(m_text);
        m_text.clear();
    }
    if (m_frame > m_last) {
        end();
        return;
    }
    emit progressed();
    m_timer.start();
}

void NumberTable::writeRow()
{
    m_text += QByteArray::number(static_cast<qlonglong>(m_frame));
    append(*m_run);
    if (m_comparison)
        append(*m_comparison);
    m_text += '\n';
    m_frame += m_run->track.framesPerOutput();
}

void NumberTable::append(SteppedRun &run)
{
    std::vector<double> row(m_sheet.quantities.size(), std::nan(""));
    if (run.goTo(m_frame))
        run.read(m_sheet.quantities, row);
    for (const double value : row)
        appendField(m_text, value);
}

void NumberTable::end()
{
    const QString path = m_file.fileName();
    if (m_file.isOpen() && m_file.commit())
        emit written(path);
    else
        emit failed(
            tr("Could not save the numbers as %1: %2. Choose another folder, or free some disk space.")
                .arg(quoted(QFileInfo(path).fileName()), oneLine(m_file.errorString())));
}

}
