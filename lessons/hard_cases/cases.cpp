#include "cases.h"

#include "lessons/api/choice_group.h"
#include "lessons/api/creature.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_look.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/tree/joints.h"
#include "sim/hard_cases/catalogue.h"

#include <QCoreApplication>

#include <algorithm>

using namespace lessons;

namespace hard_cases {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(HardCases)
};

constexpr double mostForks = 12.0;  ///< 8191 branches
constexpr double trunkWidth = 10.0; ///< px
constexpr double lightRadius = 6.0;
constexpr double heavyRadius = 20.0;
constexpr double jointRadius = 4.0;

/// A text of sim, in the learner's language.
QString phrase(const std::string &text)
{
    return QCoreApplication::translate("sim", text.c_str());
}

Look treeLook(const sim::Tree &tree)
{
    Look look;
    look.bodies.assign(tree.parent.size(), {BodyLook::Shape::none, 0.0});
    look.tree = TreeLook{tree.parent, tree.scale, tree.scale};
    for (double &length : look.tree->length)
        length *= tree.baseLength;
    for (double &width : look.tree->width)
        width *= trunkWidth;
    look.stage = QRectF(0, 0, 550, 400);
    look.sky = Look::Sky::dusk;
    return look;
}

BodyLook bodyLook(const std::string &name)
{
    if (isBody(name))
        return {BodyLook::Shape::body, bodyWidth / 2};
    if (name == "heavy" || name == "lead")
        return {BodyLook::Shape::body, name == "heavy" ? heavyRadius : bodyWidth / 2};
    if (name == "light")
        return {BodyLook::Shape::foot, lightRadius};
    return name.starts_with("p") ? BodyLook{BodyLook::Shape::joint, jointRadius} : BodyLook{};
}

}

std::vector<sim::HardCase> shownCases()
{
    std::vector<sim::HardCase> all = sim::hardCases();
    std::erase_if(all, [](const sim::HardCase &one) { return one.asksFor(sim::Ask::refused); });
    for (sim::HardCase &one : all) {
        if (one.script.values.has("levels"))
            one.script.values.set("levels", std::min(one.script.values["levels"], mostForks));
    }
    return all;
}

sim::HardCase caseNumber(int number)
{
    return shownCases().at(static_cast<std::size_t>(number));
}

int numberOf(const char *id)
{
    const std::vector<sim::HardCase> all = shownCases();
    const auto found =
        std::find_if(all.begin(), all.end(), [id](const sim::HardCase &one) { return one.id == id; });
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

Parameter caseParameter()
{
    QStringList ids, titles, helps;
    for (const sim::HardCase &one : shownCases()) {
        ids << QString::fromStdString(one.id);
        titles << lessons::grouped(phrase(one.family), phrase(one.title));
        helps << phrase(one.story);
    }
    Parameter parameter = choice("case", Text::tr("Case"),
                                 Text::tr("The experiment that runs. Another one begins at frame 0."), ids);
    parameter.choiceTitles = titles;
    parameter.choiceHelps = helps;
    parameter.preset = numberOf("runaway_pair");
    parameter.opens = true;
    return parameter;
}

Parameter stiffnessOfCase()
{
    Parameter parameter = stiffness(0.0);
    parameter.help = Text::tr("How hard the springs of the case pull. 0: as hard as the case has it.");
    parameter.sliderMax = 10.0;
    return parameter;
}

void openCase(sim::Script &script)
{
    const sim::HardCase hard = caseNumber(script.values.whole("case"));
    script.input = hard.script.input;
    script.bodies = hard.script.bodies;
    script.step = sim::scriptOf(hard, script.method, hard.brief).step;
}

Look caseLook(const sim::Scene &scene, const sim::Values &)
{
    Look look;
    for (const std::string &name : scene.names)
        look.bodies.push_back(bodyLook(name));
    if (std::any_of(scene.names.begin(), scene.names.end(), isBody))
        look = creatureLookWithLegs(scene);
    else if (scene.names.front() == "light")
        look.legs = {{1, 0}};
    for (const sim::EffectPtr &effect : scene.effects) {
        if (const auto *joints = dynamic_cast<const sim::Joints *>(effect.get()))
            return treeLook(joints->tree());
        if (const auto *walls = dynamic_cast<const sim::Walls *>(effect.get()))
            look.room = walls->room();
        if (const auto *ground = dynamic_cast<const sim::Ground *>(effect.get()))
            look.ground = ground->soil().ground;
    }
    for (const sim::Sticks *sticks : sim::sticksAmong(scene.effects)) {
        for (const sim::Stick &stick : sticks->list())
            look.sticks.push_back({stick.a, stick.b, stick.length});
    }
    if (scene.names.front() == "lead" && look.sticks.empty())
        look.legs = {{0, 1}}; // a soft stick
    return look;
}

}
