#pragma once

#include "app/model/experiment/experiment.h"

#include <QTest>

/// Shared by the suites that read bad experiments.
namespace user_errors {

inline const app::LessonLibrary &allLessons()
{
    static const app::LessonLibrary library = app::LessonLibrary::load({LESSON_DIR});
    return library;
}

/// Returns the error that reading `text` as a file x.json gives; empty if it is accepted.
inline QString errorOf(const QByteArray &text)
{
    try {
        app::parseExperiment(text, "x.json", allLessons());
        return {};
    } catch (const app::UserError &error) {
        return error.sentence();
    }
}

/// An experiment of the step with any number of feet; `fields` begin on line 5.
inline QByteArray with(const QByteArray &fields)
{
    return "{\n\"format\": \"springstep-experiment/1\",\n\"lesson\": \"multi_foot\",\n\"step\": "
           "\"any_number\",\n" +
           fields + "\n}\n";
}

/// The columns of a row: a text, and the sentence that it is refused with, without the file's name.
inline void addColumns()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("sentence");
}

inline void checkRow()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, sentence);
    QCOMPARE(errorOf(text), "x.json: " + sentence);
}

}
