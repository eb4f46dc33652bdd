#include "tests/lessons/support/player.h"

#include "sim/methods/methods.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

#include <limits>

namespace support {

RunPlayer::RunPlayer(const lessons::Step &step, std::size_t number)
    : m_step(step), m_run(step.script()), m_try(step.tries.at(number)),
      m_timing([](const sim::Script &, std::int64_t) { return std::numeric_limits<double>::infinity(); })
{
    checkTry();
}

void RunPlayer::checkTry()
{
    m_done = m_done || (m_try.isDone(m_run) &&
                        (!m_try.budget || lessons::staysWithin(*m_try.budget, m_run.script(), m_timing)));
    const bool isOpen = !m_done && m_try.conditions.hasBegun(m_run) && !m_try.isDone(m_run);
    m_lackedHint = m_lackedHint || (isOpen && todo().isEmpty());
}

QString RunPlayer::missing() const
{
    const lessons::Condition *condition = m_try.conditions.missing(m_run);
    if (!condition || condition->sentence.isEmpty())
        return todo();
    return condition->measured ? condition->sentence + ' ' + condition->number(m_run) : condition->sentence;
}

void RunPlayer::play(int frames)
{
    for (int i = 0; i < frames; ++i) {
        m_run.nextOutputStep();
        checkTry();
    }
}

void Player::playUntilDone(int frames)
{
    for (int i = 0; i < frames && !done(); ++i)
        play(1);
}

void RunPlayer::grab(const std::string &body)
{
    m_held = body;
    m_run.applyInput(sim::Grab{body});
    checkTry();
}

void Player::dragTo(sim::Vec2 to, int frames)
{
    const sim::Vec2 from = at(m_held);
    for (int i = 1; i <= frames; ++i) {
        movePointer(from + (double(i) / frames) * (to - from));
        play(1);
    }
}

void RunPlayer::movePointer(sim::Vec2 to)
{
    m_run.applyInput(sim::Move{to});
}

void RunPlayer::release()
{
    m_run.applyInput(sim::Release{});
    checkTry();
}

void Player::drag(const std::string &body, sim::Vec2 to, int frames)
{
    grab(body);
    dragTo(to, frames);
    release();
}

void RunPlayer::point(sim::Vec2 at, bool down)
{
    m_run.applyInput(sim::Pointer{at, down});
    checkTry();
}

void RunPlayer::target(sim::Vec2 at)
{
    m_run.applyInput(sim::Target{at});
    checkTry();
}

void RunPlayer::key(bool sim::Keys::*key, bool down)
{
    m_run.applyInput(sim::Key{key, down});
    checkTry();
}

void RunPlayer::set(const std::string &parameter, double value)
{
    const lessons::Parameter *declared = m_step.parameter(QString::fromStdString(parameter));
    if (declared && declared->restartsRun) {
        sim::Values values = m_step.defaultValues();
        values.set(parameter, value);
        m_run = sim::Timeline(m_step.scriptWith(values, m_run.script().method));
    } else {
        m_run.setParameter(parameter, value);
    }
    checkTry();
}

void RunPlayer::use(sim::Script script)
{
    script.step = sim::stepFor(*script.method, script.step);
    m_run.replaceScript(std::move(script));
    checkTry();
}

void RunPlayer::useMethod(const std::string &id)
{
    sim::Script script = m_run.script();
    script.method = sim::findMethod(id);
    use(std::move(script));
}

void RunPlayer::useStep(double h)
{
    sim::Script script = m_run.script();
    script.step = sim::StepSize::ofLength(h);
    use(std::move(script));
}

void RunPlayer::useTolerance(double tolerance)
{
    sim::Script script = m_run.script();
    script.step = sim::StepSize::withTolerance(tolerance);
    use(std::move(script));
}

void RunPlayer::useTiming(lessons::TimeMeasurement timing)
{
    m_timing = std::move(timing);
}

void RunPlayer::goTo(std::int64_t frame)
{
    m_run.seek({frame, 0});
    checkTry();
}

void RunPlayer::stepPhases(int count)
{
    for (int i = 0; i < count; ++i) {
        m_run.nextPhase();
        checkTry();
    }
}

sim::Vec2 Player::at(const std::string &body) const
{
    return run().state().positionOf(run().track().interval().scene.find(body));
}

}
