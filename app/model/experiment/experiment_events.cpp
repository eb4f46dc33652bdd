#include "app/model/experiment/experiment_events.h"

namespace app {

namespace {

const std::vector<EventKind> &allKinds()
{
    using lessons::Interaction;
    static const auto x = QStringLiteral("x");
    static const auto y = QStringLiteral("y");
    static const std::vector<EventKind> kinds = {
        {QStringLiteral("grab"), {QStringLiteral("body")}, {}, Interaction::drag},
        {QStringLiteral("move"), {x, y}, {}, Interaction::drag},
        {QStringLiteral("release"), {}, {}, Interaction::drag},
        {QStringLiteral("pointer"), {x, y}, {QStringLiteral("down")}, Interaction::pointer},
        {QStringLiteral("target"), {x, y}, {}, Interaction::target},
        {QStringLiteral("gust"), {QStringLiteral("degrees")}, {}, Interaction::gust},
        {QStringLiteral("key"), {QStringLiteral("key"), QStringLiteral("down")}, {}, Interaction::keys},
        {QStringLiteral("set"), {QStringLiteral("parameter"), QStringLiteral("value")}, {}, {}},
    };
    return kinds;
}

}

std::vector<EventKind> eventKindsOf(const lessons::Step &step)
{
    std::vector<EventKind> known;
    for (const EventKind &kind : allKinds()) {
        if (!kind.does || step.accepts(*kind.does))
            known.push_back(kind);
    }
    return known;
}

const std::vector<KeyName> &keyNames()
{
    static const std::vector<KeyName> names = {
        {QStringLiteral("left"), &sim::Keys::left},
        {QStringLiteral("right"), &sim::Keys::right},
        {QStringLiteral("up"), &sim::Keys::up},
        {QStringLiteral("down"), &sim::Keys::down},
    };
    return names;
}

}
