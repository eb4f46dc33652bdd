#include "app/listing/interpreter.h"

#include "app/listing/compile_sentences.h"
#include "app/listing/limits.h"
#include "app/listing/script_functions.h"
#include "sim/base/direction.h"
#include "sim/base/random.h"
#include "sim/effects/tree/tree.h"

#include <angelscript.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <functional>

namespace listing {

using namespace AngelScript;

namespace {

using sim::Vec2;

/// Releases the memory that the interpreter keeps for a thread when the thread ends.
struct ThreadCleanup
{
    ~ThreadCleanup() { asThreadCleanup(); }
};

void prepareThread()
{
    // So that all engines of the process share one thread manager, whichever thread makes the first one.
    static const int prepared = asPrepareMultithread();
    static_cast<void>(prepared);
    static thread_local ThreadCleanup cleanup;
    static_cast<void>(cleanup);
}

bool isFiniteVector(Vec2 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y);
}

std::string cellName(const std::string &array, std::size_t index)
{
    return array + "[" + std::to_string(index) + "]";
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

/// Returns the index of `cell` in `cells`, if it is one of them.
template <class Cell>
std::optional<std::size_t> indexOf(const Cell *cell, const std::vector<Cell> &cells)
{
    const std::less<const Cell *> isBefore;
    if (!cell || cells.empty() || isBefore(cell, cells.data()) ||
        !isBefore(cell, cells.data() + cells.size()))
        return {};
    return static_cast<std::size_t>(cell - cells.data());
}

}

std::string typeName(const Value &value)
{
    static const char *const names[] = {"double", "int", "bool", "Vec2", "Body"};
    const auto *reference = std::get_if<BodyReference>(&value);
    if (reference && reference->kind == BodyReference::Kind::creature)
        return "Creature";
    if (reference && reference->kind == BodyReference::Kind::stick)
        return "Stick";
    return names[value.index()];
}

Interpreter::Interpreter(const SourceScan &scan, const Vocabulary &vocabulary)
    : m_scan(scan), m_vocabulary(vocabulary)
{
    prepareThread();
    m_engine = asCreateScriptEngine();
    m_engine->SetMessageCallback(asFUNCTION(messageCallback), this, asCALL_CDECL);
    m_engine->SetEngineProperty(asEP_ALLOW_IMPLICIT_HANDLE_TYPES, 1);
    m_engine->SetEngineProperty(asEP_INIT_GLOBAL_VARS_AFTER_BUILD, 0);
    m_engine->SetEngineProperty(asEP_MAX_STACK_SIZE, 1 << 20);
    m_engine->SetEngineProperty(asEP_AUTO_GARBAGE_COLLECT, 0); // nothing of a listing is collected
    registerLanguage();
    compile();
    m_engine->ClearMessageCallback();
    if (!m_errors.empty())
        return;
    m_context = m_engine->CreateContext();
    m_context->SetLineCallback(asFUNCTION(lineCallback), this, asCALL_CDECL);
    m_context->SetExceptionCallback(asFUNCTION(exceptionCallback), this, asCALL_CDECL);
}

Interpreter::~Interpreter()
{
    if (m_context)
        m_context->Release();
    m_engine->ShutDownAndRelease();
}

void Interpreter::registerLanguage()
{
    registerFunctions(*m_engine, m_vocabulary.parameters);
    m_vec2Type = m_engine->GetTypeIdByDecl("Vec2");
    registerBodies();
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

void Interpreter::registerBodies()
{
    // Variables of this type are references, so `Body foot = feet[i]` names the same body and copies nothing.
    m_engine->RegisterObjectType("Body", 0, asOBJ_REF | asOBJ_NOCOUNT | asOBJ_IMPLICIT_HANDLE);
    m_bodyType = m_engine->GetTypeIdByDecl("Body") & asTYPEID_MASK_SEQNBR;
    const auto property = [this](const char *declaration, std::size_t offset) {
        m_engine->RegisterObjectProperty("Body", declaration, static_cast<int>(offset));
    };
    property("Vec2 position", offsetof(BodyCell, position));
    property("Vec2 velocity", offsetof(BodyCell, velocity));
    property("const Vec2 before", offsetof(BodyCell, before));
    property("const bool held", offsetof(BodyCell, held));
    property("const double mass", offsetof(BodyCell, mass));
    property("const double radius", offsetof(BodyCell, radius));
    if (m_vocabulary.bodiesTurn) {
        property("double angle", offsetof(BodyCell, angle));
        property("double spin", offsetof(BodyCell, spin));
    }
    m_engine->RegisterObjectMethod("Body", "bool opEquals(const Body @) const", asFUNCTION(isSameBody),
                                   asCALL_CDECL_OBJFIRST);
    m_engine->RegisterObjectType("Bodies", 0, asOBJ_REF | asOBJ_NOHANDLE);
    m_engine->RegisterObjectProperty("Bodies", "const int count",
                                     static_cast<int>(offsetof(BodyArray, count)));
    m_engine->RegisterObjectMethod("Bodies", "Body @opIndex(int)", asFUNCTION(bodyAt), asCALL_CDECL_OBJLAST);
}

void Interpreter::registerCreatures()
{
    m_engine->RegisterObjectType("Creature", 0, asOBJ_REF | asOBJ_NOCOUNT | asOBJ_IMPLICIT_HANDLE);
    m_creatureType = m_engine->GetTypeIdByDecl("Creature") & asTYPEID_MASK_SEQNBR;
    const auto property = [this](const char *declaration, std::size_t offset) {
        m_engine->RegisterObjectProperty("Creature", declaration, static_cast<int>(offset));
    };
    m_engine->RegisterObjectMethod("Creature", "Body @get_body() property", asFUNCTION(bodyOf),
                                   asCALL_CDECL_OBJLAST);
    property("Bodies feet", offsetof(CreatureCell, feet));
    if (m_vocabulary.hasGait) {
        property("double gait", offsetof(CreatureCell, gait));
        property("double gait_speed", offsetof(CreatureCell, gaitSpeed));
    }
    m_engine->RegisterObjectMethod("Creature", "bool opEquals(const Creature @) const",
                                   asFUNCTION(isSameCreature), asCALL_CDECL_OBJFIRST);
    m_engine->RegisterObjectType("Creatures", 0, asOBJ_REF | asOBJ_NOHANDLE);
    m_engine->RegisterObjectProperty("Creatures", "const int count",
                                     static_cast<int>(offsetof(CreatureArray, count)));
    m_engine->RegisterObjectMethod("Creatures", "Creature @opIndex(int)", asFUNCTION(creatureAt),
                                   asCALL_CDECL_OBJLAST);
}

void Interpreter::registerBranches()
{
    m_engine->RegisterObjectType("Children", 0, asOBJ_REF | asOBJ_NOHANDLE);
    m_engine->RegisterObjectProperty("Children", "const int count",
                                     static_cast<int>(offsetof(ChildArray, count)));
    m_engine->RegisterObjectMethod("Children", "Body @opIndex(int)", asFUNCTION(childAt),
                                   asCALL_CDECL_OBJLAST);
    const auto property = [this](const char *declaration, std::size_t offset) {
        m_engine->RegisterObjectProperty("Body", declaration, static_cast<int>(offset));
    };
    property("const int number", offsetof(BodyCell, number));
    property("const double rest", offsetof(BodyCell, rest));
    property("const double scale", offsetof(BodyCell, scale));
    property("const double length", offsetof(BodyCell, length));
    property("const double inertia", offsetof(BodyCell, inertia));
    property("Children children", offsetof(BodyCell, children));
}

void Interpreter::registerSticks()
{
    m_engine->RegisterObjectType("Stick", 0, asOBJ_REF | asOBJ_NOCOUNT | asOBJ_IMPLICIT_HANDLE);
    m_stickType = m_engine->GetTypeIdByDecl("Stick") & asTYPEID_MASK_SEQNBR;
    const auto property = [this](const char *declaration, std::size_t offset) {
        m_engine->RegisterObjectProperty("Stick", declaration, static_cast<int>(offset));
    };
    property("Body @const a", offsetof(StickCell, a));
    property("Body @const b", offsetof(StickCell, b));
    property("const double length", offsetof(StickCell, length));
    property("const double share", offsetof(StickCell, share));
    m_engine->RegisterObjectType("Sticks", 0, asOBJ_REF | asOBJ_NOHANDLE);
    m_engine->RegisterObjectProperty("Sticks", "const int count",
                                     static_cast<int>(offsetof(StickArray, count)));
    m_engine->RegisterObjectMethod("Sticks", "Stick @opIndex(int)", asFUNCTION(stickAt),
                                   asCALL_CDECL_OBJLAST);
}

void Interpreter::registerFunctionsOfScene()
{
    const auto method = [this](const char *declaration, const asSFuncPtr &function) {
        m_engine->RegisterGlobalFunction(declaration, function, asCALL_THISCALL_ASGLOBAL, this);
    };
    method("double sin(double)", asMETHOD(Interpreter, sine));
    method("double cos(double)", asMETHOD(Interpreter, cosine));
    method("double atan2(double, double)", asMETHOD(Interpreter, arcTangent));
    method("double random(int)", asMETHOD(Interpreter, random));
    method("double random(int, int)", asMETHOD(Interpreter, randomInFrame));
    if (m_vocabulary.hasTree)
        method("Vec2 direction(const Body @)", asMETHOD(Interpreter, directionOfBranch));
    const auto direction = [this](const char *declaration, const asSFuncPtr &function) {
        m_engine->RegisterGlobalFunction(declaration, function, asCALL_CDECL);
    };
    direction("Vec2 direction(const Body @, const Body @)", asFUNCTION(directionBetween));
    direction("Vec2 direction(const Body @, const Vec2 &in)", asFUNCTION(directionToPlace));
    direction("Vec2 direction(const Vec2 &in, const Vec2 &in, const Body @)", asFUNCTION(directionOfPlaces));
}

void Interpreter::registerInput()
{
    m_engine->RegisterObjectType("Targets", 0, asOBJ_REF | asOBJ_NOHANDLE);
    m_engine->RegisterObjectProperty("Targets", "const int count",
                                     static_cast<int>(offsetof(TargetArray, count)));
    m_engine->RegisterObjectMethod("Targets", "Vec2 opIndex(int) const", asFUNCTION(targetAt),
                                   asCALL_CDECL_OBJLAST);
    m_engine->RegisterObjectType("Keys", 0, asOBJ_REF | asOBJ_NOHANDLE);
    const auto key = [this](const char *declaration, std::size_t offset) {
        m_engine->RegisterObjectProperty("Keys", declaration, static_cast<int>(offset));
    };
    key("const bool left", offsetof(KeyCell, left));
    key("const bool right", offsetof(KeyCell, right));
    key("const bool up", offsetof(KeyCell, up));
    key("const bool down", offsetof(KeyCell, down));
}

void Interpreter::registerNames()
{
    const auto global = [this](const std::string &declaration, void *address) {
        m_engine->RegisterGlobalProperty(declaration.c_str(), address);
    };
    for (const std::string &name : m_vocabulary.bodies) {
        m_bodies.emplace_back();
        m_handles.push_back(nullptr);
        global("Body @const " + name, &m_handles.back());
    }
    for (const Vocabulary::Array &array : m_vocabulary.arrays) {
        m_arrays.emplace_back().name = array.name;
        global("Bodies " + array.name, &m_arrays.back());
    }
    if (m_vocabulary.hasCreatures)
        global("Creatures creatures", &m_creatures);
    if (m_vocabulary.hasSticks)
        global("Sticks sticks", &m_sticks);
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

void Interpreter::addError(int line, int column, std::string sentence)
{
    const auto isOnLine = [&](const CompileError &error) { return error.line == line; };
    if (std::none_of(m_errors.begin(), m_errors.end(), isOnLine))
        m_errors.push_back({line, column, m_scan.lengthAt(line, column), std::move(sentence)});
}

void Interpreter::messageCallback(const asSMessageInfo *message, void *self)
{
    auto &interpreter = *static_cast<Interpreter *>(self);
    const SourceScan &scan = interpreter.m_scan;
    const std::string text = message->message;
    // A variable without a value would hold what an earlier call left behind.
    const bool isWarning =
        message->type == asMSGTYPE_WARNING && text.find("is not initialized") == std::string::npos;
    if (message->type == asMSGTYPE_INFORMATION || isWarning || text.starts_with("Instead found"))
        return;
    const int line = std::max(1, message->row), column = std::max(1, message->col);
    const std::size_t offset = scan.offsetOf(line, column);
    const Tokens &tokens = scan.tokens();
    auto marked = std::find_if(tokens.begin(), tokens.end(), [&](const Token &token) {
        return offset >= token.offset && offset < token.end();
    });
    MarkedPlace place = {{}, interpreter.m_vocabulary, scan.declaredNames()};
    if (marked == tokens.end())
        return interpreter.addError(line, column, plainSentence(text, place));
    if (isAboutChange(text) && marked != tokens.begin())
        --marked; // the interpreter points at the sign behind it
    else if (marked->text == "." && marked + 1 != tokens.end())
        ++marked; // the interpreter points at the dot before a member
    place.word = std::string(marked->text);
    interpreter.addError(marked->line, marked->column, plainSentence(text, place));
}

void Interpreter::compile()
{
    if (m_scan.error()) {
        m_errors.push_back(*m_scan.error());
        return;
    }
    const auto addMissingFrame = [this] {
        addError(1, 1, "The function 'void frame()' is missing. It runs once in every frame.");
    };
    if (m_scan.tokens().empty())
        return addMissingFrame();
    m_module = m_engine->GetModule("listing", asGM_ALWAYS_CREATE);
    const std::string text = m_scan.compiledText();
    m_module->AddScriptSection("listing", text.data(), text.size());
    const int built = m_module->Build();
    if (built < 0) {
        if (m_errors.empty())
            addError(1, 1, "This listing cannot be compiled.");
        return;
    }
    m_frame = m_module->GetFunctionByDecl("void frame()");
    if (!m_frame)
        addMissingFrame();
    findGlobals();
}

std::size_t Interpreter::sizeOf(int type) const
{
    if (type == m_vec2Type)
        return sizeof(Vec2);
    if ((type & ~asTYPEID_MASK_SEQNBR) != 0 || type > asTYPEID_DOUBLE)
        return 0;
    return static_cast<std::size_t>(std::max(0, m_engine->GetSizeOfPrimitiveType(type)));
}

void Interpreter::findGlobals()
{
    for (asUINT i = 0; i < m_module->GetGlobalVarCount(); ++i) {
        Global global = {nullptr, 0, i, 0};
        m_module->GetGlobalVar(i, &global.name, nullptr, &global.type);
        global.bytes = sizeOf(global.type);
        if (global.bytes == 0) {
            const auto &tokens = m_scan.tokens();
            const auto found = std::find_if(tokens.begin(), tokens.end(),
                                            [&](const Token &token) { return token.text == global.name; });
            addError(found == tokens.end() ? 1 : found->line, found == tokens.end() ? 1 : found->column,
                     "'" + std::string(global.name) +
                         "' cannot be remembered from frame to frame. Only numbers, bool and Vec2 can.");
            continue;
        }
        m_memoryBytes += global.bytes;
        m_globals.push_back(global);
    }
    if (m_memoryBytes > maxMemoryBytes)
        addError(1, 1,
                 "The variables outside of functions take " + std::to_string(m_memoryBytes) +
                     " bytes. The most is " + std::to_string(maxMemoryBytes) + ".");
}

template <class Visit>
void Interpreter::forEachCell(Visit &&visit) const
{
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        if (m_handles[i])
            visit(m_bodies[i], [&] { return m_vocabulary.bodies[i]; });
    }
    for (const BodyArray &array : m_arrays) {
        for (std::size_t i = 0; i < array.cells.size(); ++i)
            visit(array.cells[i], [&] { return cellName(array.name, i); });
    }
    for (std::size_t i = 0; i < m_creatures.cells.size(); ++i) {
        const CreatureCell &creature = m_creatures.cells[i];
        visit(creature.body, [&] { return cellName("creatures", i) + ".body"; });
        for (std::size_t j = 0; j < creature.feet.cells.size(); ++j)
            visit(creature.feet.cells[j], [&] { return cellName(creature.feet.name, j); });
    }
    for (const BodyCell &cell : m_otherBodies)
        visit(cell, [&] { return nameBySticks(&cell); });
}

void Interpreter::load(const sim::State &state, const Binding &binding)
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
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        const int point = binding.bodies[i];
        m_handles[i] = point < 0 ? nullptr : &m_bodies[i];
        if (point >= 0)
            fill(m_bodies[i], point);
    }
    const auto fillArray = [&](BodyArray &array, const std::vector<int> &points) {
        array.cells.resize(points.size());
        array.count = static_cast<int>(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            fill(array.cells[i], points[i]);
    };
    for (std::size_t i = 0; i < m_arrays.size(); ++i)
        fillArray(m_arrays[i], binding.arrays[i]);
    resizeCreatures(binding.creatures.size());
    for (std::size_t i = 0; i < binding.creatures.size(); ++i) {
        CreatureCell &creature = m_creatures.cells[i];
        fill(creature.body, binding.creatures[i].body);
        fillArray(creature.feet, binding.creatures[i].feet);
        const auto clock = static_cast<Eigen::Index>(i);
        creature.gait = clock < state.gait.rows() ? state.gait[clock] : 0.0;
        creature.gaitSpeed = clock < state.gaitSpeed.rows() ? state.gaitSpeed[clock] : 0.0;
    }
    m_otherBodies.resize(binding.otherBodies.size());
    for (std::size_t i = 0; i < m_otherBodies.size(); ++i)
        fill(m_otherBodies[i], binding.otherBodies[i]);
    loadBranches(binding);
    loadSticks(state, binding);
    std::copy(binding.parameters.begin(), binding.parameters.end(), m_parameters.begin());
    m_angleFunctions = binding.angleFunctions;
    m_degrees = binding.degrees;
    m_seed = binding.seed;
    m_frameNumber = static_cast<double>(state.frame);
    m_gait = state.gait.rows() == 1 ? state.gait[0] : 0.0;
    m_gaitSpeed = state.gaitSpeed.rows() == 1 ? state.gaitSpeed[0] : 0.0;
    m_gustFront = state.gustExtent.front;
    m_gustTail = state.gustExtent.tail;
    loadInput(state);
}

void Interpreter::loadInput(const sim::State &state)
{
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

void Interpreter::loadBranches(const Binding &binding)
{
    for (BodyArray &array : m_arrays) {
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

void Interpreter::loadSticks(const sim::State &state, const Binding &binding)
{
    if (!m_vocabulary.hasSticks)
        return;
    std::vector<BodyCell *> cellOf(static_cast<std::size_t>(state.pointCount()), nullptr);
    forEachCell([&](const BodyCell &cell, const auto &) {
        cellOf[static_cast<std::size_t>(cell.point)] = const_cast<BodyCell *>(&cell);
    });
    m_sticks.count = static_cast<int>(binding.sticks.size());
    m_sticks.cells.clear();
    for (const sim::Stick &stick : binding.sticks)
        m_sticks.cells.push_back({cellOf[static_cast<std::size_t>(stick.a)],
                                  cellOf[static_cast<std::size_t>(stick.b)], stick.length, stick.share});
}

void Interpreter::resizeCreatures(std::size_t count)
{
    const std::size_t named = m_creatures.cells.size();
    m_creatures.cells.resize(count);
    m_creatures.count = static_cast<int>(count);
    for (std::size_t i = named; i < count; ++i)
        m_creatures.cells[i].feet.name = cellName("creatures", i) + ".feet";
}

void Interpreter::store(sim::State &state) const
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
    for (std::size_t i = 0; i < m_creatures.cells.size(); ++i)
        storeGait(static_cast<Eigen::Index>(i), m_creatures.cells[i].gait, m_creatures.cells[i].gaitSpeed);
    if (m_vocabulary.hasGust)
        state.gustExtent = {m_gustFront, m_gustTail};
    state.memory.resize(m_memoryBytes);
    std::size_t at = 0;
    for (const Global &global : m_globals) {
        std::memcpy(state.memory.data() + at, addressOf(global), global.bytes);
        at += global.bytes;
    }
}

RunResult Interpreter::run(sim::State &state, const Binding &binding, const Recording &recording)
{
    prepareThread();
    load(state, binding);
    RunResult result = execute(state, binding, recording);
    if (!result.error && !result.isStopped && !firstNonFinite().empty()) {
        // Once more, with a check after each line. This finds the line without slowing down every frame.
        Recording search;
        search.findsNonFinite = true;
        load(state, binding);
        const RunResult found = execute(state, binding, search);
        result.error = found.error;
    }
    if (!result.error)
        store(state);
    return result;
}

RunResult Interpreter::execute(const sim::State &state, const Binding &binding, const Recording &recording)
{
    m_recording = recording;
    m_result = {};
    m_cues = m_lines = m_lastLine = m_lastDepth = 0;
    m_before = {};
    if (state.memory.size() != m_memoryBytes) {
        initialise();
    } else {
        allocateGlobals(state, binding);
        std::size_t at = 0;
        for (const Global &global : m_globals) {
            if (void *address = addressOf(global))
                std::memcpy(address, state.memory.data() + at, global.bytes);
            at += global.bytes;
        }
    }
    for (const Global &global : m_globals) {
        if (!addressOf(global) && !m_result.error)
            m_result.error =
                RunError{RunErrorKind::other,
                         1,
                         "The first value of '" + std::string(global.name) + "' cannot be computed.",
                         {}};
    }
    m_cues = m_lastLine = 0;
    m_recorded.clear();
    if (!m_result.error)
        runFrame();
    if (m_recording.lines) {
        recordChanges();
        m_result.globals = variables();
    }
    if (m_recording.findsNonFinite && !m_result.error) {
        const std::string name = firstNonFinite();
        if (!name.empty()) {
            m_result.error = RunError{RunErrorKind::notFinite, m_before.line,
                                      name + " is not a finite number.", m_before.variables};
        }
    }
    return std::move(m_result);
}

void *Interpreter::addressOf(const Global &global) const
{
    return m_module->GetAddressOfGlobalVar(global.index);
}

void Interpreter::initialise()
{
    if (m_globals.empty())
        return;
    m_isInitialising = true;
    if (m_module->ResetGlobalVars(m_context) < 0 && !m_result.error)
        m_result.error = RunError{RunErrorKind::other, m_lastLine, "The interpreter stopped.", {}};
    m_isInitialising = false;
}

void Interpreter::allocateGlobals(const sim::State &state, const Binding &binding)
{
    const auto isMissing = [this](const Global &global) { return !addressOf(global); };
    const auto anyIsMissing = [&] { return std::any_of(m_globals.begin(), m_globals.end(), isMissing); };
    if (!anyIsMissing())
        return;
    // The values do not matter: those of the state replace them. Computing them can fail in the current state, for
    // example if a body is gone since the first frame. Then other parameters and bodies help.
    initialise();
    m_result.error.reset();
    m_cues = 0;
    if (!anyIsMissing())
        return;
    for (std::size_t i = 0; i < m_parameters.size(); ++i)
        m_parameters[i] = 0.7310585786300049 + 0.0137 * static_cast<double>(i);
    for (std::size_t i = 0; i < m_handles.size(); ++i)
        m_handles[i] = &m_bodies[i];
    const auto fillUp = [](BodyArray &array, std::size_t count) {
        array.cells.resize(count);
        array.count = static_cast<int>(count);
    };
    for (BodyArray &array : m_arrays)
        fillUp(array, 1000);
    if (m_vocabulary.hasCreatures)
        resizeCreatures(100);
    for (CreatureCell &creature : m_creatures.cells)
        fillUp(creature.feet, 100);
    BodyCell end;
    m_sticks.cells.assign(1000, {&end, &end, 1.0, 0.5});
    m_sticks.count = 1000;
    initialise();
    m_result.error.reset();
    m_cues = 0;
    load(state, binding);
}

void Interpreter::runFrame()
{
    m_context->Prepare(m_frame);
    const int code = m_context->Execute();
    if (code != asEXECUTION_FINISHED && !m_result.error && !m_result.isStopped)
        m_result.error = RunError{RunErrorKind::other, m_lastLine, "The interpreter stopped.", {}};
    m_context->Unprepare();
}

void Interpreter::lineCallback(asIScriptContext *, void *self)
{
    static_cast<Interpreter *>(self)->onLine();
}

void Interpreter::exceptionCallback(asIScriptContext *, void *self)
{
    static_cast<Interpreter *>(self)->onException();
}

void Interpreter::fail(RunErrorKind kind, int line, std::string sentence)
{
    if (!m_result.error)
        m_result.error = RunError{kind, line, std::move(sentence), variables()};
    m_context->Abort();
}

void Interpreter::onLine()
{
    int column = 0;
    const int line = m_context->GetLineNumber(0, &column);
    const int depth = static_cast<int>(m_context->GetCallstackSize()) - 1;
    if (++m_cues > maxLinesPerFrame) {
        const std::size_t at = m_scan.offsetOf(line, column);
        int loopLine = line;
        for (const Loop &loop : m_scan.loops()) { // the innermost comes last
            if (loop.whole.contains(at))
                loopLine = loop.line;
        }
        return fail(RunErrorKind::endlessLoop, loopLine,
                    "This did not end after " + std::to_string(maxLinesPerFrame) +
                        " lines. A loop or a function repeats without end.");
    }
    if (depth > maxCallDepth)
        return fail(
            RunErrorKind::tooDeep, line,
            "Functions call functions " + std::to_string(maxCallDepth) +
                " times inside one another. A function that calls itself needs a case in which it does not.");
    const bool isNewLine = line != m_lastLine || depth != m_lastDepth;
    m_lastLine = line;
    m_lastDepth = depth;
    if (m_isInitialising || !isNewLine)
        return;
    ++m_lines;
    if (m_recording.lines || m_recording.findsNonFinite || m_recording.stopAfter >= 0)
        record(line, column, depth);
}

void Interpreter::record(int line, int column, int depth)
{
    const bool keepsLine = m_recording.lines && m_recording.lines->size() < std::size_t{maxTracedLines};
    const bool isLast = m_recording.stopAfter >= 0 && m_lines > m_recording.stopAfter;
    if (m_recording.findsNonFinite) {
        const std::string name = firstNonFinite();
        if (!name.empty() && !m_result.error) {
            m_result.error = RunError{RunErrorKind::notFinite, m_before.line,
                                      name + " is not a finite number.", m_before.variables};
            m_context->Abort();
            return;
        }
    }
    if (m_recording.lines && !keepsLine)
        m_result.isComplete = false;
    if (m_recording.lines && m_result.isComplete)
        recordChanges();
    if (!keepsLine && !isLast && !m_recording.findsNonFinite)
        return;
    TracedLine traced = {line, depth, m_context->GetFunction(0)->GetName(), variables(), {}};
    const std::size_t at = m_scan.offsetOf(line, column);
    for (const Loop &loop : m_scan.loops()) {
        // The turn is counted afterwards: 0 in the head of a loop.
        if (loop.whole.contains(at))
            traced.loops.push_back({loop.line, loop.body.contains(at) ? 1 : 0, 0});
    }
    if (isLast) {
        m_result.isStopped = true;
        m_result.next = std::move(traced);
        m_context->Abort();
    } else if (m_recording.findsNonFinite) {
        m_before = std::move(traced);
    } else {
        m_recording.lines->push_back(std::move(traced));
    }
}

void Interpreter::recordChanges()
{
    const bool isFirst = m_recorded.empty();
    std::size_t next = 0;
    forEachCell([&](const BodyCell &cell, const auto &) {
        const BodyMotion now = {cell.point, cell.position, cell.velocity, cell.angle, cell.spin};
        if (isFirst) {
            m_recorded.push_back(now);
        } else if (BodyMotion &before = m_recorded[next++]; before != now) {
            before = now;
            m_recording.lines->back().changed.push_back(now);
        }
    });
}

void Interpreter::onException()
{
    const std::string text = m_context->GetExceptionString();
    const int line = m_context->GetExceptionLineNumber();
    RunErrorKind kind = RunErrorKind::other;
    std::string sentence = text;
    if (text.starts_with("There is no ")) {
        kind = RunErrorKind::noSuchBody;
    } else if (text == "Null pointer access") {
        kind = RunErrorKind::noSuchBody;
        sentence = "This variable stands for no body.";
    } else if (text == "Divide by zero") {
        kind = RunErrorKind::divisionByZero;
        sentence = "This divides by 0.";
    } else if (text == "Overflow in integer division" || text == "Overflow in exponent operation") {
        kind = RunErrorKind::notFinite;
        sentence = "The result is too large for a number.";
    } else if (text.starts_with("Stack overflow")) {
        kind = RunErrorKind::tooDeep;
        sentence = "Functions call functions too many times inside one another.";
    }
    if (!m_result.error)
        m_result.error = RunError{kind, line, std::move(sentence), variables()};
}

std::string Interpreter::firstNonFinite() const
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
    for (std::size_t i = 0; i < m_creatures.cells.size(); ++i) {
        if (!std::isfinite(m_creatures.cells[i].gait) || !std::isfinite(m_creatures.cells[i].gaitSpeed))
            return "The gait of " + cellName("creatures", i);
    }
    for (const Global &global : m_globals) {
        const std::optional<Value> value = valueAt(addressOf(global), global.type);
        const auto *number = value ? std::get_if<double>(&*value) : nullptr;
        const auto *vector = value ? std::get_if<Vec2>(&*value) : nullptr;
        if ((number && !std::isfinite(*number)) || (vector && !isFiniteVector(*vector)))
            return "'" + std::string(global.name) + "'";
    }
    return {};
}

Value Interpreter::valueOf(const BodyCell *cell) const
{
    if (!cell)
        return BodyReference();
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        if (cell == &m_bodies[i])
            return BodyReference{m_vocabulary.bodies[i], cell->point};
    }
    for (const BodyArray &array : m_arrays) {
        if (const auto index = indexOf(cell, array.cells))
            return BodyReference{cellName(array.name, *index), cell->point};
    }
    for (std::size_t i = 0; i < m_creatures.cells.size(); ++i) {
        const CreatureCell &creature = m_creatures.cells[i];
        if (cell == &creature.body)
            return BodyReference{cellName("creatures", i) + ".body", cell->point};
        if (const auto index = indexOf(cell, creature.feet.cells))
            return BodyReference{cellName(creature.feet.name, *index), cell->point};
    }
    return BodyReference{nameBySticks(cell), cell->point};
}

std::string Interpreter::nameBySticks(const BodyCell *cell) const
{
    for (std::size_t i = 0; i < m_sticks.cells.size(); ++i) {
        const StickCell &stick = m_sticks.cells[i];
        if (cell == stick.a || cell == stick.b)
            return cellName("sticks", i) + (cell == stick.a ? ".a" : ".b");
    }
    return {};
}

Value Interpreter::valueOf(const CreatureCell *cell) const
{
    const std::optional<std::size_t> index = indexOf(cell, m_creatures.cells);
    constexpr auto kind = BodyReference::Kind::creature;
    return index ? BodyReference{cellName("creatures", *index), cell->body.point, kind}
                 : BodyReference{{}, -1, kind};
}

Value Interpreter::valueOf(const StickCell *cell) const
{
    const std::optional<std::size_t> index = indexOf(cell, m_sticks.cells);
    return BodyReference{index ? cellName("sticks", *index) : std::string(), -1, BodyReference::Kind::stick};
}

std::optional<Value> Interpreter::valueAt(const void *address, int type) const
{
    if (!address)
        return {};
    const auto number = [address]<class Number>(Number value) {
        std::memcpy(&value, address, sizeof value);
        return value;
    };
    switch (type) {
    case asTYPEID_BOOL:
        return Value(number(char{}) != 0);
    case asTYPEID_INT32:
        return Value(std::int64_t{number(std::int32_t{})});
    case asTYPEID_DOUBLE:
        return Value(number(double{}));
    default:
        break;
    }
    if (type == m_vec2Type)
        return Value(number(Vec2{}));
    if ((type & asTYPEID_MASK_SEQNBR) == m_bodyType)
        return valueOf(number(static_cast<const BodyCell *>(nullptr)));
    if ((type & asTYPEID_MASK_SEQNBR) == m_creatureType)
        return valueOf(number(static_cast<const CreatureCell *>(nullptr)));
    if ((type & asTYPEID_MASK_SEQNBR) == m_stickType)
        return valueOf(number(static_cast<const StickCell *>(nullptr)));
    return {};
}

const Interpreter::Scopes &Interpreter::scopesOf(asIScriptFunction *function) const
{
    const auto [found, isNew] = m_scopes.try_emplace(function);
    Scopes &scopes = found->second;
    if (!isNew)
        return scopes;
    const FunctionText *text = nullptr;
    for (const FunctionText &candidate : m_scan.functions()) {
        // Functions with the same name differ by their lines.
        if (candidate.name == function->GetName() &&
            function->FindNextLineWithCode(m_scan.lineOf(candidate.extent.begin)) >= 0)
            text = &candidate;
    }
    std::map<std::string, std::size_t> seen; // declarations of each name so far
    for (asUINT i = 0; i < function->GetVarCount(); ++i) {
        const char *name = nullptr;
        function->GetVar(i, &name, nullptr);
        Extent scope;
        if (text && name && *name) {
            std::size_t number = seen[name]++;
            for (const Declaration &declaration : text->declarations) {
                if (declaration.name == name && number-- == 0) {
                    scope = declaration.scope;
                    break;
                }
            }
        }
        scopes.push_back(scope);
    }
    return scopes;
}

std::vector<Variable> Interpreter::variables() const
{
    std::vector<Variable> all;
    asIScriptFunction *function = m_isInitialising ? nullptr : m_context->GetFunction(0);
    int column = 0;
    const int line = function ? m_context->GetLineNumber(0, &column) : 0;
    const std::size_t at = m_scan.offsetOf(line, column);
    const int count = function ? m_context->GetVarCount(0) : 0;
    for (int i = 0; i < count; ++i) {
        const char *name = m_context->GetVarName(static_cast<asUINT>(i), 0);
        const Scopes &scopes = scopesOf(function);
        const auto index = static_cast<std::size_t>(i);
        if (!name || !*name || index >= scopes.size() || !scopes[index].contains(at) ||
            !m_context->IsVarInScope(static_cast<asUINT>(i), 0))
            continue;
        const std::optional<Value> value = valueAt(m_context->GetAddressOfVar(static_cast<asUINT>(i), 0),
                                                   m_context->GetVarTypeId(static_cast<asUINT>(i), 0));
        if (value)
            all.push_back({name, *value, false});
    }
    for (const Global &global : m_globals) {
        if (const std::optional<Value> value = valueAt(addressOf(global), global.type))
            all.push_back({global.name, *value, true});
    }
    return all;
}

double Interpreter::random(int i) const
{
    return sim::uniform(m_seed, static_cast<std::uint64_t>(m_frameNumber),
                        static_cast<std::uint64_t>(static_cast<std::int64_t>(i)));
}

double Interpreter::randomInFrame(int i, int frame) const
{
    return sim::uniform(m_seed, static_cast<std::uint64_t>(static_cast<std::int64_t>(frame)),
                        static_cast<std::uint64_t>(static_cast<std::int64_t>(i)));
}

bool Interpreter::isSameBody(const BodyCell *a, const BodyCell *b)
{
    return a == b;
}

bool Interpreter::isSameCreature(const CreatureCell *a, const CreatureCell *b)
{
    return a == b;
}

Interpreter::BodyCell *Interpreter::bodyAt(int index, BodyArray *array)
{
    return cellAt(index, array->cells, array->name);
}

Interpreter::CreatureCell *Interpreter::creatureAt(int index, CreatureArray *array)
{
    return cellAt(index, array->cells, "creatures");
}

Interpreter::BodyCell *Interpreter::bodyOf(CreatureCell *creature)
{
    return &creature->body;
}

Interpreter::BodyCell *Interpreter::childAt(int index, ChildArray *array)
{
    if (index >= 0 && index < array->count)
        return array->first + index;
    raiseNoElement(index, array->count, "children");
    return nullptr;
}

Interpreter::StickCell *Interpreter::stickAt(int index, StickArray *array)
{
    return cellAt(index, array->cells, "sticks");
}

Vec2 Interpreter::targetAt(int index, const TargetArray *array)
{
    if (index >= 0 && index < array->count)
        return array->all[static_cast<std::size_t>(index)];
    raiseNoElement(index, array->count, "new_targets");
    return {};
}

Vec2 Interpreter::directionOfBranch(const BodyCell *branch) const
{
    return isBody(branch) ? sim::branchReach(branch->angle, 1.0, m_degrees) : Vec2();
}

Vec2 Interpreter::directionBetween(const BodyCell *from, const BodyCell *to)
{
    if (!isBody(from) || !isBody(to))
        return {};
    return directionOf(from->position, to->position, from->point, to->point);
}

Vec2 Interpreter::directionToPlace(const BodyCell *from, const VectorCell &to)
{
    return isBody(from) ? directionOf(from->position, read(to), from->point, placeIndex) : Vec2();
}

Vec2 Interpreter::directionOfPlaces(const VectorCell &from, const VectorCell &to, const BodyCell *owner)
{
    return isBody(owner) ? directionOf(read(from), read(to), placeIndex, owner->point) : Vec2();
}

}
