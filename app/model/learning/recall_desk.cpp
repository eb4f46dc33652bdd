#include "app/model/learning/recall_desk.h"

#include "app/model/breakpoints/breakpoint_monitor.h"
#include "app/model/catalog/lists.h"
#include "app/model/experiment/experiment_line.h"
#include "app/model/learning/run_setup.h"
#include "app/model/run/same_run.h"
#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "lessons/api/text/document.h"
#include "sim/base/error.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <numeric>

namespace app {

namespace {

const QString recallKind = QStringLiteral("recall");

QString recallKey(const LessonEntry &lesson, const lessons::RecallQuestion &question)
{
    return RecallDesk::keyOf(lesson.id, question.id);
}

/// A number for each text, the same on every machine (FNV-1a).
quint32 numberOf(const QString &text)
{
    quint32 number = 2166136261U;
    for (const char one : text.toUtf8())
        number = (number ^ static_cast<quint8>(one)) * 16777619U;
    return number;
}

}

RecallDesk::RecallDesk(Session &session, QObject *parent) : QObject(parent), m_session(session)
{
    session.onChange(ChangeKind::step, this, &RecallDesk::followStep);
    session.onChange(ChangeKind::run | ChangeKind::cursor, this, &RecallDesk::followRun);
    session.onChange(ChangeKind::texts, this, [this] {
        if (!m_lesson.isEmpty() && !question())
            stop(); // the document has it no more
    });
}

QString RecallDesk::keyOf(const QString &lesson, const QString &question)
{
    return QStringLiteral("%1/%2:%3").arg(lesson, recallKind, question);
}

std::vector<std::size_t> RecallDesk::shuffled(const lessons::RecallQuestion &question)
{
    std::vector<std::size_t> order(question.choices.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    quint32 number = numberOf(question.id);
    for (std::size_t i = order.size(); i > 1; --i) { // Fisher and Yates
        number = number * 1664525U + 1013904223U;
        std::swap(order[i - 1], order[(number >> 16U) % i]);
    }
    return order;
}

std::optional<std::size_t> RecallDesk::chosen(const LessonEntry &lesson,
                                              const lessons::RecallQuestion &question) const
{
    const Note *note = m_session.notes().find(recallKey(lesson, question));
    bool isNumber = false;
    const uint choice = note ? note->said.toUInt(&isNumber) : 0;
    return isNumber && choice < question.choices.size() ? std::optional<std::size_t>(choice) : std::nullopt;
}

bool RecallDesk::isAnswered(const LessonEntry &lesson, const lessons::RecallQuestion &question) const
{
    return m_session.notes().find(recallKey(lesson, question));
}

void RecallDesk::choose(const LessonEntry &lesson, const lessons::RecallQuestion &question,
                        std::size_t choice)
{
    if (choice >= question.choices.size())
        return;
    m_session.notes().keep(recallKey(lesson, question), {.kind = recallKind,
                                                         .said = QString::number(choice),
                                                         .found = QStringLiteral("0"),
                                                         .isRight = choice == 0});
}

void RecallDesk::start(const LessonEntry &lesson, const lessons::RecallQuestion &question)
{
    if (!question.task)
        return;
    stop();
    m_lesson = lesson.id;
    m_question = question.id;
    m_isDone = false;
    if (setUp(*question.task))
        emit changed();
    else
        stop();
}

void RecallDesk::startAgain()
{
    const lessons::RecallQuestion *now = question();
    if (!now)
        return;
    m_isDone = false;
    if (setUp(*now->task))
        emit changed();
}

bool RecallDesk::setUp(const lessons::RecallTask &task)
{
    const lessons::Step *step = stepCalled(task.setup.step, m_session.library());
    if (!step) {
        m_session.showMessage(tr("There is no step %1.").arg(quoted(task.setup.step)));
        return false;
    }
    const QScopedValueRollback starting(m_isStarting, true);
    try {
        const sim::Script script = scriptFor(task.setup, *step);
        if (&m_session.step() != step)
            m_session.openStep(task.setup.step.section('/', 0, 0), step->id);
        if (!m_session.editor().setUp({tr("Set the scene up"), tr("your run")}, script,
                                      RunEditor::Maker::program))
            return false;
    } catch (const UserError &error) {
        m_session.showMessage(error.sentence());
        return false;
    } catch (const sim::Error &error) {
        m_session.showMessage(sentenceFor(error));
        return false;
    }
    m_begun = m_session.timeline().script();
    return true;
}

void RecallDesk::stop()
{
    if (m_lesson.isEmpty())
        return;
    m_lesson.clear();
    m_question.clear();
    m_isDone = false;
    m_begun = {};
    emit changed();
}

const LessonEntry *RecallDesk::lesson() const
{
    return m_lesson.isEmpty() ? nullptr : m_session.library().lesson(m_lesson);
}

const lessons::RecallQuestion *RecallDesk::question() const
{
    const LessonEntry *of = lesson();
    if (!of)
        return nullptr;
    const lessons::RecallQuestion *found = findById(of->recall.questions, m_question);
    return found && found->task ? found : nullptr;
}

void RecallDesk::followStep()
{
    const lessons::RecallQuestion *now = question();
    if (m_isStarting || !now)
        return;
    if (m_session.run().key() != now->task->setup.step)
        stop();
}

void RecallDesk::followRun()
{
    const lessons::RecallQuestion *now = question();
    if (m_isStarting || m_isDone || !now || sameScript(m_session.timeline().script(), m_begun) ||
        !isTaskDone(*now->task, m_session.step(), m_session.timeline()))
        return;
    m_isDone = true;
    const QString key = recallKey(*lesson(), *now);
    keepProof(key);
    m_session.notes().keep(key, {.kind = recallKind, .said = {}, .isRight = true});
    emit changed();
}

void RecallDesk::keepProof(const QString &key)
{
    const sim::Timeline &run = m_session.timeline();
    const std::int64_t frames = std::max<std::int64_t>(1, run.cursor().frame);
    try {
        const Experiment done{m_session.lesson().id, m_session.step().id, frames, run.script()};
        m_session.proofs().keep(key, {.run = experimentLine(done, m_session.library()), .at = run.cursor()});
    } catch (const UserError &) { // too long for a file, or a number is not finite
    }
}

bool isTaskDone(const lessons::RecallTask &task, const lessons::Step &step, const sim::Timeline &run)
{
    const QString &method = task.setup.method;
    if (!method.isEmpty() && run.script().method->id() != method.toStdString())
        return false; // the question asks to keep it
    try {
        return Condition::parse(task.setup.until, conditionNames(step, run))
            .holds({run.state(), run.cursor().frame, nullptr, {}, &run.track()});
    } catch (const UserError &) {
        return false; // a name in it does not exist under this method
    }
}

void checkRecall(const lessons::Recall &recall, const LessonLibrary &library)
{
    for (const lessons::RecallQuestion &question : recall.questions) {
        if (!question.task)
            continue;
        const lessons::RunSetup &setup = question.task->setup;
        const auto reject = [&](const QString &why) {
            throw lessons::DocumentError(recall.file, setup.line, why);
        };
        const lessons::Step *step = stepCalled(setup.step, library);
        if (!step)
            return reject(
                RecallDesk::tr("there is no step %1. Write “- step: lesson/step”.").arg(quoted(setup.step)));
        try {
            const FollowedRun run(*step, scriptFor(setup, *step));
            run.condition(setup.until);
        } catch (const UserError &error) {
            reject(error.sentence());
        } catch (const sim::Error &error) {
            reject(sentenceFor(error));
        }
    }
}

}
