#include "app/listing/scene_cells.h"

#include "sim/base/direction.h"
#include "sim/base/random.h"
#include "sim/effects/tree/tree.h"

#include <angelscript.h>

#include <algorithm>
#include <cmath>

namespace listing {

using namespace AngelScript;

namespace {

using sim::Vec2;

bool isFiniteVector(Vec2 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y);
}

/// Stops the program with the error that the array `name` with `count` elements has no element `index`.
void raiseNoElement(int index, int count, const std::string &name)
{
    std::string sentence = "There is no " + name + "[" + std::to_string(index) + "]: ";
    if (count == 0)
        sentence += name + " is empty.";
    else if (count == 1)
        sentence += "the only one is " + name + "[0].";
    else
        sentence += name + " goes from " + name + "[0] to " + name + "[" + std::to_string(count - 1) + "].";
    asGetActiveContext()->SetException(sentence.c_str());
}

/// Returns the cell with this index of an array of the scene. If there is none, the program stops with an error.
template <class Cell>
Cell *cellAt(int index, std::vector<Cell> &cells, const std::string &name)
{
    const int count = static_cast<int>(cells.size());
    if (index >= 0 && index < count)
        return &cells[static_cast<std::size_t>(index)];
    raiseNoElement(index, count, name);
    return nullptr;
}

/// Returns whether `cell` is a body. If a variable stands for none, the program stops with an error.
bool isBody(const void *cell)
{
    if (!cell)
        asGetActiveContext()->SetException("Null pointer access");
    return cell != nullptr;
}

/// Stands for a place in sim::direction(), as a place is not one of the points.
constexpr int placeIndex = -1;

Vec2 directionOf(Vec2 from, Vec2 to, int fromPoint, int toPoint)
{
    return sim::direction(to - from, fromPoint, toPoint).out;
}

}

SceneCells::SceneCells(asIScriptEngine &engine, const Vocabulary &vocabulary, BodyAccess access)
    : m_engine(engine), m_vocabulary(vocabulary)
{
    registerFunctions(m_engine, m_vocabulary.parameters);
    m_types.vec2 = m_engine.GetTypeIdByDecl("Vec2");
    registerBodies(access);
    if (m_vocabulary.hasTree)
        registerBranches();
    if (m_vocabulary.hasCreatures)
        registerCreatures();
    if (m_vocabulary.hasSticks)
        registerSticks();
    registerInput();
    registerFunctionsOfScene();
    registerNames();
}

void SceneCells::registerBodies(BodyAccess access)
{
    // Variables of this type are references, so `Body foot = feet[i]` names the same body and copies nothing.
    m_engine.RegisterObjectType("Body", 0, asOBJ_REF | asOBJ_NOCOUNT | asOBJ_IMPLICIT_HANDLE);
    m_types.body = m_engine.GetTypeIdByDecl("Body") & asTYPEID_MASK_SEQNBR;
    const auto property = [this](const char *declaration, std::size_t offset) {
        m_engine.RegisterObjectProperty("Body", declaration, static_cast<int>(offset));
    };
    const bool isWritable = access == BodyAccess::write;
    property(isWritable ? "Vec2 position" : "const Vec2 position", offsetof(BodyCell, position));
    property(isWritable ? "Vec2 velocity" : "const Vec2 velocity", offsetof(BodyCell, velocity));
    property("const Vec2 before", offsetof(BodyCell, before));
    property("const bool held", offsetof(BodyCell, held));
    property("const double mass", offsetof(BodyCell, mass));
    property("const double radius", offsetof(BodyCell, radius));
    if (m_vocabulary.bodiesTurn) {
        property("double angle", offsetof(BodyCell, angle));
        property("double spin", offsetof(BodyCell, spin));
    }
    m_engine.RegisterObjectMethod("Body", "bool opEquals(const Body @) const", asFUNCTION(isSameBody),
                                  asCALL_CDECL_OBJFIRST);
    m_engine.RegisterObjectType("Bodies", 0, asOBJ_REF | asOBJ_NOHANDLE);
    m_engine.RegisterObjectProperty("Bodies", "const int count",
                                    static_cast<int>(offsetof(BodyArray, count)));
    m_engine.RegisterObjectMethod("Bodies", "Body @opIndex(int)", asFUNCTION(bodyAt), asCALL_CDECL_OBJLAST);
}

void SceneCells::registerCreatures()
{
    m_engine.RegisterObjectType("Creature", 0, asOBJ_REF | asOBJ_NOCOUNT | asOBJ_IMPLICIT_HANDLE);
    m_types.creature = m_engine.GetTypeIdByDecl("Creature") & asTYPEID_MASK_SEQNBR;
    const auto property = [this](const char *declaration, std::size_t offset) {
        m_engine.RegisterObjectProperty("Creature", declaration, static_cast<int>(offset));
    };
    m_engine.RegisterObjectMethod("Creature", "Body @get_body() property", asFUNCTION(bodyOf),
                                  asCALL_CDECL_OBJLAST);
    property("Bodies feet", offsetof(CreatureCell, feet));
    if (m_vocabulary.hasGait) {
        property("double gait", offsetof(CreatureCell, gait));
        property("double gait_speed", offsetof(CreatureCell, gaitSpeed));
    }
    m_engine.RegisterObjectMethod("Creature", "bool opEquals(const Creature @) const",
                                  asFUNCTION(isSameCreature), asCALL_CDECL_OBJFIRST);
    m_engine.RegisterObjectType("Creatures", 0, asOBJ_REF | asOBJ_NOHANDLE);
    m_engine.RegisterObjectProperty("Creatures", "const int count",
                                    static_cast<int>(offsetof(CreatureArray, count)));
    m_engine.RegisterObjectMethod("Creatures", "Creature @opIndex(int)", asFUNCTION(creatureAt),
                                  asCALL_CDECL_OBJLAST);
}

void SceneCells::registerBranches()
{
    m_engine.RegisterObjectType("Children", 0, asOBJ_REF | asOBJ_NOHANDLE);
    m_engine.RegisterObjectProperty("Children", "const int count",
                                    static_cast<int>(offsetof(ChildArray, count)));
    m_engine.RegisterObjectMethod("Children", "Body @opIndex(int)", asFUNCTION(childAt),
                                  asCALL_CDECL_OBJLAST);
    const auto property = [this](const char *declaration, std::size_t offset) {
        m_engine.RegisterObjectProperty("Body", declaration, static_cast<int>(offset));
    };
    property("const int number", offsetof(BodyCell, number));
    property("const double rest", offsetof(BodyCell, rest));
    property("const double scale", offsetof(BodyCell, scale));
    property("const double length", offsetof(BodyCell, length));
    property("const double inertia", offsetof(BodyCell, inertia));
    property("Children children", offsetof(BodyCell, children));
}

void SceneCells::registerSticks()
{
    m_engine.RegisterObjectType("Stick", 0, asOBJ_REF | asOBJ_NOCOUNT | asOBJ_IMPLICIT_HANDLE);
    m_types.stick = m_engine.GetTypeIdByDecl("Stick") & asTYPEID_MASK_SEQNBR;
    const auto property = [this](const char *declaration, std::size_t offset) {
        m_engine.RegisterObjectProperty("Stick", declaration, static_cast<int>(offset));
    };
    property("Body @const a", offsetof(StickCell, a));
    property("Body @const b", offsetof(StickCell, b));
    property("const double length", offsetof(StickCell, length));
    property("const double share", offsetof(StickCell, share));
    m_engine.RegisterObjectType("Sticks", 0, asOBJ_REF | asOBJ_NOHANDLE);
    m_engine.RegisterObjectProperty("Sticks", "const int count",
                                    static_cast<int>(offsetof(StickArray, count)));
    m_engine.RegisterObjectMethod("Sticks", "Stick @opIndex(int)", asFUNCTION(stickAt), asCALL_CDECL_OBJLAST);
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
    const auto direction = [this](const char *declaration, const asSFuncPtr &function) {
        m_engine.RegisterGlobalFunction(declaration, function, asCALL_CDECL);
    };
    direction("Vec2 direction(const Body @, const Body @)", asFUNCTION(directionBetween));
    direction("Vec2 direction(const Body @, const Vec2 &in)", asFUNCTION(directionToPlace));
    direction("Vec2 direction(const Vec2 &in, const Vec2 &in, const Body @)", asFUNCTION(directionOfPlaces));
}

void SceneCells::registerInput()
{
    m_engine.RegisterObjectType("Targets", 0, asOBJ_REF | asOBJ_NOHANDLE);
    m_engine.RegisterObjectProperty("Targets", "const int count",
                                    static_cast<int>(offsetof(TargetArray, count)));
    m_engine.RegisterObjectMethod("Targets", "Vec2 opIndex(int) const", asFUNCTION(targetAt),
                                  asCALL_CDECL_OBJLAST);
    m_engine.RegisterObjectType("Keys", 0, asOBJ_REF | asOBJ_NOHANDLE);
    const auto key = [this](const char *declaration, std::size_t offset) {
        m_engine.RegisterObjectProperty("Keys", declaration, static_cast<int>(offset));
    };
    key("const bool left", offsetof(KeyCell, left));
    key("const bool right", offsetof(KeyCell, right));
    key("const bool up", offsetof(KeyCell, up));
    key("const bool down", offsetof(KeyCell, down));
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
    forEachCell([&](const BodyCell &cell, const auto &) {
        into.push_back({cell.point, cell.position, cell.velocity, cell.angle, cell.spin});
    });
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
    forEachCell([&](const BodyCell &cell, const auto &) {
        state.place(cell.point, cell.position);
        state.setVelocity(cell.point, cell.velocity);
        if (state.angle.rows() > cell.point)
            state.angle[cell.point] = cell.angle;
        if (state.spin.rows() > cell.point)
            state.spin[cell.point] = cell.spin;
    });
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
        if (!isFiniteVector(cell.position))
            name = "The position of " + nameOf();
        else if (!isFiniteVector(cell.velocity))
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
    return sim::uniform(m_seed, static_cast<std::uint64_t>(m_frameNumber),
                        static_cast<std::uint64_t>(static_cast<std::int64_t>(i)));
}

double SceneCells::randomInFrame(int i, int frame) const
{
    return sim::uniform(m_seed, static_cast<std::uint64_t>(static_cast<std::int64_t>(frame)),
                        static_cast<std::uint64_t>(static_cast<std::int64_t>(i)));
}

bool SceneCells::isSameBody(const BodyCell *a, const BodyCell *b)
{
    return a == b;
}

bool SceneCells::isSameCreature(const CreatureCell *a, const CreatureCell *b)
{
    return a == b;
}

BodyCell *SceneCells::bodyAt(int index, BodyArray *array)
{
    return cellAt(index, array->cells, array->name);
}

CreatureCell *SceneCells::creatureAt(int index, CreatureArray *array)
{
    return cellAt(index, array->cells, "creatures");
}

BodyCell *SceneCells::bodyOf(CreatureCell *creature)
{
    return &creature->body;
}

BodyCell *SceneCells::childAt(int index, ChildArray *array)
{
    if (index >= 0 && index < array->count)
        return array->first + index;
    raiseNoElement(index, array->count, "children");
    return nullptr;
}

StickCell *SceneCells::stickAt(int index, StickArray *array)
{
    return cellAt(index, array->cells, "sticks");
}

Vec2 SceneCells::targetAt(int index, const TargetArray *array)
{
    if (index >= 0 && index < array->count)
        return array->all[static_cast<std::size_t>(index)];
    raiseNoElement(index, array->count, "new_targets");
    return {};
}

Vec2 SceneCells::directionOfBranch(const BodyCell *branch) const
{
    return isBody(branch) ? sim::branchReach(branch->angle, 1.0, m_degrees) : Vec2();
}

Vec2 SceneCells::directionBetween(const BodyCell *from, const BodyCell *to)
{
    if (!isBody(from) || !isBody(to))
        return {};
    return directionOf(from->position, to->position, from->point, to->point);
}

Vec2 SceneCells::directionToPlace(const BodyCell *from, const VectorCell &to)
{
    return isBody(from) ? directionOf(from->position, read(to), from->point, placeIndex) : Vec2();
}

Vec2 SceneCells::directionOfPlaces(const VectorCell &from, const VectorCell &to, const BodyCell *owner)
{
    return isBody(owner) ? directionOf(read(from), read(to), placeIndex, owner->point) : Vec2();
}

}
