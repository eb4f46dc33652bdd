#include "sim/catalogue/hard_cases.h"

#include "sim/catalogue/families/families.h"
#include "sim/scene/scene.h"

#include <iterator>

namespace sim {

namespace hard {

HardCase caseOf(const char *id, const char *title, const char *story, Scene (*scene)(const Values &),
                Values values, std::int64_t frames)
{
    HardCase hardCase;
    hardCase.id = id;
    hardCase.title = title;
    hardCase.story = story;
    hardCase.script.build = scene;
    hardCase.script.values = std::move(values);
    hardCase.brief.frames = hardCase.full.frames = frames;
    return hardCase;
}

}

std::vector<HardCase> hardCases()
{
    struct Family
    {
        const char *title;
        std::vector<HardCase> (*cases)();
    };
    static constexpr Family families[] = {
        {SIM_TEXT("Stiff springs"), hard::stiffSprings},
        {SIM_TEXT("Many feet on one body"), hard::manyFeet},
        {SIM_TEXT("All in one place"), hard::coincidentPoints},
        {SIM_TEXT("Grabbed and dragged"), hard::suddenDrags},
        {SIM_TEXT("Walls and walking"), hard::wallsAndWalking},
        {SIM_TEXT("Sticks that contradict"), hard::rigidSticks},
        {SIM_TEXT("Swimmers"), hard::swimmers},
        {SIM_TEXT("Trees in wind"), hard::windyTrees},
        {SIM_TEXT("Unusual steps"), hard::unusualSteps},
        {SIM_TEXT("Long runs"), hard::longRuns},
        {SIM_TEXT("Invalid input"), hard::invalidInput},
    };
    std::vector<HardCase> all;
    for (const Family &family : families) {
        for (HardCase &hardCase : family.cases()) {
            hardCase.family = family.title;
            all.push_back(std::move(hardCase));
        }
    }
    return all;
}

std::optional<HardCase> findHardCase(const std::string &id)
{
    for (HardCase &hardCase : hardCases()) {
        if (hardCase.id == id)
            return std::move(hardCase);
    }
    return {};
}

}
