#include "app/ui/code/engine/code_card.h"

#include "app/model/code/code_values.h"
#include "app/model/text/phrases.h"
#include "app/ui/theme/theme.h"

#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <QScreen>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr int cardWidth = 280;
constexpr int padding = 12;
constexpr int headHeight = 20;
constexpr int gap = 8;
constexpr int plotHeight = 56;
constexpr int axisHeight = 16;

double partOf(const std::variant<double, sim::Vec2> &value, int part)
{
    if (const double *number = std::get_if<double>(&value))
        return *number;
    const sim::Vec2 pair = std::get<sim::Vec2>(value);
    return part == 0 ? pair.x : pair.y;
}

}

CodeCard::CodeCard(const Theme &theme, QWidget *parent) : QWidget(parent, Qt::ToolTip), m_theme(theme)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_ShowWithoutActivating);
    setFocusPolicy(Qt::NoFocus);
}

void CodeCard::show(const CodeSymbol &symbol, const QString &whose, const CodeHistory &history,
                    const QString &value, const QRect &word)
{
    m_symbol = symbol;
    m_whose = whose;
    m_history = history;
    m_value = value;
    setAccessibleName(tr("%1: %2. %3").arg(symbol.title, value, text()));
    const bool isDrawn = history.samples.size() > 1;
    resize(cardWidth,
           2 * padding + headHeight + textHeight() + (isDrawn ? gap + plotHeight + axisHeight : 0));
    const QScreen *screen = QGuiApplication::screenAt(word.center());
    const QRect room = (screen ? screen : QGuiApplication::primaryScreen())->availableGeometry();
    const bool below = word.bottom() + 6 + height() <= room.bottom();
    move(std::clamp(word.left(), room.left(), std::max(room.left(), room.right() - width())),
         below ? word.bottom() + 6 : word.top() - 6 - height());
    setVisible(true);
    update();
}

QString CodeCard::headline() const
{
    return m_symbol.title == m_symbol.name ? m_symbol.name
                                           : QStringLiteral("%1 · %2").arg(m_symbol.name, m_symbol.title);
}

QString CodeCard::text() const
{
    QStringList lines;
    if (!m_symbol.what.isEmpty())
        lines << m_symbol.what;
    if (!m_whose.isEmpty())
        lines << m_whose;
    if (!m_symbol.parameter.isEmpty())
        lines << tr("Drag it sideways, or double-click it to type.");
    return lines.join('\n');
}

int CodeCard::textHeight() const
{
    if (text().isEmpty())
        return 0;
    const QRect room(0, 0, cardWidth - 2 * padding, 1000);
    return 4 + QFontMetrics(m_theme.ui(12)).boundingRect(room, Qt::TextWordWrap, text()).height();
}

void CodeCard::paintEvent(QPaintEvent *)
{
    const Tokens &t = m_theme.tokens();
    QPainter painter(this);
    painter.setPen(t.line2);
    painter.setBrush(t.panel);
    // Square corners, like the other cards: without a compositor, rounded corners would be black.
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    painter.setRenderHint(QPainter::Antialiasing);
    const QRect inside = rect().adjusted(padding, padding, -padding, -padding);
    painter.setFont(m_theme.mono(12));
    painter.setPen(t.ink);
    const QRect head(inside.left(), inside.top(), inside.width(), headHeight);
    painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, m_value);
    const int room = inside.width() - painter.fontMetrics().horizontalAdvance(m_value) - gap;
    painter.setFont(m_theme.ui(12, QFont::DemiBold));
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(headline(), Qt::ElideRight, room));
    painter.setFont(m_theme.ui(12));
    painter.setPen(t.ink2);
    painter.drawText(QRect(inside.left(), head.bottom() + 5, inside.width(), textHeight()), Qt::TextWordWrap,
                     text());
    if (m_history.samples.size() > 1)
        paintPlot(painter, QRectF(inside.left(), inside.bottom() + 1 - axisHeight - plotHeight,
                                  inside.width(), plotHeight));
}

std::pair<double, double> CodeCard::range() const
{
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const CodeHistory::Sample &sample : m_history.samples) {
        for (int part = 0; part <= int(m_history.isPair()); ++part) {
            const double value = partOf(sample.value, part);
            if (!std::isfinite(value))
                continue;
            least = std::min(least, value);
            most = std::max(most, value);
        }
    }
    if (!(least <= most))
        return {-1.0, 1.0};
    // A constant value is drawn as a line in the middle.
    const double spare = most - least > 1e-12 * std::max(std::abs(least), std::abs(most))
                             ? 0.06 * (most - least)
                             : std::max(1e-12, 0.5 * std::abs(most));
    return {least - spare, most + spare};
}

void CodeCard::paintLine(QPainter &painter, const QRectF &area, int part) const
{
    const auto [least, most] = range();
    const double first = static_cast<double>(m_history.samples.front().frame);
    const double frames = static_cast<double>(m_history.samples.back().frame) - first;
    QPainterPath line;
    bool isOn = false;
    for (const CodeHistory::Sample &sample : m_history.samples) {
        const double value = partOf(sample.value, part);
        if (!std::isfinite(value)) {
            isOn = false;
            continue;
        }
        const QPointF at(area.left() + (static_cast<double>(sample.frame) - first) / frames * area.width(),
                         area.bottom() - (value - least) / (most - least) * area.height());
        isOn ? line.lineTo(at) : line.moveTo(at);
        isOn = true;
    }
    QPen pen(part == 0 ? m_theme.tokens().ink : m_theme.tokens().ink3, 1.5);
    if (part == 1)
        pen.setDashPattern({3.0, 2.0});
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(line);
}

void CodeCard::paintLabels(QPainter &painter, const QRectF &area) const
{
    const Tokens &t = m_theme.tokens();
    const auto [least, most] = range();
    painter.setFont(m_theme.ui(11));
    painter.setPen(t.ink3);
    const QRectF below(area.left(), area.bottom() + 2, area.width(), axisHeight);
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, frameName(m_history.samples.front().frame));
    painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(m_history.samples.back().frame));
    if (m_history.isPair())
        painter.drawText(below, Qt::AlignCenter, tr("x solid, y dashed"));
    painter.setFont(m_theme.mono(11));
    const double spare = 0.06 / 1.12 * (most - least);
    const auto label = [&](const QRectF &room, Qt::Alignment where, double value) {
        const QString text = shownNumber(value);
        painter.fillRect(painter.boundingRect(room, static_cast<int>(where), text), t.scene);
        painter.drawText(room, static_cast<int>(where), text); // cleared, so that no line crosses the text
    };
    label(area.adjusted(4, 2, 0, 0), Qt::AlignLeft | Qt::AlignTop, most - spare);
    label(area.adjusted(4, 0, 0, -2), Qt::AlignLeft | Qt::AlignBottom, least + spare);
}

void CodeCard::paintPlot(QPainter &painter, const QRectF &area) const
{
    const Tokens &t = m_theme.tokens();
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.scene);
    painter.drawRect(area);
    for (int part = int(m_history.isPair()); part >= 0; --part)
        paintLine(painter, area, part);
    painter.setPen(QPen(t.now, 2.0));
    painter.drawLine(area.topRight(), area.bottomRight());
    paintLabels(painter, area);
}

}
