#include "sim/catalogue/hard_cases.h"

#include "sim/catalogue/families/families.h"
#include "sim/scene/scene.h"

#include <iterator>

namespace sim {

namespace hard {

HardCase caseOf(const char *id, const char *title, const char *story, Scene (*scene)(const Values &),
                Values values, std::int64_t frames)
{
    HardCase one;
    one.id = id;
    one.title = title;
    one.story = story;
    one.script.build = scene;
    one.script.values = std::move(values);
    one.brief.frames = one.full.frames = frames;
    return one;
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
        {SIM_TEXT("All in one place"), hard::crampedPlaces},
        {SIM_TEXT("Torn by a hand"), hard::roughHands},
        {SIM_TEXT("Walls and walking"), hard::wallsAndWalking},
        {SIM_TEXT("Sticks that contradict"), hard::rigidSticks},
        {SIM_TEXT("Swimmers"), hard::swimmers},
        {SIM_TEXT("Trees in wind"), hard::windyTrees},
        {SIM_TEXT("Unusual steps"), hard::oddSteps},
        {SIM_TEXT("Long runs"), hard::longRuns},
        {SIM_TEXT("Input that is refused"), hard::badInput},
    };
    std::vector<HardCase> all;
    for (const Family &family : families) {
        for (HardCase &one : family.cases()) {
            one.family = family.title;
            all.push_back(std::move(one));
        }
    }
    return all;
}

std::optional<HardCase> findHardCase(const std::string &id)
{
    for (HardCase &one : hardCases()) {
        if (one.id == id)
            return std::move(one);
    }
    return {};
}

}
