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
    if (m_isOver || run.isFinished())
        return true;
    const bool stands = run.cursor().phase == 0 && !isApart(run.state(), m_last);
    if (!stands) {
        m_last = run.state();
        m_ahead.reset();
        return false;
    }
    if (run.cursor().frame < m_again)
        return false;
    if (!m_ahead)
        begin(run);
    QElapsedTimer clock;
    clock.start();
    while (!m_ahead->isFinished() && clock.elapsed() < sliceMilliseconds) {
        m_ahead->seek({m_ahead->cursor().frame + m_ahead->framesPerOutput(), 0});
        const bool tooFar = m_ahead->cursor().frame > run.cursor().frame + farthest;
        if (tooFar || isApart(m_ahead->state(), m_last)) {
            m_again = tooFar ? std::numeric_limits<std::int64_t>::max() : run.cursor().frame + lookAgain;
            m_ahead.reset();
            return false;
        }
    }
    m_isOver = m_ahead->isFinished();
    return m_isOver;
}

}
