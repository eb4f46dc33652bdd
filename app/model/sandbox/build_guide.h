#pragma once

#include "app/model/sandbox/sandbox_editor.h"

namespace app {

/// A guide through the first build, one task at a time: a body with two feet that walks. The next task depends only on
/// the present scene. Undo therefore goes back one task, and the guide skips parts that exist already.
class BuildGuide : public QObject
{
    Q_OBJECT

public:
    /// The tasks, in order.
    enum class Step {
        footTool,
        body,
        leftFoot,
        rightFoot,
        chooseTool,
        foot,
        swing,
        ground,
        walls,
        play,
        watch,
        done
    };
    static constexpr int lastStep = static_cast<int>(Step::play) + 1; ///< number of clicks

    /// The arguments must outlive the guide.
    BuildGuide(const OpenRun &run, RunEditor &changes, const Playback &playback, SandboxEditor &editor,
               QObject *parent = nullptr);

    bool isOn() const { return m_isOn; }
    /// Starts the guide with a new scene. Undo restores the previous scene.
    void start();
    void leave();

    /// Returns the first unfinished task. Valid only while the guide is on.
    Step step() const;
    /// Returns the instructions, in one or two sentences.
    QString text() const;
    /// Returns the place where the next foot belongs, px.
    std::optional<sim::Vec2> place() const;
    /// Returns the indices of the points to click.
    std::vector<int> points() const;

    static constexpr double far = 100.0; ///< px that the body has to travel

signals:
    /// The guide was started or stopped, or its task changed.
    void changed();

private:
    void follow();
    /// Returns the body: the point that has feet, or else the first point.
    int body() const;
    /// Returns whether two feet of the body are to be on opposite sides of it.
    bool hasOppositeFeet() const;
    bool swings() const;
    bool hasChosenFoot() const;
    Step footStep() const;
    Step runStep() const;

    const OpenRun &m_run;
    RunEditor &m_changes;
    const Playback &m_playback;
    SandboxEditor &m_editor;
    bool m_isOn = false;
    bool m_hasWalked = false; ///< all tasks are done: the guide ends when the learner goes back to the start
    QString m_shown;          ///< the last instructions
};

}
