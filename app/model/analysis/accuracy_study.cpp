#include "app/model/analysis/accuracy_study.h"

#include "app/model/run/run_program.h"
#include "app/model/run/same_run.h"
#include "app/model/text/sentences.h"
#include "sim/methods/methods.h"

#include <QElapsedTimer>

#include <algorithm>
#include <utility>

namespace app {

namespace {

bool sameScene(const sim::Script &a, const sim::Script &b)
{
    return sameButForInput(a, b) && a.input == b.input;
}

}

bool sameSetup(const sim::MethodSetup &a, const sim::MethodSetup &b)
{
    return a.method && b.method && a.method->id() == b.method->id() && a.step == b.step;
}

AccuracyStudy::AccuracyStudy(const OpenRun &run, RunEditor &editor, StudyFunction function,
                             std::shared_ptr<QThreadPool> thread, QObject *parent)
    : QObject(parent), m_run(run), m_editor(editor), m_function(std::move(function)), m_job(std::move(thread))
{
    m_settleTimer.setSingleShot(true);
    m_settleTimer.setInterval(settleMilliseconds);
    connect(&m_settleTimer, &QTimer::timeout, this, &AccuracyStudy::start);
    run.onChange(ChangeKind::step | ChangeKind::run, this, &AccuracyStudy::followRun);
}

void AccuracyStudy::setActive(bool isActive)
{
    if (isActive == m_isActive)
        return;
    m_isActive = isActive;
    if (isActive && (!m_accuracy || m_stage == Stage::none)) {
        start();
        return;
    }
    if (!isActive) {
        m_settleTimer.stop();
        m_job.cancel();
        if (m_stage == Stage::measuring)
            m_stage = Stage::none; // the study starts again when a view shows it again
    }
    emit changed();
}

void AccuracyStudy::start()
{
    m_settleTimer.stop();
    m_stage = Stage::measuring;
    m_done = 0.0;
    m_error.clear();
    m_subject = Subject{m_run.lesson().id, m_run.step().id, m_run.timeline().script()};
    sim::StudyPlan plan;
    sim::Script measured = m_subject->script;
    if (programOf(measured.method)) // it has no shorter steps, so it has no error to measure
        measured.method = sim::findMethod(m_run.step().method.toStdString());
    else
        plan.inUse = sim::MethodSetup{measured.method, measured.step};
    m_job.start(
        [this, plan, script = std::move(measured), function = m_function](const BackgroundJob::Context &job) {
            QElapsedTimer sinceReport;
            const auto report = [&](const sim::Accuracy &soFar, double done) {
                if (!sinceReport.isValid() || sinceReport.hasExpired(reportMilliseconds)) {
                    sinceReport.start();
                    job.report([this, done, copy = std::make_shared<const sim::Accuracy>(soFar)] {
                        receive(copy, done);
                    });
                }
                return !job.isCancelled();
            };
            return std::make_shared<const sim::Accuracy>(function(script, plan, report));
        },
        [this](std::future<std::shared_ptr<const sim::Accuracy>> result) { finish(std::move(result)); });
    emit changed();
}

void AccuracyStudy::cancel()
{
    m_settleTimer.stop();
    if (m_stage != Stage::measuring)
        return;
    m_job.cancel();
    m_stage = Stage::cancelled;
    emit changed();
}

void AccuracyStudy::receive(std::shared_ptr<const sim::Accuracy> soFar, double done)
{
    m_accuracy = std::move(soFar);
    m_done = done;
    emit changed();
}

void AccuracyStudy::finish(std::future<std::shared_ptr<const sim::Accuracy>> result)
{
    m_done = 1.0;
    try {
        m_accuracy = result.get();
        m_stage = Stage::done;
    } catch (const sim::Error &error) {
        m_accuracy.reset();
        m_stage = Stage::refused;
        m_error = sentenceFor(error);
    }
    emit changed();
}

bool AccuracyStudy::isAbout(const Subject &subject) const
{
    return subject.lesson == m_run.lesson().id && subject.step == m_run.step().id &&
           sameScene(subject.script, m_run.timeline().script());
}

QString AccuracyStudy::leftOut() const
{
    return programOf(m_run.timeline().script().method)
               ? tr("Your code is left out: it computes whole frames, so it cannot be compared with shorter "
                    "steps.")
               : QString();
}

const sim::AccuracyRow *AccuracyStudy::inUse() const
{
    if (!m_accuracy)
        return nullptr;
    const sim::Script &script = m_run.timeline().script();
    const sim::MethodSetup setup{script.method, script.step};
    const auto &rows = m_accuracy->rows;
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const sim::AccuracyRow &row) { return sameSetup(row.setup, setup); });
    return found == rows.end() ? nullptr : &*found;
}

void AccuracyStudy::followRun()
{
    if (!m_subject) {
        if (m_settleTimer.isActive())
            m_settleTimer.start(); // the scene is still changing
        return;
    }
    const bool sameSubject = isAbout(*m_subject);
    if (!sameSubject) {
        m_job.cancel();
        m_accuracy.reset();
        m_stage = Stage::none;
        m_subject.reset();
    }
    // A finished study that does not cover the session's method or step must be repeated.
    const bool isMissing = m_stage == Stage::done && !inUse() && leftOut().isEmpty();
    if (m_isActive && (!sameSubject || isMissing))
        m_settleTimer.start();
    else
        m_settleTimer.stop();
    emit changed();
}

void AccuracyStudy::adopt(const sim::MethodSetup &setup)
{
    m_editor.use(setup.method, setup.step);
}

}
