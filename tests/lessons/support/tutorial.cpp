#include "tests/lessons/support/tutorial.h"

#include <cmath>

namespace support {

void DraggedClips::takeInput()
{
    ++m_frame;
    for (const sim::Event &event : input) {
        if (event.frame == m_frame)
            handle(event);
    }
}

void DraggedClips::handle(const sim::Event &event)
{
    if (const auto *grab = std::get_if<sim::Grab>(&event.what)) {
        m_held = findClip(grab->body);
        m_dragX = m_held->x;
        m_dragY = m_held->y;
    } else if (const auto *move = std::get_if<sim::Move>(&event.what)) {
        m_dragX = move->to.x;
        m_dragY = move->to.y;
    } else if (m_held) {
        m_held->x = m_dragX;
        m_held->y = m_dragY;
        m_held = nullptr;
    }
}

void DraggedClips::moveHeld(bool keepsVelocity)
{
    if (keepsVelocity) {
        m_held->vx = m_dragX - m_held->x;
        m_held->vy = m_dragY - m_held->y;
    }
    m_held->x = m_dragX;
    m_held->y = m_dragY;
}

void Tutorial::enterFrame()
{
    takeInput();
    if (held())
        moveHeld(held() != &body || kind == Kind::mutual);
    for (Clip &foot : feet) {
        if (&foot != held())
            footSpring(foot);
    }
    if (kind == Kind::mutual && held() != &body)
        bodySpring();
}

std::vector<Clip> Tutorial::clips() const
{
    std::vector<Clip> all = feet;
    if (kind != Kind::fixedCentre)
        all.push_back(body);
    return all;
}

Clip *Tutorial::findClip(const std::string &name)
{
    if (name == "body")
        return &body;
    const std::string number = name.substr(std::string("foot").size());
    return &feet.at(number.empty() ? 0 : std::stoul(number));
}

void Tutorial::footSpring(Clip &foot)
{
    if (kind == Kind::fixedCentre)
        springTo(foot, centreX, centreY);
    else if (kind == Kind::movingBody)
        springTo(foot, body.x, body.y);
    else if (kind == Kind::offset)
        springTo(foot, body.x + offset, body.y);
    else
        springAround(foot, body);
    dampAndMove(foot);
}

void Tutorial::bodySpring()
{
    for (const Clip &foot : feet)
        springAround(body, foot);
    dampAndMove(body);
}

void Tutorial::springTo(Clip &clip, double targetX, double targetY) const
{
    clip.vx += (targetX - clip.x) * k;
    clip.vy += (targetY - clip.y) * k;
}

void Tutorial::springAround(Clip &clip, const Clip &other) const
{
    const double dx = clip.x - other.x;
    const double dy = clip.y - other.y;
    const double angle = std::atan2(dy, dx);
    springTo(clip, other.x + std::cos(angle) * radius, other.y + std::sin(angle) * radius);
}

void Tutorial::dampAndMove(Clip &clip) const
{
    clip.vy += gravity;
    clip.vx *= damp;
    clip.vy *= damp;
    clip.x += clip.vx;
    clip.y += clip.vy;
    if (!hasWalls)
        return;
    if (clip.x > right - clip.width / 2) {
        clip.x = right - clip.width / 2;
        clip.vx *= -bounce;
    }
    if (clip.x < left + clip.width / 2) {
        clip.x = left + clip.width / 2;
        clip.vx *= -bounce;
    }
    if (clip.y > floor - clip.width / 2) {
        clip.y = floor - clip.width / 2;
        clip.vy *= -bounce;
    }
}

}
