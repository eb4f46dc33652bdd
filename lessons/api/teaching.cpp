#include "lessons/api/teaching.h"

#include <algorithm>
#include <stdexcept>

namespace lessons {

namespace {

Step &stepOf(const Teaching &teaching, std::vector<Step> &steps)
{
    const auto found =
        std::find_if(steps.begin(), steps.end(), [&](const Step &step) { return step.id == teaching.step; });
    if (found == steps.end())
        throw std::invalid_argument("something is taught about a step that is not there: " +
                                    teaching.step.toStdString());
    if (found->tries.size() != teaching.hints.size())
        throw std::invalid_argument("hints and things to try are not as many: " +
                                    teaching.step.toStdString());
    return *found;
}

}

std::vector<Step> taught(std::vector<Step> steps, const std::vector<Teaching> &all)
{
    for (const Teaching &teaching : all) {
        Step &step = stepOf(teaching, steps);
        step.explanation = {teaching.learnt, teaching.terms, teaching.whys};
        for (std::size_t i = 0; i < teaching.hints.size(); ++i)
            step.tries[i].hint = teaching.hints[i];
    }
    return steps;
}

}
