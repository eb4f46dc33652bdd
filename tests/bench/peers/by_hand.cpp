#include "tests/bench/peers/by_hand.h"

#include "tests/bench/peers/plain_crowd.h"
#include "tests/bench/scenes/limit_creatures.h"
#include "tests/bench/scenes/tree_scenes.h"

#include "sim/base/random.h"

#include <algorithm>

namespace bench::by_hand {

namespace {

class Creatures : public crowd::Runner
{
public:
    Creatures(const sim::Scene &scene, int creatures)
        : m_start(std::size_t(creatures + 3) / 4), m_now(m_start.size())
    {
        for (int creature = 0; creature < 4 * static_cast<int>(m_start.size()); ++creature) {
            for (int foot = -1; foot < crowd::feet; ++foot) {
                // the last group is filled with copies of the last creature
                const int as = std::min(creature, creatures - 1);
                const sim::Vec2 at = scene.start.positionOf(crowd::pointOf(creatures, as, foot));
                FourCreatures::Point &point = m_start[std::size_t(creature) / 4].points[foot + 1];
                point.x[creature % 4] = at.x;
                point.y[creature % 4] = at.y;
            }
        }
        m_now = m_start;
    }

    void restart() override { m_now = m_start; }
    void frame() override { limitFrame(m_now.data(), m_now.size()); }
    sim::Vec2 at(int creature, int foot) const override
    {
        const FourCreatures::Point &point = m_now[std::size_t(creature) / 4].points[foot + 1];
        return {point.x[creature % 4], point.y[creature % 4]};
    }

private:
    std::vector<FourCreatures> m_start;
    std::vector<FourCreatures> m_now;
};

class CreaturesInAir : public crowd::Runner
{
public:
    CreaturesInAir(const sim::Scene &scene, int creatures)
        : m_start(scene.start.position), m_count(scene.start.pointCount()), m_memory(std::size_t(6 * m_count))
    {
        const auto array = [&](int which) { return m_memory.data() + which * m_count; };
        m_arrays = {creatures, array(0), array(1), array(2), array(3), array(4), array(5)};
        CreaturesInAir::restart();
    }

    void restart() override
    {
        std::copy_n(m_start.data(), 2 * m_count, m_memory.begin());
        std::fill(m_memory.begin() + 2 * m_count, m_memory.end(), 0.0);
    }
    void frame() override { plainFrame(m_arrays); }
    sim::Vec2 at(int creature, int foot) const override
    {
        const int point = crowd::pointOf(m_arrays.creatures, creature, foot);
        return {m_arrays.x[point], m_arrays.y[point]};
    }

private:
    Eigen::ArrayX2d m_start;
    int m_count;
    std::vector<double> m_memory; ///< x, y, vx, vy, ax, ay
    CrowdArrays m_arrays;
};

}

std::string missing()
{
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? "" : "needs AVX2 and FMA";
}

std::unique_ptr<crowd::Runner> creatures(const sim::Scene &scene, int creatures)
{
    return std::make_unique<Creatures>(scene, creatures);
}

std::unique_ptr<crowd::Runner> creaturesInAir(const sim::Scene &scene, int creatures)
{
    return std::make_unique<CreaturesInAir>(scene, creatures);
}

Cloth::Cloth(const sim::Scene &scene, int side, const ClothNumbers &numbers)
    : m_memory(std::size_t(4 * (side * side + 4) + 8 * (side + 8))), m_numbers(numbers)
{
    const int points = side * side;
    const auto array = [&](int which) { return m_memory.data() + which * (points + 4); };
    m_arrays = {side, array(0), array(1), array(2), array(3), array(4)};
    std::copy_n(scene.start.position.data(), points, m_arrays.x);
    std::copy_n(scene.start.position.data() + points, points, m_arrays.y);
}

Tree::Tree(int forks)
{
    const sim::TreePtr tree = trees::full(forks);
    const std::size_t room = tree->rest.size() + 4;
    m_memory.resize(5 * room);
    const auto array = [&](std::size_t which) { return m_memory.data() + which * room; };
    std::copy(tree->rest.begin(), tree->rest.end(), array(0));
    std::copy(tree->scale.begin(), tree->scale.end(), array(1));
    std::copy(tree->rest.begin(), tree->rest.end(), array(2));
    m_arrays = {tree->branchCount(), array(0), array(1), array(2), array(3), array(4)};
    m_arrays.x[0] = trees::foot.x;
    m_arrays.y[0] = trees::foot.y;
    m_numbers = {tree->baseLength, trees::ease, trees::wind, trees::pointer.x, trees::pointer.y, 0.0};
}

void Tree::frame(std::int64_t number)
{
    m_numbers.gust = trees::turbulence * (2.0 * sim::uniform(trees::seed, number, 0) - 1.0);
    limitFrame(m_arrays, m_numbers);
}

}
