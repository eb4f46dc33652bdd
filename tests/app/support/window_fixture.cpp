#include "tests/app/support/window_fixture.h"

#include "app/ui/code/code_pages.h"
#include "sim/run/script/composed_interval.h"

#include <QApplication>
#include <QPushButton>
#include <QSettings>

using namespace app;

namespace tests {

namespace {

Lessons lessonsOf(WindowSetup &setup)
{
    if (!setup.codePage.isEmpty())
        QSettings().setValue(CodePages::pageKey, setup.codePage); // the window reads it when it is made
    Lessons lessons;
    if (!setup.language.isEmpty())
        lessons.language = std::make_unique<Language>(setup.language);
    lessons.library =
        setup.library ? std::move(*setup.library) : LessonLibrary::load({LESSON_DIR}, lessons.language.get());
    return lessons;
}

}

WindowFixture::WindowFixture(WindowSetup setup)
    : SessionFixture(lessonsOf(setup), setup.scheme),
      window(session, theme, std::move(setup.study), std::move(setup.cost))
{
    session.openStep(setup.lesson, setup.step);
    if (!setup.size.isEmpty())
        window.resize(setup.size);
    window.show();
    activate();
    view.setFocus();
    settle();
}

void WindowFixture::activate()
{
    window.activateWindow();
    if (!QTest::qWaitForWindowActive(&window))
        qFatal("the window does not become active");
}

void WindowFixture::failMissing(const char *type, const QString &name)
{
    qFatal("the window has no %s \"%s\"", type, qPrintable(name));
}

QAction &WindowFixture::action(const char *objectName) const
{
    return part<QAction>(objectName);
}

QAction &WindowFixture::actionCalled(const QString &text) const
{
    for (QAction *one : window.findChildren<QAction *>()) {
        if (one->text().remove('&') == text)
            return *one;
    }
    return missing<QAction>(text);
}

QDockWidget &WindowFixture::dock(const char *objectName) const
{
    return part<QDockWidget>(objectName);
}

QAbstractButton *WindowFixture::button(const QString &accessibleName) const
{
    for (QAbstractButton *one : window.findChildren<QAbstractButton *>()) {
        if (one->accessibleName().startsWith(accessibleName))
            return one;
    }
    return nullptr;
}

QStringList WindowFixture::shownDocks() const
{
    QStringList names;
    for (const QDockWidget *one : window.findChildren<QDockWidget *>()) {
        if (!one->isHidden())
            names << one->objectName();
    }
    names.sort();
    return names;
}

void WindowFixture::key(int key, Qt::KeyboardModifiers modifiers)
{
    QTest::keyClick(&view, Qt::Key(key), modifiers);
    QCoreApplication::processEvents();
}

QPoint WindowFixture::onScreen(const char *body) const
{
    const Picture picture = session.presentation().picture();
    const sim::Vec2 at = picture.state.positionOf(picture.interval->scene.find(body));
    return view.mapFromScene(at.x, at.y);
}

void WindowFixture::drag(const char *body, QPoint by)
{
    dragMouse(*view.viewport(), onScreen(body), by);
}

bool WindowFixture::answer(const QString &text)
{
    for (QPushButton *button : notice.findChildren<QPushButton *>()) {
        if (button->text() != text || !button->isVisible())
            continue;
        QTest::mouseClick(button, Qt::LeftButton);
        QCoreApplication::processEvents();
        return true;
    }
    return false;
}

}
