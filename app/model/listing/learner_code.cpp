#include "app/model/listing/learner_code.h"

#include "app/listing/listing_method.h"
#include "app/model/listing/changed_lines.h"
#include "app/model/run/run_program.h"
#include "app/model/run/same_run.h"
#include "app/model/session/run_editor.h"
#include "app/model/text/listing_text.h"
#include "app/model/text/sentences.h"
#include "sim/methods/methods.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr std::size_t mostCached = 4; ///< texts: the step's, the learner's, and those of the last undo
constexpr auto gesture = ":code";

/// Returns the first line of `text` that `other` does not have, as part of the name of a run.
QString firstNewLine(const QString &other, const QString &text)
{
    constexpr qsizetype longest = 40;
    const QStringList lines = text.split('\n');
    for (const int line : changedLines(other, text).changed) {
        const QString code = lines[line - 1].simplified();
        if (code.size() > 1) // not for a brace
            return code.size() <= longest ? code : code.left(longest - 1) + QStringLiteral("…");
    }
    return LearnerCode::tr("other code");
}

CodeMistake mistakeOf(const listing::CompileError &error, const QString &text)
{
    const QByteArray line = text.section('\n', error.line - 1, error.line - 1).toUtf8();
    const auto characters = [](const QByteArray &bytes) {
        return static_cast<int>(QString::fromUtf8(bytes).size());
    };
    return {error.line, characters(line.left(error.column - 1)) + 1,
            std::max(1, characters(line.mid(error.column - 1, error.length))),
            listingSentence(error.sentence)};
}

}

QString LearnerCode::original() const
{
    return m_run.step().listing.text;
}

bool LearnerCode::isOffered() const
{
    return !original().isEmpty() || m_run.draft() || programOf(m_run.timeline().script().method);
}

QString LearnerCode::text() const
{
    if (m_run.draft())
        return *m_run.draft();
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
    return isOwnMethod() && (!m_run.draft() || !compiled(*m_run.draft()).program);
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
    const listing::Vocabulary &names = vocabulary();
    const auto found = std::find_if(m_cache.begin(), m_cache.end(), [&](const Cached &one) {
        return one.text == text && one.vocabulary == names;
    });
    if (found != m_cache.end()) {
        std::rotate(m_cache.begin(), found, found + 1);
    } else {
        listing::Compiled result = listing::Program::compile(text.toStdString(), names);
        m_cache.insert(m_cache.begin(), {text, names, std::move(result)});
        if (m_cache.size() > mostCached)
            m_cache.pop_back();
    }
    return m_cache.front().compiled;
}

std::shared_ptr<const listing::Program> LearnerCode::program() const
{
    const std::shared_ptr<const listing::Program> used = programOf(m_run.timeline().script().method);
    return used && !m_run.draft() ? used : compiled(text()).program;
}

std::vector<CodeMistake> LearnerCode::mistakes() const
{
    std::vector<CodeMistake> mistakes;
    if (!isOffered())
        return mistakes;
    const QString written = text();
    for (const listing::CompileError &error : compiled(written).errors)
        mistakes.push_back(mistakeOf(error, written));
    return mistakes;
}

std::optional<listing::RunError> LearnerCode::runError() const
{
    return runErrorOf(m_run.timeline().track());
}

void LearnerCode::write(const QString &text)
{
    if (!m_sinceWritten.isValid() || m_sinceWritten.hasExpired(pauseMilliseconds))
        m_editor.endGesture();
    m_sinceWritten.start();
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
        m_run.changes().showMessage(
            wrong.empty() ? tr("This step has no listing.")
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
