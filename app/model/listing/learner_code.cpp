#include "app/model/listing/learner_code.h"

#include "app/listing/listing_method.h"
#include "app/model/listing/rule_code.h"
#include "app/model/run/run_program.h"
#include "app/model/session/run_editor.h"
#include "app/model/text/sentences.h"
#include "sim/methods/methods.h"

#include <utility>

namespace app {

namespace {

constexpr auto gesture = ":code";

}

QString LearnerCode::original() const
{
    return m_run.step().listing.text;
}

bool LearnerCode::isOffered() const
{
    return !original().isEmpty() || draft() || programOf(m_run.timeline().script().method);
}

const std::optional<QString> &LearnerCode::draft() const
{
    static const std::optional<QString> none;
    return hasRuleDraft(m_run) ? none : m_run.draft();
}

QString LearnerCode::text() const
{
    if (draft())
        return *draft();
    const std::shared_ptr<const listing::Program> program = programOf(m_run.timeline().script().method);
    return program ? QString::fromStdString(program->text()) : original();
}

bool LearnerCode::isOwnMethod() const
{
    const sim::Script &script = m_run.timeline().script();
    return !original().isEmpty() && script.method->id() == m_run.step().method.toStdString() &&
           script.step == sim::StepSize();
}

bool LearnerCode::isInUse() const
{
    if (programOf(m_run.timeline().script().method))
        return true;
    // A draft that compiles is not in use: the learner has chosen the method instead.
    return isOwnMethod() && (!draft() || !compiled(*draft()).program);
}

const listing::Vocabulary &LearnerCode::vocabulary() const
{
    const sim::Script &script = m_run.timeline().script();
    if (m_namesOf.first != &m_run.step() || m_namesOf.second != script.values) {
        m_names = listing::vocabularyOf(sim::sceneOf(script, script.values));
        m_namesOf = {&m_run.step(), script.values};
    }
    return m_names;
}

const listing::Compiled &LearnerCode::compiled(const QString &text) const
{
    return m_compiled.of({text, vocabulary()},
                         [&] { return listing::Program::compile(text.toStdString(), vocabulary()); });
}

std::shared_ptr<const listing::Program> LearnerCode::program() const
{
    const std::shared_ptr<const listing::Program> used = programOf(m_run.timeline().script().method);
    return used && !draft() ? used : compiled(text()).program;
}

std::vector<CodeMistake> LearnerCode::mistakes() const
{
    if (!isOffered())
        return {};
    const QString written = text();
    return mistakesOf(compiled(written).errors, written);
}

std::optional<listing::RunError> LearnerCode::runError() const
{
    return runErrorOf(m_run.timeline().track());
}

void LearnerCode::write(const QString &text)
{
    if (m_pause.endsWithChange())
        m_editor.endGesture();
    set(text,
        {tr("Change code"), firstNewLine(text, this->text()), gesture, firstNewLine(this->text(), text)});
}

void LearnerCode::reset()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    emit wasReset();
    m_editor.endGesture();
    set(original(), {tr("Reset listing"), tr("your code"), {}, tr("the listing of the step")});
}

void LearnerCode::removeLines(const lessons::CodeTask &task)
{
    const QString left = m_run.step().listing.emptied(task);
    const QString before = isChanged() ? tr("your code") : tr("the listing of the step");
    set(left, {tr("Change code"), before, {}, firstNewLine(text(), left)});
}

void LearnerCode::set(const QString &text, const EditLabel &label)
{
    if (text == this->text())
        return;
    const sim::Script &now = m_run.timeline().script();
    const std::shared_ptr<const listing::Program> program = compiled(text).program;
    if (program && isInUse()) {
        const auto [method, step] = methodOf(text, program);
        m_editor.setListing(label, {}, method, step);
        return;
    }
    const bool isOriginal = text == original() && !programOf(now.method);
    m_editor.setListing(label, isOriginal ? std::nullopt : std::optional(text), now.method, now.step);
}

std::pair<sim::MethodPtr, sim::StepSize>
LearnerCode::methodOf(const QString &text, const std::shared_ptr<const listing::Program> &program) const
{
    const sim::MethodPtr own = sim::findMethod(m_run.step().method.toStdString());
    const bool isOwn = text == original() && m_run.step().h == 1.0 && own->stepping() == sim::Stepping::fixed;
    return {isOwn ? own : std::make_shared<const listing::ListingMethod>(program), sim::StepSize()};
}

void LearnerCode::use()
{
    const QString written = text();
    const std::vector<CodeMistake> wrong = mistakes();
    const std::shared_ptr<const listing::Program> program = compiled(written).program;
    if (!program) {
        m_run.showMessage(wrong.empty()
                              ? tr("This step has no listing.")
                              : tr("Your code does not compile. Line %1: %2")
                                    .arg(QString::number(wrong.front().line), wrong.front().sentence));
        return;
    }
    m_editor.endGesture();
    const auto [method, step] = methodOf(written, program);
    const QString was = phrase(m_run.timeline().script().method->title());
    m_editor.setListing({tr("Change method"), was, {}, phrase(method->title())}, {}, method, step);
}

}
