#include "tests/listing/listing_support.h"

#include "sim/effects/constraints/sticks.h"
#include "sim/effects/tree/tree.h"
#include "sim/scene/values.h"
#include "sim/scenes/creatures.h"
#include "sim/scenes/points.h"
#include "sim/scenes/trees.h"

#include <QTest>

#include <fstream>
#include <sstream>

namespace listing_support {

sim::Scene threeFeet()
{
    sim::Scene scene = scenes::creature(3);
    for (int i = 0; i < 3; ++i)
        scene.start.place(i, {10.0 * i, 0.0});
    scene.start.place(3, {100, 50});
    sim::Values values;
    values.set("k", 0.25);
    values.set("damp", 0.5);
    values.set("radius", 50);
    values.seed = 7;
    scene.values = std::make_shared<const sim::Values>(values);
    return scene;
}

sim::Scene threeCreatures()
{
    sim::Scene scene = scenes::crowd(3, 2);
    scene.start.position.setZero();
    scene.start.gait = Eigen::ArrayXd::LinSpaced(3, 0.0, 2.0);
    scene.start.gaitSpeed = Eigen::ArrayXd::Constant(3, 0.5);
    sim::Values values;
    values.set("floor", 380);
    values.set("k", 0.25);
    scene.values = std::make_shared<const sim::Values>(values);
    return scene;
}

namespace {

sim::Scene withStiffness(sim::Scene scene)
{
    sim::Values values;
    values.set("k", 0.25);
    values.seed = 7;
    scene.values = std::make_shared<const sim::Values>(values);
    return scene;
}

}

sim::Scene swingingBush()
{
    const auto tree = std::make_shared<const sim::Tree>(scenes::bush());
    sim::Scene scene = scenes::standingTree(*tree, {0, 0}, sim::TreeFormula::corrected);
    scenes::enableSpins(scene);
    scenes::addSway(scene, tree, {});
    return withStiffness(scene);
}

sim::Scene twoSticks()
{
    sim::Scene scene = scenes::pointsAt({{0, 0}, {3, 4}, {3, 4}});
    scene.names.back() = "tail0_0";
    const std::vector<sim::Stick> sticks = {{0, 1, 10, 0.25}, {1, 2, 7, 0.5}};
    scenes::add<sim::Sticks>(scene, sticks, 3);
    return withStiffness(scene);
}

Bench::Bench(const std::string &text, const sim::Scene &inScene) : scene(inScene)
{
    const listing::Compiled compiled = listing::Program::compile(text, listing::vocabularyOf(scene));
    program = compiled.program;
    if (!program)
        qFatal("does not compile: %s", errorsOf(text, scene).c_str());
    binding = listing::bind(program->vocabulary(), scene);
}

Bench Bench::ofFrame(const std::string &body)
{
    return Bench(frameOf(body));
}

std::optional<listing::RunError> Bench::run()
{
    ++state.frame;
    return program->run(state, binding);
}

std::string frameOf(const std::string &body)
{
    return "void frame()\n{\n" + body + "\n}\n";
}

std::string errorsOf(const std::string &text, const sim::Scene &scene)
{
    std::ostringstream all;
    for (const listing::CompileError &error :
         listing::Program::compile(text, listing::vocabularyOf(scene)).errors)
        all << error.line << ':' << error.column << '+' << error.length << ' ' << error.sentence << '\n';
    std::string errors = all.str();
    if (!errors.empty())
        errors.pop_back();
    return errors;
}

std::string fileText(const std::string &path)
{
    std::ifstream file(SOURCE_DIR "/" + path);
    if (!file)
        qFatal("cannot read %s", path.c_str());
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string shown(const std::vector<listing::Variable> &variables, const std::string &name)
{
    for (const listing::Variable &variable : variables) {
        if (variable.name != name)
            continue;
        std::ostringstream text;
        text << name << " = ";
        if (const auto *number = std::get_if<double>(&variable.value))
            text << *number;
        else if (const auto *whole = std::get_if<std::int64_t>(&variable.value))
            text << *whole;
        else if (const auto *truth = std::get_if<bool>(&variable.value))
            text << (*truth ? "true" : "false");
        else if (const auto *vector = std::get_if<sim::Vec2>(&variable.value))
            text << '(' << vector->x << ", " << vector->y << ')';
        else
            text << std::get<listing::BodyReference>(variable.value).name;
        return text.str();
    }
    return {};
}

}
