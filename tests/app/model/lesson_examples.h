#pragma once

#include "app/model/lesson_folders/lesson_folder.h"
#include "app/model/text/user_error.h"
#include "tests/app/experiment/experiment_support.h"

/// The lessons without C++ that are installed as examples, and mistakes in them.
namespace lesson_examples {

using namespace app;

inline const QString examplesFolder = QStringLiteral(SOURCE_DIR "/lessons/examples/");
inline const QString pendulum = QStringLiteral("pendulum_clock");
inline const QString caterpillar = QStringLiteral("caterpillar");

/// Returns the files of an example.
inline const LessonFiles &filesOf(const QString &example)
{
    static std::map<QString, LessonFiles> all;
    const auto known = all.find(example);
    return known == all.end() ? all.emplace(example, readLessonFiles(examplesFolder + example)).first->second
                              : known->second;
}

/// Returns the files of the pendulum clock, in which one has `to` in place of `from`. None if it lacks `from`.
inline LessonFiles pendulumWith(const QString &file, const QByteArray &from, const QByteArray &to)
{
    LessonFiles files = filesOf(pendulum);
    QByteArray &content = files.all.at(file);
    const qsizetype at = content.indexOf(from);
    return at < 0 ? LessonFiles() : (content.replace(at, from.size(), to), files);
}

/// Returns the sentence of the mistake that `read` throws; empty if there is none.
template <class Read>
QString mistakeOf(const Read &read)
{
    try {
        read();
    } catch (const UserError &error) {
        return error.sentence();
    }
    return {};
}

inline void addMistakeColumns()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QString>("said");
}

/// Adds a row: `file` of the pendulum clock has `to` in place of `from`, and the error contains `said`.
inline void addMistake(const char *name, const char *file, const char *from, const QByteArray &to,
                       const char *said)
{
    QTest::newRow(name) << QString(file) << QByteArray(from) << to << QString::fromUtf8(said);
}

/// Returns the files of the lesson of a row. None if they lack its text.
inline LessonFiles mistakenFiles()
{
    QFETCH(QString, file);
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    return pendulumWith(file, from, to);
}

/// Fails unless the lesson of a row is refused with its sentence, which begins with the name of the lesson.
inline void checkMistake()
{
    QFETCH(QString, said);
    const LessonFiles files = mistakenFiles();
    QVERIFY(!files.all.empty());
    const QString mistake = mistakeOf([&] { lessonOf(files, "en", experiment_support::library()); });
    QVERIFY2(mistake.contains(said), qPrintable(mistake));
    QVERIFY2(mistake.startsWith(pendulum + '/'), qPrintable(mistake));
}

}
