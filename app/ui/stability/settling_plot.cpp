#include "app/ui/stability/settling_plot.h"

#include "app/model/text/numbers.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using Kind = sim::Settling::Kind;

constexpr double fewest = 10.0; ///< frames with the first colour
// The shades: of a cell that settles, from few frames to many, and of other cells.
constexpr double firstShade = 0.05, lastShade = 0.8, movingShade = 0.9, growingShade = 1.0;
constexpr double keyRow = 22.0; ///< px, height

QString titleOf(const lessons::Parameter &parameter)
{
    const QString name = QStringLiteral("%1 %2").arg(parameter.name, parameter.id);
    return parameter.unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, parameter.unit);
}

}

SettlingPlot::SettlingPlot(SettlingMonitor &monitor, const Theme &theme, QWidget *parent)
    : MapPlot(theme, parent), m_monitor(monitor)
{
    setObjectName("settlingMap");
    setAccessibleName(tr("Map of the time to rest"));
    axisRect()->setMargins(QMargins(48, 30 + qRound(keyRow), 14, 40));
    connect(&monitor, &SettlingMonitor::changed, this, &SettlingPlot::refresh);
    applyTheme();
}

void SettlingPlot::applyTheme()
{
    MapPlot::applyTheme();
    const Tokens &t = m_theme.tokens();
    // Ever darker on a light ground, ever brighter on a dark one: it reads without hue.
    const QColor slow = m_theme.isDark() ? mixed(t.link, Qt::white, 0.45) : mixed(t.link, Qt::black, 0.35);
    QCPColorGradient gradient;
    gradient.clearColorStops();
    gradient.setColorInterpolation(QCPColorGradient::ciRGB);
    gradient.setColorStopAt(0.0, t.scene);
    gradient.setColorStopAt(firstShade, mixed(t.scene, t.link, 0.06));
    gradient.setColorStopAt(lastShade, slow);
    gradient.setColorStopAt(lastShade + 0.01, mixed(t.scene, t.ink, 0.3));
    gradient.setColorStopAt(movingShade, mixed(t.scene, t.ink, 0.3));
    gradient.setColorStopAt(movingShade + 0.01, mixed(t.scene, t.past, 0.45));
    gradient.setColorStopAt(growingShade, mixed(t.scene, t.past, 0.45));
    setGradient(gradient);
    refresh();
}

MapPlot::Axes SettlingPlot::axes() const
{
    const sim::SettlingMap *map = m_monitor.map();
    return map ? Axes{&map->x, &map->y} : Axes{};
}

const sim::Settling *SettlingPlot::resultAt(std::size_t cell) const
{
    const sim::SettlingMap &map = *m_monitor.map();
    const std::size_t columns = map.x.values.size();
    const std::optional<std::size_t> known = map.nearestKnown(cell % columns, cell / columns);
    return known ? &*map.cells[*known] : nullptr;
}

double SettlingPlot::shadeOf(std::size_t cell) const
{
    const sim::Settling *result = resultAt(cell);
    if (!result || result->kind == Kind::fails)
        return 0.0;
    if (result->kind != Kind::settles)
        return result->kind == Kind::moves ? movingShade : growingShade;
    const double frames = std::max(static_cast<double>(result->frames), fewest);
    const double share = std::log(frames / fewest) / std::log(sim::Settling::mostFrames / fewest);
    return firstShade + (lastShade - firstShade) * share;
}

int SettlingPlot::kindOf(std::size_t cell) const
{
    const sim::Settling *result = resultAt(cell);
    return result ? static_cast<int>(result->kind) : -1;
}

QString SettlingPlot::resultWords(std::size_t cell) const
{
    const sim::Settling *result = resultAt(cell);
    if (!result)
        return {};
    switch (result->kind) {
    case Kind::settles:
        return tr("at rest after %n frames", nullptr, static_cast<int>(result->frames));
    case Kind::moves:
        return tr("still moving after %1 frames").arg(sim::Settling::mostFrames);
    case Kind::grows:
        return tr("the motion grows without bound");
    case Kind::fails:
        break;
    }
    return tr("cannot be computed");
}

QString SettlingPlot::useWords(const TriedSpot &to) const
{
    const sim::SettlingMap &map = *m_monitor.map();
    return tr("Click or press Enter to begin the run again with %1 %2 and %3 %4")
        .arg(QString::fromStdString(map.x.parameter), roughNumber(to.k),
             QString::fromStdString(map.y.parameter), roughNumber(to.damp));
}

QString SettlingPlot::acrossTitle() const
{
    const lessons::Parameter *stiffness = stiffnessOf(m_monitor.run().step());
    return stiffness ? titleOf(*stiffness) : QString();
}

QString SettlingPlot::upTitle() const
{
    const lessons::Parameter *damping = dampingOf(m_monitor.run().step());
    return damping ? titleOf(*damping) : QString();
}

QString SettlingPlot::explanation() const
{
    const std::int64_t from = m_monitor.countedFrom();
    QString text = from > 0 ? tr("Your run from its start, with all you did: how many frames after frame %1, "
                                 "your last input, "
                                 "it is at rest.")
                                  .arg(from)
                            : tr("Your run from its start: after how many frames it is at rest.");
    text +=
        ' ' +
        tr("At rest, each body stays within 1\u2009px of its last place, and moves less than 0.05\u2009px "
           "in a frame.");
    if (m_monitor.leavesInputOut())
        text += QStringLiteral(" ") + tr("Input after frame %1 is left out.").arg(SettlingMonitor::mostInput);
    return text.replace(QChar(0x2009), QChar(0x202F)); // no line breaks between a number and its unit
}

/// Draws bar and signs in one row below the title: "10 [bar] 600 frames, [dots] still moving, [strokes] grows".
void SettlingPlot::drawKey(QPainter &painter) const
{
    const QString most = tr("%1 frames").arg(sim::Settling::mostFrames), least = QString::number(fewest),
                  moves = tr("still moving"), grows = tr("grows");
    const QFontMetricsF metrics(painter.font());
    const QColor ink = m_theme.tokens().ink3;
    const double top = keyRow + 2.0, sign = 14.0, gap = 5.0, between = 10.0;
    double texts = 2.0 * (sign + gap + between) + 2.0 * gap;
    for (const QString &text : {most, least, moves, grows})
        texts += metrics.horizontalAdvance(text);
    double x = 4.0;
    const auto write = [&](const QString &text, double after) {
        painter.setPen(ink);
        painter.drawText(QRectF(x, top, 400.0, keyRow), Qt::AlignLeft | Qt::AlignVCenter, text);
        x += metrics.horizontalAdvance(text) + after;
    };
    const auto sample = [&](double shade, Kind kind) {
        const QRectF box(x, top + 5.0, sign, keyRow - 10.0);
        painter.fillRect(box, shadeColor(shade));
        for (int part = 0; part < 4; ++part) {
            const QSizeF size = box.size() / 2.0;
            drawSign(painter,
                     {box.topLeft() + QPointF(part % 2 * size.width(), part / 2 * size.height()), size},
                     static_cast<int>(kind));
        }
        x += sign + gap;
    };
    const double bar = std::clamp(width() - 8.0 - texts, 16.0, 64.0);
    write(least, gap);
    drawBar(painter, {x, top + 8.0, bar, 6.0}, firstShade, lastShade);
    x += bar + gap;
    write(most, between);
    sample(movingShade, Kind::moves);
    write(moves, between);
    sample(growingShade, Kind::grows);
    write(grows, 0.0);
}

void SettlingPlot::drawSign(QPainter &painter, const QRectF &cell, int kind) const
{
    if (kind == static_cast<int>(Kind::moves)) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_theme.tokens().ink);
        painter.drawEllipse(cell.center(), 0.8, 0.8);
    } else if (kind == static_cast<int>(Kind::grows)) {
        painter.setPen(QPen(m_theme.tokens().ink, 1.0));
        painter.drawLine(cell.bottomLeft(), cell.topRight());
    }
}

}
