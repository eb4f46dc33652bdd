#include "app/model/sandbox/sandbox_editor.h"

#include "app/model/sandbox/sandbox.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace app {

namespace {

bool sameParts(const sim::Blueprint &a, const sim::Blueprint &b)
{
    const auto sameName = [](const sim::BlueprintPoint &one, const sim::BlueprintPoint &other) {
        return one.name == other.name;
    };
    return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), sameName) &&
           a.springs.size() == b.springs.size() && a.sticks.size() == b.sticks.size() &&
           a.ruleLinks.size() == b.ruleLinks.size();
}

}

SandboxEditor::SandboxEditor(Session &session, QObject *parent) : QObject(parent), m_session(session)
{
    session.onChange(ChangeKind::step, this, [this] {
        m_tool = BuildTool::select;
        m_seen.reset();
    });
    session.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::cursor | ChangeKind::playing, this,
                     &SandboxEditor::follow);
    session.onChange(ChangeKind::selection, this, &SandboxEditor::followSelection);
}

bool SandboxEditor::canBuild() const
{
    return app::canBuild(m_session.run(), m_session.editor(), m_session.playback());
}

void SandboxEditor::follow()
{
    const std::shared_ptr<const sim::Blueprint> now = isOpen() ? m_session.editor().blueprint() : nullptr;
    const bool can = canBuild();
    if (now == m_seen && can == m_couldBuild)
        return;
    const std::optional<Renaming> renaming = now && m_seen ? renamingBetween(*m_seen, *now) : std::nullopt;
    if (!now || !m_seen || (!m_isChanging && !renaming && !sameParts(*now, *m_seen))) {
        m_chosen = {}; // after undo, or in another scene, the indices mean other parts
        m_first.reset();
    } else {
        m_chosen = within(*now, m_chosen);
    }
    const bool isAnother = now && m_seen && !m_isChanging &&
                           std::max(now->points.size(), m_seen->points.size()) >
                               std::min(now->points.size(), m_seen->points.size()) + 1;
    m_seen = now;
    m_couldBuild = can;
    if (renaming)
        followRenaming(*renaming);
    emit changed();
    if (isAnother)
        emit replaced();
}

void SandboxEditor::followRenaming(const Renaming &renaming)
{
    const QString from = QString::fromStdString(renaming.from), to = QString::fromStdString(renaming.to);
    m_session.playback().breakpoints().renameBody(from, to);
    if (m_session.selected() == from) {
        m_isSharing = true;
        m_session.select(to);
        m_isSharing = false;
    }
    emit renamed(from, to);
}

void SandboxEditor::followSelection()
{
    if (m_isSharing || !isOpen())
        return;
    const std::optional<int> point = pointCalled(plan(), m_session.selected().toStdString());
    if (point && !std::binary_search(m_chosen.points.begin(), m_chosen.points.end(), *point))
        choose({{*point}, {}, {}});
}

/// The session shows the values of one body: the last selected one.
void SandboxEditor::shareChoice()
{
    if (m_chosen.points.empty())
        return;
    m_isSharing = true;
    m_session.select(QString::fromStdString(plan().points[std::size_t(m_chosen.points.back())].name));
    m_isSharing = false;
}

void SandboxEditor::setTool(BuildTool tool)
{
    if (tool == m_tool)
        return;
    m_tool = tool;
    m_first.reset();
    emit changed();
}

void SandboxEditor::choose(Selection chosen)
{
    if (!isOpen() || chosen == m_chosen)
        return;
    m_chosen = within(plan(), chosen);
    shareChoice();
    emit changed();
}

void SandboxEditor::toggle(const Selection &parts)
{
    Selection chosen;
    for (const auto kind :
         {&Selection::points, &Selection::springs, &Selection::sticks, &Selection::ruleLinks})
        std::set_symmetric_difference((m_chosen.*kind).begin(), (m_chosen.*kind).end(), (parts.*kind).begin(),
                                      (parts.*kind).end(), std::back_inserter(chosen.*kind));
    choose(std::move(chosen));
}

bool SandboxEditor::leave()
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

void SandboxEditor::chooseAll()
{
    if (isOpen())
        choose(everything(plan()));
}

void SandboxEditor::chooseNextLink(int step)
{
    if (!isOpen())
        return;
    const int springs = static_cast<int>(plan().springs.size());
    const int sticks = springs + static_cast<int>(plan().sticks.size());
    const int all = sticks + static_cast<int>(plan().ruleLinks.size());
    if (all == 0)
        return;
    int at = step > 0 ? -1 : 0;
    if (!m_chosen.springs.empty())
        at = m_chosen.springs.front();
    else if (!m_chosen.sticks.empty())
        at = springs + m_chosen.sticks.front();
    else if (!m_chosen.ruleLinks.empty())
        at = sticks + m_chosen.ruleLinks.front();
    const int next = (at + step + all) % all;
    choose(next < springs  ? Selection{{}, {next}, {}}
           : next < sticks ? Selection{{}, {}, {next - springs}}
                           : Selection{{}, {}, {}, {next - sticks}});
}

}
