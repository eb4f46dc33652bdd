#include "app/model/blueprint_writer.h"

#include "app/model/words.h"

#include <QStringList>

namespace app {

namespace {

/// One object in one line, field by field.
class Entry
{
public:
    Entry &text(const char *name, const QString &value) { return put(name, '"' + value + '"'); }
    Entry &number(const char *name, double value) { return put(name, exactNumber(value)); }
    /// Left out where it is `usual`.
    Entry &number(const char *name, double value, double usual)
    {
        return value == usual ? *this : number(name, value);
    }
    Entry &truth(const char *name, bool value, bool usual)
    {
        return value == usual ? *this : put(name, value ? QStringLiteral("true") : QStringLiteral("false"));
    }
    QString line() const { return m_fields.isEmpty() ? "{}" : "{ " + m_fields.join(", ") + " }"; }

private:
    Entry &put(const char *name, const QString &value)
    {
        m_fields.push_back(QStringLiteral("\"%1\": %2").arg(QLatin1String(name), value));
        return *this;
    }

    QStringList m_fields;
};

/// A list or object `name` with one entry a line, as a field of the scene.
QString block(const char *name, const QString &brackets, const QStringList &entries)
{
    return QStringLiteral("\"%1\": %2\n   %3\n  %4")
        .arg(QLatin1String(name), brackets.left(1), entries.join(",\n   "), brackets.right(1));
}

QStringList pointEntries(const sim::Blueprint &plan)
{
    const sim::BlueprintPoint usual;
    QStringList entries;
    for (const sim::BlueprintPoint &one : plan.points) {
        Entry entry;
        entry.number("x", one.x.x).number("y", one.x.y);
        entry.number("vx", one.v.x, 0.0).number("vy", one.v.y, 0.0);
        entry.number("mass", one.mass, usual.mass).number("size", one.size, usual.size);
        entry.truth("fixed", one.fixed, false);
        for (const auto &[setting, value] : one.properties)
            entry.number(setting.c_str(), value);
        entries.push_back('"' + QString::fromStdString(one.name) + "\": " + entry.line());
    }
    return entries;
}

QStringList gaitEntries(const sim::Blueprint &plan)
{
    const sim::BlueprintGait usual;
    QStringList entries;
    for (const sim::BlueprintGait &one : plan.gaits) {
        Entry entry;
        entry.number("k", one.k).number("leg", one.leg).number("drop", one.drop);
        entry.number("speed", one.speed, usual.speed).number("start", one.start, usual.start);
        entry.truth("pulls_body", one.pullsBody, usual.pullsBody);
        entries.push_back(entry.line());
    }
    return entries;
}

}

QString blueprintText(const sim::Blueprint &plan)
{
    const auto name = [&](int point) {
        return QString::fromStdString(plan.points[static_cast<std::size_t>(point)].name);
    };
    QStringList springs, sticks, feet, effects;
    for (const sim::BlueprintSpring &one : plan.springs)
        springs << Entry()
                       .text("a", name(one.a))
                       .text("b", name(one.b))
                       .number("k", one.k)
                       .number("length", one.length)
                       .line();
    for (const sim::BlueprintStick &one : plan.sticks)
        sticks << Entry()
                      .text("a", name(one.a))
                      .text("b", name(one.b))
                      .number("length", one.length)
                      .number("share", one.share, 0.5)
                      .line();
    for (const sim::BlueprintFoot &one : plan.feet)
        feet << Entry()
                    .text("foot", name(one.foot))
                    .text("body", name(one.body))
                    .number("angle", one.angle, 0.0)
                    .number("gait", one.gait, 0.0)
                    .line();
    for (const std::string &id : plan.effects)
        effects << '"' + QString::fromStdString(id) + '"';

    QStringList fields = {block("bodies", "{}", pointEntries(plan))};
    const auto add = [&](const char *list, const QStringList &entries) {
        if (!entries.isEmpty())
            fields << block(list, "[]", entries);
    };
    add("springs", springs);
    add("sticks", sticks);
    add("gaits", gaitEntries(plan));
    add("feet", feet);
    fields << "\"effects\": [" + effects.join(", ") + ']';
    return "{\n  " + fields.join(",\n  ") + "\n }";
}

}
