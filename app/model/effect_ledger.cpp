#include "app/model/effect_ledger.h"

#include "app/model/workshop.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>

namespace app {

EffectLedger::EffectLedger(Session &session, CostFunction function, QObject *parent)
    : QObject(parent), m_session(session), m_costs(session, std::move(function))
{
    m_asking.setMaxThreadCount(1);
    connect(&m_costs, &CostWatch::changed, this, &EffectLedger::changed);
}

EffectLedger::~EffectLedger()
{
    m_leave = true;
    m_asking.waitForDone();
}

void EffectLedger::setWatched(bool watched)
{
    m_costs.setWatched(watched);
    if (watched && !m_isAsked)
        askLessons();
}

void EffectLedger::askLessons()
{
    m_isAsked = true;
    m_asking.start([this, &library = m_session.library()] {
        std::vector<KnownEffect> known = effectsKnownBy(library, [this] { return !m_leave; });
        QMetaObject::invokeMethod(
            this,
            [this, known = std::move(known)] {
                m_known = known;
                m_knowsAll = true;
                emit changed();
            },
            Qt::QueuedConnection);
    });
}

const std::vector<sim::EffectPtr> &EffectLedger::listed() const
{
    const std::shared_ptr<const sim::ComposedInterval> interval = m_session.timeline().track().nextInterval();
    if (m_listedIn.lock() != interval) {
        m_listed = m_session.listedEffects();
        m_listedIn = interval;
    }
    return m_listed;
}

std::vector<EffectLine> EffectLedger::lines() const
{
    EffectFacts facts;
    facts.listed = listed();
    facts.off = m_session.timeline().script().effectsOff;
    facts.leftOut = m_session.timeline().track().nextInterval()->pipeline.idleEffects;
    facts.cost = m_costs.cost();
    facts.known = m_known;
    facts.offered = m_session.step().availableEffects;
    return effectLines(facts);
}

QString EffectLedger::caption() const
{
    const CostWatch::Stage stage = m_costs.stage();
    if (!m_costs.cost())
        return stage == CostWatch::Stage::none ? QString() : tr("measuring…");
    const QString frame = frameWords(*m_costs.cost());
    if (stage != CostWatch::Stage::done)
        return tr("%1, measuring…").arg(frame);
    return m_session.timeline().cursor().frame == m_costs.frame()
               ? tr("%1, measured now").arg(frame)
               : tr("%1, measured at frame %2").arg(frame).arg(m_costs.frame());
}

void EffectLedger::switchEffect(const QString &id, bool on)
{
    const std::vector<sim::EffectPtr> &now = listed();
    const bool isThere = std::any_of(
        now.begin(), now.end(), [&](const sim::EffectPtr &one) { return one->id() == id.toStdString(); });
    if (isThere)
        m_session.setEffect(id, on);
    else
        setBuiltEffect(m_session, id, on);
}

}
