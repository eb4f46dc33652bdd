#include "tests/lessons/player.h"

#include "sim/methods/methods.h"

#include <limits>

namespace support {

Player::Player(const lessons::Step &step, std::size_t wanted)
    : m_step(step), m_run(step.script()), m_try(step.tries.at(wanted)),
      m_timing([](const sim::Script &, std::int64_t) { return std::numeric_limits<double>::infinity(); })
{
    look();
}

void Player::look()
{
    m_done = m_done || (m_try.done(m_run) &&
                        (!m_try.budget || lessons::keeps(*m_try.budget, m_run.script(), m_timing)));
}

void Player::play(int frames)
{
    for (int i = 0; i < frames; ++i) {
        m_run.stepRow();
        look();
    }
}

void Player::playUntilDone(int frames)
{
    for (int i = 0; i < frames && !m_done; ++i)
        play(1);
}

void Player::grab(const std::string &body)
{
    m_held = body;
    m_run.hand(sim::Grab{body});
    look();
}

void Player::carryTo(sim::Vec2 to, int frames)
{
    const sim::Vec2 from = at(m_held);
    for (int i = 1; i <= frames; ++i) {
        m_run.hand(sim::Move{from + (double(i) / frames) * (to - from)});
        play(1);
    }
}

void Player::letGo()
{
    m_run.hand(sim::Release{});
    look();
}

void Player::drag(const std::string &body, sim::Vec2 to, int frames)
{
    grab(body);
    carryTo(to, frames);
    letGo();
}

void Player::point(sim::Vec2 at, bool down)
{
    m_run.hand(sim::Pointer{at, down});
    look();
}

void Player::target(sim::Vec2 at)
{
    m_run.hand(sim::Target{at});
    look();
}

void Player::key(bool sim::Keys::*key, bool down)
{
    m_run.hand(sim::Key{key, down});
    look();
}

void Player::set(const std::string &parameter, double value)
{
    const lessons::Parameter *declared = m_step.parameter(QString::fromStdString(parameter));
    if (declared && declared->opens) {
        sim::Values values = m_step.presets();
        values.set(parameter, value);
        m_run = sim::Timeline(m_step.scriptWith(values, m_run.script().method));
    } else {
        m_run.set(parameter, value);
    }
    look();
}

void Player::use(sim::Script script)
{
    script.step = sim::stepFor(*script.method, script.step);
    m_run.replace(std::move(script));
    look();
}

void Player::useMethod(const std::string &id)
{
    sim::Script script = m_run.script();
    script.method = sim::findMethod(id);
    use(std::move(script));
}

void Player::useStep(double h)
{
    sim::Script script = m_run.script();
    script.step = sim::StepSize::of(h);
    use(std::move(script));
}

void Player::useTolerance(double tolerance)
{
    sim::Script script = m_run.script();
    script.step = sim::StepSize::within(tolerance);
    use(std::move(script));
}

void Player::useTiming(lessons::Timing timing)
{
    m_timing = std::move(timing);
}

void Player::goTo(std::int64_t frame)
{
    m_run.seek({frame, 0});
    look();
}

void Player::stepPhases(int count)
{
    for (int i = 0; i < count; ++i) {
        m_run.stepPhase();
        look();
    }
}

sim::Vec2 Player::at(const std::string &body) const
{
    return m_run.now().at(m_run.track().shown().scene.find(body));
}

}
