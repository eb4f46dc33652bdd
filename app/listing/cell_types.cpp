#include "app/listing/cell_values.h"
#include "app/listing/script_functions.h"
#include "sim/base/direction.h"

#include <angelscript.h>

#include <cstddef>

namespace listing {

using namespace AngelScript;

namespace {

using sim::Vec2;

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

/// Stands for a place in sim::direction(), as a place is not one of the points.
constexpr int placeIndex = -1;

Vec2 directionOf(Vec2 from, Vec2 to, int fromPoint, int toPoint)
{
    return sim::direction(to - from, fromPoint, toPoint).out;
}

bool isSameBody(const BodyCell *a, const BodyCell *b)
{
    return a == b;
}

bool isSameCreature(const CreatureCell *a, const CreatureCell *b)
{
    return a == b;
}

BodyCell *bodyAt(int index, BodyArray *array)
{
    return cellAt(index, array->cells, array->name);
}

CreatureCell *creatureAt(int index, CreatureArray *array)
{
    return cellAt(index, array->cells, "creatures");
}

BodyCell *bodyOf(CreatureCell *creature)
{
    return &creature->body;
}

BodyCell *childAt(int index, ChildArray *array)
{
    if (index >= 0 && index < array->count)
        return array->first + index;
    raiseNoElement(index, array->count, "children");
    return nullptr;
}

StickCell *stickAt(int index, StickArray *array)
{
    return cellAt(index, array->cells, "sticks");
}

Vec2 targetAt(int index, const TargetArray *array)
{
    if (index >= 0 && index < array->count)
        return array->all[static_cast<std::size_t>(index)];
    raiseNoElement(index, array->count, "new_targets");
    return {};
}

Vec2 directionBetween(const BodyCell *from, const BodyCell *to)
{
    if (!standsForBody(from) || !standsForBody(to))
        return {};
    return directionOf(from->position, to->position, from->point, to->point);
}

Vec2 directionToPlace(const BodyCell *from, const VectorCell &to)
{
    return standsForBody(from) ? directionOf(from->position, read(to), from->point, placeIndex) : Vec2();
}

Vec2 directionOfPlaces(const VectorCell &from, const VectorCell &to, const BodyCell *owner)
{
    return standsForBody(owner) ? directionOf(read(from), read(to), placeIndex, owner->point) : Vec2();
}

/// Returns a function that registers a property of `type`: its declaration and its offset.
auto propertiesOf(asIScriptEngine &engine, const char *type)
{
    return [&engine, type](const char *declaration, std::size_t offset) {
        engine.RegisterObjectProperty(type, declaration, static_cast<int>(offset));
    };
}

template <class Array>
void registerArray(asIScriptEngine &engine, const char *type, const char *element, const asSFuncPtr &at)
{
    engine.RegisterObjectType(type, 0, asOBJ_REF | asOBJ_NOHANDLE);
    propertiesOf(engine, type)("const int count", offsetof(Array, count));
    engine.RegisterObjectMethod(type, element, at, asCALL_CDECL_OBJLAST);
}

void registerBodies(asIScriptEngine &engine, const Vocabulary &vocabulary, BodyAccess access)
{
    // Variables of this type are references, so `Body foot = feet[i]` names the same body and copies nothing.
    engine.RegisterObjectType("Body", 0, asOBJ_REF | asOBJ_NOCOUNT | asOBJ_IMPLICIT_HANDLE);
    const auto property = propertiesOf(engine, "Body");
    const bool isWritable = access == BodyAccess::write;
    property(isWritable ? "Vec2 position" : "const Vec2 position", offsetof(BodyCell, position));
    property(isWritable ? "Vec2 velocity" : "const Vec2 velocity", offsetof(BodyCell, velocity));
    property("const Vec2 before", offsetof(BodyCell, before));
    property("const bool held", offsetof(BodyCell, held));
    property("const double mass", offsetof(BodyCell, mass));
    property("const double radius", offsetof(BodyCell, radius));
    if (vocabulary.bodiesTurn) {
        property("double angle", offsetof(BodyCell, angle));
        property("double spin", offsetof(BodyCell, spin));
    }
    engine.RegisterObjectMethod("Body", "bool opEquals(const Body @) const", asFUNCTION(isSameBody),
                                asCALL_CDECL_OBJFIRST);
    registerArray<BodyArray>(engine, "Bodies", "Body @opIndex(int)", asFUNCTION(bodyAt));
}

void registerCreatures(asIScriptEngine &engine, bool hasGait)
{
    engine.RegisterObjectType("Creature", 0, asOBJ_REF | asOBJ_NOCOUNT | asOBJ_IMPLICIT_HANDLE);
    const auto property = propertiesOf(engine, "Creature");
    engine.RegisterObjectMethod("Creature", "Body @get_body() property", asFUNCTION(bodyOf),
                                asCALL_CDECL_OBJLAST);
    property("Bodies feet", offsetof(CreatureCell, feet));
    if (hasGait) {
        property("double gait", offsetof(CreatureCell, gait));
        property("double gait_speed", offsetof(CreatureCell, gaitSpeed));
    }
    engine.RegisterObjectMethod("Creature", "bool opEquals(const Creature @) const",
                                asFUNCTION(isSameCreature), asCALL_CDECL_OBJFIRST);
    registerArray<CreatureArray>(engine, "Creatures", "Creature @opIndex(int)", asFUNCTION(creatureAt));
}

void registerBranches(asIScriptEngine &engine)
{
    registerArray<ChildArray>(engine, "Children", "Body @opIndex(int)", asFUNCTION(childAt));
    const auto property = propertiesOf(engine, "Body");
    property("const int number", offsetof(BodyCell, number));
    property("const double rest", offsetof(BodyCell, rest));
    property("const double scale", offsetof(BodyCell, scale));
    property("const double length", offsetof(BodyCell, length));
    property("const double inertia", offsetof(BodyCell, inertia));
    property("Children children", offsetof(BodyCell, children));
}

void registerSticks(asIScriptEngine &engine)
{
    engine.RegisterObjectType("Stick", 0, asOBJ_REF | asOBJ_NOCOUNT | asOBJ_IMPLICIT_HANDLE);
    const auto property = propertiesOf(engine, "Stick");
    property("Body @const a", offsetof(StickCell, a));
    property("Body @const b", offsetof(StickCell, b));
    property("const double length", offsetof(StickCell, length));
    property("const double share", offsetof(StickCell, share));
    registerArray<StickArray>(engine, "Sticks", "Stick @opIndex(int)", asFUNCTION(stickAt));
}

void registerInput(asIScriptEngine &engine)
{
    registerArray<TargetArray>(engine, "Targets", "Vec2 opIndex(int) const", asFUNCTION(targetAt));
    engine.RegisterObjectType("Keys", 0, asOBJ_REF | asOBJ_NOHANDLE);
    const auto key = propertiesOf(engine, "Keys");
    key("const bool left", offsetof(KeyCell, left));
    key("const bool right", offsetof(KeyCell, right));
    key("const bool up", offsetof(KeyCell, up));
    key("const bool down", offsetof(KeyCell, down));
}

void registerDirections(asIScriptEngine &engine)
{
    const auto direction = [&engine](const char *declaration, const asSFuncPtr &function) {
        engine.RegisterGlobalFunction(declaration, function, asCALL_CDECL);
    };
    direction("Vec2 direction(const Body @, const Body @)", asFUNCTION(directionBetween));
    direction("Vec2 direction(const Body @, const Vec2 &in)", asFUNCTION(directionToPlace));
    direction("Vec2 direction(const Vec2 &in, const Vec2 &in, const Body @)", asFUNCTION(directionOfPlaces));
}

}

bool standsForBody(const void *cell)
{
    if (!cell)
        asGetActiveContext()->SetException("Null pointer access");
    return cell != nullptr;
}

CellTypes registerCellTypes(asIScriptEngine &engine, const Vocabulary &vocabulary, BodyAccess access)
{
    registerBodies(engine, vocabulary, access);
    if (vocabulary.hasTree)
        registerBranches(engine);
    if (vocabulary.hasCreatures)
        registerCreatures(engine, vocabulary.hasGait);
    if (vocabulary.hasSticks)
        registerSticks(engine);
    registerInput(engine);
    registerDirections(engine);
    const auto numberOf = [&engine](const char *type) {
        return engine.GetTypeIdByDecl(type) & asTYPEID_MASK_SEQNBR;
    };
    CellTypes types;
    types.vec2 = engine.GetTypeIdByDecl("Vec2");
    types.body = numberOf("Body");
    if (vocabulary.hasCreatures)
        types.creature = numberOf("Creature");
    if (vocabulary.hasSticks)
        types.stick = numberOf("Stick");
    return types;
}

}
