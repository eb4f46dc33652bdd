#pragma once

#include "app/model/session.h"
#include "app/ui/window/appearance.h"
#include "app/ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>

/// The whole window at 1920 x 1080, with the colours that were chosen.
namespace keyboard_bench {

using namespace app;

struct Bench
{
    LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Theme theme{keptScheme()};
    Session session{library};
    MainWindow window{session, theme};

    explicit Bench(const char *lesson = "gravity_walls", const char *step = "gravity")
    {
        theme.apply(*qApp);
        session.openStep(lesson, step);
        window.resize(1920, 1080);
        window.show();
        QApplication::setActiveWindow(&window);
        QCoreApplication::processEvents();
    }

    QAction *action(const char *name) const { return window.findChild<QAction *>(name); }
    QStringList docksSeen() const
    {
        QStringList seen;
        for (const QDockWidget *dock : window.findChildren<QDockWidget *>()) {
            if (dock->isVisible())
                seen << dock->objectName();
        }
        seen.sort();
        return seen;
    }
};

}
