#include "app/model/slices.h"

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
    const int rowFrames = run.rowFrames();
    run.seek({std::min(frame, run.computed()), 0});
    const auto isThere = [&] {
        return run.at().frame + rowFrames > frame || (run.stop() && run.at().frame == run.stop()->frame);
    };
    while (!isThere() && clock.elapsed() < sliceMilliseconds)
        run.seek({run.isOver() ? frame : run.at().frame + rowFrames, 0});
    return isThere();
}

}
