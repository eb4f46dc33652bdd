// Resolves the names in a condition.

#include "app/model/breakpoints/condition_names.h"
#include "app/model/breakpoints/condition_parser.h"
#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "sim/pipeline/pipeline.h"
#include "sim/scene/scene.h"

#include <QCoreApplication>

namespace app {

using namespace condition_names;

ConditionParser::Part ConditionParser::phaseIs(const Part &text, bool equal)
{
    Condition::Operation is{Kind::phaseIs};
    for (const sim::Phase &phase : m_names.pipeline.phases) {
        const bool called = text.text == phrase(phase.title) ||
                            text.text == QString::fromStdString(phase.title) ||
                            text.text == QString::fromStdString(phase.id);
        if (called)
            is.phases.push_back(phase.id + '/' + phase.title);
    }
    if (is.phases.empty())
        refuse(text.place, tr("there is no phase %1; there are %2.")
                               .arg(quoted(text.text), someOf(phasesOf(m_names.pipeline))));
    Part whole{Type::truth, {is}, text.place, {}, {}};
    if (!equal)
        whole.program.push_back({Kind::negate});
    return whole;
}

ConditionParser::Part ConditionParser::choiceIs(const Part &choice, const Part &text, Part whole, Kind kind)
{
    const qsizetype index = choice.choices.indexOf(text.text);
    if (index < 0)
        refuse(
            text.place,
            tr("%1 is never %2; it can be %3.").arg(choice.text, quoted(text.text), someOf(choice.choices)));
    Part value{Type::number, {{Kind::number, static_cast<double>(index)}}, text.place, {}, {}};
    return joined(std::move(whole), std::move(value), kind, Type::truth);
}

ConditionParser::Part ConditionParser::named()
{
    const ConditionToken word = now();
    if (word.text == u"abs" || word.text == u"sqrt")
        return function(word.text == u"abs" ? Kind::absolute : Kind::root);
    const bool isCalled =
        m_words[m_at + 1].kind == ConditionToken::Kind::sign && m_words[m_at + 1].text == u"(";
    if (isCalled && bodyFunctions().contains(word.text)) {
        const Kind kind = bodyFunctions()[word.text];
        return kind == Kind::distance || kind == Kind::speed ? ofBodies(kind) : aboutBody(kind);
    }
    if (isVariable(word))
        return variable(word);
    if (word.text.contains('.'))
        return bodyNumber(word);
    ++m_at;
    if (word.text == u"frame")
        return {Type::number, {{Kind::frame}}, word.place, word.text, {}};
    if (word.text == u"phase")
        return {Type::phase, {}, word.place, word.text, {}};
    const std::string id = word.text.toStdString();
    if (!m_names.values.has(id))
        refuseName(word);
    const auto choices = m_names.choices.find(word.text);
    const bool isChoice = choices != m_names.choices.end() && !choices->second.isEmpty();
    return {isChoice ? Type::choice : Type::number,
            {{Kind::number, m_names.values[id]}},
            word.place,
            word.text,
            isChoice ? choices->second : QStringList()};
}

ConditionParser::Part ConditionParser::ofBodies(Kind kind)
{
    const QStringList bodies = bodiesOf(m_names.scene);
    const QString example = kind == Kind::speed
                                ? QStringLiteral("speed(%1)").arg(bodies.value(0))
                                : QStringLiteral("distance(%1, %2)").arg(bodies.value(0), bodies.value(1));
    const ConditionToken word = m_words[m_at++];
    const qsizetype opened = m_words[m_at++].place; // the parenthesis
    Condition::Operation operation{kind};
    operation.point = bodyAt(example);
    ++m_at;
    if (kind == Kind::distance) {
        if (!take(QStringLiteral(",")))
            refuse(now().place,
                   tr("distance needs two bodies with a comma between them, as in %1.").arg(example));
        operation.other = bodyAt(example);
        ++m_at;
    }
    expectClose(opened);
    return {Type::number, {operation}, word.place, {}, {}};
}

ConditionParser::Part ConditionParser::aboutBody(Kind kind)
{
    const ConditionToken word = m_words[m_at++];
    const qsizetype opened = m_words[m_at++].place; // the parenthesis
    Condition::Operation operation{kind};
    if (!isSign(QStringLiteral(")"))) {
        operation.point = bodyAt(QStringLiteral("%1(%2)").arg(word.text, bodiesOf(m_names.scene).value(0)));
        operation.path = now().text.toStdString();
        ++m_at;
    }
    expectClose(opened);
    return {Type::truth, {operation}, word.place, {}, {}};
}

int ConditionParser::bodyAt(const QString &example) const
{
    const ConditionToken &word = now();
    if (word.kind != ConditionToken::Kind::name)
        refuse(word.place, tr("the name of a body is missing here, as in %1.").arg(example));
    const int point = m_names.scene.find(word.text.toStdString());
    if (point < 0)
        refuse(word.place, tr("there is no body %1 here; there are %2.")
                               .arg(quoted(word.text), someOf(bodiesOf(m_names.scene))));
    return point;
}

bool ConditionParser::isVariable(const ConditionToken &word) const
{
    const QString root = word.text.section('.', 0, 0);
    return m_names.variables.contains(root) && m_names.scene.find(root.toStdString()) < 0;
}

ConditionParser::Part ConditionParser::variable(const ConditionToken &word)
{
    ++m_at;
    const QString root = word.text.section('.', 0, 0), type = m_names.variables.at(root);
    QString member = word.text.section('.', 1);
    if (type == u"Vec2" && member != u"x" && member != u"y")
        refuse(word.place, tr("%1 is a Vec2; ask for one of its numbers, %1.x or %1.y.").arg(root));
    if (type == u"Body") {
        static const QHash<QString, QString> members = {
            {"x", "position.x"},  {"y", "position.y"}, {"vx", "velocity.x"},
            {"vy", "velocity.y"}, {"angle", "angle"},  {"spin", "spin"},
        };
        if (!membersOf(m_names.scene.start).contains(member))
            refuse(word.place, tr("%1 is a body; ask for one of its numbers, as in %1.y (%2).")
                                   .arg(root, listOf(membersOf(m_names.scene.start))));
        member = members.value(member);
    } else if (type != u"Vec2" && !member.isEmpty()) {
        refuse(word.place, tr("%1 is a number, without members.").arg(root));
    }
    Condition::Operation read{Kind::variable};
    read.path = (member.isEmpty() ? root : root + '.' + member).toStdString();
    return {Type::number, {read}, word.place, word.text, {}};
}

ConditionParser::Part ConditionParser::bodyNumber(const ConditionToken &word)
{
    ++m_at;
    const qsizetype dot = word.text.lastIndexOf('.');
    const QString body = word.text.left(dot), member = word.text.mid(dot + 1);
    const int point = m_names.scene.find(body.toStdString());
    const QHash<QString, Kind> members = membersOf(m_names.scene.start);
    if (m_names.scene.find(word.text.toStdString()) >= 0)
        refuseName(word);
    if (point < 0)
        refuse(
            word.place,
            tr("there is no body %1 here; there are %2.").arg(quoted(body), someOf(bodiesOf(m_names.scene))));
    if (!members.contains(member))
        refuse(word.place + dot + 1,
               tr("%1 has no %2; it has %3.").arg(body, quoted(member), listOf(members)));
    return {Type::number, {{members[member], 0.0, point}}, word.place, word.text, {}};
}

void ConditionParser::refuseName(const ConditionToken &word) const
{
    if (m_names.scene.find(word.text.toStdString()) >= 0)
        refuse(word.place, tr("%1 is a body; ask for one of its numbers, as in %1.y (%2).")
                               .arg(word.text, listOf(membersOf(m_names.scene.start))));
    QStringList known = {QStringLiteral("frame"), QStringLiteral("phase")};
    known += parametersOf(m_names.values);
    for (const auto &[name, type] : m_names.variables)
        known << name;
    refuse(word.place, tr("there is no %1 here; there are %2, and numbers of bodies, as in %3.y.")
                           .arg(quoted(word.text), someOf(known), bodiesOf(m_names.scene).value(0)));
}

}
