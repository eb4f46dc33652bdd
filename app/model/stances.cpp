#include "app/model/stances.h"

#include <algorithm>
#include <cmath>

namespace app {

void Stances::follow(const Course &course, std::size_t feet)
{
    if (!goesOn(course, feet)) {
        m_feet.assign(feet, {});
        m_stood.assign(feet, 0);
        m_framesPerOutput = course.rowFrames();
        m_next = course.first();
    }
    m_first = course.first();
    if (course.isEmpty() || feet == 0)
        return;
    for (; m_next <= course.last(); m_next += m_framesPerOutput)
        add(*course.at(m_next), m_next);
    forgetBefore(m_first);
}

/// Whether the course has what was read of it, but for its first rows, and goes on after that.
bool Stances::goesOn(const Course &course, std::size_t feet) const
{
    return feet == m_feet.size() && !course.isEmpty() && course.rowFrames() == m_framesPerOutput &&
           course.first() >= m_first && course.first() <= m_next &&
           course.last() >= m_next - m_framesPerOutput;
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
