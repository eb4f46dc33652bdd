#pragma once

#include "tests/bench/scenes/crowd_runs.h"
#include "tests/bench/scenes/limit_cloth.h"
#include "tests/bench/scenes/limit_tree.h"

/// Our fastest hand-written code for the scenes that the pipeline runs.
namespace bench::by_hand {

/// Returns why this machine cannot run them; empty if it can.
std::string missing();

/// Return the code of limit_creatures.h and plain_crowd.h, set up from a scene of crowd.h.
std::unique_ptr<crowd::Runner> creatures(const sim::Scene &scene, int creatures);
std::unique_ptr<crowd::Runner> creaturesInAir(const sim::Scene &scene, int creatures);

/// The code of limit_cloth.h, set up from a scene of sim/scenes/cloth.h.
class Cloth
{
public:
    Cloth(const sim::Scene &scene, int side, const ClothNumbers &numbers);
    void frame() { limitFrame(m_arrays, m_numbers); }
    sim::Vec2 at(int point) const { return {m_arrays.x[point], m_arrays.y[point]}; }

private:
    std::vector<double> m_memory;
    ClothArrays m_arrays;
    ClothNumbers m_numbers;
};

/// The code of limit_tree.h, set up from a scene of tree_scenes.h.
class Tree
{
public:
    explicit Tree(int forks);
    void frame(std::int64_t number);
    sim::Vec2 at(int branch) const { return {m_arrays.x[branch], m_arrays.y[branch]}; }

private:
    std::vector<double> m_memory;
    TreeArrays m_arrays;
    TreeNumbers m_numbers;
};

}
