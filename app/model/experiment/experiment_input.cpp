#include "app/model/experiment/experiment_input.h"

#include "app/model/catalog/lists.h"
#include "app/model/experiment/experiment.h"
#include "app/model/experiment/experiment_events.h"
#include "app/model/experiment/json_fields.h"
#include "app/model/experiment/parameter_value.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

namespace {

/// A reader of the events of one file for one step.
class InputReader
{
    Q_DECLARE_TR_FUNCTIONS(ExperimentInput)

public:
    InputReader(const QString &file, const lessons::Step &step)
        : m_file(file), m_step(step), m_kinds(eventKindsOf(step))
    {
        for (const EventKind &kind : m_kinds)
            m_ids.push_back(kind.id);
    }

    sim::Event read(const JsonValue &value) const
    {
        const JsonFields fields(m_file, value, tr("an event"));
        const EventKind &kind = kindOf(fields);
        fields.refuseOthers(QStringList{QStringLiteral("frame"), QStringLiteral("event")} + kind.fields +
                            kind.optional);
        const auto frame = QStringLiteral("frame");
        const std::int64_t when =
            wholeOf(m_file, fields.require(frame, tr("a whole number")), frame, 0, mostFrames);
        return {when, what(kind.id, fields)};
    }

private:
    const EventKind &kindOf(const JsonFields &fields) const
    {
        const JsonValue &value = fields.require(QStringLiteral("event"), quotedList(m_ids));
        const QString id = textOf(m_file, value, QStringLiteral("event"));
        if (const EventKind *kind = findById(m_kinds, id))
            return *kind;
        refuse(m_file, value.line,
               tr("the step %1 has no event %2; it has %3.")
                   .arg(quoted(m_step.id), quoted(id), quotedList(m_ids, id)));
    }

    decltype(sim::Event::what) what(const QString &id, const JsonFields &fields) const
    {
        if (id == "grab")
            return sim::Grab{fields.text("body", tr("a body's name")).toStdString()};
        if (id == "move")
            return sim::Move{place(fields)};
        if (id == "release")
            return sim::Release{};
        if (id == "pointer")
            return sim::Pointer{place(fields), fields.boolean("down", false)};
        if (id == "target")
            return sim::Target{place(fields)};
        if (id == "gust")
            return sim::Gust{fields.number("degrees")};
        if (id == "key")
            return sim::Key{key(fields), fields.boolean("down")};
        return set(fields);
    }

    static sim::Vec2 place(const JsonFields &fields) { return {fields.number("x"), fields.number("y")}; }

    bool sim::Keys::*key(const JsonFields &fields) const
    {
        QStringList names;
        for (const KeyName &one : keyNames())
            names.push_back(one.name);
        const QString given = fields.text("key", quotedList(names));
        for (const KeyName &one : keyNames()) {
            if (one.name == given)
                return one.key;
        }
        fields.refuse("key",
                      tr("there is no key %1; there is %2.").arg(quoted(given), quotedList(names, given)));
    }

    sim::Set set(const JsonFields &fields) const
    {
        const JsonValue &id = fields.require("parameter", tr("a parameter's id"));
        const lessons::Parameter &parameter =
            parameterOf(m_file, id.line, m_step, textOf(m_file, id, "parameter"));
        const JsonValue &value = fields.require("value", tr("a value of that parameter"));
        return {parameter.id.toStdString(), parameterValue(m_file, value, parameter)};
    }

    const QString &m_file;
    const lessons::Step &m_step;
    std::vector<EventKind> m_kinds;
    QStringList m_ids;
};

}

std::vector<ReadEvent> readInput(const QString &file, const JsonValue &input, const lessons::Step &step)
{
    const InputReader reader(file, step);
    std::vector<ReadEvent> events;
    for (const JsonValue &value : listOf(file, input, QStringLiteral("input")))
        events.push_back({reader.read(value), value.line});
    std::stable_sort(events.begin(), events.end(),
                     [](const ReadEvent &a, const ReadEvent &b) { return a.event.frame < b.event.frame; });
    return events;
}

}
