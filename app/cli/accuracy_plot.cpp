#include "app/cli/accuracy_plot.h"

#include "app/cli/plot_axis.h"
#include "app/cli/svg_drawing.h"
#include "app/model/sentences.h"
#include "app/model/words.h"
#include "sim/pipeline/method.h"

#include <QCoreApplication>
#include <QPointF>

#include <algorithm>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Accuracy)
};

constexpr double width = 960, height = 600;
constexpr double left = 76, right = 720, top = 64, bottom = 530; ///< of the axes; names stand right of them

constexpr auto now = "#f5b301", shade = "#d8d5ce";

/// The measured rows of one method, from coarse to fine.
struct Ladder
{
    std::vector<const sim::AccuracyRow *> rows;
    Sign sign;
};

class Plot
{
public:
    explicit Plot(const AccuracyReport &report)
        : m_report(report), m_ladders(laddersOf(report.found)),
          m_times(numbers(report.found, &sim::AccuracyRow::nsPerFrame), left, right),
          m_errors(numbers(report.found, &sim::AccuracyRow::error), bottom, top), m_svg(width, height)
    {
    }

    QByteArray draw()
    {
        drawTitle();
        drawGrid();
        drawFront();
        for (const Ladder &ladder : m_ladders)
            drawLadder(ladder);
        drawInUse();
        drawNames();
        return m_svg.finish();
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
            const bool isNew = row.setup.method.get() != method;
            method = row.setup.method.get();
            if (isNew)
                ++count;
            if (!isDrawn(row))
                continue;
            if (ladders.empty() || ladders.back().rows.front()->setup.method->id() != method->id())
                ladders.push_back({{}, signOf(count - 1)});
            ladders.back().rows.push_back(&row);
        }
        return ladders;
    }

    QPointF at(const sim::AccuracyRow &row) const
    {
        return {m_times.at(row.nsPerFrame), m_errors.at(row.error)};
    }

    void drawTitle()
    {
        const sim::Accuracy &found = m_report.found;
        m_svg.text({left, 28}, m_report.experiment,
                   {{"fill", SvgDrawing::ink}, {"font-weight", "600"}, {"font-size", "16"}});
        const QString how = Text::tr("%1 frames; reference %2, known to %3 px")
                                .arg(found.horizon)
                                .arg(QString::fromStdString(found.reference.method),
                                     withoutPadding(QString::number(found.reference.disagreement, 'g', 2)));
        m_svg.text({left, 48}, how, {{"fill", SvgDrawing::caption}});
    }

    void drawGrid()
    {
        for (int decade = m_times.first(); decade <= m_times.last(); decade += m_times.stride()) {
            const double x = m_times.at(std::pow(10.0, decade));
            m_svg.line({x, top}, {x, bottom}, SvgDrawing::faint, "1");
            m_svg.power({x, bottom + 20}, decade, "middle");
        }
        for (int decade = m_errors.first(); decade <= m_errors.last(); decade += m_errors.stride()) {
            const double y = m_errors.at(std::pow(10.0, decade));
            m_svg.line({left, y}, {right, y}, SvgDrawing::faint, "1");
            m_svg.power({left - 10, y + 4}, decade, "end");
        }
        m_svg.text({right, bottom + 44}, Text::tr("time, ns a frame"),
                   {{"fill", SvgDrawing::caption}, {"text-anchor", "end"}});
        m_svg.text(
            {18, top}, Text::tr("error, px"),
            {{"fill", SvgDrawing::caption}, {"text-anchor", "end"}, {"transform", "rotate(-90 18 64)"}});
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
        std::vector<QPointF> points;
        for (const sim::AccuracyRow *row : rows)
            points.push_back(at(*row));
        m_svg.polyline(points, color, thickness);
    }

    void drawLadder(const Ladder &ladder)
    {
        polyline(ladder.rows, ladder.sign.color, "1.8");
        for (const sim::AccuracyRow *row : ladder.rows) {
            const double y = at(*row).y();
            m_svg.line({m_times.at(row->nsPerFrame - row->spread), y},
                       {m_times.at(row->nsPerFrame + row->spread), y}, ladder.sign.color, "1");
            m_svg.sign(at(*row), ladder.sign, row->front ? ladder.sign.color : QString(SvgDrawing::paper));
        }
    }

    void drawInUse()
    {
        for (const sim::AccuracyRow &row : m_report.found.rows) {
            const bool isInUse = row.setup.method->id() == m_report.inUse.method->id() &&
                                 row.setup.step == m_report.inUse.step && isDrawn(row);
            if (!isInUse)
                continue;
            m_svg.ring(at(row), 9, now, "3");
            m_svg.text(at(row) + QPointF(14, -8), Text::tr("in use"), {{"fill", SvgDrawing::ink}});
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
            m_svg.line(end(sorted[i]) + QPointF(7, 0), name - QPointF(10, 0), SvgDrawing::faint, "1");
            m_svg.sign(name, sorted[i]->sign, SvgDrawing::paper);
            m_svg.text(name + QPointF(12, 4), phrase(sorted[i]->rows.front()->setup.method->title()),
                       {{"fill", SvgDrawing::ink}});
        }
    }

    const AccuracyReport &m_report;
    std::vector<Ladder> m_ladders;
    LogAxis m_times;
    LogAxis m_errors;
    SvgDrawing m_svg;
};

}

QByteArray accuracyPlot(const AccuracyReport &report)
{
    return Plot(report).draw();
}

}
