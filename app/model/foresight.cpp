#include "app/model/foresight.h"

#include <QElapsedTimer>

#include <algorithm>
#include <limits>

namespace app {

namespace {

constexpr qint64 sliceMilliseconds = 4;
constexpr std::int64_t lookAgain = 300;    ///< frames after which what still moved may have come to rest
constexpr std::int64_t farthest = 100'000; ///< frames; what does not sleep by then may never do so
constexpr double seen = 1e-6;              ///< px, px/frame or degrees

bool isApart(const sim::State &a, const sim::State &b)
{
    const auto differs = [](const auto &x, const auto &y) {
        return x.rows() != y.rows() || !((x - y).abs() <= seen).all();
    };
    return differs(a.position, b.position) || differs(a.velocity, b.velocity) || differs(a.angle, b.angle);
}

}

void Foresight::begin(const sim::Track &run)
{
    m_ahead = run;
    m_ahead->setBudget(0);
}

bool Foresight::isOver(const sim::Track &run)
{
    if (m_isOver || run.isOver())
        return true;
    const bool stands = run.at().phase == 0 && !isApart(run.now(), m_last);
    if (!stands) {
        m_last = run.now();
        m_ahead.reset();
        return false;
    }
    if (run.at().frame < m_again)
        return false;
    if (!m_ahead)
        begin(run);
    QElapsedTimer clock;
    clock.start();
    while (!m_ahead->isOver() && clock.elapsed() < sliceMilliseconds) {
        m_ahead->seek({m_ahead->at().frame + m_ahead->rowFrames(), 0});
        const bool tooFar = m_ahead->at().frame > run.at().frame + farthest;
        if (tooFar || isApart(m_ahead->now(), m_last)) {
            m_again = tooFar ? std::numeric_limits<std::int64_t>::max() : run.at().frame + lookAgain;
            m_ahead.reset();
            return false;
        }
    }
    m_isOver = m_ahead->isOver();
    return m_isOver;
}

}
