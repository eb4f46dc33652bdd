#include "app/model/analysis/map_table.h"

#include "app/model/text/csv.h"

#include <QCoreApplication>

namespace app {

namespace {

struct MapTableText
{
    Q_DECLARE_TR_FUNCTIONS(MapTableText)
};

/// Returns the id of the parameter, as in an experiment file.
QByteArray titleOf(const sim::MapAxis &axis)
{
    return quotedField(axis.parameter.empty() ? MapTableText::tr("step [frames]")
                                              : QString::fromStdString(axis.parameter));
}

QByteArray titlesOf(const sim::MapAxis &x, const sim::MapAxis &y)
{
    return titleOf(x) + ',' + titleOf(y) + ',';
}

/// Appends the values of the axes at a cell, which are numbered by rows of `y`.
void appendPlace(QByteArray &text, const sim::MapAxis &x, const sim::MapAxis &y, std::size_t cell)
{
    appendNumber(text, x.values[cell % x.values.size()]);
    text += ',';
    appendNumber(text, y.values[cell / x.values.size()]);
    text += ',';
}

QString outcome(sim::Settling::Kind kind)
{
    switch (kind) {
    case sim::Settling::Kind::settles:
        return MapTableText::tr("at rest");
    case sim::Settling::Kind::moves:
        return MapTableText::tr("still moving");
    case sim::Settling::Kind::grows:
        return MapTableText::tr("grows");
    case sim::Settling::Kind::fails:
        break;
    }
    return MapTableText::tr("cannot be computed");
}

}

QByteArray growthTable(const sim::GrowthMap &map)
{
    if (map.growth.empty())
        return {};
    QByteArray text = titlesOf(map.x, map.y) + quotedField(MapTableText::tr("growth [a frame]")) + '\n';
    for (std::size_t i = 0; i < map.growth.size(); ++i) {
        appendPlace(text, map.x, map.y, i);
        appendNumber(text, map.growth[i]);
        text += '\n';
    }
    return text;
}

QByteArray settlingTable(const sim::SettlingMap &map)
{
    QByteArray rows;
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
        if (!map.cells[i])
            continue;
        appendPlace(rows, map.x, map.y, i);
        if (map.cells[i]->kind == sim::Settling::Kind::settles)
            appendNumber(rows, static_cast<double>(map.cells[i]->frames));
        rows += ',' + quotedField(outcome(map.cells[i]->kind)) + '\n';
    }
    if (rows.isEmpty())
        return {};
    return titlesOf(map.x, map.y) + quotedField(MapTableText::tr("time to rest [frames]")) + ',' +
           quotedField(MapTableText::tr("outcome")) + '\n' + rows;
}

}
