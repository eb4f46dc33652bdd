#include "sim/methods/adaptive/advance.h"

#include <algorithm>

namespace sim {

bool Advance::toNextFrame(Patient &patient, const LapVisit &visit)
{
    m_visit = &visit;
    if (m_ahead.to > 0.0)
        tell(0.0);
    return toNextFrame(patient);
}

void Advance::tell(double start) const
{
    const Ahead &ahead = m_ahead;
    Lap lap;
    lap.flow = &m_course.flow;
    lap.start = start;
    lap.end = std::min(ahead.to, 1.0);
    lap.at = [this, from = ahead.from, h = ahead.length](double time, Eigen::ArrayXd &place,
                                                         Eigen::ArrayXd &speed) {
        place.resize(m_size);
        speed.resize(m_size);
        denseAll(h, (time - from) / h, place.data(), speed.data());
    };
    if (ahead.to > 1.0) {
        lap.at(1.0, lap.nextPlace, lap.nextSpeed);
    } else {
        lap.nextPlace = Eigen::Map<const Eigen::ArrayXd>(endPlace(), m_size);
        lap.nextSpeed = Eigen::Map<const Eigen::ArrayXd>(endSpeed(), m_size);
    }
    (*m_visit)(lap);
}

void Advance::tellBegun(const Eigen::ArrayXd &place, const Eigen::ArrayXd &speed) const
{
    Lap lap; // of no length: what stood past a surface is put onto it
    lap.flow = &m_course.flow;
    lap.at = [&](double, Eigen::ArrayXd &x, Eigen::ArrayXd &v) {
        x = place;
        v = speed;
    };
    lap.nextPlace = Eigen::Map<const Eigen::ArrayXd>(endPlace(), m_size);
    lap.nextSpeed = Eigen::Map<const Eigen::ArrayXd>(endSpeed(), m_size);
    (*m_visit)(lap);
}

}
