#pragma once

namespace sim {

/// A meaning that the app has to know of a parameter.
enum class ParameterRole {
    none,
    damping,    ///< fraction of its velocity that everything keeps per frame: a smaller one damps more
    iterations, ///< iterations over the sticks per step: more of them leave a smaller error
};

/// A number that a learner can set, for the whole scene or for each point. Texts are in English; see
/// SIM_TEXT.
struct ParameterSpec
{
    const char *id = ""; ///< in files and in the shown code: lower case with underscores
    const char *name = "";
    const char *symbol = ""; ///< in formulas; may be empty
    const char *unit = "";   ///< may be empty
    const char *help = "";   ///< one sentence: what it does
    double defaultValue = 0.0;
    double min = 0.0;       ///< smallest value that files may contain
    double max = 1.0;       ///< largest value that files may contain
    double sliderMin = 0.0; ///< left end of the slider
    double sliderMax = 1.0; ///< right end of the slider
    int decimals = 2;       ///< digits shown after the decimal point
    ParameterRole role = ParameterRole::none;
    bool isInteger = false; ///< whether only whole numbers are allowed
};

}
