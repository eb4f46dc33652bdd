#include "app/model/series/stances.h"

#include <algorithm>
#include <cmath>

namespace app {

void Stances::follow(const MeasureSeries &series, std::size_t feet)
{
    if (!goesOn(series, feet)) {
        m_feet.assign(feet, {});
        m_stood.assign(feet, 0);
        m_framesPerOutput = series.framesPerOutput();
        m_next = series.first();
    }
    m_first = series.first();
    if (series.isEmpty() || feet == 0)
        return;
    for (; m_next <= series.last(); m_next += m_framesPerOutput)
        add(*series.at(m_next), m_next);
    forgetBefore(m_first);
}

/// Returns whether the series still contains what was read of it, except for its first output steps, and continues it.
bool Stances::goesOn(const MeasureSeries &series, std::size_t feet) const
{
    return feet == m_feet.size() && !series.isEmpty() && series.framesPerOutput() == m_framesPerOutput &&
           series.first() >= m_first && series.first() <= m_next &&
           series.last() >= m_next - m_framesPerOutput;
}

void Stances::add(const Sample &sample, std::int64_t frame)
{
    for (std::size_t foot = 0; foot < m_feet.size(); ++foot) {
        const bool stands = foot < sample.stands.size() && sample.stands[foot];
        std::vector<Stance> &stances = m_feet[foot];
        if (stands && !m_stood[foot])
            stances.push_back({frame, frame, 0.0});
        if (stands) {
            stances.back().to = frame;
            stances.back().slip += m_stood[foot] ? std::abs(sample.slips[foot]) : 0.0;
        }
        m_stood[foot] = stands;
    }
}

void Stances::forgetBefore(std::int64_t frame)
{
    for (std::vector<Stance> &stances : m_feet) {
        const auto stays = std::find_if(stances.begin(), stances.end(),
                                        [frame](const Stance &one) { return one.to >= frame; });
        stances.erase(stances.begin(), stays);
        if (!stances.empty())
            stances.front().from = std::max(stances.front().from, frame);
    }
}

}
