// What a learner does on the bench: each deed is one entry to undo.

#include "app/model/workbench.h"
#include "app/model/workshop.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

const sim::Vec2 besideCopied{20.0, 20.0}; ///< px: where copies stand

}

bool Workbench::change(const QString &what, const std::function<void(sim::Blueprint &)> &edit,
                       const QString &gesture)
{
    if (!isOpen())
        return false;
    if (!canBuild()) {
        emit m_session.said(tr("Building happens at the start of the run: press Home to go there."));
        return false;
    }
    sim::Blueprint next = plan();
    edit(next);
    if (next == plan())
        return false;
    m_isChanging = true;
    const bool built = m_session.build({what, {}, gesture}, std::move(next));
    m_isChanging = false;
    return built;
}

void Workbench::sayFull()
{
    emit m_session.said(tr("There is no room for more of this kind: delete something first."));
}

int Workbench::pointAt(sim::Blueprint &plan, sim::Vec2 at, int hit) const
{
    return hit >= 0 ? hit : addPoint(plan, at).value_or(-1);
}

void Workbench::useOnPoint(sim::Vec2 at, int hit)
{
    const bool nails = m_tool == BuildTool::nail;
    int point = hit;
    const auto edit = [&](sim::Blueprint &plan) {
        point = pointAt(plan, at, hit);
        if (point >= 0 && nails)
            plan.points[std::size_t(point)].fixed = !plan.points[std::size_t(point)].fixed;
    };
    if (hit >= 0 && !nails) { // there is one already
        choose({{hit}, {}, {}});
        return;
    }
    const QString what = !nails                                              ? tr("Point")
                         : hit >= 0 && plan().points[std::size_t(hit)].fixed ? tr("Nail out")
                                                                             : tr("Nail");
    if (change(what, edit))
        choose({{point}, {}, {}});
    else if (point < 0)
        sayFull();
}

void Workbench::use(sim::Vec2 at, int hit)
{
    if (!isOpen() || m_tool == BuildTool::select)
        return;
    if (!canBuild()) {
        change({}, [](sim::Blueprint &) {}); // says why not
        return;
    }
    if (m_tool == BuildTool::point || m_tool == BuildTool::nail) {
        useOnPoint(at, hit);
        return;
    }
    if (m_first) {
        link(*m_first, at, hit);
        return;
    }
    int point = hit;
    if (hit < 0 && !change(tr("Point"), [&](sim::Blueprint &plan) { point = pointAt(plan, at, hit); })) {
        if (point < 0)
            sayFull();
        return;
    }
    m_first = point;
    choose({{point}, {}, {}});
    emit changed();
}

void Workbench::link(int a, sim::Vec2 at, int hit)
{
    std::optional<int> made;
    int b = hit;
    const auto edit = [&](sim::Blueprint &plan) {
        const sim::Blueprint before = plan;
        b = pointAt(plan, at, hit);
        if (b >= 0)
            made = m_tool == BuildTool::spring  ? addSpring(plan, a, b)
                   : m_tool == BuildTool::stick ? addStick(plan, a, b)
                                                : addFoot(plan, b, a);
        if (!made)
            plan = before; // no point without the link that it is for
    };
    const BuildTool tool = m_tool;
    const QString what = tool == BuildTool::spring  ? tr("Spring")
                         : tool == BuildTool::stick ? tr("Stick")
                                                    : tr("Foot");
    const bool isDone = a != hit && change(what, edit);
    if (!isDone && a != hit) {
        sayWhyNoLink(hit, made);
        if (hit < 0)
            return; // the next click may have more luck
    }
    m_first = tool == BuildTool::foot ? std::optional(a) // the next foot of the same body
              : a != b                ? std::optional(b) // the next link goes on from here
                                      : std::nullopt;
    if (isDone && tool == BuildTool::spring)
        choose({{}, {*made}, {}});
    else if (isDone && tool == BuildTool::stick)
        choose({{}, {}, {*made}});
    else
        choose({{b}, {}, {}});
    emit changed();
}

void Workbench::sayWhyNoLink(int hit, std::optional<int> made)
{
    if (m_tool == BuildTool::foot && hit >= 0 && footOf(plan(), hit))
        emit m_session.said(tr("This point is a foot already: it can be the foot of one body."));
    else if (!made)
        sayFull();
    // Else the scene was refused, and that was said.
}

void Workbench::moveChosen(sim::Vec2 by)
{
    if (m_chosen.points.empty())
        return;
    const std::vector<int> points = m_chosen.points;
    change(
        points.size() == 1 ? tr("Place") : tr("Places"),
        [&](sim::Blueprint &plan) { moveBy(plan, points, by); }, QStringLiteral(":place"));
}

void Workbench::eraseChosen()
{
    if (m_chosen.isEmpty())
        return;
    if (m_chosen.points.size() == plan().points.size()) {
        emit m_session.said(tr("A scene needs at least one point that can move: leave one."));
        return;
    }
    const Chosen gone = m_chosen;
    if (!change(tr("Delete"), [&](sim::Blueprint &plan) { erase(plan, gone); }))
        return;
    m_chosen = {}; // the numbers mean other parts now
    m_first.reset();
    emit changed();
}

void Workbench::duplicateChosen()
{
    if (m_chosen.points.empty())
        return;
    const Chosen old = m_chosen;
    std::optional<Chosen> added;
    const auto edit = [&](sim::Blueprint &plan) { added = duplicate(plan, old, besideCopied); };
    if (change(tr("Duplicate"), edit))
        choose(*added);
    else if (canBuild() && !added)
        emit m_session.said(tr("There is no room for a copy of all that: choose fewer parts, or delete some "
                               "first."));
}

bool Workbench::has(const QString &effect) const
{
    if (!isOpen())
        return false;
    const std::vector<std::string> &all = plan().effects;
    return std::find(all.begin(), all.end(), effect.toStdString()) != all.end();
}

void Workbench::setEffect(const QString &id, bool present)
{
    if (has(id) != present)
        setBuiltEffect(m_session, id, present);
}

void Workbench::addGaitFor(int foot)
{
    change(tr("Gait group"), [&](sim::Blueprint &plan) {
        if (const std::optional<int> gait = addGait(plan))
            plan.feet[std::size_t(foot)].gait = *gait;
    });
}

}
