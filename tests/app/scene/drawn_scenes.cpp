#include "tests/app/scene/drawn_scenes.h"

#include "lessons/api/view/view.h"
#include "sim/scene/scene.h"

#include <cmath>
#include <numbers>

namespace drawn_scenes {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

sim::Vec2 endOf(const lessons::TreeView &tree, const sim::State &state, int branch)
{
    const double angle = state.angle[branch] * degree;
    return state.positionOf(branch) +
           tree.length[static_cast<std::size_t>(branch)] * sim::Vec2{std::cos(angle), std::sin(angle)};
}

class Sway : public sim::Driver
{
public:
    Sway(lessons::TreeView tree, Eigen::ArrayXd rest) : m_tree(std::move(tree)), m_rest(std::move(rest)) {}
    std::string id() const override { return "sway"; }
    std::string title() const override { return "sway"; }
    sim::EffectKind kind() const override { return sim::EffectKind::driver; }
    std::vector<sim::Region> regions(sim::DirectionRule) const override { return {}; }
    int count(const sim::State &, sim::PointRange points) const override { return points.count; }
    std::vector<sim::LiveValue> explain(const sim::State &, const sim::State &, int) const override
    {
        return {};
    }
    void drive(sim::State &state, double) const override
    {
        const double turn = 6.0 * std::sin(static_cast<double>(state.frame) / 15.0);
        for (int i = 0; i < state.pointCount(); ++i) {
            const auto row = static_cast<std::size_t>(i);
            state.angle[i] = m_rest[i] + turn * 100.0 / (100.0 + m_tree.length[row]);
            if (m_tree.parent[row] >= 0)
                state.place(i, endOf(m_tree, state, m_tree.parent[row]));
        }
    }

private:
    lessons::TreeView m_tree;
    Eigen::ArrayXd m_rest;
};

}

lessons::Step step(const char *id, const sim::Scene &scene, const lessons::View &view)
{
    lessons::Step made;
    made.id = id;
    made.title = id;
    made.scene = [scene](const sim::Values &) { return scene; };
    made.view = [view](const sim::Scene &, const sim::Values &) { return view; };
    return made;
}

void letGlide(sim::Scene &scene, sim::Vec2 velocity)
{
    scene.start.velocity.col(0) = velocity.x;
    scene.start.velocity.col(1) = velocity.y;
}

lessons::View feetOnly(const sim::Scene &scene)
{
    lessons::View view;
    view.bodies.resize(scene.names.size());
    return view;
}

Tree tree(int forks)
{
    const int count = (2 << forks) - 1;
    Tree made;
    made.scene = scenes::pointsAt(std::vector<sim::Vec2>(static_cast<std::size_t>(count), {270.0, 400.0}));
    sim::State &start = made.scene.start;
    start.angle = Eigen::ArrayXd::Constant(count, -90.0);
    lessons::TreeView branches;
    branches.parent = {-1};
    branches.length = {100.0};
    branches.width = {13.0};
    for (int i = 1; i < count; ++i) {
        const int parent = (i - 1) / 2;
        const auto row = static_cast<std::size_t>(parent);
        branches.parent.push_back(parent);
        branches.length.push_back(0.8 * branches.length[row]);
        branches.width.push_back(std::max(0.9, 0.68 * branches.width[row]));
        start.angle[i] = start.angle[parent] + (i % 2 == 1 ? -28.0 : 28.0);
        start.place(i, endOf(branches, start, parent));
    }
    made.view.bodies.resize(static_cast<std::size_t>(count), {lessons::BodyView::Shape::none, 2.0});
    made.view.tree = std::move(branches);
    made.view.sky = lessons::View::Sky::dusk;
    return made;
}

void letSway(Tree &tree)
{
    tree.scene.effects.push_back(std::make_shared<Sway>(*tree.view.tree, tree.scene.start.angle));
}

}
