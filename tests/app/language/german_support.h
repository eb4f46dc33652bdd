#pragma once

#include "tests/app/support/window_fixture.h"

namespace tests {

/// The window in German, or in the language of a code.
struct GermanWindow : WindowFixture
{
    explicit GermanWindow(QSize size = {1280, 800}, const QString &code = QStringLiteral("de"))
        : WindowFixture({.lesson = {}, .size = size, .language = code, .study = quickStudy})
    {
    }
};

}
