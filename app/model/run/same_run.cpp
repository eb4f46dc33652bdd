#include "app/model/run/same_run.h"

#include "app/model/run/run_program.h"
#include "sim/pipeline/method.h"

namespace app {

namespace {

const std::string &textOf(const sim::MethodPtr &method)
{
    static const std::string none;
    const std::shared_ptr<const listing::Program> program = programOf(method);
    return program ? program->text() : none;
}

}

bool sameMethod(const sim::MethodPtr &a, const sim::MethodPtr &b)
{
    // By id, because each search for a method creates a new object.
    return a == b || (a && b && a->id() == b->id() && textOf(a) == textOf(b));
}

bool sameRun(const sim::Script &a, const sim::Script &b)
{
    return sameMethod(a.method, b.method) && a.step == b.step && sameButForInput(a, b);
}

bool sameButForInput(const sim::Script &a, const sim::Script &b)
{
    return a.values == b.values && a.bodies == b.bodies && a.effectsOff == b.effectsOff;
}

bool sameRule(const sim::Script &a, const sim::Script &b)
{
    static const sim::BlueprintRule none;
    const auto ruleOf = [](const sim::Script &script) -> const sim::BlueprintRule & {
        return script.values.blueprint ? script.values.blueprint->rule : none;
    };
    return ruleOf(a) == ruleOf(b);
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
