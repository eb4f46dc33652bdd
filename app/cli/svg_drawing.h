#pragma once

#include <QByteArray>
#include <QPointF>
#include <QString>
#include <QXmlStreamWriter>

#include <array>
#include <utility>
#include <vector>

namespace app {

/// What tells a series on a drawing from the others: a colour and a shape.
struct Sign
{
    enum class Shape { circle, square, triangle, diamond };
    QString color;
    Shape shape = Shape::circle;
};

/// The sign of series `number`: of 28 neighbours no two look the same.
Sign signOf(std::size_t number);

/// A drawing on paper, which is readable on a light page and on a dark one, as an SVG file. All lengths in px.
class SvgDrawing
{
public:
    using Attributes = std::vector<std::pair<QString, QString>>;
    static constexpr auto ink = "#22262b", faint = "#e0dcd2", caption = "#555b62", paper = "#fbfaf7";

    SvgDrawing(double width, double height);

    void line(QPointF from, QPointF to, const QString &color, const QString &thickness);
    void polyline(const std::vector<QPointF> &points, const QString &color, const QString &thickness);
    void ring(QPointF centre, double radius, const QString &color, const QString &thickness);
    void text(QPointF at, const QString &words, const Attributes &how);
    /// A power of ten, as axes have it.
    void power(QPointF at, int exponent, const QString &anchor);
    void sign(QPointF at, const Sign &sign, const QString &fill);
    /// The file. Nothing can be drawn after it.
    QByteArray finish();

private:
    void element(const QString &name, const Attributes &all);
    void attributes(const Attributes &all);

    QByteArray m_text;
    QXmlStreamWriter m_svg;
};

}
