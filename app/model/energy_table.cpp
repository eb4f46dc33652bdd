#include "app/model/energy_table.h"

#include "app/model/csv_text.h"
#include "app/model/energy_lines.h"

#include <QCoreApplication>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(EnergyLines)
};

/// A column is called by its id, as in the files of the command line, with its unit.
QByteArray title(const QString &id, const QString &unit)
{
    return ',' + quotedField(QStringLiteral("%1 [%2]").arg(id, unit));
}

QString idOf(const sim::AccountName &name)
{
    return QString::fromStdString(name.id);
}

void append(QByteArray &text, double value)
{
    text += ',';
    appendNumber(text, value);
}

/// `titles`, and then of each row that is counted its frame and what `write` adds.
template <class Write>
QByteArray rowsOf(const EnergyCourse &course, const QByteArray &titles, Write &&write)
{
    if (course.last() < course.first())
        return {};
    QByteArray text = quotedField(Text::tr("frame")) + titles + '\n';
    for (std::int64_t frame = course.first(); frame <= course.last(); frame += course.rowFrames()) {
        text += QByteArray::number(static_cast<qlonglong>(frame));
        write(text, *course.at(frame));
        text += '\n';
    }
    return text;
}

}

QByteArray energyTable(const EnergyCourse &course)
{
    const QString unit = energyUnit(course.session().timeline().state().spin.rows() > 0);
    QByteArray titles;
    for (const char *held : {"moving", "height", "springs"})
        titles += title(QString::fromLatin1(held), unit);
    for (const sim::AccountName &name : sim::accountNames())
        titles += title(idOf(name), unit);
    titles += title(QStringLiteral("doubt"), unit);
    return rowsOf(course, titles, [](QByteArray &text, const sim::Balance &balance) {
        for (const double held : {balance.after.moving, balance.after.gravity, balance.after.springs})
            append(text, held);
        for (const sim::AccountName &name : sim::accountNames())
            append(text, balance.energy[name.account]);
        append(text, balance.errorEstimate);
    });
}

QByteArray momentumTable(const EnergyCourse &course)
{
    QByteArray titles;
    const auto addPair = [&titles](const QString &id) {
        for (const char *axis : {"_x", "_y"})
            titles += title(id + QString::fromLatin1(axis), momentumUnit());
    };
    addPair(QStringLiteral("momentum"));
    for (const sim::AccountName &name : sim::accountNames())
        addPair(idOf(name));
    return rowsOf(course, titles, [](QByteArray &text, const sim::Balance &balance) {
        const auto addBoth = [&text](sim::Vec2 push) {
            append(text, push.x);
            append(text, push.y);
        };
        addBoth(balance.after.momentum);
        for (const sim::AccountName &name : sim::accountNames())
            addBoth(balance.momentum[name.account]);
    });
}

}
