#include "app/cli/svg_drawing.h"

#include "app/model/numbers.h"

namespace app {

namespace {

// Told apart by people with any kind of colour vision (Okabe and Ito, 2008), darkened for a white ground; the shape of
// the points is the second sign. Seven and four have no common divisor.
constexpr std::array colors = {"#0072b2", "#c04f00", "#00805d", "#b3538a", "#2f8fc4", "#857300", "#3c4046"};
constexpr std::array shapes = {Sign::Shape::circle, Sign::Shape::square, Sign::Shape::triangle,
                               Sign::Shape::diamond};

QString px(double value)
{
    return QString::number(value, 'f', 1);
}

QString listed(const std::vector<QPointF> &points)
{
    QStringList all;
    for (const QPointF &point : points)
        all.push_back(px(point.x()) + ',' + px(point.y()));
    return all.join(' ');
}

}

Sign signOf(std::size_t number)
{
    return {colors[number % colors.size()], shapes[number % shapes.size()]};
}

SvgDrawing::SvgDrawing(double width, double height) : m_svg(&m_text)
{
    m_svg.setAutoFormatting(true);
    m_svg.writeStartDocument();
    m_svg.writeStartElement("svg");
    attributes({{"xmlns", "http://www.w3.org/2000/svg"},
                {"viewBox", QStringLiteral("0 0 %1 %2").arg(width).arg(height)},
                {"font-family", "Inter, sans-serif"},
                {"font-size", "13"}});
    element("rect", {{"width", px(width)}, {"height", px(height)}, {"fill", paper}});
}

QByteArray SvgDrawing::finish()
{
    m_svg.writeEndElement();
    m_svg.writeEndDocument();
    return m_text;
}

void SvgDrawing::attributes(const Attributes &all)
{
    for (const auto &[name, value] : all)
        m_svg.writeAttribute(name, value);
}

void SvgDrawing::element(const QString &name, const Attributes &all)
{
    m_svg.writeEmptyElement(name);
    attributes(all);
}

void SvgDrawing::line(QPointF from, QPointF to, const QString &color, const QString &thickness)
{
    element("line", {{"x1", px(from.x())},
                     {"y1", px(from.y())},
                     {"x2", px(to.x())},
                     {"y2", px(to.y())},
                     {"stroke", color},
                     {"stroke-width", thickness}});
}

void SvgDrawing::polyline(const std::vector<QPointF> &points, const QString &color, const QString &thickness)
{
    element("polyline", {{"points", listed(points)},
                         {"fill", "none"},
                         {"stroke", color},
                         {"stroke-width", thickness},
                         {"stroke-linejoin", "round"},
                         {"stroke-linecap", "round"}});
}

void SvgDrawing::ring(QPointF centre, double radius, const QString &color, const QString &thickness)
{
    element("circle", {{"cx", px(centre.x())},
                       {"cy", px(centre.y())},
                       {"r", px(radius)},
                       {"fill", "none"},
                       {"stroke", color},
                       {"stroke-width", thickness}});
}

void SvgDrawing::text(QPointF at, const QString &words, const Attributes &how)
{
    m_svg.writeStartElement("text");
    attributes({{"x", px(at.x())}, {"y", px(at.y())}});
    attributes(how);
    m_svg.writeCharacters(words);
    m_svg.writeEndElement();
}

void SvgDrawing::power(QPointF at, int exponent, const QString &anchor)
{
    text(at, powerOfTen(exponent), {{"text-anchor", anchor}, {"fill", caption}});
}

void SvgDrawing::sign(QPointF at, const Sign &sign, const QString &fill)
{
    static constexpr double r = 4.5;
    const Attributes look = {{"fill", fill}, {"stroke", sign.color}, {"stroke-width", "1.5"}};
    if (sign.shape == Sign::Shape::circle) {
        element("circle", {{"cx", px(at.x())}, {"cy", px(at.y())}, {"r", px(r)}});
        return attributes(look);
    }
    std::vector<QPointF> corners = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
    if (sign.shape == Sign::Shape::triangle)
        corners = {{0, -1.3 * r}, {1.2 * r, 0.8 * r}, {-1.2 * r, 0.8 * r}};
    else if (sign.shape == Sign::Shape::diamond)
        corners = {{0, -1.4 * r}, {1.4 * r, 0}, {0, 1.4 * r}, {-1.4 * r, 0}};
    for (QPointF &corner : corners)
        corner += at;
    element("polygon", {{"points", listed(corners)}});
    attributes(look);
}

}
