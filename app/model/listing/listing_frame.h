#pragma once

#include "app/listing/program.h"
#include "sim/scene/scene.h"

#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// One frame of a run, computed by a listing line by line.
class ListingFrame
{
public:
    /// Runs a frame of `program` from `start`, the state after the input of the frame. `frame` is the number of frames
    /// that are finished before it.
    ListingFrame(std::shared_ptr<const listing::Program> program, const sim::Scene &scene,
                 const sim::State &start, std::int64_t frame);

    std::int64_t frame() const { return m_frame; }
    /// Returns the number of lines that ran.
    int count() const { return static_cast<int>(m_trace.lines.size()); }
    /// Returns the line before which `index` lines have run.
    const listing::TracedLine &line(int index) const
    {
        return m_trace.lines[static_cast<std::size_t>(index)];
    }
    const std::vector<listing::TracedLine> &lines() const { return m_trace.lines; }
    /// Returns whether all lines are there; see listing::maxTracedLines.
    bool isComplete() const { return m_trace.isComplete; }
    /// Returns the mistake that stopped the frame on its last line.
    const std::optional<listing::RunError> &error() const { return m_trace.error; }
    const listing::Program &program() const { return *m_program; }

    /// Returns the state after `index` lines.
    sim::State stateAfter(int index) const;
    /// Applies the change of bodies by the line at `index` to the state before it.
    void applyLine(int index, sim::State &state) const;

    /// Returns the value of a path such as "angle", "foot.velocity", "feet[i].position.x" or "k" after `index` lines, as
    /// the line at `index` sees it; after the last line, as that line did. Empty if there is no such value, or if the path
    /// is a calculation.
    std::optional<listing::Value> valueOf(const QString &path, int index) const;
    /// The same, as the function at the line `scope` sees the names, with the values after `index` lines.
    std::optional<listing::Value> valueOf(const QString &path, int index, int scope) const;

    /// Returns a double, int or bool as a number; empty for other values. As valueOf().
    std::optional<double> numberOf(const std::string &path, int index) const;

    /// Returns the number of the call in which a line runs: lines of the same call have the same number.
    int callOf(int index) const { return m_calls[static_cast<std::size_t>(index)]; }
    /// Returns the first line after `index` with at most `depth` calls around it, or count().
    int nextWithin(int index, int depth) const;

private:
    /// Returns the motion of a point after `index` lines.
    std::optional<listing::BodyMotion> motionOf(int point, int index) const;
    std::optional<listing::Value> variable(const std::string &name, int index, int scope) const;
    /// Returns a variable, or a name of the scene that has a value by itself.
    std::optional<listing::Value> rootValue(const std::string &name, int index, int scope) const;
    /// Returns a number that the scene remembers besides its bodies: of the gait clock or of the gust.
    std::optional<listing::Value> remembered(const std::string &name, int index) const;
    /// Returns the angle of gait clock `clock`, or its speed, after `index` lines.
    std::optional<listing::Value> gaitOf(std::size_t clock, const std::string &member, int index) const;
    std::optional<listing::Value> bodyMember(const listing::BodyReference &body, const std::string &member,
                                             int index) const;
    std::optional<listing::Value> memberValue(const listing::Value &value, const std::string &member,
                                              int index) const;

    /// An array of bodies, creatures or sticks.
    struct List
    {
        std::string name;               ///< of the array that the items belong to
        const std::vector<int> *points; ///< of that array; null for creatures and sticks
        int first = 0;                  ///< index there of the first item
        int count = 0;
        listing::BodyReference::Kind kind = listing::BodyReference::Kind::body;
    };
    std::optional<List> rootList(const std::string &name) const;
    std::optional<List> memberList(const listing::Value &value, const std::string &member) const;
    std::optional<listing::Value> itemOf(const List &list, int i) const;
    /// Returns the points of an array of bodies; null if there is none of this name.
    const std::vector<int> *pointsOf(const std::string &array) const;
    /// Returns the index of a branch in the tree, or -1 if the point is none.
    int branchAt(int point) const;

    std::shared_ptr<const listing::Program> m_program;
    listing::Binding m_binding;
    std::int64_t m_frame;
    sim::State m_start; ///< as the first line finds it
    listing::Trace m_trace;
    std::vector<int> m_calls; ///< per line
};

}
