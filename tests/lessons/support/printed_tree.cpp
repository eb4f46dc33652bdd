#include "tests/lessons/support/printed_tree.h"

#include "sim/base/random.h"

#include <cmath>

namespace support {

struct PrintedTree::Branch
{
    const PrintedTree &tree;
    double x, y, scale, angle, restAngle;
    double endX = 0.0, endY = 0.0, globalEndX = 0.0, globalEndY = 0.0;
    std::vector<std::unique_ptr<Branch>> children;

    /// `number` counts in breadth-first order. A branch has two children or none, so n has 2n + 1 and 2n + 2.
    Branch(const PrintedTree &owner, double initialAngle, double initialScale, double originX, double originY,
           std::int64_t number)
        : tree(owner), x(originX), y(originY), scale(initialScale), angle(initialAngle),
          restAngle(initialAngle)
    {
        const Numbers &numbers = tree.m_numbers;
        getEndPoint();
        localToGlobal();
        if (scale * numbers.slope > numbers.minScale) {
            const double left = angle - numbers.spread + randomJitter(2 * number + 1);
            const double right = angle + numbers.spread + randomJitter(2 * number + 2);
            for (const auto &[childAngle, child] : {std::pair{left, 2 * number + 1}, {right, 2 * number + 2}})
                children.push_back(std::make_unique<Branch>(tree, childAngle, scale * numbers.slope,
                                                            globalEndX, globalEndY, child));
        }
    }

    double randomJitter(std::int64_t number) const
    {
        const double jitter = tree.m_numbers.jitter;
        return tree.random(0, number) * 2 * jitter - jitter;
    }

    void getEndPoint()
    {
        endX = tree.m_numbers.baseLength * std::cos(angle / 57.3);
        endY = tree.m_numbers.baseLength * std::sin(angle / 57.3);
    }

    void localToGlobal()
    {
        globalEndX = x + scale * endX;
        globalEndY = y + scale * endY;
    }

    double strength(double distX, double distY) const
    {
        const double distance = std::sqrt(distX * distX + distY * distY);
        switch (tree.m_stage) {
        case Stage::wind:
        case Stage::rest:
            return tree.m_numbers.ease;
        case Stage::distance:
            return distance;
        default:
            return distance * scale * scale / tree.m_numbers.wind;
        }
    }

    void bend(double turbulence)
    {
        const double distX = (tree.m_mouseX - x) / scale + endX;
        const double distY = (tree.m_mouseY - y) / scale + endY;
        if (tree.m_stage == Stage::towardsPointer) {
            angle = std::atan2(distY, distX) * 57.3;
        } else {
            double windAngle = std::atan2(distY, distX) * 57.3 - 180;
            windAngle += turbulence;
            if (windAngle - angle < -180)
                windAngle += 360;
            else if (windAngle - angle > 360)
                windAngle -= 360;
            if (std::abs(windAngle - angle) > 1)
                angle += (windAngle - angle) / strength(distX, distY);
        }
        getEndPoint();
        localToGlobal();
        for (const auto &child : children) {
            child->x = globalEndX;
            child->y = globalEndY;
            child->bend(turbulence);
        }
    }

    void returnToRest()
    {
        if (std::abs(restAngle - angle) > 1)
            angle += (restAngle - angle) / tree.m_numbers.ease;
        getEndPoint();
        localToGlobal();
        for (const auto &child : children) {
            child->x = globalEndX;
            child->y = globalEndY;
            child->returnToRest();
        }
    }
};

PrintedTree::PrintedTree(Stage stage, const Numbers &numbers) : m_stage(stage), m_numbers(numbers)
{
    m_trunk = std::make_unique<Branch>(*this, -90, 1, 275, 400, 0);
}

PrintedTree::~PrintedTree() = default;

double PrintedTree::random(std::int64_t frame, std::int64_t index) const
{
    return sim::uniform(m_numbers.seed, frame, index);
}

void PrintedTree::mouse(double x, double y, bool down)
{
    m_mouseX = x;
    m_mouseY = y;
    m_down = down;
}

void PrintedTree::enterFrame(const double *gust)
{
    ++m_frame;
    if (m_stage >= Stage::rest)
        m_trunk->returnToRest();
    if (!m_down || m_stage == Stage::still)
        return;
    double turbulence = 0.0;
    if (m_stage == Stage::turbulence)
        turbulence = gust ? *gust : random(m_frame, 0) * 2 * m_numbers.turbulence - m_numbers.turbulence;
    m_trunk->bend(turbulence);
}

std::vector<PrintedTree::BranchPose> PrintedTree::branchPoses() const
{
    std::vector<const Branch *> queue = {m_trunk.get()};
    std::vector<BranchPose> poses;
    for (std::size_t i = 0; i < queue.size(); ++i) {
        poses.push_back({queue[i]->x, queue[i]->y, queue[i]->angle});
        for (const auto &child : queue[i]->children)
            queue.push_back(child.get());
    }
    return poses;
}

}
