#pragma once

#include "app/listing/cell_values.h"
#include "app/listing/script_functions.h"
#include "app/listing/values.h"
#include "app/listing/vocabulary.h"
#include "sim/scene/state.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace listing {

/// The scene as the programs of one script engine see it: a cell of memory for each body and each other name of a
/// vocabulary. The engine knows the addresses of the cells.
class SceneCells
{
public:
    /// Registers the language and the names of `vocabulary` with `engine`. Both must outlive this object.
    SceneCells(AngelScript::asIScriptEngine &engine, const Vocabulary &vocabulary, BodyAccess access);
    SceneCells(const SceneCells &) = delete;
    SceneCells &operator=(const SceneCells &) = delete;

    /// Reads a moment of the scene. A held body is where it was before the hand moved it.
    void load(const sim::State &state, const Binding &binding);
    /// Reads only the input and the frame number.
    void loadInput(const sim::State &state);
    /// Gives every name a body or a number that is not 0, so that any expression has a value.
    void loadPlaceholders();
    /// Writes the bodies, the gait clocks and the gust to `state`.
    void store(sim::State &state) const;

    /// Gives the first array of the vocabulary `count` cells.
    void resizeFirstArray(std::size_t count);
    /// Returns the cell with this index of the first array.
    BodyCell &cellOfFirstArray(std::size_t index) { return m_cells.arrays.front().cells[index]; }
    /// Sets parameter `index` of the vocabulary.
    void setParameter(std::size_t index, double value) { m_parameters[index] = value; }
    void setSeed(std::uint64_t seed) { m_seed = seed; }

    /// Returns the reader of variables that programs of this scene have.
    CellValues values() const { return {m_cells, m_types, m_vocabulary}; }
    /// Returns the bytes of a number, a bool or a Vec2; 0 for other types.
    std::size_t sizeOf(int type) const;
    /// Reads the motion of all bodies.
    void readMotions(std::vector<BodyMotion> &into) const;
    /// Returns the name of the first position, velocity or clock that is not finite, or an empty string.
    std::string firstNonFinite() const;

private:
    void registerFunctionsOfScene();
    void registerNames();
    void loadBranches(const Binding &binding);
    void loadSticks(const sim::State &state, const Binding &binding);
    void resizeCreatures(std::size_t count);
    double random(int i) const;
    double randomInFrame(int i, int frame) const;
    double sine(double rad) const { return m_angleFunctions.sin(rad); }
    double cosine(double rad) const { return m_angleFunctions.cos(rad); }
    double arcTangent(double y, double x) const { return m_angleFunctions.atan2(y, x); }
    template <class Visit>
    void forEachCell(Visit &&visit) const;

    sim::Vec2 directionOfBranch(const BodyCell *branch) const;

    AngelScript::asIScriptEngine &m_engine;
    const Vocabulary &m_vocabulary;
    CellTypes m_types;

    // The addresses of these are registered, so the containers keep their size.
    NamedCells m_cells;
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
};

}
