#include "app/model/picture/motion_area.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {

namespace {

constexpr int mostTurned =
    2000; ///< branches whose ends are computed; in larger trees only their starts count
constexpr double branchWidth = 2.0; ///< px around a branch

/// Returns the box of all points, with one `radius` in px for all of them.
QRectF boxOfPlaces(const sim::State &state, double radius)
{
    const auto x = state.position.col(0);
    const auto y = state.position.col(1);
    return QRectF(QPointF(x.minCoeff(), y.minCoeff()), QPointF(x.maxCoeff(), y.maxCoeff()))
        .adjusted(-radius, -radius, radius, radius);
}

QRectF boxOfTree(const lessons::TreeView &tree, const sim::State &state)
{
    const int count = std::min(static_cast<int>(tree.length.size()), static_cast<int>(state.angle.rows()));
    if (count > mostTurned)
        return boxOfPlaces(state, branchWidth);
    QRectF area;
    for (int i = 0; i < count; ++i) {
        const double angle = state.angle[i] * std::numbers::pi / 180.0;
        const double length = tree.length[static_cast<std::size_t>(i)];
        const QPointF from(state.position(i, 0), state.position(i, 1));
        const QPointF to = from + length * QPointF(std::cos(angle), std::sin(angle));
        area |= QRectF(from, to).normalized().adjusted(-branchWidth, -branchWidth, branchWidth, branchWidth);
    }
    return area;
}

}

QRectF subjectBox(const lessons::View &view, const sim::State &state)
{
    if (state.pointCount() == 0)
        return {};
    if (view.tree)
        return boxOfTree(*view.tree, state);
    QRectF box;
    for (int i = 0; i < state.pointCount(); ++i) {
        const double radius = view.bodies[static_cast<std::size_t>(i)].radius;
        const QPointF at(state.position(i, 0), state.position(i, 1));
        box |= QRectF(at, at).adjusted(-radius, -radius, radius, radius);
    }
    return box;
}

double followedX(const lessons::View &view, const sim::State &state)
{
    return view.followedPoint >= 0 && view.followedPoint < state.pointCount()
               ? state.positionOf(view.followedPoint).x
               : 0.0;
}

MotionArea::MotionArea(const sim::Script &script, std::shared_ptr<const lessons::View> view,
                       std::int64_t from, std::int64_t to)
    : m_track(script, 0), m_view(std::move(view)), m_from(from), m_to(to)
{
    add();
}

bool MotionArea::goOn(qint64 milliseconds)
{
    QElapsedTimer clock;
    clock.start();
    do {
        if (m_track.isFinished() &&
            m_area.isNull()) // the run rests before the first measured frame: measure this state
            m_from = m_track.cursor().frame;
        if (m_track.isFinished() || m_track.cursor().frame + m_track.framesPerOutput() > m_to) {
            add();
            return true;
        }
        m_track.seek({m_track.cursor().frame + m_track.framesPerOutput(), 0});
        add();
    } while (clock.elapsed() < milliseconds);
    return false;
}

void MotionArea::add()
{
    const sim::State &state = m_track.state();
    if (m_track.cursor().frame < m_from || state.pointCount() != static_cast<int>(m_view->bodies.size()))
        return;
    m_area |= subjectBox(*m_view, state).translated(-followedX(*m_view, state), 0.0);
}

}
