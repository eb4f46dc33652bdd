#include "app/ui/scene/hud/unit_circle.h"

#include "app/model/text/numbers.h"
#include "app/model/text/scene_words.h"
#include "app/ui/scene/drawing/label_places.h"
#include "app/ui/scene/drawing/triangle_style.h"
#include "app/ui/scene/hud/free_area.h"
#include "app/ui/scene/scene_view.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace app {

namespace {

constexpr int cardPadding = 10;       ///< px
constexpr double circleRadius = 44.0; ///< px
constexpr int circleRoom = 110;       ///< px, width of the part with the circle
constexpr int circleRow = 17;         ///< px, height of a row of text
constexpr int sampleRoom = 26;        ///< px, for a piece of line before a row
constexpr double sampleLength = 20.0; ///< px
constexpr double angleArc = 15.0;     ///< px, radius
constexpr double beyondCircle = 6.0;  ///< px, of the x axis
constexpr double circleCardRadius = 8.0;
constexpr double tipRadius = 3.0;
constexpr double leastSide = 0.01; ///< as a part of the radius; a shorter side is not drawn

/// The rows of text, by their place.
enum CircleRow { angleRow, cosineRow, besideRow, sineRow, oppositeRow, pythagorasRow, downRow, circleRows };

QStringList linesOf(const ArrowAngle &arrow)
{
    const UnitCircleWords words = unitCircleWords();
    const double length = arrow.length(), cosine = arrow.cosine(), sine = arrow.sine();
    if (length == 0.0)
        return {words.noLength, words.noDirection};
    return {
        words.angle.arg(fixedNumber(arrow.angle() * 180.0 / std::numbers::pi, 1),
                        fixedNumber(arrow.angle(), 3)),
        words.side.arg(words.cosine, fixedNumber(arrow.vector().x, 1), fixedNumber(length, 1),
                       fixedNumber(cosine, 3)),
        words.beside,
        words.side.arg(words.sine, fixedNumber(arrow.vector().y, 1), fixedNumber(length, 1),
                       fixedNumber(sine, 3)),
        words.opposite,
        words.pythagoras.arg(fixedNumber(std::abs(cosine), 3), fixedNumber(std::abs(sine), 3)),
        words.down,
    };
}

QFont fontOf(int row, const Theme &theme)
{
    const bool isFigure = row == angleRow || row == cosineRow || row == sineRow;
    return theme.ui(12, isFigure ? QFont::DemiBold : QFont::Normal);
}

/// Returns the size of the card. It does not depend on the numbers, so that it is still while they change.
QSize cardSize(const Theme &theme)
{
    const ArrowAngle widest{{}, {-888.8, -888.8}};
    double width = 0.0;
    int row = 0;
    for (const QString &line : linesOf(widest)) {
        width = std::max(width, QFontMetricsF(fontOf(row, theme)).horizontalAdvance(line));
        ++row;
    }
    return {circleRoom + sampleRoom + static_cast<int>(std::ceil(width)) + cardPadding,
            2 * cardPadding + circleRows * circleRow};
}

}

UnitCircle::UnitCircle(SceneView &scene, const Theme &theme) : QWidget(&scene), m_scene(scene), m_theme(theme)
{
    setObjectName("unitCircle");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(unitCircleWords().title);
    hide();
    connect(&scene, &SceneView::contentChanged, this, &UnitCircle::follow);
    connect(&scene, &SceneView::zoomChanged, this, &UnitCircle::place);
    scene.installEventFilter(this);
    follow();
}

void UnitCircle::follow()
{
    const SceneContent &shown = m_scene.shown();
    const auto arrow = shown.extras.unitCircle && shown.points() > 0 ? arrowAngleOf(shown.picture)
                                                                     : std::optional<ArrowAngle>();
    if (arrow != m_arrow) {
        if (!m_arrow)
            m_corner = Corner::topRight;
        m_arrow = arrow;
        setAccessibleDescription(lines().join(QStringLiteral(". ")));
        update();
    }
    place();
}

QStringList UnitCircle::lines() const
{
    return m_arrow ? linesOf(*m_arrow) : QStringList();
}

QRect UnitCircle::boxAt(Corner corner) const
{
    const QSize size = cardSize(m_theme);
    const QRect area = freeArea(m_scene.shown(), QRectF(m_scene.viewport()->rect())).toAlignedRect();
    const bool isRight = corner == Corner::topRight || corner == Corner::bottomRight;
    const bool isTop = corner == Corner::topRight || corner == Corner::topLeft;
    QRect box(QPoint(isRight ? area.right() - size.width() : area.left(),
                     isTop ? area.top() : area.bottom() - size.height()),
              size);
    const QRect legend = m_scene.legendBox().toAlignedRect();
    if (legend.intersects(box)) // it has more than one row
        box.moveBottom(legend.top() - 1);
    return box;
}

double UnitCircle::coveredBy(const QRect &box) const
{
    const SceneContent &shown = m_scene.shown();
    const Camera camera(m_scene.viewportTransform());
    std::vector<QRectF> boxes = bodyBoxes(shown, camera);
    boxes.push_back(nameBox(shown, camera, QRectF(m_scene.viewport()->rect())));
    boxes.push_back(
        QRectF(camera.at(m_arrow->from), camera.at(m_arrow->to)).normalized().adjusted(-4, -4, 4, 4));
    double covered = 0.0;
    for (const QRectF &other : boxes) {
        const QRectF both = other & QRectF(box);
        covered += both.width() * both.height();
    }
    return covered;
}

void UnitCircle::place()
{
    constexpr std::array corners{Corner::topRight, Corner::topLeft, Corner::bottomRight, Corner::bottomLeft};
    const QRect view = m_scene.viewport()->rect();
    const bool isShown = m_arrow && view.contains(boxAt(Corner::topRight)) &&
                         std::any_of(corners.begin(), corners.end(), [&](Corner corner) {
                             return !boxAt(corner).contains(view.center()); // else it hides the figure
                         });
    setVisible(isShown);
    if (!isShown) {
        m_scene.setCard({});
        return;
    }
    double least = coveredBy(boxAt(m_corner));
    for (const Corner corner : corners) {
        if (least == 0.0)
            break; // it stays where it covers nothing, so it rarely moves
        const double covered = coveredBy(boxAt(corner));
        if (covered < least) {
            least = covered;
            m_corner = corner;
        }
    }
    const QRect box = boxAt(m_corner);
    if (box != geometry())
        setGeometry(box);
    m_scene.setCard(box);
}

bool UnitCircle::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &m_scene && event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

void UnitCircle::paintEvent(QPaintEvent *)
{
    if (!m_arrow)
        return;
    const Tokens &t = m_theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(t.line2);
    painter.setBrush(t.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), circleCardRadius,
                            circleCardRadius);
    painter.setBrush(Qt::NoBrush);
    paintCircle(painter);
    paintLines(painter);
}

void UnitCircle::paintCircle(QPainter &painter) const
{
    const Tokens &t = m_theme.tokens();
    const QPointF middle(circleRoom / 2.0, height() / 2.0);
    painter.setPen(QPen(t.ink3, 1.0));
    painter.drawEllipse(middle, circleRadius, circleRadius);
    painter.drawLine(middle, middle + QPointF(circleRadius + beyondCircle, 0.0));
    if (m_arrow->length() == 0.0)
        return;
    const QPointF side(circleRadius * m_arrow->cosine(), 0.0), rise(0.0, circleRadius * m_arrow->sine());
    const QRectF arc(middle - QPointF(angleArc, angleArc), 2.0 * QSizeF(angleArc, angleArc));
    painter.setPen(QPen(t.ink2, 1.5));
    // Qt counts angles anticlockwise, in sixteenths of a degree.
    painter.drawArc(arc, 0,
                    static_cast<int>(std::lround(-16.0 * m_arrow->angle() * 180.0 / std::numbers::pi)));
    painter.setPen(solid(t.ink2, triangleLongSide));
    painter.drawLine(middle, middle + side + rise);
    if (std::abs(m_arrow->cosine()) > leastSide) {
        painter.setPen(besidePen(t.ink));
        painter.drawLine(middle, middle + side);
    }
    if (std::abs(m_arrow->sine()) > leastSide) {
        painter.setPen(oppositePen(t.ink));
        painter.drawLine(middle + side, middle + side + rise);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.ink);
    painter.drawEllipse(middle + side + rise, tipRadius, tipRadius);
    painter.setBrush(Qt::NoBrush);
}

void UnitCircle::paintLines(QPainter &painter) const
{
    const Tokens &t = m_theme.tokens();
    int row = 0;
    for (const QString &line : lines()) {
        const QRect box(circleRoom + sampleRoom, cardPadding + row * circleRow, width(), circleRow);
        if (row == cosineRow || row == sineRow) {
            painter.setPen(row == cosineRow ? besidePen(t.ink) : oppositePen(t.ink));
            const QPointF from(circleRoom, box.center().y() + 0.5);
            painter.drawLine(from, from + QPointF(sampleLength, 0.0));
        }
        painter.setFont(fontOf(row, m_theme));
        const bool isCaption = row == besideRow || row == oppositeRow || row == downRow;
        painter.setPen(isCaption ? t.ink2 : t.ink);
        painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, line);
        ++row;
    }
}

}
