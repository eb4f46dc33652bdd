#include "app/model/analysis/remedy_search.h"

#include "app/model/run/run_program.h"

namespace app {

RemedySearch::RemedySearch(const OpenRun &run, const RunEditor &editor, QObject *parent)
    : QObject(parent), m_run(run), m_editor(editor)
{
    run.onChange(ChangeKind::step | ChangeKind::run, this, &RemedySearch::reset);
    run.onChange(ChangeKind::cursor, this, &RemedySearch::update);
}

const sim::Stop *RemedySearch::stop() const
{
    const std::optional<sim::Stop> &stop = m_run.timeline().stop();
    return stop && m_run.timeline().cursor().frame == stop->frame ? &*stop : nullptr;
}

void RemedySearch::reset()
{
    m_search.cancel();
    m_hasBegun = false;
    m_found.clear();
    update();
    emit changed();
}

void RemedySearch::update()
{
    const bool isStopped = stop() != nullptr;
    if (isStopped && !m_hasBegun)
        begin();
    if (isStopped != m_wasStopped) {
        m_wasStopped = isStopped;
        emit changed();
    }
}

void RemedySearch::begin()
{
    m_hasBegun = true;
    if (programOf(m_run.timeline().script().method))
        return; // the mistake is in the learner's code, which no other step mends
    m_search.start(
        [script = m_run.timeline().script(), stop = *stop(),
         damping = m_editor.damping()](const BackgroundJob::Context &job) {
            return sim::remediesAfter(script, stop, damping ? &*damping : nullptr, job.shouldContinue());
        },
        [this](std::future<std::vector<sim::Remedy>> found) {
            m_found = found.get();
            emit changed();
        });
}

QString remedyHelp(const sim::Remedy &remedy)
{
    const QString what = RemedySearch::tr("Computes the run again with this change, up to this frame. Your "
                                          "input is kept, and the old run stays as a ghost.");
    if (remedy.stableFrames == 0)
        return what + ' ' + RemedySearch::tr("Not tested: that would take too long.");
    return what + ' ' +
           RemedySearch::tr("Tested: it is stable for %n frames.", nullptr, int(remedy.stableFrames));
}

}
