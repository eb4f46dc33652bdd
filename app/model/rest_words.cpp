#include "app/model/rest_words.h"

#include "app/model/sentences.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/sleeping/sleep_blocker.h"

#include <QCoreApplication>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(RestWords)
};

}

QString restSentence(const sim::Track &track)
{
    if (track.sleep())
        return Text::tr("Everything rests: a frame costs nothing until something is touched.");
    const sim::SleepBlocker awake = sim::sleepBlockerOf(track.interval().pipeline, track.state());
    switch (awake.reason) {
    case sim::SleepBlocker::Reason::time:
        return Text::tr("Nothing rests now: “%1” changes with the time.").arg(phrase(awake.effect->title()));
    case sim::SleepBlocker::Reason::adaptiveSteps:
        return Text::tr("With a method that chooses its own steps, what rests costs as much as what moves.");
    case sim::SleepBlocker::Reason::nothing:
        break;
    }
    return Text::tr("What comes to rest costs nothing until it is touched.");
}

}
