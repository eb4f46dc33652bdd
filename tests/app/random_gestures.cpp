#include "random_gestures.h"

#include "sim/methods/methods.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>

using namespace app;

void arrive(const Session &session)
{
    while (session.goingTo() || session.isBringing())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

void RandomGestures::go(std::int64_t frame)
{
    m_session.goTo({frame, 0});
    arrive(m_session);
}

void RandomGestures::act()
{
    go(below(m_frames + 1));
    if (below(4) == 0)
        m_session.phaseForward();
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
        return m_session.undo();
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
        m_session.setParameter(one.id, one.defaultValue + (share() - 0.5) * 0.2 * (one.max - one.min));
    m_session.endGesture();
    arrive(m_session);
}

void RandomGestures::drag()
{
    const std::vector<std::string> names = m_session.timeline().track().interval().scene.names;
    const QString body =
        QString::fromStdString(names[static_cast<std::size_t>(below(static_cast<int>(names.size())))]);
    m_done << QStringLiteral("drag ") + body;
    m_session.grab(body);
    for (int i = below(4); i >= 0; --i) {
        m_session.moveHand({100.0 + below(300), 100.0 + below(200)});
        m_session.frameForward();
    }
    m_session.letGo();
}

void RandomGestures::effect()
{
    const std::vector<sim::EffectPtr> listed = m_session.listedEffects();
    if (listed.empty())
        return;
    const QString id = QString::fromStdString(
        listed[static_cast<std::size_t>(below(static_cast<int>(listed.size())))]->id());
    m_done << QStringLiteral("switch ") + id;
    m_session.setEffect(id, m_session.isOff(id));
}

void RandomGestures::method()
{
    const std::vector<const char *> ids = {"published", "semi_implicit_euler", "rk4", "velocity_verlet"};
    if (below(2) == 0) {
        const QString id = ids[static_cast<std::size_t>(below(4))];
        m_done << id;
        m_session.setMethod(id);
    } else {
        m_done << QStringLiteral("step");
        m_session.setStepSize(below(2) == 0 ? 1.0 : 0.5);
    }
    arrive(m_session);
}

void RandomGestures::preset()
{
    const std::vector<lessons::Preset> &gallery = m_session.step().presets;
    if (!gallery.empty() && below(2) == 0) {
        m_done << QStringLiteral("preset");
        m_session.startWith(gallery[static_cast<std::size_t>(below(static_cast<int>(gallery.size())))]);
    } else if (below(2) == 0) {
        m_done << QStringLiteral("reset");
        m_session.resetParameters();
    } else {
        m_done << QStringLiteral("afresh");
        m_session.startAfresh();
    }
}

void RandomGestures::outside()
{
    m_done << QStringLiteral("pointer, target and keys");
    const sim::Vec2 place{100.0 + below(300), 100.0 + below(200)};
    m_session.point(place, true);
    m_session.steer(&sim::Keys::left, true);
    m_session.frameForward();
    m_session.letUp();
    m_session.aim(place);
}

void RandomGestures::branch()
{
    const std::vector<Branch> &all = m_session.branches().all();
    if (all.empty())
        return parameter();
    const int id = all[static_cast<std::size_t>(below(static_cast<int>(all.size())))].id;
    const int deed = below(5);
    m_done << QStringList{"beside", "go back", "keep", "name", "delete"}.at(deed);
    if (deed == 0)
        m_session.showBeside(id);
    else if (deed == 1)
        m_session.goBackTo(id);
    else if (deed == 2)
        m_session.keepBranch(id, below(2) == 0);
    else if (deed == 3)
        m_session.renameBranch(id, QStringLiteral("run %1").arg(below(5)));
    else
        m_session.deleteBranch(id);
    arrive(m_session);
}
