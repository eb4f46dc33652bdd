#include "app/cli/trace_rows.h"

#include "sim/run/script/composed_interval.h"

#include <charconv>

namespace app {

namespace {

/// Appends the shortest text that reads back as the same number, in any locale.
template <class Number>
void append(std::string &text, Number value)
{
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end);
}

}

const char *traceTitles(lessons::TraceColumns columns)
{
    switch (columns) {
    case lessons::TraceColumns::position:
        return "frame,body,x,y\n";
    case lessons::TraceColumns::positionAndAngle:
        return "frame,body,x,y,angle\n";
    case lessons::TraceColumns::positionAndVelocity:
        break;
    }
    return "frame,body,x,y,vx,vy\n";
}

void appendTraceRow(std::string &text, const sim::Track &track, lessons::TraceColumns columns)
{
    const sim::State &state = track.state();
    const auto cell = [&text](double value) {
        text += ',';
        append(text, value);
    };
    for (int point = 0; point < state.pointCount(); ++point) {
        append(text, track.cursor().frame);
        text += ',';
        text += track.interval().scene.names[static_cast<std::size_t>(point)];
        cell(state.positionOf(point).x);
        cell(state.positionOf(point).y);
        if (columns == lessons::TraceColumns::positionAndAngle)
            cell(state.angle[point]);
        if (columns == lessons::TraceColumns::positionAndVelocity) {
            cell(state.velocityOf(point).x);
            cell(state.velocityOf(point).y);
        }
        text += '\n';
    }
}

}
