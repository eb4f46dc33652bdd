#pragma once

#include "app/model/text/language.h"
#include "tests/app/support/window_fixture.h"

#include <QTest>

namespace tests {

/// The window in the language of a code.
struct TranslatedWindow : WindowFixture
{
    explicit TranslatedWindow(const QString &code, QSize size = {1280, 800})
        : WindowFixture({.lesson = {}, .size = size, .language = code, .study = quickStudy})
    {
    }
};

/// Adds one row for each language that the program is translated into, with the column "language".
inline void addTranslatedLanguages()
{
    QTest::addColumn<QString>("language");
    for (const QString &code : app::Language::known()) {
        if (code != "en")
            QTest::newRow(qPrintable(code)) << code;
    }
}

}
