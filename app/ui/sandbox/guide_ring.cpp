#include "app/ui/sandbox/guide_ring.h"

#include <QPainter>

namespace app {

namespace {

constexpr double lineWidth = 2.0; ///< px
constexpr double corner = 7.0;    ///< px, corner radius

}

GuideRing::GuideRing(const Theme &theme, QWidget *parent) : QFocusFrame(parent), m_theme(theme)
{
    setObjectName("guideRing");
    setAttribute(Qt::WA_TransparentForMouseEvents);
}

void GuideRing::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_theme.tokens().now, lineWidth));
    const double inside = 0.5 * lineWidth;
    painter.drawRoundedRect(QRectF(rect()).adjusted(inside, inside, -inside, -inside), corner, corner);
}

}
