#include "tests/bench/race_figure.h"

#include "tests/bench/peers/creature_in_air.h"

#include "app/ui/accuracy/study_marks.h"
#include "app/ui/plots/plot.h"
#include "app/ui/plots/plot_picture.h"

#include <QBuffer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bench {

namespace {

constexpr QSize size(960, 528);
constexpr int left = 84, right = 170, top = 48, bottom = 130; ///< px, the margins around the axes
constexpr double solverLine = 20.0;                           ///< px, height of a line of solvers or names

/// The time of one team at each error.
struct Series
{
    QString title;
    QColor color;
    QCPScatterStyle::ScatterShape shape;
    std::vector<double> microseconds; ///< per frame, at each of air::errors; 0 where the team has none
    QStringList solvers;              ///< the solver that ran at each error
};

bool hasAll(const Series &series)
{
    return std::all_of(series.microseconds.begin(), series.microseconds.end(),
                       [](double time) { return time > 0.0; });
}

bool hasAny(const Series &series)
{
    return std::any_of(series.microseconds.begin(), series.microseconds.end(),
                       [](double time) { return time > 0.0; });
}

std::vector<Series> allSeries(const Measurements &medians)
{
    // Colours of Okabe and Ito, darkened for a light ground: people with any kind of colour vision can tell them apart.
    std::vector<Series> all = {
        {"Springstep", "#0072b2", QCPScatterStyle::ssDisc, {}, {}},
        {"odeint (Boost)", "#c04f00", QCPScatterStyle::ssSquare, {}, {}},
        {"CVODE (SUNDIALS)", "#00805d", QCPScatterStyle::ssTriangle, {}, {}},
    };
    for (std::size_t team = 0; team < all.size(); ++team) {
        for (const double error : air::errors) {
            const auto found = medians.find(air::nameOf(air::teams[team], error));
            const bool isMeasured = found != medians.end();
            all[team].microseconds.push_back(isMeasured ? found->second.nanoseconds / 1e3 / air::frames
                                                        : 0.0);
            const QString label = isMeasured ? QString::fromStdString(found->second.label) : QString();
            all[team].solvers << label.section(" at ", 0, 0).section(", ", 0, 0);
        }
    }
    return all;
}

/// The figure: error on the horizontal axis, from large to small; time on the vertical one.
class Figure
{
public:
    explicit Figure(std::vector<Series> all) : m_all(std::move(all))
    {
        m_plot.resize(size);
        m_plot.setBackground(m_theme.tokens().panel);
        m_plot.axisRect()->setAutoMargins(QCP::msNone);
        m_plot.axisRect()->setMargins({left, top, right, bottom});
        setUpAxis(*m_plot.xAxis, "error, px");
        setUpAxis(*m_plot.yAxis, "time, µs per frame");
        m_plot.xAxis->setRangeReversed(true);
        m_plot.xAxis->setRange(air::errors.back() / 5.0, air::errors.front() * 5.0);
        addText("A body with five feet, " + QString::number(air::frames) +
                    " frames, one core: the fastest solver of each within an error.\n"
                    "Between two lines: how many times as long the upper one takes.",
                {double(left), 4.0}, Qt::AlignLeft | Qt::AlignTop);
        for (std::size_t team = 0; team < m_all.size(); ++team) {
            if (team > 0)
                addRatios(m_all[0], m_all[team]);
            addSeries(m_all[team], size.height() - bottom + 48 + solverLine * double(team));
        }
        m_plot.yAxis->rescale();
        const QCPRange times = m_plot.yAxis->range();
        m_plot.yAxis->setRange(times.lower / 1.5, times.upper * 1.5);
        addNames();
    }

    QByteArray svg()
    {
        const app::PlotPicture picture{
            "The cost of accuracy: a creature in the air", "race", size,
            [this](QCPPainter &painter) { m_plot.toPainter(&painter, size.width(), size.height()); }};
        QBuffer file;
        file.open(QIODevice::WriteOnly);
        return app::writeSvg(file, picture, m_theme) ? file.data() : QByteArray();
    }

private:
    void setUpAxis(QCPAxis &axis, const QString &label)
    {
        app::styleAxis(axis, m_theme);
        app::makeLogarithmic(axis);
        axis.setLabel(label);
        axis.setLabelFont(m_theme.ui(12));
        axis.setLabelColor(m_theme.tokens().ink3);
    }

    /// Adds a text at a place in px of the picture.
    QCPItemText &addText(const QString &words, QPointF place, Qt::Alignment alignment)
    {
        auto *text = new QCPItemText(&m_plot);
        text->position->setType(QCPItemPosition::ptAbsolute);
        text->position->setCoords(place);
        text->setClipToAxisRect(false);
        text->setPositionAlignment(alignment);
        text->setTextAlignment(Qt::AlignLeft);
        text->setText(words);
        text->setFont(m_theme.ui(12));
        text->setColor(m_theme.tokens().ink2);
        return *text;
    }

    /// Adds the line of a team with its name, and its solvers below the axis at `y` px.
    void addSeries(const Series &series, double y)
    {
        QCPGraph &graph = *m_plot.addGraph();
        graph.setPen(QPen(series.color, 2.2));
        graph.setScatterStyle(QCPScatterStyle(series.shape, series.color, series.color, 9.0));
        addText(series.title, {size.width() - right + 12.0, y}, Qt::AlignLeft | Qt::AlignVCenter)
            .setColor(series.color);
        for (std::size_t i = 0; i < air::errors.size(); ++i) {
            if (!(series.microseconds[i] > 0.0))
                continue;
            graph.addData(air::errors[i], series.microseconds[i]);
            QCPItemText &solver =
                addText(series.solvers[qsizetype(i)], {}, Qt::AlignHCenter | Qt::AlignVCenter);
            solver.position->setTypeX(QCPItemPosition::ptPlotCoords);
            solver.position->setCoords(air::errors[i], y);
        }
    }

    /// Returns the index of the last error at which a team was measured.
    static std::size_t lastOf(const Series &series)
    {
        const auto last = std::find_if(series.microseconds.rbegin(), series.microseconds.rend(),
                                       [](double time) { return time > 0.0; });
        return std::size_t(series.microseconds.rend() - last) - 1;
    }

    /// Adds the names of the teams beside the ends of their lines, below one another.
    void addNames()
    {
        const QCPRange times = m_plot.yAxis->range();
        const double height = size.height() - top - bottom;
        std::vector<std::pair<double, const Series *>> names; // px from the upper edge
        for (const Series &one : m_all) {
            const double share =
                std::log(times.upper / one.microseconds[lastOf(one)]) / std::log(times.upper / times.lower);
            names.emplace_back(top + share * height, &one);
        }
        std::sort(names.begin(), names.end());
        double least = 0.0;
        for (const auto &[y, series] : names) {
            QCPItemText &name = addText(series->title, {}, Qt::AlignLeft | Qt::AlignVCenter);
            name.position->setTypeX(QCPItemPosition::ptPlotCoords);
            name.position->setCoords(air::errors[lastOf(*series)], std::max(y, least));
            name.setPadding({14, 0, 0, 0});
            name.setColor(series->color);
            name.setFont(m_theme.ui(12, QFont::DemiBold));
            least = std::max(y, least) + solverLine;
        }
    }

    /// Returns the time on the line of a team a tenth of the way from one error to another: at the middle of a label.
    static double timeTowards(const Series &series, std::size_t from, std::size_t to)
    {
        const double a = series.microseconds[from], b = series.microseconds[to];
        return b > 0.0 ? a * std::pow(b / a, 0.1) : a;
    }

    /// Adds lines between two series, each with the ratio of the longer time to the shorter one. The last ratio is on the
    /// left of its line.
    void addRatios(const Series &ours, const Series &other)
    {
        for (std::size_t i = 0; i < air::errors.size(); ++i) {
            const double a = ours.microseconds[i], b = other.microseconds[i];
            if (!(b > 0.0))
                continue;
            auto *line = new QCPItemLine(&m_plot);
            line->start->setCoords(air::errors[i], a);
            line->end->setCoords(air::errors[i], b);
            line->setPen(QPen(other.color, 1.0));
            const double times = std::max(a / b, b / a);
            const bool isLast = i + 1 == air::errors.size(); // the names are on its right
            QCPItemText &text = addText(QString::number(times, 'f', times < 9.95 ? 1 : 0) + QChar(0x00d7), {},
                                        (isLast ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
            text.position->setType(QCPItemPosition::ptPlotCoords);
            const std::size_t to = isLast ? i - 1 : i + 1; // the side of the label
            text.position->setCoords(air::errors[i],
                                     std::sqrt(timeTowards(ours, i, to) * timeTowards(other, i, to)));
            text.setPadding(isLast ? QMargins{0, 0, 6, 0} : QMargins{6, 0, 0, 0});
            text.setFont(m_theme.ui(12, QFont::DemiBold));
        }
    }

    std::vector<Series> m_all; ///< ours first
    const app::Theme m_theme{app::Scheme::light};
    QCustomPlot m_plot;
};

}

std::string raceFigure(const Measurements &medians)
{
    std::vector<Series> all = allSeries(medians);
    if (!hasAll(all.front()))
        return {};
    std::erase_if(all, [](const Series &series) { return !hasAny(series); });
    return all.size() < 2 ? std::string() : Figure(std::move(all)).svg().toStdString();
}

}
