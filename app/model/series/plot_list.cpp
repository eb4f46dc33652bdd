#include "app/model/series/plot_list.h"

#include "app/model/catalog/lists.h"
#include "sim/base/error.h"
#include "sim/run/track.h"

#include <QSettings>

#include <algorithm>

namespace app {

namespace {

const char *const key = "plots/list";

constexpr int framesAhead = 90;           ///< frames of a run to examine its motion
constexpr std::int64_t mostWork = 20'000; ///< limit of that computation: points times phases
constexpr double mostAside = 0.05; ///< a body moves in x alone if its motion in y is below this fraction

/// Returns the extent of the first body's path in x and in y, over the first frames of `run`.
sim::Vec2 wayOfFirst(sim::Track &run)
{
    sim::Vec2 low = run.state().positionOf(0), high = low;
    std::int64_t left = mostWork / run.state().pointCount();
    const auto goesOn = [&left] { return --left > 0; };
    for (std::int64_t frame = run.framesPerOutput(); frame <= framesAhead && left > 0;
         frame += run.framesPerOutput()) {
        if (!run.seek({frame, 0}, goesOn) || run.stop())
            break;
        const sim::Vec2 at = run.state().positionOf(0);
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    return high - low;
}

bool isOfABody(const Quantity &quantity)
{
    return aboutOf(quantity.what) != About::run;
}

void write(QSettings &settings, const QString &prefix, const Quantity &quantity)
{
    settings.setValue(prefix + "what", idOf(quantity.what));
    settings.setValue(prefix + "body", quantity.body);
    settings.setValue(prefix + "other", quantity.other);
}

/// Returns the stored quantity. Empty if the settings are invalid, because users can edit their file.
std::optional<Quantity> read(const QSettings &settings, const QString &prefix)
{
    const std::optional<QuantityKind> what = quantityKindFrom(settings.value(prefix + "what").toString());
    if (!what)
        return std::nullopt;
    return Quantity{*what, settings.value(prefix + "body").toString(),
                    settings.value(prefix + "other").toString()};
}

}

bool PlotSpec::isPinned() const
{
    return (isOfABody(up) && !up.body.isEmpty()) || (isOfABody(across) && !across.body.isEmpty());
}

PlotList::PlotList(QObject *parent) : QObject(parent)
{
    QSettings settings;
    m_isChosen = settings.contains(QString::fromLatin1(key) + "/size");
    const int count = std::min(settings.beginReadArray(key), static_cast<int>(most));
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        const std::optional<Quantity> up = read(settings, "up_"), across = read(settings, "across_");
        if (up && across)
            m_plots.push_back({*up, *across});
    }
    settings.endArray();
}

void PlotList::open(const sim::Script &script)
{
    if (m_isChosen)
        return;
    const PlotSpec first = firstPlot(script);
    if (m_plots.size() == 1 && m_plots.front() == first)
        return;
    m_plots = {first};
    emit changed();
}

void PlotList::add(const PlotSpec &plot)
{
    if (isFull())
        return;
    m_plots.push_back(plot);
    keep();
}

void PlotList::remove(std::size_t index)
{
    if (index >= m_plots.size())
        return;
    m_plots.erase(m_plots.begin() + static_cast<std::ptrdiff_t>(index));
    keep();
}

void PlotList::change(std::size_t index, const PlotSpec &plot)
{
    if (index >= m_plots.size() || m_plots[index] == plot)
        return;
    m_plots[index] = plot;
    keep();
}

void PlotList::renameBody(const QString &from, const QString &to)
{
    const std::vector<PlotSpec> before = m_plots;
    for (PlotSpec &plot : m_plots) {
        for (QString *name : {&plot.up.body, &plot.up.other, &plot.across.body, &plot.across.other}) {
            if (*name == from)
                *name = to;
        }
    }
    if (m_plots != before)
        keep();
}

void PlotList::keep()
{
    m_isChosen = true;
    QSettings settings;
    settings.remove(key);
    settings.beginWriteArray(key, static_cast<int>(m_plots.size()));
    for (std::size_t i = 0; i < m_plots.size(); ++i) {
        settings.setArrayIndex(static_cast<int>(i));
        write(settings, "up_", m_plots[i].up);
        write(settings, "across_", m_plots[i].across);
    }
    settings.endArray();
    emit changed();
}

std::vector<Quantity> quantitiesOf(const std::vector<PlotSpec> &plots)
{
    std::vector<Quantity> all;
    for (const PlotSpec &plot : plots) {
        for (const Quantity &one : {plot.up, plot.across}) {
            if (!contains(all, one))
                all.push_back(one);
        }
    }
    return all;
}

PlotSpec pinned(PlotSpec plot, const QString &selected)
{
    plot.up = boundTo(plot.up, selected);
    plot.across = boundTo(plot.across, selected);
    return plot;
}

PlotSpec unpinned(PlotSpec plot)
{
    plot.up.body.clear();
    plot.across.body.clear();
    return plot;
}

PlotSpec firstPlot(const sim::Script &script)
{
    try {
        sim::Track run(script, 0);
        if (run.state().angle.rows() > 0)
            return {{QuantityKind::angle}, {}};
        const sim::Vec2 way = wayOfFirst(run);
        return {{way.y < mostAside * way.x ? QuantityKind::placeX : QuantityKind::placeY}, {}};
    } catch (const sim::Error &) {
        return {{QuantityKind::placeY}, {}}; // the session reports why it cannot run
    }
}

}
