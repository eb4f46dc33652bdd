#include "app/listing/rule_interpreter.h"

#include "app/listing/limits.h"

#include <angelscript.h>

#include <algorithm>
#include <limits>

namespace listing {

using namespace AngelScript;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}

RuleInterpreter::RuleInterpreter(const SourceScan &scan, const Vocabulary &vocabulary, const RuleFacts &facts)
    : ScriptRunner(scan, vocabulary, BodyAccess::read, maxLinesPerRuleCall), m_facts(facts)
{
    findFunctions();
    if (errors().empty())
        makeContext();
}

void RuleInterpreter::findFunctions()
{
    if (!errors().empty())
        return;
    if (module()) {
        for (asUINT i = 0; i < module()->GetGlobalVarCount(); ++i) {
            const char *name = nullptr;
            module()->GetGlobalVar(i, &name);
            addErrorAt(name, "A rule remembers nothing, so '" + std::string(name) +
                                 "' cannot be outside of a function. Move it into one.");
        }
        m_force = find("force", "Vec2 force(Body me)");
        m_pull = find("pull", "Vec2 pull(Body me, Body other)");
    }
    if (errors().empty() && !m_force && !m_pull)
        addError(1, 1,
                 "A rule needs the function 'Vec2 force(Body me)' or 'Vec2 pull(Body me, Body other)'.");
}

asIScriptFunction *RuleInterpreter::find(const std::string &name, const std::string &declaration)
{
    asIScriptFunction *found = nullptr;
    for (asUINT i = 0; i < module()->GetFunctionCount(); ++i) {
        asIScriptFunction *function = module()->GetFunctionByIndex(i);
        if (function->GetName() != name)
            continue;
        const bool isPull = name == "pull";
        int me = 0, other = 0;
        const bool fits = function->GetParamCount() == (isPull ? 2u : 1u) &&
                          function->GetParam(0, &me) >= 0 && (!isPull || function->GetParam(1, &other) >= 0);
        const int body = module()->GetTypeIdByDecl("Body");
        const auto isBody = [&](int type) {
            return (type & asTYPEID_MASK_SEQNBR) == (body & asTYPEID_MASK_SEQNBR) &&
                   (type & asTYPEID_APPOBJECT);
        };
        if (fits && isBody(me) && (!isPull || isBody(other)) &&
            function->GetReturnTypeId() == module()->GetTypeIdByDecl("Vec2"))
            found = function;
        else
            addErrorAt(name, "The function '" + name + "' of a rule has the form '" + declaration + "'.");
    }
    return found;
}

BodyCell &RuleInterpreter::loadBody(const sim::RuleScene &scene, const sim::State &state, int point)
{
    BodyCell &cell = cells().cellOfFirstArray(static_cast<std::size_t>(point));
    cell.position = cell.before = state.positionOf(point);
    cell.velocity = state.velocityOf(point);
    cell.mass = scene.mass[point];
    cell.radius = scene.radius[point];
    cell.held = state.hold.point == point;
    cell.point = point;
    return cell;
}

void RuleInterpreter::load(const sim::RuleScene &scene, const sim::State &state)
{
    cells().resizeFirstArray(static_cast<std::size_t>(state.pointCount()));
    cells().setSeed(scene.seed);
    for (const auto &[name, index] : m_facts.parameters)
        cells().setParameter(name, scene.parameters[index]);
    if (scene.clock >= 0)
        cells().setParameter(m_facts.time, state.gait[scene.clock]);
    if (m_facts.use.input() || m_facts.use.frame)
        cells().loadInput(state);
    if (m_facts.use.bodies) {
        for (int point = 0; point < state.pointCount(); ++point)
            loadBody(scene, state, point);
    }
}

sim::Vec2 RuleInterpreter::run(const sim::RuleScene &scene, const sim::State &state,
                               const sim::RuleCall &call)
{
    const auto cellOf = [&](int point) -> BodyCell & {
        return m_facts.use.bodies ? cells().cellOfFirstArray(static_cast<std::size_t>(point))
                                  : loadBody(scene, state, point);
    };
    BodyCell &me = cellOf(call.me);
    BodyCell *other = call.other < 0 ? nullptr : &cellOf(call.other);
    if (call.moved < 0)
        return execute(me, other);
    BodyCell &moved = cells().cellOfFirstArray(static_cast<std::size_t>(call.moved));
    moved.position = moved.position + call.by;
    const sim::Vec2 force = execute(me, other);
    moved.position = state.positionOf(call.moved);
    return force;
}

sim::Vec2 RuleInterpreter::execute(BodyCell &me, BodyCell *other)
{
    restartCount();
    m_lineBefore = 0;
    context().Prepare(other ? m_pull : m_force);
    context().SetArgObject(0, &me);
    if (other)
        context().SetArgObject(1, other);
    sim::Vec2 force = {nan, nan};
    if (ScriptRunner::execute())
        force = read(*static_cast<const VectorCell *>(context().GetReturnObject()));
    else if (!error())
        setError({RunErrorKind::other, lastLine(), "The interpreter stopped.", {}});
    return force;
}

bool RuleInterpreter::evaluate(const sim::RuleScene &scene, const sim::State &state,
                               std::span<const sim::RuleCall> calls, std::span<sim::Vec2> forces)
{
    prepareScriptThread();
    forgetError();
    load(scene, state);
    for (std::size_t i = 0; i < calls.size(); ++i) {
        forces[i] = run(scene, state, calls[i]);
        if (isFinite(forces[i]))
            continue;
        m_failedCall = calls[i];
        std::fill(forces.begin() + static_cast<std::ptrdiff_t>(i), forces.end(), sim::Vec2{nan, nan});
        context().Unprepare();
        return false;
    }
    context().Unprepare();
    return true;
}

std::optional<RunError> RuleInterpreter::mistake(const sim::RuleScene &scene, const sim::State &state)
{
    if (error())
        return error();
    // Once more, with a check after each line. This finds the line without slowing down every evaluation.
    m_findsNonFinite = true;
    run(scene, state, m_failedCall);
    m_findsNonFinite = false;
    if (!error())
        setError({RunErrorKind::notFinite, lastLine(), notFiniteSentence("The force"), {}});
    context().Unprepare();
    return error();
}

void RuleInterpreter::onNewLine(int line, int, int)
{
    if (!m_findsNonFinite)
        return;
    for (const Variable &variable : variables()) {
        if (!isFinite(variable.value))
            return fail(RunErrorKind::notFinite, m_lineBefore, notFiniteSentence("'" + variable.name + "'"));
    }
    m_lineBefore = line;
}

}
