#include "app/model/run/companion_run.h"

#include "app/model/run/same_run.h"
#include "app/model/run/time_slice.h"
#include "sim/analysis/accuracy/study_run.h"
#include "sim/base/error.h"
#include "sim/methods/methods.h"

#include <algorithm>

namespace app {

namespace {

constexpr std::size_t companionMemory = std::size_t{32} << 20;

}

void CompanionRun::take(const sim::Script &script)
{
    const bool goesOn = m_track && sameButForInput(m_script, script);
    const std::int64_t from = goesOn ? sim::firstDifference(m_script.input, script.input) : 0;
    m_script = script;
    const sim::MethodPtr method = sim::findMethod(m_companion.method.toStdString());
    sim::Script own =
        sim::scriptFor(script, {method, sim::stepFor(*method, sim::StepSize::ofLength(m_companion.h))});
    for (const auto &[id, value] : m_companion.values)
        own.values.set(id.toStdString(), value);
    try {
        if (from >
            1) { // dragging changes the input many times a second; keep what was computed before the change
            sim::Track::NewInput input = m_track->prepareInput(std::move(own.input), from);
            m_track->seek({std::min(from - 1, m_track->computed()), 0});
            m_track->replaceInput(std::move(input));
        } else {
            m_track = std::make_unique<sim::Track>(std::move(own), companionMemory);
        }
    } catch (const sim::Error &) {
        m_track.reset();
    }
}

bool CompanionRun::follow(const sim::Script &script, std::int64_t frame)
{
    if (!m_isTaken || !sameButForInput(m_script, script) || m_script.input != script.input)
        take(script);
    m_isTaken = true;
    if (!m_track)
        return true;
    return goNearer(*m_track, frame);
}

}
