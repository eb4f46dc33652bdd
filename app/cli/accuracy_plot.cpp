#include "app/cli/accuracy_plot.h"

#include "app/cli/plot_axis.h"
#include "app/model/numbers.h"
#include "app/model/sentences.h"

#include <QCoreApplication>
#include <QPointF>
#include <QXmlStreamWriter>

#include <algorithm>
#include <array>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Accuracy)
};

constexpr double width = 960, height = 600;
constexpr double left = 76, right = 720, top = 64, bottom = 530; ///< of the axes; names stand right of them

// Told apart by people with any kind of colour vision (Okabe and Ito, 2008), darkened for a white ground; the shape of
// the points is the second sign. Seven and four have no common divisor: 28 methods look different.
constexpr std::array colors = {"#0072b2", "#c04f00", "#00805d", "#b3538a", "#2f8fc4", "#857300", "#3c4046"};
enum class Shape { circle, square, triangle, diamond };
constexpr std::array shapes = {Shape::circle, Shape::square, Shape::triangle, Shape::diamond};
constexpr auto ink = "#22262b", faint = "#e0dcd2", caption = "#555b62", now = "#f5b301", shade = "#d8d5ce",
               paper = "#fbfaf7";

using Attributes = std::vector<std::pair<QString, QString>>;

QString px(double value)
{
    return QString::number(value, 'f', 1);
}

/// The measured rows of one method, from coarse to fine.
struct Ladder
{
    std::vector<const sim::AccuracyRow *> rows;
    QString color;
    Shape shape = Shape::circle;
};

class Plot
{
public:
    explicit Plot(const AccuracyReport &report)
        : m_report(report), m_ladders(laddersOf(report.found)),
          m_times(numbers(report.found, &sim::AccuracyRow::nsPerFrame), left, right),
          m_errors(numbers(report.found, &sim::AccuracyRow::error), bottom, top), m_svg(&m_text)
    {
    }

    QByteArray draw()
    {
        m_svg.setAutoFormatting(true);
        m_svg.writeStartDocument();
        m_svg.writeStartElement("svg");
        attributes({{"xmlns", "http://www.w3.org/2000/svg"},
                    {"viewBox", QStringLiteral("0 0 %1 %2").arg(width).arg(height)},
                    {"font-family", "Inter, sans-serif"},
                    {"font-size", "13"}});
        element("rect", {{"width", px(width)}, {"height", px(height)}, {"fill", paper}});
        drawTitle();
        drawGrid();
        drawFront();
        for (const Ladder &ladder : m_ladders)
            drawLadder(ladder);
        drawInUse();
        drawNames();
        m_svg.writeEndElement();
        m_svg.writeEndDocument();
        return m_text;
    }

private:
    static bool isDrawn(const sim::AccuracyRow &row)
    {
        return row.outcome == sim::Outcome::measured && row.nsPerFrame > 0.0;
    }

    static std::vector<double> numbers(const sim::Accuracy &found, double sim::AccuracyRow::*number)
    {
        std::vector<double> all;
        for (const sim::AccuracyRow &row : found.rows) {
            if (isDrawn(row))
                all.push_back(row.*number);
        }
        return all;
    }

    static std::vector<Ladder> laddersOf(const sim::Accuracy &found)
    {
        std::vector<Ladder> ladders;
        const sim::Method *method = nullptr;
        std::size_t count = 0; // of methods, drawn or not: each keeps its sign on every plot
        for (const sim::AccuracyRow &row : found.rows) {
            const bool isNew = row.way.method.get() != method;
            method = row.way.method.get();
            if (isNew)
                ++count;
            if (!isDrawn(row))
                continue;
            if (ladders.empty() || ladders.back().rows.front()->way.method->id() != method->id())
                ladders.push_back(
                    {{}, colors[(count - 1) % colors.size()], shapes[(count - 1) % shapes.size()]});
            ladders.back().rows.push_back(&row);
        }
        return ladders;
    }

    QPointF at(const sim::AccuracyRow &row) const
    {
        return {m_times.at(row.nsPerFrame), m_errors.at(row.error)};
    }

    void attributes(const Attributes &all)
    {
        for (const auto &[name, value] : all)
            m_svg.writeAttribute(name, value);
    }

    void element(const QString &name, const Attributes &all)
    {
        m_svg.writeEmptyElement(name);
        attributes(all);
    }

    void line(QPointF from, QPointF to, const QString &color, const QString &thickness)
    {
        element("line", {{"x1", px(from.x())},
                         {"y1", px(from.y())},
                         {"x2", px(to.x())},
                         {"y2", px(to.y())},
                         {"stroke", color},
                         {"stroke-width", thickness}});
    }

    void text(QPointF at, const QString &words, const Attributes &how)
    {
        m_svg.writeStartElement("text");
        attributes({{"x", px(at.x())}, {"y", px(at.y())}});
        attributes(how);
        m_svg.writeCharacters(words);
        m_svg.writeEndElement();
    }

    void power(QPointF at, int exponent, const QString &anchor)
    {
        text(at, powerOfTen(exponent), {{"text-anchor", anchor}, {"fill", caption}});
    }

    void drawTitle()
    {
        const sim::Accuracy &found = m_report.found;
        text({left, 28}, m_report.experiment, {{"fill", ink}, {"font-weight", "600"}, {"font-size", "16"}});
        const QString how = Text::tr("%1 frames; reference %2, known to %3 px")
                                .arg(found.horizon)
                                .arg(QString::fromStdString(found.reference.method),
                                     QString::number(found.reference.disagreement, 'g', 2));
        text({left, 48}, how, {{"fill", caption}});
    }

    void drawGrid()
    {
        for (int decade = m_times.first(); decade <= m_times.last(); decade += m_times.stride()) {
            const double x = m_times.at(std::pow(10.0, decade));
            line({x, top}, {x, bottom}, faint, "1");
            power({x, bottom + 20}, decade, "middle");
        }
        for (int decade = m_errors.first(); decade <= m_errors.last(); decade += m_errors.stride()) {
            const double y = m_errors.at(std::pow(10.0, decade));
            line({left, y}, {right, y}, faint, "1");
            power({left - 10, y + 4}, decade, "end");
        }
        text({right, bottom + 44}, Text::tr("time, ns a frame"), {{"fill", caption}, {"text-anchor", "end"}});
        text({18, top}, Text::tr("error, px"),
             {{"fill", caption}, {"text-anchor", "end"}, {"transform", "rotate(-90 18 64)"}});
    }

    void drawFront()
    {
        std::vector<const sim::AccuracyRow *> front;
        for (const sim::AccuracyRow &row : m_report.found.rows) {
            if (row.front && isDrawn(row))
                front.push_back(&row);
        }
        std::sort(front.begin(), front.end(),
                  [](const auto *a, const auto *b) { return a->nsPerFrame < b->nsPerFrame; });
        polyline(front, shade, "9");
    }

    void polyline(const std::vector<const sim::AccuracyRow *> &rows, const QString &color,
                  const QString &thickness)
    {
        QStringList points;
        for (const sim::AccuracyRow *row : rows)
            points.push_back(px(at(*row).x()) + ',' + px(at(*row).y()));
        m_svg.writeEmptyElement("polyline");
        attributes({{"points", points.join(' ')},
                    {"fill", "none"},
                    {"stroke", color},
                    {"stroke-width", thickness},
                    {"stroke-linejoin", "round"},
                    {"stroke-linecap", "round"}});
    }

    void drawLadder(const Ladder &ladder)
    {
        polyline(ladder.rows, ladder.color, "1.8");
        for (const sim::AccuracyRow *row : ladder.rows) {
            const double y = at(*row).y();
            line({m_times.at(row->nsPerFrame - row->spread), y},
                 {m_times.at(row->nsPerFrame + row->spread), y}, ladder.color, "1");
            drawSign(at(*row), ladder, row->front ? ladder.color : QString(paper));
        }
    }

    void drawSign(QPointF at, const Ladder &ladder, const QString &fill)
    {
        static constexpr double r = 4.5;
        const Attributes look = {{"fill", fill}, {"stroke", ladder.color}, {"stroke-width", "1.5"}};
        if (ladder.shape == Shape::circle) {
            m_svg.writeEmptyElement("circle");
            attributes({{"cx", px(at.x())}, {"cy", px(at.y())}, {"r", px(r)}});
            return attributes(look);
        }
        std::vector<QPointF> corners = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
        if (ladder.shape == Shape::triangle)
            corners = {{0, -1.3 * r}, {1.2 * r, 0.8 * r}, {-1.2 * r, 0.8 * r}};
        else if (ladder.shape == Shape::diamond)
            corners = {{0, -1.4 * r}, {1.4 * r, 0}, {0, 1.4 * r}, {-1.4 * r, 0}};
        QStringList points;
        for (const QPointF &corner : corners)
            points.push_back(px(at.x() + corner.x()) + ',' + px(at.y() + corner.y()));
        m_svg.writeEmptyElement("polygon");
        attributes({{"points", points.join(' ')}});
        attributes(look);
    }

    void drawInUse()
    {
        for (const sim::AccuracyRow &row : m_report.found.rows) {
            const bool isInUse = row.way.method->id() == m_report.inUse.method->id() &&
                                 row.way.step == m_report.inUse.step && isDrawn(row);
            if (!isInUse)
                continue;
            element("circle", {{"cx", px(at(row).x())},
                               {"cy", px(at(row).y())},
                               {"r", "9"},
                               {"fill", "none"},
                               {"stroke", now},
                               {"stroke-width", "3"}});
            text(at(row) + QPointF(14, -8), Text::tr("in use"), {{"fill", ink}});
        }
    }

    /// The name of each method, level with the end of its ladder where there is room.
    void drawNames()
    {
        std::vector<const Ladder *> sorted;
        for (const Ladder &ladder : m_ladders)
            sorted.push_back(&ladder);
        const auto end = [this](const Ladder *ladder) { return at(*ladder->rows.back()); };
        std::sort(sorted.begin(), sorted.end(),
                  [&](const Ladder *a, const Ladder *b) { return end(a).y() < end(b).y(); });
        std::vector<double> places;
        for (const Ladder *ladder : sorted)
            places.push_back(end(ladder).y());
        spreadOut(places, 22, top, bottom);
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            const QPointF name(right + 34, places[i]);
            line(end(sorted[i]) + QPointF(7, 0), name - QPointF(10, 0), faint, "1");
            drawSign(name, *sorted[i], paper);
            text(name + QPointF(12, 4), phrase(sorted[i]->rows.front()->way.method->title()),
                 {{"fill", ink}});
        }
    }

    const AccuracyReport &m_report;
    std::vector<Ladder> m_ladders;
    LogAxis m_times;
    LogAxis m_errors;
    QByteArray m_text;
    QXmlStreamWriter m_svg;
};

}

QByteArray accuracyPlot(const AccuracyReport &report)
{
    return Plot(report).draw();
}

}
