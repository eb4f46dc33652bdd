#include "app/model/series/energy_table.h"

#include "app/model/analysis/energy_lines.h"
#include "app/model/text/csv.h"
#include "app/model/text/phrases.h"

#include <QCoreApplication>

namespace app {

namespace {

struct EnergyTableText
{
    Q_DECLARE_TR_FUNCTIONS(EnergyTableText)
};

/// Returns the title of a column: its id, as in the files of the command line, and its unit.
QByteArray title(const QString &id, const QString &unit)
{
    return ',' + quotedField(QStringLiteral("%1 [%2]").arg(id, unit));
}

QString idOf(const sim::AccountName &name)
{
    return QString::fromStdString(name.id);
}

/// Writes `titles`, and then for each counted output step its frame and the text from `write`.
template <class Write>
QByteArray rowsOf(const EnergySeries &series, const QByteArray &titles, Write &&write)
{
    if (series.last() < series.first())
        return {};
    QByteArray text = quotedField(frameHeading()) + titles + '\n';
    for (std::int64_t frame = series.first(); frame <= series.last(); frame += series.framesPerOutput()) {
        text += QByteArray::number(static_cast<qlonglong>(frame));
        write(text, *series.at(frame));
        text += '\n';
    }
    return text;
}

}

QByteArray energyTable(const EnergySeries &series)
{
    const QString unit = energyUnit(series.run().timeline().state().spin.rows() > 0);
    QByteArray titles;
    for (const char *held : {"moving", "height", "springs"})
        titles += title(QString::fromLatin1(held), unit);
    for (const sim::AccountName &name : sim::accountNames())
        titles += title(idOf(name), unit);
    titles += title(QStringLiteral("doubt"), unit);
    return rowsOf(series, titles, [](QByteArray &text, const sim::Balance &balance) {
        for (const double held : {balance.after.moving, balance.after.gravity, balance.after.springs})
            appendField(text, held);
        for (const sim::AccountName &name : sim::accountNames())
            appendField(text, balance.energy[name.account]);
        appendField(text, balance.errorEstimate);
    });
}

QByteArray momentumTable(const EnergySeries &series)
{
    QByteArray titles;
    const auto addPair = [&titles](const QString &id) {
        for (const char *axis : {"_x", "_y"})
            titles += title(id + QString::fromLatin1(axis), momentumUnit());
    };
    addPair(QStringLiteral("momentum"));
    for (const sim::AccountName &name : sim::accountNames())
        addPair(idOf(name));
    return rowsOf(series, titles, [](QByteArray &text, const sim::Balance &balance) {
        const auto addBoth = [&text](sim::Vec2 push) {
            appendField(text, push.x);
            appendField(text, push.y);
        };
        addBoth(balance.after.momentum);
        for (const sim::AccountName &name : sim::accountNames())
            addBoth(balance.momentum[name.account]);
    });
}

}
