#include "app/model/experiment_input.h"

#include "app/model/experiment.h"
#include "app/model/json_fields.h"
#include "app/model/parameter_value.h"
#include "app/model/words.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(ExperimentInput)
};

/// An event's kind, and the fields it has besides "frame" and "event".
struct EventKind
{
    QString id;
    QStringList fields;
};

const std::vector<EventKind> &eventKinds()
{
    static const std::vector<EventKind> kinds = {
        {QStringLiteral("grab"), {QStringLiteral("body")}},
        {QStringLiteral("move"), {QStringLiteral("x"), QStringLiteral("y")}},
        {QStringLiteral("release"), {}},
        {QStringLiteral("set"), {QStringLiteral("parameter"), QStringLiteral("value")}},
    };
    return kinds;
}

const EventKind &kindOf(const QString &file, const JsonFields &fields, const lessons::Step &step)
{
    QStringList ids;
    for (const EventKind &kind : eventKinds())
        ids.push_back(kind.id);
    const JsonValue &value = fields.require(QStringLiteral("event"), quotedList(ids));
    const QString id = textOf(file, value, QStringLiteral("event"));
    for (const EventKind &kind : eventKinds()) {
        if (kind.id == id)
            return kind;
    }
    refuse(file, value.line,
           Text::tr("the step %1 has no event %2; it knows %3.")
               .arg(quoted(step.id), quoted(id), quotedList(ids)));
}

sim::Event readEvent(const QString &file, const JsonValue &value, const lessons::Step &step)
{
    const JsonFields fields(file, value, Text::tr("an event"));
    const EventKind &kind = kindOf(file, fields, step);
    fields.refuseOthers(QStringList{QStringLiteral("frame"), QStringLiteral("event")} + kind.fields);
    sim::Event event;
    const auto frame = QStringLiteral("frame");
    event.frame = wholeOf(file, fields.require(frame, Text::tr("a whole number")), frame, 0, mostFrames);
    if (kind.id == "grab") {
        const JsonValue &body = fields.require(QStringLiteral("body"), Text::tr("a body's name"));
        event.what = sim::Grab{textOf(file, body, QStringLiteral("body")).toStdString()};
    } else if (kind.id == "move") {
        event.what = sim::Move{{fields.number(QStringLiteral("x")), fields.number(QStringLiteral("y"))}};
    } else if (kind.id == "release") {
        event.what = sim::Release{};
    } else {
        const JsonValue &id = fields.require(QStringLiteral("parameter"), Text::tr("a parameter's id"));
        const lessons::Parameter &parameter =
            parameterOf(file, id.line, step, textOf(file, id, QStringLiteral("parameter")));
        const JsonValue &set = fields.require(QStringLiteral("value"), Text::tr("a value of that parameter"));
        event.what = sim::Set{parameter.id.toStdString(), parameterValue(file, set, parameter)};
    }
    return event;
}

}

std::vector<ReadEvent> readInput(const QString &file, const JsonValue &input, const lessons::Step &step)
{
    std::vector<ReadEvent> events;
    for (const JsonValue &value : listOf(file, input, QStringLiteral("input")))
        events.push_back({readEvent(file, value, step), value.line});
    std::stable_sort(events.begin(), events.end(),
                     [](const ReadEvent &a, const ReadEvent &b) { return a.event.frame < b.event.frame; });
    return events;
}

}
