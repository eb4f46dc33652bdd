#pragma once

#include "app/ui/dialogs/notice.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/window/main_window.h"
#include "tests/app/support/session_fixture.h"
#include "tests/app/support/studies.h"
#include "tests/app/support/user_input.h"
#include "tests/app/support/waiting.h"

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QTest>

namespace tests {

/// How a WindowFixture opens. Accuracy and costs are not measured unless a test asks for it: that takes seconds.
struct WindowSetup
{
    QString lesson = QStringLiteral("single_spring"); ///< empty: the first step of the library
    QString step = QStringLiteral("fixed_centre");
    QSize size = {1280, 800};                       ///< empty: as the settings say
    std::optional<app::LessonLibrary> library = {}; ///< in place of the program's lessons
    QString language = {};                          ///< its code, for example "de"; empty: English
    app::Scheme scheme = app::Scheme::light;
    app::StudyFunction study = noStudy;
    app::CostFunction cost = noCost;
    QString codePage = QStringLiteral("engine"); ///< the page of the code; empty: as the settings say
};

/// The main window on the lessons of the program, shown and active, with the keyboard focus in the scene. Its functions
/// find parts of the window as a user names them, and do what a user does.
class WindowFixture : public SessionFixture
{
public:
    explicit WindowFixture(WindowSetup setup = {});

    // Parts of the window. The test ends if there is none of that name.
    QAction &action(const char *objectName) const;
    /// Returns the action with this text, without its mnemonic.
    QAction &actionCalled(const QString &text) const;
    QDockWidget &dock(const char *objectName) const;
    template <class Widget>
    Widget &part(const QString &objectName = {}) const
    {
        auto *found = window.findChild<Widget *>(objectName);
        return found ? *found : missing<Widget>(objectName);
    }
    /// Returns the first button whose accessible name begins so; null if there is none.
    QAbstractButton *button(const QString &accessibleName) const;
    /// Returns the names of the docks that are not hidden, sorted. Some of them may be tabs behind others.
    QStringList shownDocks() const;

    // The run
    std::int64_t frame() const { return session.timeline().cursor().frame; }
    int phase() const { return session.timeline().cursor().phase; }

    // User input
    /// Makes the window active again: a dialog that has closed does not do so without a window manager.
    void activate();
    /// Presses a key where the scene has the keyboard focus.
    void key(int key, Qt::KeyboardModifiers modifiers = {});
    /// Returns where a body is in the viewport of the scene, px.
    QPoint onScreen(const char *body) const;
    /// Drags a body by so many px of the screen.
    void drag(const char *body, QPoint by);
    /// Clicks the button of the notice with this text. Returns whether there is one.
    bool answer(const QString &text);

    // State that a user can see
    /// Returns whether the title has the mark of a run that is not saved.
    bool isMarked() const { return window.isWindowModified(); }
    QImage screenshot() { return window.grab().toImage(); }

    app::MainWindow window;
    app::SceneView &view = part<app::SceneView>();
    app::Notice &notice = part<app::Notice>();

private:
    [[noreturn]] static void failMissing(const char *type, const QString &name);
    template <class Part>
    [[noreturn]] static Part &missing(const QString &name)
    {
        failMissing(Part::staticMetaObject.className(), name);
    }
};

}
