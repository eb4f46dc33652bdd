#include "sim/scenes/links.h"

namespace scenes {

namespace {

void join(std::vector<sim::Link> &links, int a, int b)
{
    links.push_back({a, b});
    links.push_back({b, a});
}

}

std::vector<sim::Link> legs(int feet)
{
    std::vector<sim::Link> links;
    for (int i = 0; i < feet; ++i)
        links.push_back({i, feet});
    for (int i = 0; i < feet; ++i)
        links.push_back({feet, i});
    return links;
}

std::vector<sim::Link> legsByParts(int creatures, int feet)
{
    std::vector<sim::Link> links;
    for (int foot = creatures; foot < creatures * (feet + 1); ++foot)
        join(links, foot, foot % creatures);
    return links;
}

std::vector<sim::Link> chainLinks(int points)
{
    std::vector<sim::Link> links;
    for (int i = 0; i + 1 < points; ++i)
        join(links, i, i + 1);
    return links;
}

std::vector<sim::Link> gridLinks(int side)
{
    std::vector<sim::Link> links;
    for (int i = 0; i < side * side; ++i) {
        if (i % side + 1 < side)
            join(links, i, i + 1);
        if (i + side < side * side)
            join(links, i, i + side);
    }
    return links;
}

}
