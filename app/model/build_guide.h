#pragma once

#include "app/model/workbench.h"

namespace app {

/// A first build, one thing at a time: a body with two feet that walks. Which thing is next follows from the scene as it
/// is, not from what was done before: undoing goes back a step, and what is there already is not asked for.
class BuildGuide : public QObject
{
    Q_OBJECT

public:
    /// What is asked for, in order.
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
    static constexpr int lastStep = static_cast<int>(Step::play) + 1; ///< so many clicks

    /// Both must outlive it.
    BuildGuide(Session &session, Workbench &bench, QObject *parent = nullptr);

    bool isOn() const { return m_isOn; }
    /// Begins, with a new scene: undo brings back what was there.
    void start();
    void leave();

    /// The first thing that is not done. Only while it is on.
    Step step() const;
    /// Returns what to do, in one or two sentences.
    QString text() const;
    /// Returns the place where a foot is asked for, px.
    std::optional<sim::Vec2> place() const;
    /// Returns the points to click, by number.
    std::vector<int> points() const;

    static constexpr double far = 100.0; ///< px that the body has to travel

signals:
    /// Whether it is on, or what it asks for.
    void changed();

private:
    void follow();
    /// The body: the point that has feet, or the first that there is.
    int body() const;
    /// Whether two feet of the body belong on opposite sides of it.
    bool hasOppositeFeet() const;
    bool swings() const;
    bool hasChosenFoot() const;
    Step footStep() const;
    Step runStep() const;

    Session &m_session;
    Workbench &m_bench;
    bool m_isOn = false;
    bool m_hasWalked = false; ///< all is done: it ends when the learner goes back to the start
    QString m_shown;          ///< what it asked for last
};

}
