#pragma once

#include "app/model/sandbox/blueprint_edits.h"
#include "app/model/sandbox/body_names.h"
#include "app/model/session/session.h"

#include <functional>

namespace app {

/// The action of a click in the view of a sandbox scene.
enum class BuildTool { select, point, nail, spring, stick, foot, ruleLink };

/// Returns whether the tool links two points.
inline bool isLinkTool(BuildTool tool)
{
    return tool == BuildTool::spring || tool == BuildTool::stick || tool == BuildTool::foot ||
           tool == BuildTool::ruleLink;
}

/// The editor of a sandbox scene: the current tool, the selection, and the edits. Each edit is one undo step.
class SandboxEditor : public QObject
{
    Q_OBJECT

public:
    explicit SandboxEditor(Session &session, QObject *parent = nullptr);

    /// Returns whether a sandbox scene is open.
    bool isOpen() const { return m_session.isSandbox() && m_session.editor().blueprint(); }
    /// Returns whether the selection belongs to the present scene. While a change is being announced, it may still
    /// belong to the previous one.
    bool isUpToDate() const { return isOpen() && m_seen == m_session.editor().blueprint(); }
    /// Returns whether the scene can be edited now, which requires the run to be at its start.
    bool canBuild() const;
    /// Returns the scene's plan. Valid only while a sandbox scene is open.
    const sim::Blueprint &plan() const { return *m_session.editor().blueprint(); }

    BuildTool tool() const { return m_tool; }
    void setTool(BuildTool tool);
    const Selection &chosen() const { return m_chosen; }
    void choose(Selection chosen);
    /// Adds each of `parts` to the selection, or removes it.
    void toggle(const Selection &parts);
    /// Returns the first end of the link or foot that was begun, if any.
    std::optional<int> first() const { return m_first; }

    /// Handles a click with the tool (not `select`) at `at` (px). `hit` is the point under the pointer, or -1.
    void use(sim::Vec2 at, int hit);
    /// One end of a drag: a place (px), and the point there, or -1.
    struct End
    {
        sim::Vec2 at;
        int hit = -1;
    };
    /// Handles a drag with a tool that links two points. It makes one link and any missing points, as one undo step.
    /// It also ends a chain of clicks.
    void drag(End from, End to);
    /// Cancels the innermost action: first an unfinished link, then the tool, then the selection. Returns whether there
    /// was one.
    bool leave();

    void moveChosen(sim::Vec2 by);
    void eraseChosen();
    void duplicateChosen();
    void chooseAll();
    /// Adds a rule link between each two of the selected points.
    void addRuleLinksAmongChosen();
    /// Selects the link after (or before) the selected one: springs, then sticks, then rule links.
    void chooseNextLink(int step);
    void setEffect(const QString &id, bool present);
    bool has(const QString &effect) const;
    void addGaitFor(int foot);
    /// Returns why the point cannot be called `name`, as a sentence; empty if it can.
    QString whyNotCalled(int point, const QString &name) const;
    /// Gives a point another name. The run and its branches stay the same, and so do conditions of breakpoints. If the
    /// point cannot have the name, a message says why. Returns whether it has it now.
    bool rename(int point, const QString &name);

    /// Changes the plan as one undo step with the title `what`. Consecutive edits with the same gesture are merged. If
    /// the scene cannot be edited now, a message says so and nothing changes. Returns whether the plan was changed.
    bool change(const QString &what, const std::function<void(sim::Blueprint &)> &edit,
                const QString &gesture = {});

signals:
    /// The tool, the selection, the plan, or whether it can be edited has changed.
    void changed();
    /// The scene was replaced by another one: an example, a new scene, or the result of undo.
    void replaced();
    /// A body has another name, also after Undo.
    void renamed(const QString &from, const QString &to);

private:
    void follow();
    void followSelection();
    void followRenaming(const Renaming &renaming);
    void shareChoice();
    /// Links two points, and adds missing ones, as one edit.
    void link(End from, End to);
    /// Adds a link of the tool's kind. Returns its index if there was room.
    std::optional<int> addLink(sim::Blueprint &plan, int a, int b) const;
    /// Explains why there is no link between the points `from` and `to`; -1: a new point. `made` is the link that made
    /// the scene invalid; empty if there was none.
    void reportWhyNoLink(int from, int to, std::optional<int> made);
    /// Returns whether the scene can be edited now; if not, a message says so.
    bool requireStart();
    int pointAt(sim::Blueprint &plan, sim::Vec2 at, int hit) const;
    void useOnPoint(sim::Vec2 at, int hit);
    void reportFull();

    Session &m_session;
    BuildTool m_tool = BuildTool::select;
    Selection m_chosen;
    std::optional<int> m_first;
    std::shared_ptr<const sim::Blueprint> m_seen; ///< the plan that the selection belongs to
    bool m_couldBuild = false;
    bool m_isChanging = false; ///< an edit of this editor is changing the plan
    bool m_isSharing = false;  ///< the selection is being sent to the session
};

}
