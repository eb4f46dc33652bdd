#include "tests/sim/support/energy_support.h"

#include "tests/sim/support/support.h"

#include "sim/analysis/energy/ledger.h"
#include "sim/methods/methods.h"

#include <QTest>

using namespace sim;

namespace energy_support {

LedgerTotals totalsOf(const Script &script, int frames)
{
    Track track(script, Timeline::defaultBudget);
    track.seek({frames, 0});
    Ledger ledger;
    LedgerTotals totals;
    for (std::int64_t frame = track.framesPerOutput(); frame <= frames; frame += track.framesPerOutput()) {
        const Balance step = ledger.balanceAt(track, frame).value();
        if (frame == track.framesPerOutput())
            totals.balance.before = step.before;
        totals.balance.append(step);
        totals.absoluteDrift += std::abs(step.energy[Account::drift]);
    }
    return totals;
}

Balance balanceOf(const Script &script, int frames)
{
    return totalsOf(script, frames).balance;
}

Script scriptOf(const Scene &scene, const std::string &method, double h)
{
    Script script = support::script(scene, method);
    script.step = support::stepFor(*findMethod(method), h);
    return script;
}

void addMethodRows(bool (*wanted)(const Method &))
{
    QTest::addColumn<QString>("method");
    for (const MethodPtr &method : allMethods()) {
        if (wanted(*method))
            QTest::newRow(method->id().c_str()) << QString::fromStdString(method->id());
    }
}

bool anyMethod(const Method &)
{
    return true;
}

}
