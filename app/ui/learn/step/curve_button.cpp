#include "app/ui/learn/step/curve_button.h"

#include "app/model/learning/prediction_text.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double curveMargin = 8.0; ///< px around the curve
constexpr int curveCorner = 5;      ///< px
constexpr int curveTick = 12;       ///< px

}

CurveButton::CurveButton(int number, const Theme &theme, QWidget *parent)
    : QAbstractButton(parent), m_theme(theme), m_number(number)
{
    setObjectName(QStringLiteral("curve%1").arg(number));
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Choose this curve (%1)").arg(number));
    connect(this, &QAbstractButton::toggled, this, &CurveButton::describe);
    describe();
}

void CurveButton::setCurve(const std::vector<double> &curve, double least, double most, bool pointsDown)
{
    m_curve = curve;
    m_least = least;
    m_most = most;
    m_pointsDown = pointsDown;
    describe();
    update();
}

void CurveButton::setRight(bool isRight)
{
    m_isRight = isRight;
    describe();
    update();
}

void CurveButton::describe()
{
    const QString name = tr("Curve %1: %2").arg(m_number).arg(curveWords(m_curve));
    setAccessibleName(m_isRight ? tr("%1, right").arg(name) : name);
}

void CurveButton::nextCheckState()
{
    setChecked(true); // a choice is not taken back by a second click
}

void CurveButton::paintEvent(QPaintEvent *)
{
    const Tokens &t = m_theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isMarked = isChecked() || m_isRight;
    const QColor frame = m_isRight ? t.ok : isChecked() ? t.link : t.line2;
    painter.setPen(QPen(frame, isMarked ? 2.0 : 1.0));
    painter.setBrush(isEnabled() && underMouse() ? t.hover : t.scene);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), curveCorner, curveCorner);
    painter.setFont(m_theme.ui(11));
    painter.setPen(t.ink3);
    painter.drawText(rect().adjusted(6, 3, -4, -3), Qt::AlignLeft | Qt::AlignTop, QString::number(m_number));
    if (m_isRight)
        m_theme.icon("check", t.ok).paint(&painter, QRect(width() - curveTick - 5, 4, curveTick, curveTick));
    if (m_curve.size() < 2)
        return;
    const QRectF area = QRectF(rect()).adjusted(curveMargin, curveMargin + 8.0, -curveMargin, -curveMargin);
    const double span = std::max(m_most - m_least, 1e-9);
    QPolygonF line;
    for (std::size_t i = 0; i < m_curve.size(); ++i) {
        if (!std::isfinite(m_curve[i]))
            break;
        const double across = static_cast<double>(i) / static_cast<double>(m_curve.size() - 1);
        const double share = (m_curve[i] - m_least) / span;
        line << QPointF(area.left() + across * area.width(), m_pointsDown
                                                                 ? area.top() + share * area.height()
                                                                 : area.bottom() - share * area.height());
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(t.ink, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
}

}
