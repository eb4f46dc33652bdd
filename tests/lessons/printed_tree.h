#pragma once

#include "sim/run/script/script.h"

#include <memory>
#include <string>
#include <vector>

namespace support {

/// The tutorial's tree, written down a second time straight from the printed code, recursion and all, with nothing of
/// sim's tree in it: the yardstick for the lesson. Which of its printed stages runs is a matter of `stage`.
class PrintedTree
{
public:
    enum class Stage { still, towardsPointer, wind, rest, distance, thickness, turbulence };

    struct Numbers
    {
        double spread = 30.0, jitter = 0.0, slope = 0.8, minScale = 0.2, baseLength = 100.0;
        double ease = 8.0, wind = 5.0, turbulence = 20.0;
        std::uint64_t seed = 1;
    };

    struct Row
    {
        double x = 0.0, y = 0.0, angle = 0.0;
    };

    PrintedTree(Stage stage, const Numbers &numbers);
    ~PrintedTree();

    /// The mouse and its button from the next frame on.
    void mouse(double x, double y, bool down);
    /// Computes one frame. `gust`: its turbulence in degrees, in place of the random one.
    void enterFrame(const double *gust);
    /// All branches, breadth first, the left one first.
    std::vector<Row> rows() const;

private:
    struct Branch;
    double random(std::uint64_t frame, std::uint64_t index) const;

    Stage m_stage;
    Numbers m_numbers;
    std::unique_ptr<Branch> m_trunk;
    double m_mouseX = 0.0, m_mouseY = 0.0;
    bool m_down = false;
    std::uint64_t m_frame = 0;
};

}
