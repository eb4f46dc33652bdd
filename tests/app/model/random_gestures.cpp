#include "tests/app/model/random_gestures.h"

#include "sim/methods/methods.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>

using namespace app;

void arrive(const Session &session)
{
    while (session.playback().goal() || session.comparisons().isComputing())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

void RandomGestures::go(std::int64_t frame)
{
    m_session.playback().goTo({frame, 0});
    arrive(m_session);
}

void RandomGestures::act()
{
    go(below(m_frames + 1));
    if (below(4) == 0)
        m_session.playback().phaseForward();
    switch (below(13)) {
    case 0:
    case 1:
    case 2:
        return parameter();
    case 3:
    case 4:
        return drag();
    case 5:
        return effect();
    case 6:
        return method();
    case 7:
        return preset();
    case 8:
        return outside();
    case 9:
        m_done << QStringLiteral("undo");
        return m_session.editor().undo();
    default:
        return branch();
    }
}

void RandomGestures::parameter()
{
    const std::vector<lessons::Parameter> &all = m_session.step().parameters;
    if (all.empty())
        return;
    const lessons::Parameter one = all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
    const int moves = 1 + below(3);
    m_done << one.id;
    for (int i = 0; i < moves; ++i) // near its preset: the ends can be scenes that take long
        m_session.editor().setParameter(one.id,
                                        one.defaultValue + (share() - 0.5) * 0.2 * (one.max - one.min));
    m_session.editor().endGesture();
    arrive(m_session);
}

void RandomGestures::drag()
{
    const std::vector<std::string> names = m_session.timeline().track().interval().scene.names;
    const QString body =
        QString::fromStdString(names[static_cast<std::size_t>(below(static_cast<int>(names.size())))]);
    m_done << QStringLiteral("drag ") + body;
    m_session.input().grab(body);
    for (int i = below(4); i >= 0; --i) {
        m_session.input().moveTo({100.0 + below(300), 100.0 + below(200)});
        m_session.playback().frameForward();
    }
    m_session.input().release();
}

void RandomGestures::effect()
{
    const std::vector<sim::EffectPtr> listed = m_session.editor().listedEffects();
    if (listed.empty())
        return;
    const QString id = QString::fromStdString(
        listed[static_cast<std::size_t>(below(static_cast<int>(listed.size())))]->id());
    m_done << QStringLiteral("switch ") + id;
    m_session.editor().setEffect(id, m_session.editor().isOff(id));
}

void RandomGestures::method()
{
    const std::vector<const char *> ids = {"published", "semi_implicit_euler", "rk4", "velocity_verlet"};
    if (below(2) == 0) {
        const QString id = ids[static_cast<std::size_t>(below(4))];
        m_done << id;
        m_session.editor().setMethod(id);
    } else {
        m_done << QStringLiteral("step");
        m_session.editor().setStepSize(below(2) == 0 ? 1.0 : 0.5);
    }
    arrive(m_session);
}

void RandomGestures::preset()
{
    const std::vector<lessons::Preset> &gallery = m_session.step().presets;
    if (!gallery.empty() && below(2) == 0) {
        m_done << QStringLiteral("preset");
        m_session.editor().startWith(
            gallery[static_cast<std::size_t>(below(static_cast<int>(gallery.size())))]);
    } else if (below(2) == 0) {
        m_done << QStringLiteral("reset");
        m_session.editor().resetParameters();
    } else {
        m_done << QStringLiteral("afresh");
        m_session.editor().startAfresh();
    }
}

void RandomGestures::outside()
{
    m_done << QStringLiteral("pointer, target and keys");
    const sim::Vec2 place{100.0 + below(300), 100.0 + below(200)};
    m_session.input().setPointer(place, true);
    m_session.input().setKey(&sim::Keys::left, true);
    m_session.playback().frameForward();
    m_session.input().releaseAll();
    m_session.input().setTarget(place);
}

void RandomGestures::branch()
{
    const std::vector<Branch> &all = m_session.comparisons().branches().all();
    if (all.empty())
        return parameter();
    const int id = all[static_cast<std::size_t>(below(static_cast<int>(all.size())))].id;
    const int action = below(5);
    m_done << QStringList{"beside", "go back", "keep", "name", "delete"}.at(action);
    if (action == 0)
        m_session.comparisons().show(id);
    else if (action == 1)
        m_session.editor().goBackTo(id);
    else if (action == 2)
        m_session.comparisons().keep(id, below(2) == 0);
    else if (action == 3)
        m_session.comparisons().rename(id, QStringLiteral("run %1").arg(below(5)));
    else
        m_session.comparisons().remove(id);
    arrive(m_session);
}
