#pragma once

#include "sim/run/script/script.h"

#include <QString>

#include <functional>
#include <memory>
#include <vector>

namespace app {

constexpr qsizetype longestRunName = 200;     ///< letters, in a file
constexpr std::size_t mostKeptBranches = 100; ///< in a file

/// A run that was replaced by another one. Only its script is kept, which reproduces the run bit for bit.
struct Branch
{
    int id = 0;           ///< unique among all branches of a session
    QString name;         ///< its difference from the run, or the learner's name for it
    bool isNamed = false; ///< whether the learner named it
    bool isKept = false;  ///< whether it stays until the learner deletes it
    std::int64_t end = 0; ///< its last computed frame
    std::shared_ptr<const sim::Script> script;
    friend bool operator==(const Branch &, const Branch &) = default;
};

/// Details of the run in use that a branch keeps when another run replaces it. The run may have been a branch
/// before.
struct OwnRun
{
    QString made; ///< its difference from the run before: "after: damp 0.5"
    QString name; ///< the learner's name for it; may be empty
    bool isKept = false;
    std::int64_t end = 0; ///< last frame computed before, perhaps not since the run is in use again
    friend bool operator==(const OwnRun &, const OwnRun &) = default;
};

/// The branches of a step, oldest first. If there are too many, the oldest branches that are not kept are removed.
/// This is a plain value: copies share the scripts.
class Branches
{
public:
    /// The number of branches that stay without being kept.
    static constexpr std::size_t mostPassing = 6;

    const std::vector<Branch> &all() const { return m_all; }
    bool isEmpty() const { return m_all.empty(); }
    /// Returns the branch with this `id`, or null.
    const Branch *find(int id) const;
    /// Returns the branch with the same run as `script`, or null.
    const Branch *find(const sim::Script &script) const;

    const OwnRun &own() const { return m_own; }
    void setOwn(OwnRun own) { m_own = std::move(own); }

    /// Adds the newest branch. If its name is taken, the frame `leftAt` is added to the name, and then a number if
    /// needed. Branches with the same run are removed. If one of them was kept, the new branch is kept, too.
    void add(Branch branch, std::int64_t leftAt = 0);
    /// Makes `script` the run in use. A branch with the same run is removed, and the run in use takes over its
    /// name.
    void settle(const sim::Script &script);
    void rename(int id, const QString &name);
    void keep(int id, bool kept);
    void remove(int id);
    /// Removes the oldest branches that are not kept, until at most mostPassing of them remain.
    void limit();

    /// Returns the branches that the learner named or keeps, and the name of the run in use. Files contain these.
    Branches marked() const;
    /// Returns a copy whose runs have the scripts that `change` makes of theirs.
    Branches withScripts(const std::function<sim::Script(const sim::Script &)> &change) const;
    /// Returns a copy with new ids that follow `last`, and updates `last`.
    Branches renumbered(int &last) const;
    friend bool operator==(const Branches &, const Branches &) = default;

private:
    QString ownName(const QString &name, int id) const;

    std::vector<Branch> m_all;
    OwnRun m_own;
};

/// Returns whether `a` and `b` would be the same in a file: names, kept branches and runs.
bool sameMarked(const Branches &a, const Branches &b);

/// Returns the frame from which two runs of a step differ. Returns 0 if they differ from the start, and the largest
/// number if they are the same.
std::int64_t firstDifferent(const sim::Script &a, const sim::Script &b);

/// Returns the last frame that two runs of a step share, or 0 if they differ from the start.
std::int64_t lastShared(const sim::Script &a, const sim::Script &b);

}
