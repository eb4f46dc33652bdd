#include "app/model/run/time_slice.h"

#include <QElapsedTimer>

#include <algorithm>

namespace app {

namespace {

constexpr qint64 sliceMilliseconds = 12;

}

bool goNearer(sim::Track &run, std::int64_t frame)
{
    QElapsedTimer clock;
    clock.start();
    const int framesPerOutput = run.framesPerOutput();
    run.seek({std::min(frame, run.computed()), 0});
    const auto isThere = [&] {
        return run.cursor().frame + framesPerOutput > frame ||
               (run.stop() && run.cursor().frame == run.stop()->frame);
    };
    while (!isThere() && clock.elapsed() < sliceMilliseconds)
        run.seek({run.isFinished() ? frame : run.cursor().frame + framesPerOutput, 0});
    return isThere();
}

}
