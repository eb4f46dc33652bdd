#include "app/model/same_run.h"

namespace app {

bool sameRun(const sim::Script &a, const sim::Script &b)
{
    return a.method == b.method && a.step == b.step && a.values == b.values && a.bodies == b.bodies &&
           a.effectsOff == b.effectsOff;
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
