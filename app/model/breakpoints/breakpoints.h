#pragma once

#include <QObject>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace app {

/// A line of a source file that the code panel shows, or of the listing.
struct CodePlace
{
    QString file; ///< relative to the project's top folder; empty: the listing of the step
    int line = 0; ///< from 1

    bool isInListing() const { return file.isEmpty(); }
    friend bool operator==(const CodePlace &, const CodePlace &) = default;
};

/// A line or a condition that stops the run.
struct Breakpoint
{
    int id = 0;
    /// The line: the run stops before each phase that contains it, or each time before the line of the listing. Empty:
    /// the run stops before any phase, as soon as the condition becomes true.
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
    const std::vector<Breakpoint> &all() const { return m_open.all; }
    const Breakpoint *find(int id) const;
    const Breakpoint *at(const CodePlace &place) const;

    /// Makes `key` the open step, with the breakpoints that it had when it was last open.
    void open(const QString &key);
    /// Sets a breakpoint at `place`, or removes the existing one. Returns whether there is one now.
    bool toggle(const CodePlace &place);
    /// Adds a breakpoint without a line. The caller must have checked `condition`.
    void add(const QString &condition);
    void setCondition(int id, const QString &condition);
    void setOn(int id, bool on);
    void remove(int id);
    /// Writes the new name of a body into the conditions of the open step.
    void renameBody(const QString &from, const QString &to);
    /// Moves the breakpoints in the listing of the open step with their lines, to where these are in `text`. A
    /// breakpoint whose line was deleted is removed.
    void followListing(const QString &text);

signals:
    void changed();

private:
    /// The breakpoints of a step, and the text of its listing that their lines belong to.
    struct OfStep
    {
        std::vector<Breakpoint> all;
        std::optional<QString> listing; ///< empty: not known yet
    };

    OfStep m_open;
    std::map<QString, OfStep> m_closed; ///< by step
    QString m_key;
    int m_last = 0; ///< the last id used
};

}
