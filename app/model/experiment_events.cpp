#include "app/model/experiment_events.h"

namespace app {

namespace {

const std::vector<EventKind> &allKinds()
{
    using lessons::Does;
    static const auto x = QStringLiteral("x");
    static const auto y = QStringLiteral("y");
    static const std::vector<EventKind> kinds = {
        {QStringLiteral("grab"), {QStringLiteral("body")}, {}, Does::hand},
        {QStringLiteral("move"), {x, y}, {}, Does::hand},
        {QStringLiteral("release"), {}, {}, Does::hand},
        {QStringLiteral("pointer"), {x, y}, {QStringLiteral("down")}, Does::pointer},
        {QStringLiteral("target"), {x, y}, {}, Does::target},
        {QStringLiteral("gust"), {QStringLiteral("degrees")}, {}, Does::gust},
        {QStringLiteral("key"), {QStringLiteral("key"), QStringLiteral("down")}, {}, Does::keys},
        {QStringLiteral("set"), {QStringLiteral("parameter"), QStringLiteral("value")}, {}, {}},
    };
    return kinds;
}

}

std::vector<EventKind> eventKindsOf(const lessons::Step &step)
{
    std::vector<EventKind> known;
    for (const EventKind &kind : allKinds()) {
        if (!kind.does || step.can(*kind.does))
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
