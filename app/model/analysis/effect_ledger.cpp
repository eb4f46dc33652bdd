#include "app/model/analysis/effect_ledger.h"

#include "app/model/sandbox/sandbox.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>

namespace app {

EffectLedger::EffectLedger(const OpenRun &run, RunEditor &editor, const Playback &playback,
                           CostFunction function, std::shared_ptr<QThreadPool> thread, QObject *parent)
    : QObject(parent), m_run(run), m_editor(editor), m_playback(playback),
      m_costs(run, playback, std::move(function), std::move(thread))
{
    connect(&m_costs, &CostMonitor::changed, this, &EffectLedger::changed);
}

void EffectLedger::setActive(bool isActive)
{
    m_costs.setActive(isActive);
    if (isActive && !m_knowsAll && !m_request.isRunning())
        requestKnownEffects();
}

void EffectLedger::requestKnownEffects()
{
    m_request.start(
        [&library = m_run.library()](const BackgroundJob::Context &job) {
            return effectsKnownBy(library, job.shouldContinue());
        },
        [this](std::future<std::vector<KnownEffect>> known) {
            m_known = known.get();
            m_knowsAll = true;
            emit changed();
        });
}

const std::vector<sim::EffectPtr> &EffectLedger::listed() const
{
    const std::shared_ptr<const sim::ComposedInterval> interval = m_run.timeline().track().nextInterval();
    if (m_listedIn.lock() != interval) {
        m_listed = m_editor.listedEffects();
        m_listedIn = interval;
    }
    return m_listed;
}

std::vector<EffectLine> EffectLedger::lines() const
{
    EffectFacts facts;
    facts.listed = listed();
    facts.off = m_run.timeline().script().effectsOff;
    facts.leftOut = m_run.timeline().track().nextInterval()->pipeline.idleEffects;
    facts.cost = m_costs.cost();
    facts.known = m_known;
    facts.offered = m_run.step().availableEffects;
    return effectLines(facts);
}

QString EffectLedger::caption() const
{
    const CostMonitor::Stage stage = m_costs.stage();
    if (!m_costs.cost())
        return stage == CostMonitor::Stage::none ? QString() : tr("measuring…");
    const QString frame = frameWords(*m_costs.cost());
    if (stage != CostMonitor::Stage::done)
        return tr("%1, measuring…").arg(frame);
    return m_run.timeline().cursor().frame == m_costs.frame()
               ? tr("%1, measured now").arg(frame)
               : tr("%1, measured at frame %2").arg(frame).arg(m_costs.frame());
}

void EffectLedger::switchEffect(const QString &id, bool on)
{
    const std::vector<sim::EffectPtr> &now = listed();
    const bool isThere = std::any_of(
        now.begin(), now.end(), [&](const sim::EffectPtr &one) { return one->id() == id.toStdString(); });
    if (isThere)
        m_editor.setEffect(id, on);
    else
        setBuiltEffect(m_run, m_editor, m_playback, id, on);
}

}
