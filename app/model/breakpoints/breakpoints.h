#pragma once

#include <QObject>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace app {

/// A line of a source file that the code panel shows.
struct CodePlace
{
    QString file; ///< relative to the project's top folder
    int line = 0; ///< from 1
    friend bool operator==(const CodePlace &, const CodePlace &) = default;
};

/// A line or a condition that stops the run.
struct Breakpoint
{
    int id = 0;
    /// The line: the run stops before each phase that contains it. Empty: the run stops before any phase, as soon as
    /// the condition becomes true.
    std::optional<CodePlace> place;
    QString condition; ///< see Condition; required if there is no place
    bool isOn = true;
    friend bool operator==(const Breakpoint &, const Breakpoint &) = default;
};

/// The breakpoints of all steps that were opened. Only those of the open step are active.
class Breakpoints : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Returns the breakpoints of the open step, in the order in which they were set.
    const std::vector<Breakpoint> &all() const { return m_open; }
    const Breakpoint *find(int id) const;
    const Breakpoint *at(const CodePlace &place) const;
    /// Returns whether any breakpoint is switched on.
    bool isAnyOn() const;

    /// Makes `key` the open step, with the breakpoints that it had when it was last open.
    void open(const QString &key);
    /// Sets a breakpoint at `place`, or removes the existing one. Returns whether there is one now.
    bool toggle(const CodePlace &place);
    /// Adds a breakpoint without a line. The caller must have checked `condition`.
    void add(const QString &condition);
    void setCondition(int id, const QString &condition);
    void setOn(int id, bool on);
    void remove(int id);

signals:
    void changed();

private:
    Breakpoint *its(int id);

    std::vector<Breakpoint> m_open;
    std::map<QString, std::vector<Breakpoint>> m_closed; ///< by step
    QString m_key;
    int m_last = 0; ///< the last id used
};

}
