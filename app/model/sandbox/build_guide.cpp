#include "app/model/sandbox/build_guide.h"

#include "app/model/sandbox/sandbox.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double beside = 50.0;        ///< px from the body to its feet, sideways and down
constexpr double opposite = 180.0;     ///< degrees between the angles of two feet that step in turn
constexpr double askew = 45.0;         ///< tolerance of that angle, degrees
constexpr std::int64_t patience = 400; ///< frames in which a walking creature has gone far

/// Returns how far two angles are from being opposite, degrees.
double offOpposite(double a, double b)
{
    return std::abs(std::remainder(a - b - opposite, 360.0));
}

}

BuildGuide::BuildGuide(const OpenRun &run, RunEditor &changes, const Playback &playback,
                       SandboxEditor &editor, QObject *parent)
    : QObject(parent), m_run(run), m_changes(changes), m_playback(playback), m_editor(editor)
{
    connect(&editor, &SandboxEditor::changed, this, &BuildGuide::follow);
    connect(&editor, &SandboxEditor::replaced, this, &BuildGuide::leave);
    run.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::cursor | ChangeKind::playing, this,
                 &BuildGuide::follow);
}

void BuildGuide::start()
{
    if (!m_editor.isOpen() || !startEmpty(m_run, m_changes))
        return;
    m_editor.setTool(BuildTool::select);
    m_editor.choose({});
    m_isOn = true;
    m_hasWalked = false;
    m_shown = text();
    emit changed();
}

void BuildGuide::leave()
{
    m_isOn = false;
    m_shown.clear();
    emit changed();
}

void BuildGuide::follow()
{
    if (!m_isOn)
        return;
    if (!m_editor.isOpen()) {
        leave(); // in another lesson there is nothing to build
        return;
    }
    m_hasWalked = m_hasWalked || step() == Step::done;
    if (m_hasWalked && m_run.timeline().cursor().frame == 0) {
        leave();
        return;
    }
    const QString now = text();
    if (now == m_shown)
        return;
    m_shown = now;
    emit changed();
}

int BuildGuide::body() const
{
    return m_editor.plan().feet.empty() ? 0 : m_editor.plan().feet.front().body;
}

bool BuildGuide::hasOppositeFeet() const
{
    const std::vector<sim::BlueprintFoot> &feet = m_editor.plan().feet;
    return std::any_of(feet.begin(), feet.end(), [&](const sim::BlueprintFoot &one) {
        return std::any_of(feet.begin(), feet.end(), [&](const sim::BlueprintFoot &other) {
            return one.body == other.body && offOpposite(one.angle, other.angle) <= askew;
        });
    });
}

bool BuildGuide::swings() const
{
    const sim::Blueprint &plan = m_editor.plan();
    return std::any_of(plan.feet.begin(), plan.feet.end(), [&](const sim::BlueprintFoot &one) {
        return plan.gaits[std::size_t(one.gait)].speed != 0.0;
    });
}

bool BuildGuide::hasChosenFoot() const
{
    const std::vector<int> &points = m_editor.chosen().points;
    return points.size() == 1 && footOf(m_editor.plan(), points.front());
}

BuildGuide::Step BuildGuide::footStep() const
{
    if (m_editor.tool() != BuildTool::foot)
        return Step::footTool;
    if (m_editor.first() != body())
        return Step::body;
    return m_editor.plan().feet.empty() ? Step::leftFoot : Step::rightFoot;
}

BuildGuide::Step BuildGuide::runStep() const
{
    const sim::Vec2 from = m_editor.plan().points[std::size_t(body())].x;
    const sim::State &now = m_run.timeline().state();
    if (body() < now.pointCount() && std::abs(now.positionOf(body()).x - from.x) >= far)
        return Step::done;
    return m_playback.isPlaying() || m_run.timeline().cursor().frame > 0 ? Step::watch : Step::play;
}

BuildGuide::Step BuildGuide::step() const
{
    if (!hasOppositeFeet())
        return footStep();
    if (!swings() && m_editor.tool() != BuildTool::select)
        return Step::chooseTool;
    if (!swings())
        return hasChosenFoot() ? Step::swing : Step::foot;
    if (!m_editor.has(QStringLiteral("ground")))
        return Step::ground;
    if (m_editor.has(QStringLiteral("walls")))
        return Step::walls;
    return runStep();
}

std::optional<sim::Vec2> BuildGuide::place() const
{
    const Step now = step();
    if (now != Step::leftFoot && now != Step::rightFoot)
        return std::nullopt;
    const sim::Vec2 from = m_editor.plan().points[std::size_t(body())].x;
    return from + sim::Vec2{now == Step::leftFoot ? -beside : beside, beside};
}

std::vector<int> BuildGuide::points() const
{
    if (step() == Step::body)
        return {body()};
    std::vector<int> feet;
    if (step() == Step::foot) {
        for (const sim::BlueprintFoot &one : m_editor.plan().feet)
            feet.push_back(one.foot);
    }
    return feet;
}

QString BuildGuide::text() const
{
    switch (step()) {
    case Step::footTool:
        return tr("The point in the picture is the body of your creature. Press Foot (F) to give it feet.");
    case Step::body:
        return tr("Click the body.");
    case Step::leftFoot:
        return tr("Click the cross on the left: the first foot.");
    case Step::rightFoot:
        return m_editor.plan().feet.size() < 2
                   ? tr("Click the cross on the right. Opposite feet need opposite angles: one 0°, the other "
                        "180°.")
                   : tr("Two feet must be opposite each other. Click the cross on the right.");
    case Step::chooseTool:
        return tr("Now set the numbers of the feet. Press Select (V).");
    case Step::foot:
        return tr("Click one of the feet.");
    case Step::swing:
        return tr(
            "Swing makes it walk: it turns the legs. Type 0.05 into the field Swing, and press Return.");
    case Step::ground:
        return tr("Feet need something to push against. Switch Ground on.");
    case Step::walls:
        return tr("Switch Walls off, so that nothing is in the way.");
    case Step::play:
        return tr("Press Play (Space).");
    case Step::watch:
        return m_run.timeline().cursor().frame < patience
                   ? tr("Watch it: it lands, and then its feet push it along.")
                   : tr("It does not walk yet. Press Home, and make Swing 0.05.");
    case Step::done:
        break;
    }
    return tr("It walks! Press Home to change it: another Swing, a third foot, or a heavier body.");
}

}
