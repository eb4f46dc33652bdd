#include "app/listing/scene_cells.h"

#include "sim/base/random.h"
#include "sim/effects/tree/tree.h"

#include <angelscript.h>

#include <algorithm>
#include <cmath>

namespace listing {

using namespace AngelScript;

namespace {

using sim::Vec2;

BodyMotion motionOf(const BodyCell &cell)
{
    return {cell.point, cell.position, cell.velocity, cell.angle, cell.spin};
}

}

SceneCells::SceneCells(asIScriptEngine &engine, const Vocabulary &vocabulary, BodyAccess access)
    : m_engine(engine), m_vocabulary(vocabulary)
{
    registerFunctions(m_engine, m_vocabulary.parameters);
    m_types = registerCellTypes(m_engine, m_vocabulary, access);
    registerFunctionsOfScene();
    registerNames();
}

void SceneCells::registerFunctionsOfScene()
{
    const auto method = [this](const char *declaration, const asSFuncPtr &function) {
        m_engine.RegisterGlobalFunction(declaration, function, asCALL_THISCALL_ASGLOBAL, this);
    };
    method("double sin(double)", asMETHOD(SceneCells, sine));
    method("double cos(double)", asMETHOD(SceneCells, cosine));
    method("double atan2(double, double)", asMETHOD(SceneCells, arcTangent));
    method("double random(int)", asMETHOD(SceneCells, random));
    method("double random(int, int)", asMETHOD(SceneCells, randomInFrame));
    if (m_vocabulary.hasTree)
        method("Vec2 direction(const Body @)", asMETHOD(SceneCells, directionOfBranch));
}

void SceneCells::registerNames()
{
    const auto global = [this](const std::string &declaration, void *address) {
        m_engine.RegisterGlobalProperty(declaration.c_str(), address);
    };
    for (const std::string &name : m_vocabulary.bodies) {
        m_cells.bodies.emplace_back();
        m_cells.handles.push_back(nullptr);
        global("Body @const " + name, &m_cells.handles.back());
    }
    for (const Vocabulary::Array &array : m_vocabulary.arrays) {
        m_cells.arrays.emplace_back().name = array.name;
        global("Bodies " + array.name, &m_cells.arrays.back());
    }
    if (m_vocabulary.hasCreatures)
        global("Creatures creatures", &m_cells.creatures);
    if (m_vocabulary.hasSticks)
        global("Sticks sticks", &m_cells.sticks);
    for (const std::string &name : m_vocabulary.parameters) {
        m_parameters.push_back(0.0);
        global("const double " + name, &m_parameters.back());
    }
    global("const Vec2 hand", &m_hand);
    global("const Vec2 pointer", &m_pointer);
    global("const bool pointer_down", &m_pointerDown);
    global("const bool pointer_known", &m_pointerKnown);
    global("const Vec2 target", &m_target);
    global("const Targets new_targets", &m_newTargets);
    global("const Keys keys", &m_keys);
    global("const double frame_number", &m_frameNumber);
    global("const double pi", &m_pi);
    if (m_vocabulary.hasGait && !m_vocabulary.hasCreatures) {
        global("double gait", &m_gait);
        global("double gait_speed", &m_gaitSpeed);
    }
    if (m_vocabulary.hasTree) {
        global("const double gust", &m_gust);
        global("const bool gust_known", &m_gustKnown);
    }
    if (m_vocabulary.hasGust) {
        global("double gust_front", &m_gustFront);
        global("double gust_tail", &m_gustTail);
    }
}

std::size_t SceneCells::sizeOf(int type) const
{
    if (type == m_types.vec2)
        return sizeof(Vec2);
    if ((type & ~asTYPEID_MASK_SEQNBR) != 0 || type > asTYPEID_DOUBLE)
        return 0;
    return static_cast<std::size_t>(std::max(0, m_engine.GetSizeOfPrimitiveType(type)));
}

template <class Visit>
void SceneCells::forEachCell(Visit &&visit) const
{
    for (std::size_t i = 0; i < m_cells.bodies.size(); ++i) {
        if (m_cells.handles[i])
            visit(m_cells.bodies[i], [&] { return m_vocabulary.bodies[i]; });
    }
    for (const BodyArray &array : m_cells.arrays) {
        for (std::size_t i = 0; i < array.cells.size(); ++i)
            visit(array.cells[i], [&] { return cellName(array.name, i); });
    }
    for (std::size_t i = 0; i < m_cells.creatures.cells.size(); ++i) {
        const CreatureCell &creature = m_cells.creatures.cells[i];
        visit(creature.body, [&] { return cellName("creatures", i) + ".body"; });
        for (std::size_t j = 0; j < creature.feet.cells.size(); ++j)
            visit(creature.feet.cells[j], [&] { return cellName(creature.feet.name, j); });
    }
    for (const BodyCell &cell : m_cells.others)
        visit(cell, [&] { return values().nameBySticks(&cell); });
}

void SceneCells::load(const sim::State &state, const Binding &binding)
{
    const auto fill = [&](BodyCell &cell, int point) {
        const bool held = state.hold.point == point;
        // The program moves a held body itself, from where it was before the hand moved it.
        cell.position = held ? state.hold.positionBefore : state.positionOf(point);
        cell.velocity = held ? state.hold.velocityBefore : state.velocityOf(point);
        cell.before = cell.position;
        cell.mass = binding.mass[point];
        cell.radius = binding.radius[point];
        cell.angle = state.angle.rows() > point ? state.angle[point] : 0.0;
        cell.spin = state.spin.rows() > point ? state.spin[point] : 0.0;
        cell.held = held;
        cell.point = point;
    };
    for (std::size_t i = 0; i < m_cells.bodies.size(); ++i) {
        const int point = binding.bodies[i];
        m_cells.handles[i] = point < 0 ? nullptr : &m_cells.bodies[i];
        if (point >= 0)
            fill(m_cells.bodies[i], point);
    }
    const auto fillArray = [&](BodyArray &array, const std::vector<int> &points) {
        array.cells.resize(points.size());
        array.count = static_cast<int>(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            fill(array.cells[i], points[i]);
    };
    for (std::size_t i = 0; i < m_cells.arrays.size(); ++i)
        fillArray(m_cells.arrays[i], binding.arrays[i]);
    resizeCreatures(binding.creatures.size());
    for (std::size_t i = 0; i < binding.creatures.size(); ++i) {
        CreatureCell &creature = m_cells.creatures.cells[i];
        fill(creature.body, binding.creatures[i].body);
        fillArray(creature.feet, binding.creatures[i].feet);
        const auto clock = static_cast<Eigen::Index>(i);
        creature.gait = clock < state.gait.rows() ? state.gait[clock] : 0.0;
        creature.gaitSpeed = clock < state.gaitSpeed.rows() ? state.gaitSpeed[clock] : 0.0;
    }
    m_cells.others.resize(binding.otherBodies.size());
    for (std::size_t i = 0; i < m_cells.others.size(); ++i)
        fill(m_cells.others[i], binding.otherBodies[i]);
    loadBranches(binding);
    loadSticks(state, binding);
    std::copy(binding.parameters.begin(), binding.parameters.end(), m_parameters.begin());
    m_angleFunctions = binding.angleFunctions;
    m_degrees = binding.degrees;
    m_seed = binding.seed;
    m_gait = state.gait.rows() == 1 ? state.gait[0] : 0.0;
    m_gaitSpeed = state.gaitSpeed.rows() == 1 ? state.gaitSpeed[0] : 0.0;
    m_gustFront = state.gustExtent.front;
    m_gustTail = state.gustExtent.tail;
    loadInput(state);
}

void SceneCells::loadInput(const sim::State &state)
{
    m_frameNumber = static_cast<double>(state.frame);
    m_pointer = state.input.pointer.value_or(Vec2{});
    m_pointerDown = state.input.pointerDown;
    m_pointerKnown = state.input.pointer.has_value();
    m_hand = state.hold.point >= 0 ? state.hold.hand : m_pointer;
    m_target = state.input.target;
    m_newTargets.all = state.input.newTargets;
    m_newTargets.count = static_cast<int>(m_newTargets.all.size());
    m_gust = state.input.gust.value_or(0.0);
    m_gustKnown = state.input.gust.has_value();
    const sim::Keys &keys = state.input.keys;
    m_keys = {keys.left, keys.right, keys.up, keys.down};
}

void SceneCells::loadBranches(const Binding &binding)
{
    for (BodyArray &array : m_cells.arrays) {
        if (binding.branches.size() != array.cells.size())
            continue;
        for (std::size_t i = 0; i < array.cells.size(); ++i) {
            const Binding::Branch &branch = binding.branches[i];
            BodyCell &cell = array.cells[i];
            cell.number = static_cast<int>(i);
            cell.rest = branch.rest;
            cell.scale = branch.scale;
            cell.length = branch.length;
            cell.inertia = branch.inertia;
            cell.children = {branch.children,
                             branch.children > 0 ? array.cells.data() + branch.firstChild : nullptr};
        }
    }
}

void SceneCells::loadSticks(const sim::State &state, const Binding &binding)
{
    if (!m_vocabulary.hasSticks)
        return;
    std::vector<BodyCell *> cellOf(static_cast<std::size_t>(state.pointCount()), nullptr);
    forEachCell([&](const BodyCell &cell, const auto &) {
        cellOf[static_cast<std::size_t>(cell.point)] = const_cast<BodyCell *>(&cell);
    });
    m_cells.sticks.count = static_cast<int>(binding.sticks.size());
    m_cells.sticks.cells.clear();
    for (const sim::Stick &stick : binding.sticks)
        m_cells.sticks.cells.push_back({cellOf[static_cast<std::size_t>(stick.a)],
                                        cellOf[static_cast<std::size_t>(stick.b)], stick.length,
                                        stick.share});
}

void SceneCells::resizeFirstArray(std::size_t count)
{
    m_cells.arrays.front().cells.resize(count);
    m_cells.arrays.front().count = static_cast<int>(count);
}

void SceneCells::loadPlaceholders()
{
    for (std::size_t i = 0; i < m_parameters.size(); ++i)
        m_parameters[i] = 0.7310585786300049 + 0.0137 * static_cast<double>(i);
    for (std::size_t i = 0; i < m_cells.handles.size(); ++i)
        m_cells.handles[i] = &m_cells.bodies[i];
    const auto fillUp = [](BodyArray &array, std::size_t count) {
        array.cells.resize(count);
        array.count = static_cast<int>(count);
    };
    for (BodyArray &array : m_cells.arrays)
        fillUp(array, 1000);
    if (m_vocabulary.hasCreatures)
        resizeCreatures(100);
    for (CreatureCell &creature : m_cells.creatures.cells)
        fillUp(creature.feet, 100);
    BodyCell end;
    m_cells.sticks.cells.assign(1000, {&end, &end, 1.0, 0.5});
    m_cells.sticks.count = 1000;
}

void SceneCells::readMotions(std::vector<BodyMotion> &into) const
{
    into.clear();
    forEachCell([&](const BodyCell &cell, const auto &) { into.push_back(motionOf(cell)); });
}

void SceneCells::resizeCreatures(std::size_t count)
{
    const std::size_t named = m_cells.creatures.cells.size();
    m_cells.creatures.cells.resize(count);
    m_cells.creatures.count = static_cast<int>(count);
    for (std::size_t i = named; i < count; ++i)
        m_cells.creatures.cells[i].feet.name = cellName("creatures", i) + ".feet";
}

void SceneCells::store(sim::State &state) const
{
    forEachCell([&](const BodyCell &cell, const auto &) { apply(motionOf(cell), state); });
    const auto storeGait = [&](Eigen::Index clock, double gait, double speed) {
        if (clock < state.gait.rows())
            state.gait[clock] = gait;
        if (clock < state.gaitSpeed.rows())
            state.gaitSpeed[clock] = speed;
    };
    if (!m_vocabulary.hasCreatures && state.gait.rows() == 1)
        storeGait(0, m_gait, m_gaitSpeed);
    for (std::size_t i = 0; i < m_cells.creatures.cells.size(); ++i)
        storeGait(static_cast<Eigen::Index>(i), m_cells.creatures.cells[i].gait,
                  m_cells.creatures.cells[i].gaitSpeed);
    if (m_vocabulary.hasGust)
        state.gustExtent = {m_gustFront, m_gustTail};
}

std::string SceneCells::firstNonFinite() const
{
    std::string name;
    forEachCell([&](const BodyCell &cell, const auto &nameOf) {
        if (!name.empty())
            return;
        if (!isFinite(cell.position))
            name = "The position of " + nameOf();
        else if (!isFinite(cell.velocity))
            name = "The velocity of " + nameOf();
        else if (!std::isfinite(cell.angle) || !std::isfinite(cell.spin))
            name = "The angle or the spin of " + nameOf();
    });
    if (!name.empty())
        return name;
    if (!std::isfinite(m_gait) || !std::isfinite(m_gaitSpeed))
        return "'gait'";
    if (!std::isfinite(m_gustFront) || !std::isfinite(m_gustTail))
        return "'gust_front' or 'gust_tail'";
    for (std::size_t i = 0; i < m_cells.creatures.cells.size(); ++i) {
        if (!std::isfinite(m_cells.creatures.cells[i].gait) ||
            !std::isfinite(m_cells.creatures.cells[i].gaitSpeed))
            return "The gait of " + cellName("creatures", i);
    }
    return {};
}

double SceneCells::random(int i) const
{
    return sim::uniform(m_seed, static_cast<std::int64_t>(m_frameNumber), i);
}

double SceneCells::randomInFrame(int i, int frame) const
{
    return sim::uniform(m_seed, frame, i);
}

Vec2 SceneCells::directionOfBranch(const BodyCell *branch) const
{
    return standsForBody(branch) ? sim::branchReach(branch->angle, 1.0, m_degrees) : Vec2();
}

}
