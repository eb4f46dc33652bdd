#include "app/model/accuracy_study.h"

#include "app/model/sentences.h"

#include <QElapsedTimer>

#include <algorithm>
#include <atomic>

namespace app {

namespace {

bool sameScene(const sim::Script &a, const sim::Script &b)
{
    return a.values == b.values && a.bodies == b.bodies && a.effectsOff == b.effectsOff && a.input == b.input;
}

}

struct AccuracyStudy::Run
{
    std::atomic<bool> stop = false;
    std::optional<sim::Error> error; ///< written before the thread ends, read after
};

bool sameWay(const sim::MethodSetup &a, const sim::MethodSetup &b)
{
    return a.method && b.method && a.method->id() == b.method->id() && a.step == b.step;
}

AccuracyStudy::AccuracyStudy(Session &session, StudyFunction function, QObject *parent)
    : QObject(parent), m_session(session), m_function(std::move(function))
{
    m_later.setSingleShot(true);
    m_later.setInterval(settleMilliseconds);
    connect(&m_later, &QTimer::timeout, this, &AccuracyStudy::start);
    connect(&session, &Session::runChanged, this, &AccuracyStudy::follow);
    connect(&session, &Session::stepOpened, this, &AccuracyStudy::follow);
}

AccuracyStudy::~AccuracyStudy()
{
    stop();
    if (m_thread.joinable())
        m_thread.join();
}

void AccuracyStudy::setWatched(bool watched)
{
    if (watched == m_watched)
        return;
    m_watched = watched;
    if (watched && (!m_accuracy || m_stage == Stage::none)) {
        start();
        return;
    }
    if (!watched) {
        m_later.stop();
        stop();
        if (m_stage == Stage::measuring)
            m_stage = Stage::none; // whoever watches again wants it to go on
    }
    emit changed();
}

void AccuracyStudy::start()
{
    m_later.stop();
    m_stage = Stage::measuring;
    m_done = 0.0;
    m_refusal.clear();
    m_subject = Subject{m_session.lesson().id, m_session.step().id, m_session.timeline().script()};
    stop();
    if (m_run)
        m_again = true; // end() begins the new one
    else
        begin();
    emit changed();
}

void AccuracyStudy::begin()
{
    m_again = false;
    if (m_thread.joinable())
        m_thread.join(); // it has said its last word already
    const auto run = std::make_shared<Run>();
    m_run = run;
    sim::StudyPlan plan;
    plan.inUse = sim::MethodSetup{m_subject->script.method, m_subject->script.step};
    m_thread = std::thread([this, run, plan, script = m_subject->script, function = m_function] {
        QElapsedTimer sinceTold;
        const auto tell = [&](const sim::Accuracy &soFar, double done) {
            sinceTold.start();
            auto copy = std::make_shared<const sim::Accuracy>(soFar);
            QMetaObject::invokeMethod(
                this, [this, run, copy = std::move(copy), done] { take(run, copy, done); },
                Qt::QueuedConnection);
        };
        try {
            const sim::Accuracy last = function(script, plan, [&](const sim::Accuracy &soFar, double done) {
                if (run->stop)
                    return false;
                if (!sinceTold.isValid() || sinceTold.hasExpired(tellMilliseconds))
                    tell(soFar, done);
                return true;
            });
            tell(last, run->stop ? 0.0 : 1.0);
        } catch (const sim::Error &error) {
            run->error = error;
        }
        QMetaObject::invokeMethod(
            this, [this, run] { end(run); }, Qt::QueuedConnection);
    });
}

void AccuracyStudy::stop()
{
    m_again = false;
    if (m_run)
        m_run->stop = true;
}

void AccuracyStudy::cancel()
{
    m_later.stop();
    if (m_stage != Stage::measuring)
        return;
    stop();
    m_stage = Stage::cancelled;
    emit changed();
}

void AccuracyStudy::take(const std::shared_ptr<Run> &run, std::shared_ptr<const sim::Accuracy> accuracy,
                         double done)
{
    if (run->stop)
        return;
    m_accuracy = std::move(accuracy);
    m_done = done;
    emit changed();
}

void AccuracyStudy::end(const std::shared_ptr<Run> &run)
{
    m_run.reset();
    if (m_again) {
        begin();
        return;
    }
    if (run->stop)
        return;
    m_stage = Stage::done;
    m_done = 1.0;
    if (run->error) {
        m_stage = Stage::refused;
        m_accuracy.reset();
        m_refusal = sentenceFor(*run->error);
    }
    emit changed();
}

bool AccuracyStudy::isAbout(const Subject &subject) const
{
    return subject.lesson == m_session.lesson().id && subject.step == m_session.step().id &&
           sameScene(subject.script, m_session.timeline().script());
}

const sim::AccuracyRow *AccuracyStudy::inUse() const
{
    if (!m_accuracy)
        return nullptr;
    const sim::Script &script = m_session.timeline().script();
    const sim::MethodSetup setup{script.method, script.step};
    const auto &rows = m_accuracy->rows;
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const sim::AccuracyRow &row) { return sameWay(row.setup, setup); });
    return found == rows.end() ? nullptr : &*found;
}

void AccuracyStudy::follow()
{
    if (!m_subject) {
        if (m_later.isActive())
            m_later.start(); // it goes on changing
        return;
    }
    const bool sameSubject = isAbout(*m_subject);
    if (!sameSubject) {
        stop();
        m_accuracy.reset();
        m_stage = Stage::none;
        m_subject.reset();
    }
    // A method or step that a finished study does not cover needs another study.
    const bool isMissing = m_stage == Stage::done && !inUse();
    if (m_watched && (!sameSubject || isMissing))
        m_later.start();
    else
        m_later.stop();
    emit changed();
}

void AccuracyStudy::adopt(const sim::MethodSetup &setup)
{
    m_session.use(setup.method, setup.step);
}

}
