#include "app/ui/time/footfall_strip.h"

#include "app/ui/time/timeline_strip.h"
#include "sim/run/script/composed_interval.h"

#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

namespace {

constexpr int titleHeight = 18;
constexpr int tallRow = 14;
constexpr int mostHeight = 84; ///< px, of all rows together
constexpr int bottomMargin = 8;
constexpr double widestUnnamed = 26.0; ///< px; from this width on, a stance shows how far its foot slips
constexpr double leastWidth = 1.5;     ///< px, of a stance
constexpr double leastSeen = 0.5;      ///< px, of the part of a stance that others do not cover

QString pixels(double value)
{
    return QLocale().toString(value, 'f', value < 10.0 ? 1 : 0);
}

}

FootfallStrip::FootfallStrip(const OpenRun &run, Playback &playback, Preview &preview,
                             const MeasureSeries &series, TimelineStrip &timeline, const Theme &theme,
                             QWidget *parent)
    : QWidget(parent), m_run(run), m_playback(playback), m_preview(preview), m_series(series),
      m_timeline(timeline), m_theme(theme)
{
    setObjectName("footfall");
    setLayoutDirection(Qt::LeftToRight); // as the timeline
    setAccessibleName(tr("Feet on the ground"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&series, &MeasureSeries::changed, this, &FootfallStrip::read);
    run.onChange(ChangeKind::step | ChangeKind::run, this, &FootfallStrip::open);
    run.onChange(ChangeKind::cursor | ChangeKind::preview, this, qOverload<>(&QWidget::update));
    run.onChange(ChangeKind::cursor, this, &FootfallStrip::addFeet);
    run.onChange(ChangeKind::cursor, this, &FootfallStrip::updateDescription);
    open();
}

std::vector<QString> FootfallStrip::feetAtCursor() const
{
    std::vector<QString> names;
    if (m_run.step().isFootDown) {
        const sim::ComposedInterval &interval = m_run.timeline().track().interval();
        for (const int foot : m_run.step().view(interval.scene, interval.values).feet)
            names.push_back(QString::fromStdString(interval.scene.names[static_cast<std::size_t>(foot)]));
    }
    return names;
}

void FootfallStrip::open()
{
    m_points = m_run.timeline().track().interval().scene.names.size();
    m_names = feetAtCursor();
    setVisible(!m_names.empty());
    updateGeometry();
    read();
}

void FootfallStrip::addFeet()
{
    const std::size_t points = m_run.timeline().track().interval().scene.names.size();
    if (std::exchange(m_points, points) == points)
        return;
    std::vector<QString> names = feetAtCursor();
    if (names.size() <= m_names.size())
        return; // the rows of feet that were there earlier in the run stay
    m_names = std::move(names);
    updateGeometry();
    read();
}

void FootfallStrip::read()
{
    m_stances.follow(m_series, m_names.size());
    update();
    updateDescription();
}

int FootfallStrip::rowHeight() const
{
    const int rows = std::max(1, static_cast<int>(m_names.size()));
    return std::clamp(mostHeight / rows, 5, tallRow);
}

QSize FootfallStrip::sizeHint() const
{
    return {600, titleHeight + static_cast<int>(m_names.size()) * rowHeight() + bottomMargin};
}

int FootfallStrip::rowAt(int y) const
{
    const int row = (y - titleHeight) / rowHeight();
    return y >= titleHeight && row < static_cast<int>(m_names.size()) ? row : -1;
}

const Stance *FootfallStrip::stanceAt(std::size_t foot, std::int64_t frame) const
{
    const std::vector<Stance> &stances = m_stances.of(foot);
    const auto after = std::upper_bound(stances.begin(), stances.end(), frame,
                                        [](std::int64_t at, const Stance &one) { return at < one.from; });
    return after != stances.begin() && std::prev(after)->to >= frame ? &*std::prev(after) : nullptr;
}

QString FootfallStrip::sentence() const
{
    QStringList parts;
    for (std::size_t foot = 0; foot < m_names.size(); ++foot) {
        const Stance *stance = stanceAt(foot, m_timeline.frame());
        parts << (stance ? tr("%1 stands, slipped %2\u202Fpx.").arg(m_names[foot], pixels(stance->slip))
                         : tr("%1 is in the air.").arg(m_names[foot]));
    }
    return parts.join(' ');
}

void FootfallStrip::updateDescription()
{
    if (!m_playback.isPlaying() && isVisible())
        setAccessibleDescription(sentence());
}

void FootfallStrip::paintFoot(QPainter &painter, std::size_t foot, double top,
                              const QFontMetricsF &metrics) const
{
    const TimelineAxis &axis = m_timeline.axis();
    const double high = rowHeight() - (rowHeight() > 8 ? 3.0 : 1.0);
    const double round = std::min(3.0, high / 2);
    double painted = 0.0; ///< px, the row is painted up to here
    for (const Stance &stance : m_stances.of(foot)) {
        // A sample belongs to the end of its output step. This shift also makes a stance of one sample
        // visible.
        const double from = axis.xOf(stance.from - m_series.framesPerOutput() / 2);
        const double to = std::max(axis.xOf(stance.to), from + leastWidth);
        if (to - painted < leastSeen)
            continue; // in long runs, thousands of stances share a pixel
        const QRectF bar(from, top, to - from, high);
        if (bar.width() > 2.0 * round) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(m_theme.tokens().contact);
            painter.drawRoundedRect(bar, round, round);
            paintSlip(painter, stance, bar, metrics);
        } else {
            painter.fillRect(bar, m_theme.tokens().contact);
        }
        painted = to;
    }
}

void FootfallStrip::paintSlip(QPainter &painter, const Stance &stance, const QRectF &bar,
                              const QFontMetricsF &metrics) const
{
    if (rowHeight() < tallRow || bar.width() < widestUnnamed)
        return;
    const QString slip = pixels(stance.slip);
    if (bar.width() < metrics.horizontalAdvance(slip) + 8.0)
        return;
    painter.setPen(m_theme.tokens().panel);
    painter.drawText(bar.adjusted(0.0, -1.0, 0.0, 1.0), Qt::AlignCenter, slip);
}

void FootfallStrip::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), m_theme.tokens().panel);
    painter.setRenderHint(QPainter::Antialiasing);
    const TimelineAxis &axis = m_timeline.axis();
    const QFont caption = m_theme.ui(11.5);
    painter.setFont(caption);
    painter.setPen(m_theme.tokens().ink3);
    const double baseline = QFontMetricsF(caption).ascent();
    painter.drawText(QPointF(axis.left(), baseline), tr("Feet on the ground, and how many px each slips"));
    const QFont small = m_theme.mono(11);
    const QFontMetricsF metrics(small);
    painter.setFont(small);
    for (std::size_t foot = 0; foot < m_stances.feet(); ++foot) {
        const double top = titleHeight + static_cast<double>(foot) * rowHeight();
        const double middle = std::floor(top + rowHeight() / 2.0 - 1.0) + 0.5;
        painter.setPen(m_theme.tokens().line);
        painter.drawLine(QPointF(axis.left(), middle), QPointF(axis.right(), middle));
        if (rowHeight() == tallRow) {
            painter.setPen(m_theme.tokens().ink3);
            painter.drawText(QPointF(4.0, top + metrics.ascent() - 1.0), QString::number(foot));
        }
        paintFoot(painter, foot, top, metrics);
    }
    paintCursors(painter);
}

void FootfallStrip::paintCursors(QPainter &painter) const
{
    const auto line = [&](std::int64_t frame, const QPen &pen) {
        const double x = m_timeline.axis().xOf(frame);
        painter.setPen(pen);
        painter.drawLine(QPointF(x, titleHeight - 2.0), QPointF(x, height() - bottomMargin + 2.0));
    };
    line(m_timeline.frame(), QPen(m_theme.tokens().now, 2.0));
    if (m_timeline.pointed())
        line(*m_timeline.pointed(), QPen(m_theme.tokens().ink3, 1.0));
}

QString FootfallStrip::tipAt(const QPoint &place) const
{
    const int row = rowAt(place.y());
    if (row < 0)
        return tr("The times when each foot is on the ground. Click to go to that frame");
    const auto foot = static_cast<std::size_t>(row);
    const std::int64_t frame = m_timeline.axis().frameAt(place.x());
    const Stance *stance = stanceAt(foot, frame);
    if (!stance)
        return tr("%1 is in the air at frame %2").arg(m_names[foot]).arg(frame);
    return tr("%1 stands from frame %2 to %3 and slips %4\u202Fpx")
        .arg(m_names[foot])
        .arg(stance->from)
        .arg(stance->to)
        .arg(pixels(stance->slip));
}

bool FootfallStrip::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

void FootfallStrip::mousePressEvent(QMouseEvent *event)
{
    m_preview.end(); // a press acts at the cursor of the run
    if (event->button() == Qt::LeftButton)
        m_timeline.scrubTo(m_timeline.axis().frameAt(event->position().x()));
}

void FootfallStrip::mouseMoveEvent(QMouseEvent *event)
{
    const std::int64_t frame = m_timeline.axis().frameAt(event->position().x());
    if (event->buttons() & Qt::LeftButton)
        m_timeline.scrubTo(frame);
    else if (frame <= m_run.timeline().computed())
        m_preview.show({frame, 0});
    else
        m_preview.end();
}

void FootfallStrip::leaveEvent(QEvent *)
{
    m_preview.end();
}

}
