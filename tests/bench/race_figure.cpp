#include "race_figure.h"

#include "creature_in_air.h"

#include "app/cli/plot_axis.h"
#include "app/cli/svg_drawing.h"

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

using app::Sign;
using app::SvgDrawing;

constexpr double width = 960, height = 560;
constexpr double left = 76, right = 700, top = 96, bottom = 420; ///< of the axes
constexpr double inset = 60; ///< of the first and last error from their ends

/// What one team takes at each error.
struct Series
{
    QString title;
    Sign sign;
    std::vector<double> microseconds; ///< a frame, at each of air::errors; 0 where there is none
    QStringList solvers;              ///< who ran
};

Series seriesOf(std::size_t team, const QString &title, const Measurements &medians)
{
    Series series{title, app::signOf(team), {}, {}};
    for (const double error : air::errors) {
        const auto found = medians.find(air::nameOf(air::teams[team], error));
        const bool isThere = found != medians.end();
        series.microseconds.push_back(isThere ? found->second.nanoseconds / 1e3 / air::frames : 0.0);
        const QString label = isThere ? QString::fromStdString(found->second.label) : QString();
        series.solvers.push_back(label.section(" at ", 0, 0).section(", ", 0, 0)); // the name alone
    }
    return series;
}

std::vector<double> allNumbers(const std::vector<Series> &all)
{
    std::vector<double> numbers;
    for (const Series &series : all)
        numbers.insert(numbers.end(), series.microseconds.begin(), series.microseconds.end());
    return numbers;
}

class Figure
{
public:
    explicit Figure(std::vector<Series> all)
        : m_all(std::move(all)),
          m_errors({air::errors.begin(), air::errors.end()}, right - inset, left + inset),
          m_times(allNumbers(m_all), bottom, top), m_svg(width, height)
    {
    }

    QByteArray draw()
    {
        drawTitle();
        drawGrid();
        for (std::size_t other = 1; other < m_all.size(); ++other)
            drawRatios(m_all[0], m_all[other]);
        for (const Series &series : m_all)
            drawSeries(series);
        drawNames();
        drawSolvers();
        return m_svg.finish();
    }

private:
    QPointF at(const Series &series, std::size_t i) const
    {
        return {m_errors.at(air::errors[i]), m_times.at(series.microseconds[i])};
    }

    void drawTitle()
    {
        m_svg.text({left, 32}, "What exactness costs: a creature in the air",
                   {{"fill", SvgDrawing::ink}, {"font-weight", "600"}, {"font-size", "16"}});
        const auto words = [this](double y, const QString &line) {
            m_svg.text({left, y}, line, {{"fill", SvgDrawing::caption}});
        };
        words(54,
              QStringLiteral(
                  "A body with five feet, %1 frames, one core: the fastest solver of each within an error")
                  .arg(air::frames));
        words(74, "Between two lines: how many times as long the upper one takes");
    }

    void drawGrid()
    {
        for (const double error : air::errors) {
            const double x = m_errors.at(error);
            m_svg.line({x, top}, {x, bottom}, SvgDrawing::faint, "1");
            m_svg.power({x, bottom + 20}, static_cast<int>(std::lround(std::log10(error))), "middle");
        }
        for (int decade = m_times.first(); decade <= m_times.last(); ++decade) {
            const double y = m_times.at(std::pow(10.0, decade));
            m_svg.line({left, y}, {right, y}, SvgDrawing::faint, "1");
            m_svg.text({left - 10, y + 4}, QString::number(std::pow(10.0, decade)),
                       {{"text-anchor", "end"}, {"fill", SvgDrawing::caption}});
        }
        m_svg.text({left - 10, bottom + 20}, "error, px",
                   {{"fill", SvgDrawing::caption}, {"text-anchor", "middle"}});
        m_svg.text({20, top}, QStringLiteral("time, \u00b5s a frame"),
                   {{"fill", SvgDrawing::caption},
                    {"text-anchor", "end"},
                    {"transform", QStringLiteral("rotate(-90 20 %1)").arg(top)}});
    }

    void drawSeries(const Series &series)
    {
        std::vector<QPointF> points;
        for (std::size_t i = 0; i < air::errors.size(); ++i) {
            if (series.microseconds[i] > 0.0)
                points.push_back(at(series, i));
        }
        m_svg.polyline(points, series.sign.color, "2.2");
        for (const QPointF &point : points)
            m_svg.sign(point, series.sign, series.sign.color);
    }

    /// Between two series, how many times as long the slower one takes.
    void drawRatios(const Series &ours, const Series &other)
    {
        for (std::size_t i = 0; i < air::errors.size(); ++i) {
            if (other.microseconds[i] <= 0.0)
                continue;
            const QPointF a = at(ours, i), b = at(other, i);
            m_svg.line(a, b, other.sign.color, "1");
            const double share = ours.microseconds[i] / other.microseconds[i];
            const double times = std::max(share, 1.0 / share);
            m_svg.text((a + b) / 2 + QPointF(8, 4),
                       QString::number(times, 'f', times < 9.95 ? 1 : 0) + QChar(0x00d7),
                       {{"fill", SvgDrawing::ink}, {"font-weight", "600"}});
        }
    }

    /// Each beside the end of its line.
    void drawNames()
    {
        std::vector<std::pair<double, const Series *>> ends;
        for (const Series &series : m_all) {
            std::size_t last = air::errors.size();
            while (series.microseconds[last - 1] <= 0.0)
                --last;
            ends.emplace_back(at(series, last - 1).y(), &series);
        }
        std::sort(ends.begin(), ends.end());
        std::vector<double> places;
        for (const auto &[y, series] : ends)
            places.push_back(y);
        app::spreadOut(places, 20, top, bottom);
        for (std::size_t i = 0; i < ends.size(); ++i)
            m_svg.text({right + 16, places[i] + 4}, ends[i].second->title,
                       {{"fill", ends[i].second->sign.color}, {"font-weight", "600"}});
    }

    /// Below each error, who was the fastest of each team.
    void drawSolvers()
    {
        double y = bottom + 56;
        for (const Series &series : m_all) {
            m_svg.sign({left - 20, y - 4}, series.sign, series.sign.color);
            m_svg.text({right + 16, y}, series.title, {{"fill", SvgDrawing::caption}});
            for (std::size_t i = 0; i < air::errors.size(); ++i)
                m_svg.text({m_errors.at(air::errors[i]), y}, series.solvers[qsizetype(i)],
                           {{"fill", SvgDrawing::ink}, {"text-anchor", "middle"}, {"font-size", "12"}});
            y += 22;
        }
    }

    std::vector<Series> m_all; ///< ours first
    app::LogAxis m_errors;
    app::LogAxis m_times;
    SvgDrawing m_svg;
};

bool isWhole(const Series &series)
{
    return std::all_of(series.microseconds.begin(), series.microseconds.end(),
                       [](double us) { return us > 0.0; });
}

bool isAny(const Series &series)
{
    return std::any_of(series.microseconds.begin(), series.microseconds.end(),
                       [](double us) { return us > 0.0; });
}

}

std::string raceFigure(const Measurements &medians)
{
    static constexpr std::array titles = {"Springstep", "odeint (Boost)", "CVODE (SUNDIALS)"};
    std::vector<Series> all;
    for (std::size_t team = 0; team < titles.size(); ++team) {
        const Series series = seriesOf(team, titles[team], medians);
        if (team == 0 ? isWhole(series) : !all.empty() && isAny(series))
            all.push_back(series);
    }
    return all.size() < 2 ? std::string() : Figure(std::move(all)).draw().toStdString();
}

}
