#include "app/model/learning/prediction_desk.h"

#include "app/model/catalog/lists.h"
#include "app/model/learning/run_setup.h"
#include "app/model/run/same_run.h"
#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "sim/base/error.h"

#include <QScopedValueRollback>

#include <utility>

namespace app {

PredictionDesk::PredictionDesk(Session &session, QObject *parent) : QObject(parent), m_session(session)
{
    session.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::cursor, this, &PredictionDesk::follow);
    session.onChange(ChangeKind::texts, this, [this] {
        m_step.clear(); // the predictions may be others
        openStep();
    });
    openStep();
}

QString PredictionDesk::keyOf(const QString &id) const
{
    return Notes::keyOf(m_session.lesson().id, m_session.step().id, QStringLiteral("predict"), id);
}

const lessons::Prediction *PredictionDesk::find(const QString &id) const
{
    return findById(m_session.step().predictions, id);
}

PredictionDesk::Sheet PredictionDesk::sheet(const QString &id) const
{
    return m_sheets.value(keyOf(id));
}

const PredictionTruth *PredictionDesk::truth(const QString &id) const
{
    const auto found = m_truths.constFind(id);
    return found == m_truths.constEnd() ? nullptr : &*found;
}

void PredictionDesk::openStep()
{
    const QString step = m_session.run().key();
    if (step == m_step)
        return; // the run was replaced as a whole
    for (Sheet &sheet : m_sheets) {
        if (sheet.stage == Stage::playing)
            sheet.stage = Stage::open;
        sheet.mistake.clear();
    }
    m_step = step;
    m_active.clear();
    m_script.reset();
    m_isPicking = false;
    m_session.playback().setEnd({});
    for (const lessons::Prediction &prediction : m_session.step().predictions) {
        const Note *note = m_session.notes().find(keyOf(prediction.id));
        if (!note || note->kind != notedKind(prediction.question) || m_sheets.contains(keyOf(prediction.id)))
            continue;
        const auto said = answerInNote(prediction.question, note->said);
        const auto found = answerInNote(prediction.question, note->found);
        if (said && found)
            m_sheets.insert(keyOf(prediction.id), {Stage::shown, said, found});
    }
    computeTruths();
    m_isOnStage = false;
    emit changed();
}

void PredictionDesk::computeTruths()
{
    m_job.cancel();
    m_truths.clear();
    // The lessons outlive the session, and with it this job. Their predictions change with their texts, so they are copied.
    for (const lessons::Prediction &prediction : m_session.step().predictions)
        m_job.add(
            [&step = m_session.step(), prediction](const BackgroundJob::Context &context) {
                return truthOf(prediction, step, context.shouldContinue());
            },
            [this, id = prediction.id](std::future<std::optional<PredictionTruth>> truth) {
                receive(id, std::move(truth));
            });
}

void PredictionDesk::receive(const QString &id, std::future<std::optional<PredictionTruth>> future)
{
    Sheet &sheet = m_sheets[keyOf(id)];
    try {
        const std::optional<PredictionTruth> truth = future.get();
        if (!truth)
            return;
        m_truths.insert(id, *truth);
        if (sheet.stage == Stage::shown)
            sheet.found = truth->answer; // the document may have changed since
    } catch (const UserError &error) {
        sheet.mistake = error.sentence();
    } catch (const sim::Error &error) {
        sheet.mistake = sentenceFor(error);
    }
    if (id == m_active && sheet.stage == Stage::playing)
        begin();
    emit changed();
}

void PredictionDesk::say(const QString &id, const std::optional<PredictedAnswer> &answer)
{
    if (!find(id) || sheet(id).stage != Stage::open)
        return;
    m_sheets[keyOf(id)].said = answer;
    emit changed();
}

void PredictionDesk::commit(const QString &id)
{
    const Sheet now = sheet(id);
    if (!find(id) || now.stage != Stage::open || !now.said || !now.mistake.isEmpty())
        return;
    interrupt(); // the other one that plays
    m_isPicking = false;
    m_active = id;
    Sheet &sheet = m_sheets[keyOf(id)];
    sheet.stage = Stage::playing;
    sheet.wasInterrupted = false;
    begin();
    emit changed();
}

void PredictionDesk::begin()
{
    const lessons::Prediction *prediction = find(m_active);
    const PredictionTruth *known = truth(m_active);
    if (!prediction || !known)
        return; // begins when the truth is known
    if (!setUp(*prediction)) {
        m_sheets[keyOf(m_active)].stage = Stage::open;
        return;
    }
    m_session.playback().setEnd(known->end);
    m_session.playback().play();
}

bool PredictionDesk::setUp(const lessons::Prediction &prediction)
{
    const QScopedValueRollback changes(m_changesRun, true);
    m_active = prediction.id;
    try {
        m_script = scriptFor(prediction.run, m_session.step());
    } catch (const UserError &error) {
        m_sheets[keyOf(prediction.id)].mistake = error.sentence();
        return false;
    } catch (const sim::Error &error) {
        m_sheets[keyOf(prediction.id)].mistake = sentenceFor(error);
        return false;
    }
    m_isOnStage = m_session.editor().setUp({tr("Prediction"), tr("the prediction"), {}, tr("prediction")},
                                           *m_script, RunEditor::Maker::program);
    return m_isOnStage;
}

void PredictionDesk::startAgain(const QString &id)
{
    if (!find(id))
        return;
    if (id == m_active) {
        m_isPicking = false;
        m_session.playback().setEnd({});
    }
    const QString mistake = sheet(id).mistake;
    m_sheets[keyOf(id)] = {.mistake = mistake};
    emit changed();
}

void PredictionDesk::pick(const QString &id)
{
    const lessons::Prediction *prediction = find(id);
    if (!prediction || prediction->question.kind != lessons::Question::Kind::place ||
        sheet(id).stage != Stage::open)
        return;
    interrupt();
    m_isPicking = setUp(*prediction);
    emit changed();
    if (m_isPicking)
        emit pickingStarted();
}

void PredictionDesk::stopPicking()
{
    if (std::exchange(m_isPicking, false))
        emit changed();
}

const lessons::Prediction *PredictionDesk::picking() const
{
    return m_isPicking ? find(m_active) : nullptr;
}

sim::Vec2 PredictionDesk::placeOfBody() const
{
    const lessons::Prediction *prediction = find(m_active);
    if (!prediction)
        return {};
    const sim::Timeline &timeline = m_session.timeline();
    const int point = timeline.track().interval().scene.find(prediction->question.of.toStdString());
    return point < 0 ? sim::Vec2{} : timeline.state().positionOf(point);
}

std::optional<PredictionDesk::PlaceMark> PredictionDesk::mark() const
{
    const lessons::Prediction *prediction = find(m_active);
    if (!m_isOnStage || !prediction || prediction->question.kind != lessons::Question::Kind::place)
        return std::nullopt;
    const Sheet now = sheet(m_active);
    if (!now.said)
        return std::nullopt;
    PlaceMark mark{now.said->place};
    if (now.stage == Stage::shown && now.found)
        mark.found = now.found->place;
    return mark;
}

void PredictionDesk::follow(const Change &change)
{
    if (m_changesRun)
        return;
    if (change.isAny(ChangeKind::step))
        openStep();
    if (m_active.isEmpty())
        return;
    const bool was = m_isOnStage;
    if (change.isAny(ChangeKind::step | ChangeKind::run))
        m_isOnStage = m_script && sameScript(*m_script, m_session.timeline().script());
    const bool isAtStart = m_session.timeline().cursor() == sim::Cursor{};
    const bool stopsPicking = m_isPicking && !(m_isOnStage && isAtStart);
    if (stopsPicking)
        m_isPicking = false;
    const PredictionTruth *known = truth(m_active);
    if (known && sheet(m_active).stage == Stage::playing) {
        if (!m_isOnStage)
            interrupt();
        else if (m_session.timeline().cursor().frame >= known->end)
            finish();
    }
    if (stopsPicking || was != m_isOnStage)
        emit changed();
}

void PredictionDesk::interrupt()
{
    const auto active = m_sheets.find(keyOf(m_active));
    if (active == m_sheets.end() || active->stage != Stage::playing)
        return;
    active->stage = Stage::open;
    active->wasInterrupted = true;
    m_session.playback().setEnd({});
    emit changed();
}

void PredictionDesk::finish()
{
    Sheet &sheet = m_sheets[keyOf(m_active)];
    const lessons::Question question = find(m_active)->question;
    sheet.stage = Stage::shown;
    sheet.found = truth(m_active)->answer;
    m_session.notes().keep(keyOf(m_active), {notedKind(question), notedAnswer(question, *sheet.said),
                                             notedAnswer(question, *sheet.found),
                                             isGood(question, *sheet.said, *sheet.found)});
    emit changed();
}

}
