#pragma once

#include "app/model/blueprint_edits.h"
#include "app/model/session.h"

#include <functional>

namespace app {

/// What a click in the picture does while a scene is built.
enum class BuildTool { select, point, nail, spring, stick, foot };

/// Returns whether the tool ties two points.
inline bool isLinkTool(BuildTool tool)
{
    return tool == BuildTool::spring || tool == BuildTool::stick || tool == BuildTool::foot;
}

/// The bench on which a learner builds the scene of a workshop: the tool in hand, what is chosen, and what is done
/// with both. Every deed is one entry to undo.
class Workbench : public QObject
{
    Q_OBJECT

public:
    explicit Workbench(Session &session, QObject *parent = nullptr);

    /// Whether a scene is open that is built.
    bool isOpen() const { return m_session.isWorkshop() && m_session.blueprint(); }
    /// Whether the choice is of what is built now. While a change is being told of, it may still be of what was before.
    bool isUpToDate() const { return isOpen() && m_seen == m_session.blueprint(); }
    /// Whether it can be changed now: it can at the start of the run, while that stands.
    bool canBuild() const;
    /// What is built. Only while it is open.
    const sim::Blueprint &plan() const { return *m_session.blueprint(); }

    BuildTool tool() const { return m_tool; }
    void setTool(BuildTool tool);
    const Chosen &chosen() const { return m_chosen; }
    void choose(Chosen chosen);
    /// Adds a part to what is chosen, or takes it away.
    void togglePoint(int point);
    void toggleSpring(int spring);
    void toggleStick(int stick);
    /// The end that a spring, stick or foot begins at, if one was given.
    std::optional<int> first() const { return m_first; }

    /// A click with the tool (not `select`), at `at` (px) on the point `hit`, or on none (-1).
    void use(sim::Vec2 at, int hit);
    /// One end of a drag: a place (px), and the point there, or -1.
    struct End
    {
        sim::Vec2 at;
        int hit = -1;
    };
    /// A drag with a spring, stick or foot: makes one link, with the points that it needs, as one entry to undo. A chain
    /// of clicks ends with it.
    void drag(End from, End to);
    /// Leaves what was begun: first a link, then the tool, then what is chosen. Returns whether there was any of it.
    bool leave();

    void moveChosen(sim::Vec2 by);
    void eraseChosen();
    void duplicateChosen();
    void chooseAll();
    /// Chooses the link after (or before) the chosen one, springs before sticks.
    void chooseNextLink(int step);
    void setEffect(const QString &id, bool present);
    bool has(const QString &effect) const;
    void addGaitFor(int foot);

    /// Changes the plan, as one deed called `what`; deeds in a row with the same gesture are one. Where a scene cannot be
    /// built now, that is said, and nothing changes. Returns whether it was changed.
    bool change(const QString &what, const std::function<void(sim::Blueprint &)> &edit,
                const QString &gesture = {});

signals:
    /// Tool, choice, or whether and what is built.
    void changed();
    /// Another scene stands in the place of the one that was built: an example, a new one, or what undo brought back.
    void replaced();

private:
    void follow();
    void followSelection();
    void shareChoice();
    /// Ties two points, of which those that are missing are added: one deed.
    void link(End from, End to);
    /// Adds a link of the tool's kind. Returns its number, if there was room.
    std::optional<int> addLink(sim::Blueprint &plan, int a, int b) const;
    /// `made`: the link that the scene was refused with; empty where there was no room for one.
    void sayWhyNoLink(int hit, std::optional<int> made);
    int pointAt(sim::Blueprint &plan, sim::Vec2 at, int hit) const;
    void useOnPoint(sim::Vec2 at, int hit);
    void sayFull();

    Session &m_session;
    BuildTool m_tool = BuildTool::select;
    Chosen m_chosen;
    std::optional<int> m_first;
    std::shared_ptr<const sim::Blueprint> m_seen; ///< what the choice is from
    bool m_couldBuild = false;
    bool m_isChanging = false; ///< what is built changes by a deed of the bench
    bool m_isSharing = false;  ///< the session is told what is chosen
};

}
