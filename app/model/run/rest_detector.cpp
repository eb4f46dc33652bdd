#include "app/model/run/rest_detector.h"

#include <QElapsedTimer>

#include <limits>

namespace app {

namespace {

constexpr qint64 aheadMilliseconds = 4;
constexpr std::int64_t recheckAfter = 300; ///< frames; after these, a moving run may have come to rest
constexpr std::int64_t mostFramesAhead =
    100'000;                  ///< frames; a run that does not sleep by then may never sleep
constexpr double seen = 1e-6; ///< px, px/frame or degrees

bool isApart(const sim::State &a, const sim::State &b)
{
    const auto differs = [](const auto &x, const auto &y) {
        return x.rows() != y.rows() || !((x - y).abs() <= seen).all();
    };
    return differs(a.position, b.position) || differs(a.velocity, b.velocity) || differs(a.angle, b.angle);
}

}

void RestDetector::begin(const sim::Track &run)
{
    m_ahead = run;
    m_ahead->setBudget(0);
}

bool RestDetector::isOver(const sim::Track &run)
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
    while (!m_ahead->isFinished() && clock.elapsed() < aheadMilliseconds) {
        m_ahead->seek({m_ahead->cursor().frame + m_ahead->framesPerOutput(), 0});
        const bool tooFar = m_ahead->cursor().frame > run.cursor().frame + mostFramesAhead;
        if (tooFar || isApart(m_ahead->state(), m_last)) {
            m_again = tooFar ? std::numeric_limits<std::int64_t>::max() : run.cursor().frame + recheckAfter;
            m_ahead.reset();
            return false;
        }
    }
    m_isOver = m_ahead->isFinished();
    return m_isOver;
}

}
