#include "app/ui/time/speed_button.h"

#include "app/model/run/frame_clock.h"

#include <QActionGroup>
#include <QFontMetricsF>
#include <QLocale>
#include <QMenu>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

constexpr std::array speeds = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0};
constexpr double padding = 8.0;
constexpr double chipGap = 6.0;
constexpr int arrow = 12;

QString number(double value)
{
    return QLocale().toString(value, 'g', 3);
}

}

SpeedButton::SpeedButton(const Theme &theme, QWidget *parent)
    : QToolButton(parent), m_theme(theme), m_choices(new QActionGroup(this))
{
    setObjectName("speed");
    setPopupMode(QToolButton::InstantPopup);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    QMenu *menu = new QMenu(this);
    for (const double speed : speeds) {
        QAction *action = menu->addAction(tr("%1×").arg(number(speed)));
        action->setCheckable(true);
        action->setData(speed);
        m_choices->addAction(action);
    }
    m_choices->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    connect(m_choices, &QActionGroup::triggered, this, [this](const QAction *action) {
        emit chosen(action->data().toDouble());
        setSpeed(m_speed); // undoes the uncheck by a click on the checked entry
    });
    setMenu(menu);
    setSpeed(1.0);
}

void SpeedButton::setSpeed(double speed)
{
    m_speed = speed;
    for (QAction *action : m_choices->actions())
        action->setChecked(action->data().toDouble() == speed);
    setAccessibleName(tr("Playing speed %1, %2").arg(factor(), rate()));
    updateGeometry();
    update();
}

void SpeedButton::setBrief(bool brief)
{
    if (brief == m_isBrief)
        return;
    m_isBrief = brief;
    updateGeometry();
    update();
}

double SpeedButton::slowerThan(double speed)
{
    const auto found = std::find_if(speeds.rbegin(), speeds.rend(), [&](double one) { return one < speed; });
    return found == speeds.rend() ? speed : *found;
}

double SpeedButton::fasterThan(double speed)
{
    const auto found = std::find_if(speeds.begin(), speeds.end(), [&](double one) { return one > speed; });
    return found == speeds.end() ? speed : *found;
}

QString SpeedButton::factor() const
{
    return tr("%1×").arg(number(m_speed));
}

QString SpeedButton::rate() const
{
    return tr("%1 frames/s").arg(number(m_speed * FrameClock::framesPerSecond));
}

QSize SpeedButton::sizeHint() const
{
    double width = 2 * padding + chipGap + arrow;
    width += QFontMetricsF(m_theme.ui(13, QFont::Medium)).horizontalAdvance(factor());
    if (!m_isBrief)
        width += chipGap + QFontMetricsF(m_theme.ui(13)).horizontalAdvance(rate());
    return {static_cast<int>(std::ceil(width)), 28};
}

void SpeedButton::paintEvent(QPaintEvent *)
{
    const Tokens &t = m_theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (underMouse() || isDown())
        m_theme.paintSurface(painter, rect(), 6, Surface::hovered);
    double x = padding;
    const auto write = [&](const QString &text, const QFont &font, const QColor &color) {
        painter.setFont(font);
        painter.setPen(color);
        painter.drawText(QRectF(x, 0, width(), height()), Qt::AlignVCenter | Qt::AlignLeft, text);
        x += QFontMetricsF(font).horizontalAdvance(text) + chipGap;
    };
    write(factor(), m_theme.ui(13, QFont::Medium), t.ink);
    if (!m_isBrief)
        write(rate(), m_theme.ui(13), t.ink2);
    m_theme.icon("down").paint(&painter,
                               QRect(static_cast<int>(std::round(x)), (height() - arrow) / 2, arrow, arrow));
}

}
