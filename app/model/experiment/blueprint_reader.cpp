#include "app/model/experiment/blueprint_reader.h"

#include "app/listing/rule_program.h"
#include "app/model/catalog/lists.h"
#include "app/model/experiment/experiment_method.h"
#include "app/model/experiment/json_fields.h"
#include "app/model/sandbox/blueprint_limits.h"
#include "app/model/text/listing_text.h"
#include "app/model/text/quoting.h"
#include "sim/effects/all_effects.h"
#include "sim/scene/blueprint_draft.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>

namespace app {

bool built::isName(const QString &name)
{
    static const QRegularExpression allowed(QStringLiteral("\\A[A-Za-z][A-Za-z0-9_.]*\\z"));
    return name.size() <= longestName && allowed.match(name).hasMatch();
}

namespace {

/// A reader of one built scene, list by list.
class BlueprintReader
{
    Q_DECLARE_TR_FUNCTIONS(BlueprintReader)

public:
    BlueprintReader(const QString &file, const JsonValue &scene, const lessons::Step &step)
        : m_file(file), m_scene(file, scene, quoted("scene")), m_step(step)
    {
        m_scene.refuseOthers(
            {"bodies", "springs", "sticks", "feet", "gaits", "effects", "rule", "rule_links"});
    }

    sim::Blueprint read()
    {
        readPoints();
        readSprings();
        readSticks();
        readGaits();
        readFeet();
        readEffects();
        readRule();
        readRuleLinks();
        return m_plan;
    }

private:
    /// Calls `each(value)` for each entry of the list `name`, if the list exists.
    template <class Each>
    void forEach(const QString &name, std::size_t most, const Each &each) const
    {
        const JsonValue *value = m_scene.find(name);
        if (!value)
            return;
        const JsonValue::List &list = listOf(m_file, *value, name);
        refuseMore(name, list.size(), most, value->line);
        for (const JsonValue &one : list)
            each(one);
    }

    void refuseMore(const QString &name, std::size_t count, std::size_t most, int line) const
    {
        if (count > most)
            refuse(m_file, line,
                   tr("%1 has %2 entries; the most is %3.").arg(quoted(name)).arg(count).arg(most));
    }

    void readPoints()
    {
        const JsonFields bodies(m_file, m_scene.require("bodies", tr("an object in { }")), quoted("bodies"));
        refuseMore("bodies", bodies.all().size(), built::mostPoints, bodies.line());
        if (bodies.all().empty())
            refuse(m_file, bodies.line(), tr("\"bodies\" is empty; a scene needs at least one body."));
        for (const auto &[name, value] : bodies.all()) {
            if (!built::isName(name))
                refuse(m_file, value.line,
                       tr("a body cannot be called %1; a name is a letter, then up to %2 letters, digits, "
                          "dots and _.")
                           .arg(quoted(name))
                           .arg(built::longestName - 1));
            m_numbers.insert(name, static_cast<int>(m_plan.points.size()));
            m_plan.points.push_back(point(name, value));
        }
    }

    sim::BlueprintPoint point(const QString &name, const JsonValue &value) const
    {
        const JsonFields body(m_file, value, tr("the body %1").arg(quoted(name)));
        QStringList known = {"x", "y", "vx", "vy", "mass", "size", "fixed"};
        for (const sim::EffectDescription *effect : m_step.availableEffects) {
            for (const sim::ParameterSpec &parameter : effect->pointProperties)
                known.push_back(QString::fromUtf8(parameter.id));
        }
        body.refuseOthers(known);
        sim::BlueprintPoint point;
        point.name = name.toStdString();
        point.x = {body.number("x", built::place), body.number("y", built::place)};
        point.v = {body.number("vx", built::speed, 0.0), body.number("vy", built::speed, 0.0)};
        point.mass = body.number("mass", built::mass, point.mass);
        point.size = body.number("size", built::size, point.size);
        point.fixed = body.boolean("fixed", false);
        for (const sim::EffectDescription *effect : m_step.availableEffects) {
            for (const sim::ParameterSpec &parameter : effect->pointProperties) {
                const double own =
                    body.number(parameter.id, {parameter.min, parameter.max}, parameter.defaultValue);
                sim::setValue(point, parameter, own);
            }
        }
        return point;
    }

    /// Returns the index of the body that the field `name` names.
    int end(const JsonFields &fields, const QString &name) const
    {
        const JsonValue &value = fields.require(name, tr("a body's name"));
        const QString given = textOf(m_file, value, name);
        const auto found = m_numbers.constFind(given);
        if (found == m_numbers.constEnd())
            refuse(m_file, value.line,
                   tr("there is no body %1 in this scene; %2 must be the name of one of its \"bodies\".")
                       .arg(quoted(given), quoted(name)));
        return *found;
    }

    /// Returns the bodies in the fields `a` and `b`, which must differ.
    std::pair<int, int> ends(const JsonFields &fields, const QString &a, const QString &b,
                             const QString &what) const
    {
        const std::pair<int, int> both(end(fields, a), end(fields, b));
        if (both.first == both.second)
            refuse(m_file, fields.line(),
                   tr("%1 has %2 at both ends; give it two bodies.")
                       .arg(what, quoted(QString::fromStdString(
                                      m_plan.points[static_cast<std::size_t>(both.first)].name))));
        return both;
    }

    void readSprings()
    {
        forEach("springs", built::mostLinks, [this](const JsonValue &value) {
            const JsonFields spring(m_file, value, tr("a spring"));
            spring.refuseOthers({"a", "b", "k", "length"});
            const auto [a, b] = ends(spring, "a", "b", tr("a spring"));
            m_plan.springs.push_back(
                {a, b, spring.number("k", built::stiffness), spring.number("length", built::length)});
        });
    }

    void readSticks()
    {
        forEach("sticks", built::mostLinks, [this](const JsonValue &value) {
            const JsonFields stick(m_file, value, tr("a stick"));
            stick.refuseOthers({"a", "b", "length", "share"});
            const auto [a, b] = ends(stick, "a", "b", tr("a stick"));
            m_plan.sticks.push_back(
                {a, b, stick.number("length", built::length), stick.number("share", built::share, 0.5)});
        });
    }

    void readGaits()
    {
        forEach("gaits", built::mostGaits, [this](const JsonValue &value) {
            const JsonFields fields(m_file, value, tr("a gait group"));
            fields.refuseOthers({"k", "leg", "drop", "speed", "start", "pulls_body"});
            sim::BlueprintGait gait;
            gait.k = fields.number("k", built::stiffness, gait.k);
            gait.leg = fields.number("leg", built::length, gait.leg);
            gait.drop = fields.number("drop", built::drop, gait.drop);
            gait.speed = fields.number("speed", built::gaitSpeed, gait.speed);
            gait.start = fields.number("start", built::gaitStart, gait.start);
            gait.pullsBody = fields.boolean("pulls_body", gait.pullsBody);
            m_plan.gaits.push_back(gait);
        });
    }

    void readFeet()
    {
        std::vector<char> isFoot(m_plan.points.size());
        forEach("feet", built::mostPoints, [&](const JsonValue &value) {
            const JsonFields fields(m_file, value, tr("a foot"));
            fields.refuseOthers({"foot", "body", "angle", "gait"});
            if (m_plan.gaits.empty())
                refuse(m_file, fields.line(),
                       tr("a foot belongs to a gait group, and there is none; add \"gaits\": [{}]."));
            const auto [foot, body] = ends(fields, "foot", "body", tr("a foot"));
            if (std::exchange(isFoot[static_cast<std::size_t>(foot)], 1))
                refuse(m_file, fields.line(),
                       tr("%1 is a foot twice; it can be the foot of only one body.")
                           .arg(quoted(
                               QString::fromStdString(m_plan.points[static_cast<std::size_t>(foot)].name))));
            const auto last = std::int64_t(m_plan.gaits.size()) - 1;
            const int gait = int(fields.integer("gait", 0, last, 0));
            m_plan.feet.push_back({foot, body, fields.number("angle", built::angle, 0.0), gait});
        });
    }

    void readEffects()
    {
        QStringList known;
        for (const sim::EffectDescription *effect : m_step.availableEffects)
            known.push_back(QString::fromUtf8(effect->id));
        forEach("effects", std::size_t(known.size()), [&](const JsonValue &value) {
            const QString id = textOf(m_file, value, "effects");
            if (!known.contains(id))
                refuse(m_file, value.line,
                       tr("a scene cannot have the effect %1; it can have %2. Its springs, sticks and feet "
                          "need no effect.")
                           .arg(quoted(id), quotedList(known, id)));
            std::vector<std::string> &all = m_plan.effects;
            if (contains(all, id.toStdString()))
                refuse(m_file, value.line, tr("the effect %1 is given twice; keep one.").arg(quoted(id)));
            all.push_back(id.toStdString());
        });
    }

    void readRule()
    {
        if (!m_scene.find("rule"))
            return;
        std::vector<std::string> declared; // by a lesson, since all others belong to effects
        for (const lessons::Parameter &parameter : m_step.parameters) {
            if (parameter.effects.isEmpty())
                declared.push_back(parameter.id.toStdString());
        }
        const listing::CompiledRule compiled =
            listing::compileRule(codeText(m_scene, "rule").toStdString(), declared);
        if (!compiled.rule) {
            const listing::CompileError &error = compiled.errors.front();
            m_scene.refuse("rule", tr("\"rule\" does not compile. Line %1: %2")
                                       .arg(QString::number(error.line), listingSentence(error.sentence)));
        }
        m_plan.rule = {compiled.rule};
    }

    void readRuleLinks()
    {
        forEach("rule_links", built::mostLinks, [this](const JsonValue &value) {
            const JsonFields link(m_file, value, tr("a rule link"));
            link.refuseOthers({"a", "b"});
            const auto [a, b] = ends(link, "a", "b", tr("a rule link"));
            m_plan.ruleLinks.push_back({a, b});
        });
    }

    QString m_file;
    JsonFields m_scene;
    const lessons::Step &m_step;
    sim::Blueprint m_plan;
    QHash<QString, int> m_numbers; ///< index of each body, by name
};

}

sim::Blueprint readBlueprint(const QString &file, const JsonValue &scene, const lessons::Step &step)
{
    return BlueprintReader(file, scene, step).read();
}

}
