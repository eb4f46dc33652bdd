#include "sim/purpose.h"

#include <algorithm>
#include <string_view>

namespace sim {

namespace {

struct Purpose
{
    std::string_view effect; ///< its id
    const char *sentence;
};

/// One line an effect, by id.
constexpr Purpose purposes[] = {
    {"angle_limits", SIM_TEXT("Keep joints from bending too far: a knee does not bend forwards.")},
    {"anticipation",
     SIM_TEXT(
         "Shifts the swimmer back before it goes to a new target, as a cat draws back before it leaps.")},
    {"area_stick", SIM_TEXT("Keeps the area of the body: what gets longer gets thinner.")},
    {"body_spring", SIM_TEXT("Pulls a foot to the body, wherever that is.")},
    {"breeze", SIM_TEXT("Blows everything sideways, wide bodies more, and swells and ebbs.")},
    {"damping", SIM_TEXT("Takes a share of every velocity each frame, so that things come to rest.")},
    {"gait_clock",
     SIM_TEXT("Turns the angle that swings the legs on, a little each frame: the beat of the walk.")},
    {"gravity", SIM_TEXT("Pulls everything down, and everything alike.")},
    {"ground", SIM_TEXT("Keeps the feet from sinking in, and from slipping where it holds them.")},
    {"gust", SIM_TEXT("Lets a gust run outwards from the pointer, so that near branches feel it first.")},
    {"joints", SIM_TEXT("Set each branch on the end of the branch that carries it.")},
    {"leg_spring", SIM_TEXT("Pull each foot to a place of its own, as seen from the body.")},
    {"motor", SIM_TEXT("Pulls the swimmer to its target, as a spring does.")},
    {"offset_spring", SIM_TEXT("Pulls a foot to a place beside the body.")},
    {"point_spring", SIM_TEXT("Pulls a foot to a fixed place.")},
    {"pointer", SIM_TEXT("Carries a point to where the pointer is.")},
    {"push",
     SIM_TEXT("Pushes apart what comes too close, so that creatures do not walk through each other.")},
    {"radial_spring",
     SIM_TEXT("Keep two points a length apart: they pull when it is more, and push when it is less.")},
    {"ramp", SIM_TEXT("Keeps everything on one side of a straight line, which leans as you like.")},
    {"return_to_rest", SIM_TEXT("Turns each branch a part of the way back to where it grew.")},
    {"room",
     SIM_TEXT("Keeps everything between two walls and above a floor, with friction and without a bounce.")},
    {"soft_sticks", SIM_TEXT("Keep a point near its distance, but let it lag behind for a while.")},
    {"split_damping", SIM_TEXT("Slows the tail, and more so across the body than along it, as water does.")},
    {"springs",
     SIM_TEXT("Keep two points a length apart: they pull when it is more, and push when it is less.")},
    {"steering", SIM_TEXT("Lets the arrow keys and the pointer set how fast the legs swing.")},
    {"sticks",
     SIM_TEXT("Give each pair of points its length back, by moving them: a stick does not stretch.")},
    {"torsion",
     SIM_TEXT("Bend each joint back: the harder, the farther a branch has turned from where it grew.")},
    {"turn_round", SIM_TEXT("Makes a creature that meets a wall walk the other way.")},
    {"turn_to_pointer", SIM_TEXT("Turns every branch to the pointer while its button is down.")},
    {"walls", SIM_TEXT("Put back what has gone past a wall or the floor, and turn its velocity round.")},
    {"wind", SIM_TEXT("Turns the branches away from the pointer while its button is down.")},
};

}

std::string purposeOf(const Effect &effect)
{
    const std::string id = effect.id();
    const auto *found = std::find_if(std::begin(purposes), std::end(purposes),
                                     [&](const Purpose &one) { return one.effect == id; });
    return found == std::end(purposes) ? std::string() : std::string(found->sentence);
}

}
