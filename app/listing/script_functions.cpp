#include "app/listing/script_functions.h"

#include "sim/base/vec2.h"

#include <angelscript.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace listing {

using namespace AngelScript;

namespace {

using sim::Vec2;

VectorCell &write(VectorCell &cell, Vec2 value)
{
    cell.x = value.x;
    cell.y = value.y;
    return cell;
}

// The operators of Vec2 in a listing are those of sim::Vec2, so that both give the same bits.
void makeVec2(VectorCell *made)
{
    write(*made, {});
}
void makeVec2From(double x, double y, VectorCell *made)
{
    write(*made, {x, y});
}
Vec2 plus(const VectorCell &a, const VectorCell &b)
{
    return read(a) + read(b);
}
Vec2 minus(const VectorCell &a, const VectorCell &b)
{
    return read(a) - read(b);
}
Vec2 timesNumber(const VectorCell &a, double s)
{
    return s * read(a);
}
Vec2 numberTimes(double s, const VectorCell &a)
{
    return s * read(a);
}
/// Stops the program as a division of two numbers does.
void requireDivisor(double s)
{
    if (s == 0)
        asGetActiveContext()->SetException("Divide by zero");
}
Vec2 divided(const VectorCell &a, double s)
{
    requireDivisor(s);
    return read(a) / s;
}
Vec2 negated(const VectorCell &a)
{
    return {-a.x, -a.y};
}
VectorCell &add(const VectorCell &b, VectorCell &a)
{
    return write(a, read(a) + read(b));
}
VectorCell &subtract(const VectorCell &b, VectorCell &a)
{
    return write(a, read(a) - read(b));
}
VectorCell &multiply(double s, VectorCell &a)
{
    return write(a, s * read(a));
}
VectorCell &divide(double s, VectorCell &a)
{
    requireDivisor(s);
    return write(a, read(a) / s);
}
bool equal(const VectorCell &a, const VectorCell &b)
{
    return read(a) == read(b);
}
double lengthOf(const VectorCell &a)
{
    return sim::length(read(a));
}
double dotOf(const VectorCell &a, const VectorCell &b)
{
    return sim::dot(read(a), read(b));
}

double absolute(double x)
{
    return std::abs(x);
}
double least(double a, double b)
{
    return b < a ? b : a;
}
double greatest(double a, double b)
{
    return a < b ? b : a;
}
// As std::clamp of the core computes it, which must not be called with an empty range: `high` wins then.
double clamped(double x, double low, double high)
{
    return least(greatest(x, low), high);
}

void registerVec2(asIScriptEngine &engine)
{
    engine.RegisterObjectType("Vec2", sizeof(Vec2),
                              static_cast<asDWORD>(asOBJ_VALUE | asOBJ_POD | asOBJ_APP_CLASS |
                                                   asOBJ_APP_CLASS_ALLFLOATS |
                                                   asOBJ_APP_CLASS_MORE_CONSTRUCTORS));
    engine.RegisterObjectProperty("Vec2", "double x", static_cast<int>(offsetof(Vec2, x)));
    engine.RegisterObjectProperty("Vec2", "double y", static_cast<int>(offsetof(Vec2, y)));
    engine.RegisterObjectBehaviour("Vec2", asBEHAVE_CONSTRUCT, "void f()", asFUNCTION(makeVec2),
                                   asCALL_CDECL_OBJLAST);
    engine.RegisterObjectBehaviour("Vec2", asBEHAVE_CONSTRUCT, "void f(double, double)",
                                   asFUNCTION(makeVec2From), asCALL_CDECL_OBJLAST);
    const auto method = [&engine](const char *declaration, const asSFuncPtr &function, asDWORD convention) {
        engine.RegisterObjectMethod("Vec2", declaration, function, convention);
    };
    method("Vec2 opAdd(const Vec2 &in) const", asFUNCTION(plus), asCALL_CDECL_OBJFIRST);
    method("Vec2 opSub(const Vec2 &in) const", asFUNCTION(minus), asCALL_CDECL_OBJFIRST);
    method("Vec2 opMul(double) const", asFUNCTION(timesNumber), asCALL_CDECL_OBJFIRST);
    method("Vec2 opMul_r(double) const", asFUNCTION(numberTimes), asCALL_CDECL_OBJLAST);
    method("Vec2 opDiv(double) const", asFUNCTION(divided), asCALL_CDECL_OBJFIRST);
    method("Vec2 opNeg() const", asFUNCTION(negated), asCALL_CDECL_OBJFIRST);
    method("Vec2 &opAddAssign(const Vec2 &in)", asFUNCTION(add), asCALL_CDECL_OBJLAST);
    method("Vec2 &opSubAssign(const Vec2 &in)", asFUNCTION(subtract), asCALL_CDECL_OBJLAST);
    method("Vec2 &opMulAssign(double)", asFUNCTION(multiply), asCALL_CDECL_OBJLAST);
    method("Vec2 &opDivAssign(double)", asFUNCTION(divide), asCALL_CDECL_OBJLAST);
    method("bool opEquals(const Vec2 &in) const", asFUNCTION(equal), asCALL_CDECL_OBJFIRST);
}

}

void registerFunctions(asIScriptEngine &engine, const std::vector<std::string> &parameters)
{
    registerVec2(engine);
    const auto function = [&engine](const char *declaration, const asSFuncPtr &pointer) {
        engine.RegisterGlobalFunction(declaration, pointer, asCALL_CDECL);
    };
    function("double length(const Vec2 &in)", asFUNCTION(lengthOf));
    function("double dot(const Vec2 &in, const Vec2 &in)", asFUNCTION(dotOf));
    function("double sqrt(double)", asFUNCTIONPR(std::sqrt, (double), double));
    function("double pow(double, double)", asFUNCTIONPR(std::pow, (double, double), double));
    function("double hypot(double, double)", asFUNCTIONPR(std::hypot, (double, double), double));
    function("double remainder(double, double)", asFUNCTIONPR(std::remainder, (double, double), double));
    if (std::find(parameters.begin(), parameters.end(), "floor") == parameters.end())
        function("double floor(double)", asFUNCTIONPR(std::floor, (double), double));
    function("double abs(double)", asFUNCTION(absolute));
    function("double min(double, double)", asFUNCTION(least));
    function("double max(double, double)", asFUNCTION(greatest));
    function("double clamp(double, double, double)", asFUNCTION(clamped));
}

}
