#include "sim/hard/catalogue.h"

#include "sim/hard/families.h"

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
    std::vector<HardCase> all;
    for (const auto family : {hard::stiffSprings, hard::manyFeet, hard::crampedPlaces, hard::roughHands,
                              hard::wallsAndWalking, hard::rigidSticks, hard::swimmers, hard::windyTrees,
                              hard::oddSteps, hard::longRuns, hard::badInput}) {
        std::vector<HardCase> cases = family();
        std::move(cases.begin(), cases.end(), std::back_inserter(all));
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
