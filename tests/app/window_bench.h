#pragma once

#include "app/ui/scene/scene_view.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/notice.h"
#include "sim/run/script/composed_interval.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QTest>

/// What suites of files share: the real window on the real lessons, and hands for it.
namespace window_bench {

/// Settings of the suite's own.
inline void keepSettingsIn(const QString &folder)
{
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
}

struct Bench
{
    app::LessonLibrary library = app::LessonLibrary::load({LESSON_DIR});
    app::Theme theme{app::Scheme::light};
    app::Session session{library};
    app::MainWindow window;
    app::SceneView &view = *window.findChild<app::SceneView *>();
    app::Notice &notice = *window.findChild<app::Notice *>();

    explicit Bench(const char *lesson = "single_spring", const char *step = "fixed_centre",
                   app::StudyFunction study = sim::studyAccuracy)
        : window(session, theme, std::move(study))
    {
        theme.apply(*qApp);
        session.openStep(lesson, step);
        window.resize(1280, 800);
        window.show();
        QApplication::setActiveWindow(&window);
        view.setFocus();
        QCoreApplication::processEvents();
    }

    /// Drags a body by so many px of the screen, and lets go.
    void drag(const char *body, QPoint by)
    {
        const app::Picture picture = session.picture();
        const sim::Vec2 at = picture.state.positionOf(picture.interval->scene.find(body));
        const QPoint from = view.mapFromScene(at.x, at.y);
        QWidget *target = view.viewport();
        QTest::mousePress(target, Qt::LeftButton, {}, from);
        QMouseEvent move(QEvent::MouseMove, from + by, target->mapToGlobal(from + by), Qt::NoButton,
                         Qt::LeftButton, {});
        QApplication::sendEvent(target, &move);
        QTest::mouseRelease(target, Qt::LeftButton, {}, from + by);
    }

    /// Takes an answer of the notice, by mouse. False: it has none of this name.
    bool answer(const QString &text)
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

    void press(int key, Qt::KeyboardModifiers modifiers)
    {
        QTest::keyClick(&view, Qt::Key(key), modifiers);
        QCoreApplication::processEvents();
    }

    bool isMarked() const { return window.isWindowModified(); }
};

}
