#pragma once

namespace sim {

/// What a setting means for the run as a whole.
enum class ParameterRole {
    none,
    damping,    ///< the share of its speed that everything keeps each frame: less of it is more damping
    iterations, ///< how often a step goes through a list of sticks: more of it leaves less error
};

/// A number that a learner sets: of the whole scene, or of each point. Texts are in English; see SIM_TEXT.
struct ParameterSpec
{
    const char *id = ""; ///< in files and in the shown code: lower case with underscores
    const char *name = "";
    const char *symbol = ""; ///< as formulas write it; may be empty
    const char *unit = "";   ///< may be empty
    const char *help = "";   ///< one sentence: what it does
    double defaultValue = 0.0;
    double min = 0.0; ///< the least and the most that files may give
    double max = 1.0;
    double sliderMin = 0.0; ///< the range of the slider
    double sliderMax = 1.0;
    int decimals = 2; ///< shown after the point
    ParameterRole role = ParameterRole::none;
    bool isInteger = false; ///< a count: nothing between two whole numbers
};

}
