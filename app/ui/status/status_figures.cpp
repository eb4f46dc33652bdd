#include "app/ui/status/status_figures.h"

#include "app/model/text/accuracy_text.h"
#include "app/model/text/numbers.h"
#include "app/model/text/phrases.h"
#include "sim/run/script/composed_interval.h"

#include <QHBoxLayout>
#include <QLabel>

namespace app {

namespace {

constexpr int numberGap = 18; ///< px between two numbers
constexpr int leftMargin = 8;
constexpr int rightMargin = 14;

}

StatusFigures::StatusFigures(const OpenRun &run, const Playback &playback, const AccuracyStudy &study,
                             QWidget *parent)
    : QWidget(parent), m_run(run), m_playback(playback), m_study(study)
{
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(leftMargin, 0, rightMargin, 0);
    row->setSpacing(numberGap);
    const QString tips[count] = {
        tr("How many points the scene has: each body, foot or joint is one"),
        tr("How often a frame computes all forces. The cost of a frame depends on this"),
        tr("The time to compute a frame of this scene on this machine (the median of many runs)"),
        tr("The largest distance of any body from the exact motion, over these frames"),
    };
    for (int i = 0; i < count; ++i) {
        m_labels[i] = new QLabel(this);
        m_labels[i]->setToolTip(tips[i]);
        m_labels[i]->hide();
        row->addWidget(m_labels[i]);
    }
    m_refreshTimer.setSingleShot(true);
    connect(&m_refreshTimer, &QTimer::timeout, this, &StatusFigures::refresh);
    run.onChange(ChangeKind::step | ChangeKind::playing, this, &StatusFigures::refresh);
    run.onChange(ChangeKind::run | ChangeKind::cursor, this, &StatusFigures::refreshSoon);
    connect(&study, &AccuracyStudy::changed, this, &StatusFigures::refresh);
    refresh();
}

QStringList StatusFigures::figures() const
{
    QStringList all;
    for (const QLabel *label : m_labels) {
        if (!label->isHidden())
            all << label->text();
    }
    return all;
}

void StatusFigures::refreshSoon()
{
    if (!m_playback.isPlaying() || !m_since.isValid() || m_since.hasExpired(refreshMilliseconds))
        refresh();
    else if (!m_refreshTimer.isActive())
        m_refreshTimer.start(refreshMilliseconds - static_cast<int>(m_since.elapsed()));
}

void StatusFigures::refresh()
{
    m_refreshTimer.stop();
    m_since.start();
    // A change of the number of points is seen at once, although it acts on the next frame.
    put(points, pointCount(m_run.timeline().track().nextInterval()->scene.start.pointCount()));
    put(work, workWords());
    const sim::AccuracyRow *row = m_study.inUse();
    const bool isTimed = row && row->nsPerFrame > 0.0;
    put(time, isTimed ? tr("%1 a frame").arg(duration(row->nsPerFrame)) : QString());
    const bool isMeasured = row && row->outcome == sim::Outcome::measured;
    put(error,
        isMeasured
            ? tr("error %1 over %2 frames").arg(pixels(row->error)).arg(m_study.accuracy()->framesCompared())
            : QString());
    showWhatFits();
}

QString StatusFigures::workWords() const
{
    const sim::Track &track = m_run.timeline().track();
    const sim::Script &script = track.script();
    const int each = script.method->evaluationsPerStep();
    if (each > 0) {
        const double times = double(each) * script.step.stepsPerOutput / script.step.framesPerOutput;
        return times == 1.0 ? tr("forces once a frame")
                            : tr("forces %1 times a frame").arg(roughNumber(times));
    }
    const std::int64_t frames = track.state().frame;
    if (frames <= 0 || track.state().pointEvaluations <= 0)
        return {};
    const double mean = track.state().forceEvaluations() / static_cast<double>(frames);
    return tr("forces %1 times a frame so far").arg(roughNumber(mean));
}

void StatusFigures::put(Figure figure, const QString &text)
{
    if (m_labels[figure]->text() != text)
        m_labels[figure]->setText(text);
}

void StatusFigures::setMost(int px)
{
    if (px == m_most)
        return;
    m_most = px;
    showWhatFits();
}

void StatusFigures::showWhatFits()
{
    int left = m_most - leftMargin - rightMargin + numberGap;
    for (int i = count - 1; i >= 0; --i) {
        QLabel &label = *m_labels[i];
        const bool isEmpty = label.text().isEmpty();
        if (!isEmpty)
            left -= numberGap + label.sizeHint().width();
        const bool isShown = !isEmpty && left >= 0;
        if (label.isHidden() == isShown)
            label.setVisible(isShown);
    }
}

}
