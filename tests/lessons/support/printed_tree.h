#pragma once

#include "sim/run/script/script.h"

#include <memory>
#include <string>
#include <vector>

namespace support {

/// The tutorial's tree, transcribed from the printed code with its recursion. It shares no code with sim's
/// tree and serves as the reference for the lesson. `Stage` selects one of the printed stages.
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

    struct BranchPose
    {
        double x = 0.0, y = 0.0; ///< px, origin of the branch
        double angle = 0.0;      ///< degrees
    };

    PrintedTree(Stage stage, const Numbers &numbers);
    ~PrintedTree();

    /// Sets the mouse and its button from the next frame on.
    void mouse(double x, double y, bool down);
    /// Computes one frame. `gust` replaces the random turbulence, in degrees, unless it is null.
    void enterFrame(const double *gust);
    /// Returns all branches in breadth-first order, left before right.
    std::vector<BranchPose> branchPoses() const;

private:
    struct Branch;
    double random(std::int64_t frame, std::int64_t index) const;

    Stage m_stage;
    Numbers m_numbers;
    std::unique_ptr<Branch> m_trunk;
    double m_mouseX = 0.0, m_mouseY = 0.0;
    bool m_down = false;
    std::int64_t m_frame = 0;
};

}
