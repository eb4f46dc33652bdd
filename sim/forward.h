#pragma once

#include <functional>
#include <memory>

// Types that interfaces only pass on: a header that names one of them by reference or pointer needs no more than this.

namespace sim {

class Effect;
class Method;
class Timeline;
class Track;
class Values;
struct Blueprint;
struct EffectDescription;
struct Event;
struct Phase;
struct Pipeline;
struct Room;
struct Scene;
struct Script;
struct ComposedInterval;
struct State;
struct Stick;
struct BlueprintDraft;
struct Tree;

/// Whether somebody still waits for what may take long; asked now and then on the way.
using ShouldContinue = std::function<bool()>;

using EffectPtr = std::shared_ptr<const Effect>;
using MethodPtr = std::shared_ptr<const Method>;

}
