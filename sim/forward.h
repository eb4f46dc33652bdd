#pragma once

#include <functional>
#include <memory>

// Forward declarations for headers that use these types only by reference or pointer.

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

/// Returns false to cancel a long computation, which calls it from time to time.
using ShouldContinue = std::function<bool()>;

using EffectPtr = std::shared_ptr<const Effect>;
using MethodPtr = std::shared_ptr<const Method>;

}
