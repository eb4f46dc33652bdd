#pragma once

#include "sim/run/script/script.h"

#include <QString>

#include <memory>
#include <vector>

namespace app {

constexpr qsizetype longestRunName = 200;     ///< letters, in a file
constexpr std::size_t mostKeptBranches = 100; ///< in a file

/// A run that was left for another one. Its script alone is kept: that gives every bit of it again.
struct Branch
{
    int id = 0;           ///< never used for two branches of a session
    QString name;         ///< what it differs by, or what the learner calls it
    bool isNamed = false; ///< by the learner
    bool isKept = false;  ///< it stays until the learner deletes it
    std::int64_t end = 0; ///< the last frame that was computed of it
    std::shared_ptr<const sim::Script> script;
    friend bool operator==(const Branch &, const Branch &) = default;
};

/// The run in use, as far as it will matter when it is left: it may have been a branch before.
struct OwnRun
{
    QString made; ///< what made it differ from the run before: "after: damp 0.5"
    QString name; ///< what the learner calls it; empty if nothing
    bool isKept = false;
    std::int64_t end = 0; ///< computed before, though maybe not since it is in use again
    friend bool operator==(const OwnRun &, const OwnRun &) = default;
};

/// The branches of a step, oldest first. Those that are not kept go when there are too many, the oldest first. A plain
/// value: copies share the scripts.
class Branches
{
public:
    /// So many stay without being kept.
    static constexpr std::size_t mostPassing = 6;

    const std::vector<Branch> &all() const { return m_all; }
    bool isEmpty() const { return m_all.empty(); }
    /// Null if there is none with that id.
    const Branch *find(int id) const;
    /// The branch that is this run; null if there is none.
    const Branch *find(const sim::Script &script) const;

    const OwnRun &own() const { return m_own; }
    void setOwn(OwnRun own) { m_own = std::move(own); }

    /// Adds the newest one. If another one has its name, the frame at which it was left tells them apart, and a number if
    /// that does not. A branch that is the same run gives way to it, and stays kept.
    void add(Branch branch, std::int64_t leftAt = 0);
    /// The run in use is `script`: a branch that is the same run is one no more, and hands on its name.
    void settle(const sim::Script &script);
    void rename(int id, const QString &name);
    void keep(int id, bool kept);
    void remove(int id);
    /// Lets the oldest go that are not kept, until there are not too many of those.
    void limit();

    /// Those that the learner named or keeps, and the name of the run in use: what files have of them.
    Branches marked() const;
    /// The same with other ids, counted on from `last`.
    Branches renumbered(int &last) const;
    friend bool operator==(const Branches &, const Branches &) = default;

private:
    Branch *changeable(int id);
    QString ownName(const QString &name, int id) const;

    std::vector<Branch> m_all;
    OwnRun m_own;
};

/// Whether two have the same of what files have: names, what is kept, and runs.
bool sameMarked(const Branches &a, const Branches &b);

/// The frame from which two runs of a step differ: 0 if they do from the start, the largest number if they are the same.
std::int64_t firstDifferent(const sim::Script &a, const sim::Script &b);

/// The last frame that two runs of a step share: 0 if they differ from the start.
std::int64_t lastShared(const sim::Script &a, const sim::Script &b);

}
