#pragma once

#include "app/model/session/session.h"
#include "app/ui/window/main_window.h"
#include "tests/lessons/support/player.h"

#include <QPoint>

class QAbstractButton;
class QMenu;

namespace app {

class SceneView;

}

namespace support {

/// Lets the window paint, and delete the widgets that it has replaced.
void settle();

/// A learner who uses the window with the mouse and the keys only.
class Learner : public Player
{
public:
    explicit Learner(app::Session &session, app::MainWindow &window);

    /// The thing to try of the open step that is looked at; begins the step afresh.
    void begin(std::size_t number);

    // Reading
    /// Clicks a lesson in the list of lessons.
    void openLesson(const QString &title);
    /// Clicks a step of the open lesson.
    void openStep(const QString &title);
    QString narration() const;
    /// Asks for all hints, and returns what they say.
    QStringList hints();
    /// Unfolds all why-boxes, and returns the answers.
    QStringList answers();
    /// Returns whether a thing to try shows its tick.
    bool sees(std::size_t number) const;
    void pressNext();

    void play(int frames) override;
    void grab(const std::string &body) override;
    void movePointer(sim::Vec2 to) override;
    void release() override;
    void point(sim::Vec2 at, bool down) override;
    void target(sim::Vec2 at) override;
    void key(bool sim::Keys::*key, bool down) override;
    void set(const std::string &parameter, double value) override;
    void useMethod(const std::string &id) override;
    void useStep(double h) override;
    void useTolerance(double tolerance) override;
    void useTiming(lessons::TimeMeasurement timing) override;
    void goTo(std::int64_t frame) override;
    void stepPhases(int count) override;

    bool done() const override;
    const sim::Timeline &run() const override { return m_session.timeline(); }

private:
    void openRow(const QString &title, const QModelIndex &parent);
    QPoint onScreen(sim::Vec2 place) const;
    /// The same for where the hand goes: a learner does not know what is outside of the picture.
    QPoint inPicture(sim::Vec2 place) const;
    int bodyAt(QPoint place) const;
    QPoint freePlaceNear(QPoint place) const;
    void press(QPoint place);
    void move(QPoint place);
    void releaseButton();
    /// leavePicture() is called before the mouse is used elsewhere, comeBack() after a menu or a list was open.
    void leavePicture();
    void comeBack();
    void bringIntoView(const std::string &body);
    void step(bool byPhase);
    void playInTime(int frames);
    void look();
    /// Opens the menu of the button whose name begins with `name`, and lets `choose` have it.
    void inMenu(const QString &name, const std::function<void(QMenu &)> &choose);
    void chooseStep(double value, bool isTolerance);
    void chooseFrom(QWidget &field, int row);
    /// The button of `part` that is called `name`. @throws std::runtime_error without one
    QAbstractButton &button(const QWidget *part, const QString &name) const;

    app::Session &m_session;
    app::MainWindow &m_window;
    app::SceneView &m_view;
    std::size_t m_number = 0;
    QPoint m_pointer; ///< of the mouse, in the picture
    bool m_isDown = false;
    sim::Keys m_keys;
    int m_unseen = 0; ///< frames since the picture was painted
};

}
