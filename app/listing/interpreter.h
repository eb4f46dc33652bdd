#pragma once

#include "app/listing/script_functions.h"
#include "app/listing/source_scan.h"
#include "app/listing/values.h"
#include "app/listing/vocabulary.h"
#include "sim/scene/state.h"

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace AngelScript {
class asIScriptContext;
class asIScriptEngine;
class asIScriptFunction;
class asIScriptModule;
struct asSMessageInfo;
}

namespace listing {

using AngelScript::asIScriptContext;
using AngelScript::asIScriptEngine;
using AngelScript::asIScriptFunction;
using AngelScript::asIScriptModule;
using AngelScript::asSMessageInfo;

/// What a frame does besides computing the new state.
struct Recording
{
    std::vector<TracedLine> *lines = nullptr; ///< receives each line, up to maxTracedLines; null: none
    /// Number of lines to run: the frame is left before the next one. Negative: all.
    int stopAfter = -1;
    bool findsNonFinite = false; ///< whether the first line that makes a number infinite or NaN is an error
};

/// The result of Interpreter::run().
struct RunResult
{
    std::optional<RunError> error;
    bool isStopped = false;         ///< whether it was left because of Recording::stopAfter
    bool isComplete = true;         ///< whether all lines were recorded
    std::optional<TracedLine> next; ///< if it was left: the line before which it stopped
    std::vector<Variable> globals;  ///< after the frame, if its lines were recorded
};

/// A compiled listing, its script engine, and the memory for one frame. Only one thread may use it at a time, so
/// Program makes one for each thread.
class Interpreter
{
public:
    /// Compiles the text of `scan`. Both arguments must outlive this object.
    Interpreter(const SourceScan &scan, const Vocabulary &vocabulary);
    ~Interpreter();
    Interpreter(const Interpreter &) = delete;
    Interpreter &operator=(const Interpreter &) = delete;

    const std::vector<CompileError> &errors() const { return m_errors; }
    /// Computes a frame of `state`. If it is left by an error, `state` does not change, except that
    /// Recording::stopAfter leaves it as it is inside the frame.
    RunResult run(sim::State &state, const Binding &binding, const Recording &recording);

private:
    struct BodyCell;
    /// Bodies that are neighbours in an array: the children of a branch.
    struct ChildArray
    {
        int count = 0;
        BodyCell *first = nullptr;
    };
    /// A body as the interpreter sees it.
    struct BodyCell
    {
        sim::Vec2 position, velocity, before;
        double mass = 0.0, radius = 0.0, angle = 0.0, spin = 0.0;
        bool held = false;
        int point = -1;
        // of a branch
        int number = 0;
        double rest = 0.0, scale = 0.0, length = 0.0, inertia = 0.0;
        ChildArray children;
    };
    struct BodyArray
    {
        int count = 0;
        std::string name;
        std::vector<BodyCell> cells;
    };
    struct CreatureCell
    {
        BodyCell body;
        BodyArray feet;
        double gait = 0.0, gaitSpeed = 0.0;
    };
    struct CreatureArray
    {
        int count = 0;
        std::vector<CreatureCell> cells;
    };
    struct StickCell
    {
        BodyCell *a = nullptr, *b = nullptr;
        double length = 0.0, share = 0.0;
    };
    struct StickArray
    {
        int count = 0;
        std::vector<StickCell> cells;
    };
    struct TargetArray
    {
        int count = 0;
        std::vector<sim::Vec2> all;
    };
    /// A global variable of the listing.
    struct Global
    {
        const char *name;
        int type;
        unsigned index;
        std::size_t bytes;
    };
    struct KeyCell
    {
        bool left = false, right = false, up = false, down = false;
    };
    /// The scope of each variable of a function of the interpreter, by its number. Empty: not known.
    using Scopes = std::vector<Extent>;

    void registerLanguage();
    void registerBodies();
    void registerBranches();
    void registerCreatures();
    void registerSticks();
    void registerInput();
    void registerFunctionsOfScene();
    void registerNames();
    void compile();
    /// Adds an error, if it is the first on its line: the interpreter's later ones follow from it.
    void addError(int line, int column, std::string sentence);
    void findGlobals();
    std::size_t sizeOf(int type) const;
    void load(const sim::State &state, const Binding &binding);
    void loadInput(const sim::State &state);
    void loadBranches(const Binding &binding);
    void loadSticks(const sim::State &state, const Binding &binding);
    void resizeCreatures(std::size_t count);
    void store(sim::State &state) const;
    RunResult execute(const sim::State &state, const Binding &binding, const Recording &recording);
    void runFrame();
    /// Sets the globals to their initial values.
    void initialise();
    /// Makes sure that the globals have addresses, which they only have once they had a value.
    void allocateGlobals(const sim::State &state, const Binding &binding);
    /// Returns where a global is; null if it never had a value.
    void *addressOf(const Global &global) const;
    void onLine();
    void onException();
    void record(int line, int column, int depth);
    /// Adds the bodies that have changed since the last call to the last recorded line.
    void recordChanges();
    void fail(RunErrorKind kind, int line, std::string sentence);
    /// Returns the name of the first position, velocity or global that is not finite, or an empty string.
    std::string firstNonFinite() const;
    std::vector<Variable> variables() const;
    std::optional<Value> valueAt(const void *address, int type) const;
    Value valueOf(const BodyCell *cell) const;
    Value valueOf(const CreatureCell *cell) const;
    Value valueOf(const StickCell *cell) const;
    /// Returns the name of a body that has none in the scene, by a stick that ends there: "sticks[3].b".
    std::string nameBySticks(const BodyCell *cell) const;
    const Scopes &scopesOf(asIScriptFunction *function) const;
    double random(int i) const;
    double randomInFrame(int i, int frame) const;
    double sine(double rad) const { return m_angleFunctions.sin(rad); }
    double cosine(double rad) const { return m_angleFunctions.cos(rad); }
    double arcTangent(double y, double x) const { return m_angleFunctions.atan2(y, x); }
    template <class Visit>
    void forEachCell(Visit &&visit) const;

    static bool isSameBody(const BodyCell *a, const BodyCell *b);
    static bool isSameCreature(const CreatureCell *a, const CreatureCell *b);
    static BodyCell *bodyAt(int index, BodyArray *array);
    static CreatureCell *creatureAt(int index, CreatureArray *array);
    static BodyCell *bodyOf(CreatureCell *creature);
    static BodyCell *childAt(int index, ChildArray *array);
    static StickCell *stickAt(int index, StickArray *array);
    static sim::Vec2 targetAt(int index, const TargetArray *array);
    sim::Vec2 directionOfBranch(const BodyCell *branch) const;
    static sim::Vec2 directionBetween(const BodyCell *from, const BodyCell *to);
    static sim::Vec2 directionToPlace(const BodyCell *from, const VectorCell &to);
    static sim::Vec2 directionOfPlaces(const VectorCell &from, const VectorCell &to, const BodyCell *owner);
    static void lineCallback(asIScriptContext *context, void *self);
    static void exceptionCallback(asIScriptContext *context, void *self);
    static void messageCallback(const asSMessageInfo *message, void *self);

    const SourceScan &m_scan;
    const Vocabulary &m_vocabulary;
    std::vector<CompileError> m_errors;
    asIScriptEngine *m_engine = nullptr;
    asIScriptContext *m_context = nullptr;
    asIScriptModule *m_module = nullptr;
    asIScriptFunction *m_frame = nullptr;
    int m_vec2Type = 0;
    int m_bodyType = 0;
    int m_creatureType = -1; ///< -1: this scene has no creatures
    int m_stickType = -1;    ///< -1: this scene has no sticks
    std::vector<Global> m_globals;
    std::size_t m_memoryBytes = 0;
    mutable std::map<asIScriptFunction *, Scopes> m_scopes;

    // The memory of a frame. The addresses of these are registered, so the containers keep their size.
    std::deque<BodyCell> m_bodies;
    std::deque<BodyCell *> m_handles; ///< one per single body; null if the scene does not have it
    std::deque<BodyArray> m_arrays;
    CreatureArray m_creatures;
    std::vector<BodyCell> m_otherBodies; ///< without a name
    StickArray m_sticks;
    TargetArray m_newTargets;
    std::deque<double> m_parameters;
    AngleFunctions m_angleFunctions;
    double m_degrees = 1.0;
    sim::Vec2 m_hand, m_pointer, m_target;
    KeyCell m_keys;
    bool m_pointerDown = false, m_pointerKnown = false, m_gustKnown = false;
    double m_gust = 0.0, m_gustFront = 0.0, m_gustTail = 0.0;
    double m_frameNumber = 0.0, m_gait = 0.0, m_gaitSpeed = 0.0;
    double m_pi = 3.14159265358979323846;
    std::uint64_t m_seed = 1;

    // The frame that is running.
    Recording m_recording;
    RunResult m_result;
    int m_cues = 0;                     ///< calls of onLine()
    int m_lines = 0;                    ///< lines so far, of which a line with several parts is one
    int m_lastLine = 0;                 ///< of the last cue
    int m_lastDepth = 0;                ///< of the last cue
    TracedLine m_before;                ///< the line that runs now, for findsNonFinite
    std::vector<BodyMotion> m_recorded; ///< all bodies at the last call of recordChanges()
    bool m_isInitialising = false;
};

}
