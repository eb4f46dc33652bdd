#include "app/model/workbench.h"

#include "app/model/workshop.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

void toggle(std::vector<int> &numbers, int one)
{
    const auto place = std::lower_bound(numbers.begin(), numbers.end(), one);
    if (place != numbers.end() && *place == one)
        numbers.erase(place);
    else
        numbers.insert(place, one);
}

bool sameParts(const sim::Blueprint &a, const sim::Blueprint &b)
{
    const auto sameName = [](const sim::BlueprintPoint &one, const sim::BlueprintPoint &other) {
        return one.name == other.name;
    };
    return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), sameName) &&
           a.springs.size() == b.springs.size() && a.sticks.size() == b.sticks.size();
}

}

Workbench::Workbench(Session &session, QObject *parent) : QObject(parent), m_session(session)
{
    connect(&session, &Session::stepOpened, this, [this] {
        m_tool = BuildTool::select;
        m_seen.reset();
        follow();
    });
    connect(&session, &Session::runChanged, this, &Workbench::follow);
    connect(&session, &Session::moved, this, &Workbench::follow);
    connect(&session, &Session::playingChanged, this, &Workbench::follow);
    connect(&session, &Session::selectionChanged, this, &Workbench::followSelection);
}

bool Workbench::canBuild() const
{
    return app::canBuild(m_session);
}

void Workbench::follow()
{
    const std::shared_ptr<const sim::Blueprint> now = isOpen() ? m_session.blueprint() : nullptr;
    const bool can = canBuild();
    if (now == m_seen && can == m_couldBuild)
        return;
    if (!now || !m_seen || (!m_isChanging && !sameParts(*now, *m_seen))) {
        m_chosen = {}; // undone, or another scene: the numbers mean other parts
        m_first.reset();
    } else {
        m_chosen = within(*now, m_chosen);
    }
    const bool isAnother = now && m_seen && !m_isChanging &&
                           std::max(now->points.size(), m_seen->points.size()) >
                               std::min(now->points.size(), m_seen->points.size()) + 1;
    m_seen = now;
    m_couldBuild = can;
    emit changed();
    if (isAnother)
        emit replaced();
}

void Workbench::followSelection()
{
    if (m_isSharing || !isOpen())
        return;
    const std::string name = m_session.selected().toStdString();
    const std::vector<sim::BlueprintPoint> &points = plan().points;
    const auto found = std::find_if(points.begin(), points.end(),
                                    [&](const sim::BlueprintPoint &one) { return one.name == name; });
    if (found == points.end())
        return;
    const int point = static_cast<int>(found - points.begin());
    if (!std::binary_search(m_chosen.points.begin(), m_chosen.points.end(), point))
        choose({{point}, {}, {}});
}

/// The session shows the values of one body: the last one that is chosen.
void Workbench::shareChoice()
{
    if (m_chosen.points.empty())
        return;
    m_isSharing = true;
    m_session.select(QString::fromStdString(plan().points[std::size_t(m_chosen.points.back())].name));
    m_isSharing = false;
}

void Workbench::setTool(BuildTool tool)
{
    if (tool == m_tool)
        return;
    m_tool = tool;
    m_first.reset();
    emit changed();
}

void Workbench::choose(Chosen chosen)
{
    if (!isOpen() || chosen == m_chosen)
        return;
    m_chosen = within(plan(), chosen);
    shareChoice();
    emit changed();
}

void Workbench::togglePoint(int point)
{
    Chosen chosen = m_chosen;
    toggle(chosen.points, point);
    choose(std::move(chosen));
}

void Workbench::toggleSpring(int spring)
{
    Chosen chosen = m_chosen;
    toggle(chosen.springs, spring);
    choose(std::move(chosen));
}

void Workbench::toggleStick(int stick)
{
    Chosen chosen = m_chosen;
    toggle(chosen.sticks, stick);
    choose(std::move(chosen));
}

bool Workbench::leave()
{
    if (m_first) {
        m_first.reset();
        emit changed();
        return true;
    }
    if (m_tool != BuildTool::select) {
        setTool(BuildTool::select);
        return true;
    }
    const bool any = !m_chosen.isEmpty();
    choose({});
    return any;
}

void Workbench::chooseAll()
{
    if (isOpen())
        choose(everything(plan()));
}

void Workbench::chooseNextLink(int step)
{
    if (!isOpen())
        return;
    const int springs = static_cast<int>(plan().springs.size());
    const int all = springs + static_cast<int>(plan().sticks.size());
    if (all == 0)
        return;
    int at = step > 0 ? -1 : 0;
    if (!m_chosen.springs.empty())
        at = m_chosen.springs.front();
    else if (!m_chosen.sticks.empty())
        at = springs + m_chosen.sticks.front();
    const int next = (at + step + all) % all;
    choose(next < springs ? Chosen{{}, {next}, {}} : Chosen{{}, {}, {next - springs}});
}

}
