#include "app/model/remedy_search.h"

#include <atomic>

namespace app {

struct RemedySearch::Run
{
    std::atomic<bool> isLeft = false; ///< nobody waits for it any more
};

RemedySearch::RemedySearch(Session &session, QObject *parent) : QObject(parent), m_session(session)
{
    connect(&session, &Session::stepOpened, this, &RemedySearch::forget);
    connect(&session, &Session::runChanged, this, &RemedySearch::forget);
    connect(&session, &Session::moved, this, &RemedySearch::look);
}

RemedySearch::~RemedySearch()
{
    if (m_run)
        m_run->isLeft = true;
    if (m_thread.joinable())
        m_thread.join();
}

const sim::Stop *RemedySearch::stop() const
{
    const std::optional<sim::Stop> &stop = m_session.timeline().stop();
    return stop && m_session.timeline().cursor().frame == stop->frame ? &*stop : nullptr;
}

void RemedySearch::forget()
{
    if (m_run)
        m_run->isLeft = true;
    m_run.reset();
    m_found.clear();
    look();
    emit changed();
}

void RemedySearch::look()
{
    const bool isStopped = stop() != nullptr;
    if (isStopped && !m_run)
        begin();
    if (isStopped != m_wasStopped) {
        m_wasStopped = isStopped;
        emit changed();
    }
}

void RemedySearch::begin()
{
    if (m_thread.joinable())
        m_thread.join(); // it has ended, or ends at once
    const auto run = std::make_shared<Run>();
    m_run = run;
    m_isDone = false;
    m_thread = std::thread([this, run, script = m_session.timeline().script(), stop = *stop(),
                            damping = m_session.damping()] {
        std::vector<sim::Remedy> found =
            sim::remediesAfter(script, stop, damping ? &*damping : nullptr, [run] { return !run->isLeft; });
        QMetaObject::invokeMethod(
            this,
            [this, run, found = std::move(found)] {
                if (run != m_run)
                    return;
                m_found = found;
                m_isDone = true;
                emit changed();
            },
            Qt::QueuedConnection);
    });
}

QString remedyHelp(const sim::Remedy &remedy)
{
    const QString what = RemedySearch::tr(
        "Computes the run again with that, up to this frame. What you did is kept, and the old run "
        "stays as a ghost.");
    if (remedy.stableFrames == 0)
        return what + ' ' + RemedySearch::tr("Not tried out: that would take long.");
    return what + ' ' +
           RemedySearch::tr("Tried out: it holds for %n frames.", nullptr, int(remedy.stableFrames));
}

}
