#include "app/model/web/page_plots.h"

#include "app/model/text/json_writer.h"
#include "app/model/text/quantity_text.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>

namespace app {

PagePlots::PagePlots(std::vector<PlotSpec> plots)
    : m_plots(std::move(plots)), m_quantities(quantitiesOf(m_plots)), m_values(m_quantities.size())
{
}

void PagePlots::add(const std::shared_ptr<const sim::ComposedInterval> &interval, const sim::State &state,
                    const sim::State *before, double frames)
{
    if (m_reader.segment() != interval.get())
        m_reader = QuantityReader(m_quantities, interval);
    m_turns = state.angle.rows() > 0;
    const bool isSameScene = before && before->pointCount() == state.pointCount();
    std::vector<double> row(m_quantities.size());
    m_reader.read({state, isSameScene ? before : nullptr, frames}, row);
    for (std::size_t i = 0; i < row.size(); ++i)
        m_values[i].push_back(row[i]);
}

void PagePlots::writeAxis(JsonWriter &json, NumberColumns &columns, const QString &name,
                          const Quantity &quantity) const
{
    const auto found = std::find(m_quantities.begin(), m_quantities.end(), quantity);
    json.beginObject(name);
    json.field("title", quantityTitle(quantity));
    json.field("unit", unitOf(quantity.what, m_turns));
    json.field("down", pointsDown(quantity.what));
    json.field("values", columns.addShort(m_values[static_cast<std::size_t>(found - m_quantities.begin())]));
    json.endObject();
}

void PagePlots::write(JsonWriter &json, NumberColumns &columns) const
{
    json.beginList("plots");
    for (const PlotSpec &plot : m_plots) {
        json.beginObject(JsonWriter::Layout::oneLine);
        writeAxis(json, columns, "up", plot.up);
        if (!plot.isAgainstTime())
            writeAxis(json, columns, "across", plot.across);
        json.endObject();
    }
    json.endList();
}

}
