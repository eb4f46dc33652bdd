#include "app/ui/scene/body_drag.h"

#include <QLineF>

namespace app {

namespace {

constexpr double reach = 12.0;     ///< screen px
constexpr double clickSlack = 3.0; ///< screen px that the mouse may move during a click

/// Returns whether the larger disc of `above` covers the whole disc of `below`, so that nobody can see what is below.
bool covers(const SceneContent &shown, int above, int below)
{
    const double apart = sim::length(shown.state().positionOf(above) - shown.state().positionOf(below));
    return apart + shown.radius(below) < shown.radius(above);
}

}

int BodyDrag::bodyAt(const SceneContent &shown, const Camera &camera, QPointF place)
{
    int nearest = -1;
    double least = 0.0;
    for (int i = 0; i < shown.points(); ++i) {
        if (shown.isHidden(i))
            continue;
        const QPointF away = camera.at(shown.state().positionOf(i)) - place;
        const double distance = QPointF::dotProduct(away, away);
        const double most = std::max(reach, camera.radius(shown.radius(i)));
        if (distance > most * most)
            continue;
        // Later bodies are drawn over earlier ones.
        if (nearest < 0 || distance < least || covers(shown, i, nearest)) {
            nearest = i;
            least = distance;
        }
    }
    return nearest;
}

void BodyDrag::press(const QString &body, sim::Vec2 where, sim::Vec2 place, QPointF pointer)
{
    m_body = body;
    m_offset = where - place;
    m_pressed = pointer;
    m_holds = m_playback.isPlaying();
    if (m_holds)
        m_input.grab(body);
    else
        m_input.select(body);
}

void BodyDrag::carry(sim::Vec2 place, QPointF pointer)
{
    if (!m_body)
        return;
    if (!m_holds) {
        if (QLineF(m_pressed, pointer).length() < clickSlack)
            return;
        m_holds = true;
        m_playback.startForInput(); // before the grab, which makes the cursor the end of the run
        m_input.grab(*m_body);
    }
    m_input.moveTo(place + m_offset);
    m_playback.reportIfPaused(); // after each change, which clears the status bar
}

void BodyDrag::release()
{
    const bool held = m_holds;
    m_body.reset();
    m_holds = false;
    if (held) {
        m_input.release();
        m_playback.reportIfPaused();
    }
}

}
