#pragma once

#include "app/model/language.h"
#include "app/ui/window/main_window.h"
#include "tests/app/studies.h"

#include <QApplication>

/// What suites of the German window share.
namespace app {

/// The window, in German where nothing else is asked for.
struct German
{
    Language language;
    LessonLibrary library = LessonLibrary::load({LESSON_DIR}, &language);
    Theme theme{Scheme::light};
    Session session{library};
    MainWindow window{session, theme, quickStudy, noCost};

    explicit German(QSize size = {1280, 800}, const QString &code = "de") : language(code)
    {
        theme.apply(*qApp);
        window.setAttribute(Qt::WA_DontShowOnScreen);
        window.resize(size);
        window.show();
        QCoreApplication::processEvents();
    }
};

}
