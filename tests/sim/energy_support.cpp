#include "energy_support.h"

#include "support.h"

#include "sim/analysis/energy/ledger.h"
#include "sim/methods/methods.h"

#include <QTest>

using namespace sim;

namespace energy_bench {

Run accounted(const Script &script, int frames)
{
    Track track(script, Timeline::defaultBudget);
    track.seek({frames, 0});
    Ledger ledger;
    Run run;
    for (std::int64_t frame = track.framesPerOutput(); frame <= frames; frame += track.framesPerOutput()) {
        const Balance row = ledger.row(track, frame).value();
        if (frame == track.framesPerOutput())
            run.sum.before = row.before;
        run.sum.append(row);
        run.drifted += std::abs(row.energy[Account::drift]);
    }
    return run;
}

Balance balanceOf(const Script &script, int frames)
{
    return accounted(script, frames).sum;
}

Script scriptOf(const Scene &scene, const std::string &method, double h)
{
    Script script = support::script(scene, method);
    script.step = support::stepFor(*findMethod(method), h);
    return script;
}

void addMethods(bool (*wanted)(const Method &))
{
    QTest::addColumn<QString>("method");
    for (const MethodPtr &method : allMethods()) {
        if (wanted(*method))
            QTest::newRow(method->id().c_str()) << QString::fromStdString(method->id());
    }
}

bool every(const Method &)
{
    return true;
}

}
