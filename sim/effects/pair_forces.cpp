// The descriptions of the forces between two points.

#include "sim/effects/description.h"
#include "sim/effects/push.h"
#include "sim/values.h"

#include <numeric>

namespace sim {

namespace {

constexpr Setting pushSettings[] = {
    {"push", SIM_TEXT("Push"), "k", SIM_TEXT("1/frame²"),
     SIM_TEXT("How hard two bodies push: this share of the missing distance, each frame."), 0.2, 0.0, 1e9},
    {"distance", SIM_TEXT("Distance"), "", SIM_TEXT("px"),
     SIM_TEXT("Two bodies closer than this push each other."), 20.0, 0.0, 1e6, 0.0, 100.0, 0}};

EffectPtr buildPush(const Blueprint &plan, const Values &values)
{
    std::vector<int> all(plan.points.size());
    std::iota(all.begin(), all.end(), 0);
    return std::make_shared<Push>(all, values["push"], values["distance"], Reaction::equal);
}

}

namespace described {

extern constinit const Description body_spring = {"body_spring", SIM_TEXT("spring"), Kind::spring,
                                                  SIM_TEXT("Pulls a foot to the body, wherever that is.")};
extern constinit const Description leg_spring = {
    "leg_spring", SIM_TEXT("legs"), Kind::spring,
    SIM_TEXT("Pull each foot to a place of its own, as seen from the body.")};
extern constinit const Description offset_spring = {"offset_spring", SIM_TEXT("spring"), Kind::spring,
                                                    SIM_TEXT("Pulls a foot to a place beside the body.")};
extern constinit const Description point_spring = {"point_spring", SIM_TEXT("spring"), Kind::spring,
                                                   SIM_TEXT("Pulls a foot to a fixed place.")};
extern constinit const Description radial_spring = {
    "radial_spring", SIM_TEXT("springs"), Kind::spring,
    SIM_TEXT("Keep two points a length apart: they pull when it is more, and push when it is less.")};
extern constinit const Description springs = {
    "springs", SIM_TEXT("springs"), Kind::spring,
    SIM_TEXT("Keep two points a length apart: they pull when it is more, and push when it is less.")};
extern constinit const Description push = {
    .id = "push",
    .title = SIM_TEXT("push"),
    .kind = Kind::spring,
    .purpose =
        SIM_TEXT("Pushes apart what comes too close, so that creatures do not walk through each other."),
    .settings = pushSettings,
    .make = buildPush};

}

}
