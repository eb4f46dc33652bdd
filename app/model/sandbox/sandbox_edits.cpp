// Edits of a sandbox scene: each one is one undo step.

#include "app/model/catalog/lists.h"
#include "app/model/run/run_program.h"
#include "app/model/sandbox/blueprint_limits.h"
#include "app/model/sandbox/sandbox.h"
#include "app/model/sandbox/sandbox_editor.h"
#include "app/model/text/sentences.h"

#include <utility>

namespace app {

namespace {

const sim::Vec2 besideCopied{20.0, 20.0}; ///< px: offset of copies

QString pointTitle(const sim::Blueprint &plan, int point)
{
    return bodyTitle(QString::fromStdString(plan.points[std::size_t(point)].name));
}

/// Names the selection in a few words, as the object of a sentence: "p1", "spring", "3 parts".
QString titleOf(const sim::Blueprint &plan, const Selection &chosen)
{
    if (chosen.points.size() == 1)
        return pointTitle(plan, chosen.points.front()); // together with its links
    if (chosen.count() != 1)
        return SandboxEditor::tr("%1 parts").arg(chosen.count());
    return !chosen.springs.empty()  ? SandboxEditor::tr("spring")
           : !chosen.sticks.empty() ? SandboxEditor::tr("stick")
                                    : SandboxEditor::tr("rule link");
}

/// Returns the selection of the link that `tool` made. A foot has no link to select.
Selection linkOf(BuildTool tool, int made)
{
    switch (tool) {
    case BuildTool::spring:
        return {{}, {made}, {}};
    case BuildTool::stick:
        return {{}, {}, {made}};
    case BuildTool::ruleLink:
        return {{}, {}, {}, {made}};
    default:
        return {};
    }
}

}

bool SandboxEditor::requireStart()
{
    if (!canBuild())
        m_session.showMessage(buildOnlyAtStart());
    return canBuild();
}

bool SandboxEditor::change(const QString &what, const std::function<void(sim::Blueprint &)> &edit,
                           const QString &gesture)
{
    if (!isOpen())
        return false;
    if (!requireStart())
        return false;
    sim::Blueprint next = plan();
    edit(next);
    if (next == plan())
        return false;
    m_isChanging = true;
    const bool built = m_session.editor().build({what, {}, gesture}, std::move(next));
    m_isChanging = false;
    return built;
}

void SandboxEditor::reportFull()
{
    m_session.showMessage(tr("The scene has too many of this kind. Delete some first."));
}

int SandboxEditor::pointAt(sim::Blueprint &plan, sim::Vec2 at, int hit) const
{
    return hit >= 0 ? hit : addPoint(plan, at).value_or(-1);
}

void SandboxEditor::useOnPoint(sim::Vec2 at, int hit)
{
    const bool nails = m_tool == BuildTool::nail;
    int point = hit;
    const auto edit = [&](sim::Blueprint &plan) {
        point = pointAt(plan, at, hit);
        if (point >= 0 && nails)
            plan.points[std::size_t(point)].fixed = !plan.points[std::size_t(point)].fixed;
    };
    if (hit >= 0 && !nails) { // there is a point already
        choose({{hit}, {}, {}});
        return;
    }
    const QString what = !nails    ? tr("Add point")
                         : hit < 0 ? tr("Add nail")
                         : plan().points[std::size_t(hit)].fixed
                             ? tr("Free %1").arg(pointTitle(plan(), hit))
                             : tr("Nail %1 down").arg(pointTitle(plan(), hit));
    if (change(what, edit))
        choose({{point}, {}, {}});
    else if (point < 0)
        reportFull();
}

void SandboxEditor::use(sim::Vec2 at, int hit)
{
    if (!isOpen() || m_tool == BuildTool::select || !requireStart())
        return;
    if (m_tool == BuildTool::point || m_tool == BuildTool::nail) {
        useOnPoint(at, hit);
        return;
    }
    if (m_first) {
        link({{}, *m_first}, {at, hit});
        return;
    }
    int point = hit;
    if (hit < 0 && !change(tr("Add point"), [&](sim::Blueprint &plan) { point = pointAt(plan, at, hit); })) {
        if (point < 0)
            reportFull();
        return;
    }
    m_first = point;
    choose({{point}, {}, {}});
    emit changed();
}

void SandboxEditor::drag(End from, End to)
{
    if (!isOpen() || !isLinkTool(m_tool))
        return;
    m_first.reset();
    link(from, to);
    m_first.reset(); // a drag makes one link: the next drag starts a new one
    emit changed();
}

std::optional<int> SandboxEditor::addLink(sim::Blueprint &plan, int a, int b) const
{
    switch (m_tool) {
    case BuildTool::spring:
        return addSpring(plan, a, b);
    case BuildTool::stick:
        return addStick(plan, a, b);
    case BuildTool::ruleLink:
        return addRuleLink(plan, a, b);
    default:
        return addFoot(plan, b, a);
    }
}

void SandboxEditor::link(End from, End to)
{
    std::optional<int> made;
    int a = from.hit, b = to.hit;
    const bool isOnePoint = a >= 0 && a == b;
    const auto edit = [&](sim::Blueprint &plan) {
        const sim::Blueprint before = plan;
        a = pointAt(plan, from.at, from.hit);
        b = pointAt(plan, to.at, to.hit);
        if (a >= 0 && b >= 0)
            made = addLink(plan, a, b);
        if (!made)
            plan = before; // do not keep a point without its link
    };
    const BuildTool tool = m_tool;
    const QString what = tool == BuildTool::spring     ? tr("Add spring")
                         : tool == BuildTool::stick    ? tr("Add stick")
                         : tool == BuildTool::ruleLink ? tr("Add rule link")
                                                       : tr("Add foot");
    const bool isDone = !isOnePoint && change(what, edit);
    if (!isDone && !isOnePoint) {
        reportWhyNoLink(from.hit, to.hit, made);
        if (from.hit < 0 || to.hit < 0)
            return; // keep the first end, so that the learner can click again
    }
    m_first = tool == BuildTool::foot ? std::optional(a) // next, another foot of the same body
              : a != b                ? std::optional(b) // the next link starts here
                                      : std::nullopt;
    const Selection link = isDone ? linkOf(tool, *made) : Selection{};
    choose(link.isEmpty() ? Selection{{b}, {}, {}} : link);
    emit changed();
}

void SandboxEditor::reportWhyNoLink(int from, int to, std::optional<int> made)
{
    if (m_tool == BuildTool::ruleLink && from >= 0 && to >= 0 && plan().ruleLinks.size() < built::mostLinks)
        m_session.showMessage(
            tr("These two points have a rule link already, and the rule acts once along it."));
    else if (m_tool == BuildTool::foot && to >= 0 && footOf(plan(), to))
        m_session.showMessage(
            tr("This point is already a foot, and a point can be the foot of only one body. "
               "Choose another point."));
    else if (!made)
        reportFull();
    // Otherwise the scene was rejected, with a message.
}

void SandboxEditor::moveChosen(sim::Vec2 by)
{
    if (m_chosen.points.empty())
        return;
    const std::vector<int> points = m_chosen.points;
    change(
        tr("Move %1").arg(titleOf(plan(), {points, {}, {}})),
        [&](sim::Blueprint &plan) { moveBy(plan, points, by); }, QStringLiteral(":place"));
}

void SandboxEditor::eraseChosen()
{
    if (m_chosen.isEmpty())
        return;
    if (m_chosen.points.size() == plan().points.size()) {
        m_session.showMessage(tr("A scene needs at least one point that can move. Leave one free."));
        return;
    }
    const Selection gone = m_chosen;
    if (!change(tr("Delete %1").arg(titleOf(plan(), gone)), [&](sim::Blueprint &plan) { erase(plan, gone); }))
        return;
    m_chosen = {}; // the indices mean other parts now
    m_first.reset();
    emit changed();
}

void SandboxEditor::duplicateChosen()
{
    if (m_chosen.points.empty())
        return;
    const Selection old = m_chosen;
    std::optional<Selection> added;
    const auto edit = [&](sim::Blueprint &plan) { added = duplicate(plan, old, besideCopied); };
    if (change(tr("Duplicate %1").arg(titleOf(plan(), old)), edit))
        choose(*added);
    else if (canBuild() && !added)
        m_session.showMessage(
            tr("With this copy, the scene would have too many parts. Select fewer parts, or "
               "delete some first."));
}

void SandboxEditor::addRuleLinksAmongChosen()
{
    const std::vector<int> points = m_chosen.points;
    if (points.size() < 2) {
        m_session.showMessage(tr("Select at least two points first: draw a box around them."));
        return;
    }
    std::optional<int> added;
    const auto edit = [&](sim::Blueprint &plan) { added = addRuleLinksAmong(plan, points); };
    if (change(tr("Link %1 by the rule").arg(titleOf(plan(), {points, {}, {}})), edit))
        emit changed();
    else if (canBuild() && !added)
        reportFull();
    else if (canBuild() && *added == 0)
        m_session.showMessage(tr("All of these points have rule links already."));
}

bool SandboxEditor::has(const QString &effect) const
{
    if (!isOpen())
        return false;
    const std::vector<std::string> &all = plan().effects;
    return contains(all, effect.toStdString());
}

void SandboxEditor::setEffect(const QString &id, bool present)
{
    if (has(id) != present)
        setBuiltEffect(m_session.run(), m_session.editor(), m_session.playback(), id, present);
}

QString SandboxEditor::whyNotCalled(int point, const QString &name) const
{
    const std::string wanted = name.toStdString();
    const std::vector<sim::BlueprintPoint> &points = plan().points;
    if (std::size_t(point) >= points.size() || points[std::size_t(point)].name == wanted)
        return {};
    if (!canBuild())
        return buildOnlyAtStart();
    if (programOf(m_session.timeline().script().method))
        return tr("Your code computes this run, and it names the points. Choose another method first.");
    if (const QString why = whyNotAName(name); !why.isEmpty())
        return why;
    if (pointCalled(plan(), wanted))
        return tr("Another point is called “%1”. Choose another name.").arg(name);
    if (m_session.step().parameter(name))
        return tr("“%1” is a parameter. Choose another name, such as “%1_1”.").arg(name);
    return {};
}

bool SandboxEditor::rename(int point, const QString &name)
{
    if (!isOpen() || point < 0 || std::size_t(point) >= plan().points.size())
        return false;
    const Renaming renaming{plan().points[std::size_t(point)].name, name.toStdString()};
    if (renaming.from == renaming.to)
        return true;
    if (const QString why = whyNotCalled(point, name); !why.isEmpty()) {
        m_session.showMessage(why);
        return false;
    }
    return m_session.editor().rewriteScene(
        {tr("Rename %1 to %2").arg(QString::fromStdString(renaming.from), name), {}, {}},
        [&](const sim::Script &script) { return withBodyRenamed(script, renaming); });
}

void SandboxEditor::addGaitFor(int foot)
{
    change(tr("Add gait group"), [&](sim::Blueprint &plan) {
        if (const std::optional<int> gait = addGait(plan))
            plan.feet[std::size_t(foot)].gait = *gait;
    });
}

}
