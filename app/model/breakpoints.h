#pragma once

#include <QObject>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace app {

/// A line of a file whose regions are shown.
struct CodePlace
{
    QString file; ///< from the project's top folder
    int line = 0; ///< from 1
    friend bool operator==(const CodePlace &, const CodePlace &) = default;
};

/// Where a run is to stop by itself.
struct Breakpoint
{
    int id = 0;
    /// Before each phase that this line belongs to; empty: before any phase, as soon as the condition comes true.
    std::optional<CodePlace> place;
    QString condition; ///< see Condition; only one with a place may do without
    bool isOn = true;
    friend bool operator==(const Breakpoint &, const Breakpoint &) = default;
};

/// The breakpoints of the steps that were open; those of the one that is open now are in force.
class Breakpoints : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Those of the open step, in the order in which they were set.
    const std::vector<Breakpoint> &all() const { return m_open; }
    const Breakpoint *find(int id) const;
    const Breakpoint *at(const CodePlace &place) const;
    /// Whether one is switched on.
    bool isAnyOn() const;

    /// The step called `key` is open from now on, with the breakpoints that it was left with.
    void open(const QString &key);
    /// Sets one, or takes away the one that is there. Returns whether there is one now.
    bool toggle(const CodePlace &place);
    /// Adds one without a line. Whether `condition` fits must have been seen to.
    void add(const QString &condition);
    void setCondition(int id, const QString &condition);
    void setOn(int id, bool on);
    void remove(int id);

signals:
    void changed();

private:
    Breakpoint *its(int id);

    std::vector<Breakpoint> m_open;
    std::map<QString, std::vector<Breakpoint>> m_left; ///< by step
    QString m_key;
    int m_last = 0; ///< the id last given
};

}
