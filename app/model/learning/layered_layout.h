#pragma once

#include <cstddef>
#include <vector>

namespace app {

/// A layered drawing of an acyclic graph: each node is in a row below its predecessors. No edge passes through
/// a node. The unit of x is the distance between two nodes side by side.
struct LayeredLayout
{
    struct Place
    {
        int row = 0;
        double x = 0.0; ///< of the centre, from 0 to LayeredLayout::width
    };
    struct Edge
    {
        std::size_t from = 0; ///< a node
        std::size_t to = 0;   ///< the node below it that rests on it
        std::vector<Place> between =
            {}; ///< where the edge passes the rows between the two, from top to bottom
    };
    static constexpr double passing = 0.54;   ///< least distance between a node and an edge that passes it
    static constexpr double alongside = 0.06; ///< least distance between edges of two nodes that pass a row

    std::vector<Place> nodes;
    std::vector<Edge> edges; ///< transitive reduction: no edge a - c if there are a - b and b - c
    int rows = 0;
    double width = 0.0;
};

/// Lays a graph out with at most `mostInRow` nodes in a row. restsOn[i] has indices smaller than i.
LayeredLayout layeredLayout(const std::vector<std::vector<std::size_t>> &restsOn, int mostInRow);

}
