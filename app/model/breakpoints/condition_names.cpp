#include "app/model/breakpoints/condition_names.h"

#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "sim/pipeline/pipeline.h"
#include "sim/scene/scene.h"

#include <QCoreApplication>

#include <algorithm>

namespace app::condition_names {

namespace {

struct ConditionNamesText
{
    Q_DECLARE_TR_FUNCTIONS(ConditionNamesText)
};

using Kind = Condition::Operation::Kind;

}

void refuse(qsizetype place, const QString &why)
{
    throw UserError(ConditionNamesText::tr("Character %1: %2").arg(place).arg(why));
}

const QHash<QString, Kind> &bodyFunctions()
{
    static const QHash<QString, Kind> functions = {{"distance", Kind::distance},
                                                   {"speed", Kind::speed},
                                                   {"still", Kind::still},
                                                   {"held", Kind::held},
                                                   {"released", Kind::released}};
    return functions;
}

QString someOf(const QStringList &names)
{
    constexpr int most = 8;
    return names.mid(0, most).join(QStringLiteral(", ")) +
           (names.size() > most ? QStringLiteral(", …") : QString());
}

QStringList bodiesOf(const sim::Scene &scene)
{
    QStringList names;
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.names.size(), 9); ++i)
        names << QString::fromStdString(scene.names[i]);
    return names;
}

QStringList parametersOf(const sim::Values &values)
{
    QStringList ids;
    for (const auto &[id, value] : values.all())
        ids << QString::fromStdString(id);
    return ids;
}

std::map<QString, QStringList> choicesOf(const lessons::Step &step)
{
    std::map<QString, QStringList> choices;
    for (const lessons::Parameter &parameter : step.parameters) {
        if (!parameter.choices.isEmpty())
            choices[parameter.id] = parameter.choices;
    }
    return choices;
}

QStringList phasesOf(const sim::Pipeline &pipeline)
{
    QStringList titles;
    for (const sim::Phase &phase : pipeline.phases)
        titles << phrase(phase.title);
    titles.removeDuplicates();
    return titles;
}

QHash<QString, Kind> membersOf(const sim::State &state)
{
    QHash<QString, Kind> members = {{"x", Kind::x}, {"y", Kind::y}, {"vx", Kind::vx}, {"vy", Kind::vy}};
    if (state.angle.size() > 0)
        members.insert("angle", Kind::angle);
    if (state.spin.size() > 0)
        members.insert("spin", Kind::spin);
    return members;
}

QString listOf(const QHash<QString, Kind> &members)
{
    QStringList names;
    for (const char *name : {"x", "y", "vx", "vy", "angle", "spin"}) {
        if (members.contains(name))
            names << name;
    }
    return names.join(QStringLiteral(", "));
}

}
