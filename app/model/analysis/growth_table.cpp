#include "app/model/analysis/growth_table.h"

#include "app/model/text/csv.h"

#include <QCoreApplication>

namespace app {

namespace {

struct GrowthTableText
{
    Q_DECLARE_TR_FUNCTIONS(GrowthTableText)
};

/// Returns the id of the parameter, as in an experiment file.
QByteArray titleOf(const sim::MapAxis &axis)
{
    return quotedField(axis.parameter.empty() ? GrowthTableText::tr("step [frames]")
                                              : QString::fromStdString(axis.parameter));
}

}

QByteArray growthTable(const sim::GrowthMap &map)
{
    if (map.growth.empty())
        return {};
    QByteArray text = titleOf(map.x) + ',' + titleOf(map.y) + ',' +
                      quotedField(GrowthTableText::tr("growth [a frame]")) + '\n';
    const std::size_t columns = map.x.values.size();
    for (std::size_t i = 0; i < map.growth.size(); ++i) {
        appendNumber(text, map.x.values[i % columns]);
        text += ',';
        appendNumber(text, map.y.values[i / columns]);
        text += ',';
        appendNumber(text, map.growth[i]);
        text += '\n';
    }
    return text;
}

}
