#include "app/model/listing/rule_code.h"

#include "app/model/run/rule_error.h"
#include "app/model/run/run_program.h"
#include "app/model/session/run_editor.h"

#include <QStringList>

namespace app {

namespace {

constexpr auto ruleGesture = ":rule";

}

bool hasRuleDraft(const OpenRun &run)
{
    return run.isSandbox() && !programOf(run.timeline().script().method);
}

QString RuleCode::startingText()
{
    const QStringList lines = {
        QStringLiteral("// ") + tr("The force on each body."),
        QStringLiteral("// ") + tr("me.position is in px, y points down."),
        QStringLiteral("// ") + tr("me.velocity is in px per frame."),
        QStringLiteral("Vec2 force(Body me)"),
        QStringLiteral("{"),
        QStringLiteral("    return Vec2(0, 0);"),
        QStringLiteral("}"),
        {},
        QStringLiteral("// ") + tr("The force on me from other."),
        QStringLiteral("// ") + tr("It acts on both ends of each rule link."),
        QStringLiteral("Vec2 pull(Body me, Body other)"),
        QStringLiteral("{"),
        QStringLiteral("    return Vec2(0, 0);"),
        QStringLiteral("}"),
        {},
    };
    return lines.join('\n');
}

const sim::BlueprintRule &RuleCode::rule() const
{
    static const sim::BlueprintRule none;
    const auto &blueprint = m_run.timeline().script().values.blueprint;
    return blueprint ? blueprint->rule : none;
}

QString RuleCode::text() const
{
    if (hasRuleDraft(m_run) && m_run.draft())
        return *m_run.draft();
    return rule() ? QString::fromStdString(rule().text()) : startingText();
}

bool RuleCode::hasRule() const
{
    return static_cast<bool>(rule());
}

bool RuleCode::isActing() const
{
    return hasRule() && !m_run.draft();
}

const listing::CompiledRule &RuleCode::compiled(const QString &text) const
{
    return m_compiled.of(text, [&] { return listing::compileRule(text.toStdString()); });
}

std::vector<CodeMistake> RuleCode::mistakes() const
{
    const QString written = text();
    if (!isOffered() || written.trimmed().isEmpty())
        return {};
    return mistakesOf(compiled(written).errors, written);
}

std::optional<listing::RuleError> RuleCode::runError() const
{
    return hasRule() ? ruleErrorOf(m_run.timeline().track()) : std::nullopt;
}

void RuleCode::write(const QString &text)
{
    if (m_pause.endsWithChange())
        m_editor.endGesture();
    set(text,
        {tr("Change rule"), firstNewLine(text, this->text()), ruleGesture, firstNewLine(this->text(), text)});
}

void RuleCode::remove()
{
    m_editor.endGesture();
    set(startingText(), {tr("Delete rule"), tr("your rule"), {}, tr("no rule")});
}

void RuleCode::set(const QString &text, const EditLabel &label)
{
    if (!isOffered() || text == this->text())
        return;
    if (text == startingText()) {
        m_editor.setRule(label, {}, {});
    } else if (text.trimmed().isEmpty()) {
        m_editor.setRule(label, text, {}); // the starting text would come back while the learner starts over
    } else {
        const std::shared_ptr<const sim::Rule> written = compiled(text).rule;
        written ? m_editor.setRule(label, {}, {written}) : m_editor.setRule(label, text, rule());
    }
}

}
