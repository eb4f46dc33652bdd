#include "app/model/run/same_run.h"

#include "sim/pipeline/method.h"

#include <algorithm>
#include <limits>

namespace app {

namespace {

/// Compares ids, because each search for a method creates a new object.
bool sameMethod(const sim::MethodPtr &a, const sim::MethodPtr &b)
{
    return a == b || (a && b && a->id() == b->id());
}

}

bool sameRun(const sim::Script &a, const sim::Script &b)
{
    return sameMethod(a.method, b.method) && a.step == b.step && a.values == b.values &&
           a.bodies == b.bodies && a.effectsOff == b.effectsOff;
}

bool sameScript(const sim::Script &a, const sim::Script &b)
{
    return sameRun(a, b) && a.input == b.input;
}

sim::Script withoutInput(const sim::Script &script)
{
    sim::Script plain;
    plain.values = script.values;
    plain.bodies = script.bodies;
    plain.effectsOff = script.effectsOff;
    plain.method = script.method;
    plain.step = script.step;
    return plain;
}

}
