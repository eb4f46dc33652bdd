#include "app/model/text/rest_text.h"

#include "app/model/text/sentences.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/sleeping/sleep_blocker.h"

#include <QCoreApplication>

namespace app {

namespace {

struct RestText
{
    Q_DECLARE_TR_FUNCTIONS(RestText)
};

}

QString restSentence(const sim::Track &track)
{
    if (track.sleep())
        return RestText::tr("Everything is at rest: a frame costs nothing until you touch something.");
    const sim::SleepBlocker awake = sim::sleepBlockerOf(track.interval().pipeline, track.state());
    switch (awake.reason) {
    case sim::SleepBlocker::Reason::time:
        return RestText::tr("Nothing can rest now, because “%1” changes over time.")
            .arg(phrase(awake.effect->title()));
    case sim::SleepBlocker::Reason::adaptiveSteps:
        return RestText::tr(
            "With a method that chooses its own steps, bodies at rest cost as much as moving ones.");
    case sim::SleepBlocker::Reason::nothing:
        break;
    }
    return RestText::tr("Bodies at rest cost nothing until you touch them.");
}

}
