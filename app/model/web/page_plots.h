#pragma once

#include "app/model/series/plot_list.h"
#include "app/model/web/number_columns.h"

namespace app {

class JsonWriter;

/// The plots of a web page.
class PagePlots
{
public:
    /// `plots` must name their bodies.
    explicit PagePlots(std::vector<PlotSpec> plots);

    /// Adds the next frame, at `state` of a scene. `before` is the state one output step earlier, `frames` frames; null
    /// at the start.
    void add(const std::shared_ptr<const sim::ComposedInterval> &interval, const sim::State &state,
             const sim::State *before, double frames);
    void write(JsonWriter &json, NumberColumns &columns) const;

private:
    void writeAxis(JsonWriter &json, NumberColumns &columns, const QString &name,
                   const Quantity &quantity) const;

    std::vector<PlotSpec> m_plots;
    std::vector<Quantity> m_quantities; ///< each once
    std::vector<std::vector<double>> m_values;
    QuantityReader m_reader;
    bool m_turns = false; ///< whether the points of the scene turn
};

}
