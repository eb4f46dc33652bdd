// A lesson without C++ in a notebook: handed in with a run that uses its own parameter, and checked from the command line.

#include "tests/app/cli/program.h"
#include "tests/app/notebook/notebook_maker.h"

#include "app/model/files/whole_file.h"
#include "app/model/lesson_folders/lesson_folder.h"
#include "app/model/notebook/notebook_check.h"
#include "app/model/notebook/notebook_file.h"
#include "app/model/session/session.h"
#include "app/ui/notebook/hand_in_dialog.h"
#include "tests/suite.h"

#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

using namespace app;
using namespace tests;

namespace {

QString pathOfExample(const QString &id)
{
    return QStringLiteral(SOURCE_DIR "/lessons/examples/") + id;
}

/// Returns the lessons of the program with both examples under "Yours".
const LessonLibrary &withExamples()
{
    static const LessonLibrary all = [] {
        LessonLibrary library = allLessons();
        for (const char *id : {"pendulum_clock", "caterpillar"})
            library.yours.push_back(readLesson(pathOfExample(id), library));
        return library;
    }();
    return all;
}

/// Does the try "quarter" of the clock, whose parameter "wheel" the lesson declares, as its hint says.
void quarterThePush(Session &session)
{
    session.openStep("pendulum_clock", "clock");
    session.editor().setParameter("wheel", 0.025);
    session.input().grab("bob");
    for (int i = 1; i <= 10; ++i) {
        session.input().moveTo({270.0 + 4.0 * i, 300.0 - 0.4 * i});
        session.playback().frameForward();
    }
    session.input().release();
    session.playback().goTo({1201, 0});
    QTRY_VERIFY(!session.playback().goal()); // distant frames are computed in slices
    for (int i = 0; i < 300 && !session.progress().isDone("pendulum_clock", "clock", 2); ++i)
        session.playback().frameForward();
}

/// Returns the notebook of a learner who has done that, as the file that the dialog writes.
const QByteArray &handedIn()
{
    static const QByteArray text = [] {
        forgetRecords();
        Session session(withExamples());
        quarterThePush(session);
        if (!session.progress().isDone("pendulum_clock", "clock", 2))
            qFatal("the clock does not swing half as wide");
        const QTemporaryDir folder;
        HandInDialog dialog(withExamples(), session.progress(), session.notes(), session.proofs(), {});
        dialog.offer();
        dialog.findChild<QLineEdit *>("handInFile")->setText(folder.filePath("ada"));
        QTest::mouseClick(dialog.findChild<QPushButton *>("handInWrite"), Qt::LeftButton);
        QFile file(folder.filePath("ada.springstep-notebook"));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }();
    return text;
}

}

class NotebookOfYours : public QObject
{
    Q_OBJECT

private slots:
    void aRunWithAParameterOfTheLessonIsShown()
    {
        const Notebook book = parseNotebook(handedIn(), "ada", withExamples());
        QVERIFY(book.isSealed);
        QCOMPARE(book.entries.size(), std::size_t(1));
        const NotebookEntry &entry = book.entries.front();
        QCOMPARE(entry.lesson + '/' + entry.step + '/' + entry.id, QString("pendulum_clock/clock/quarter"));
        QVERIFY2(entry.run.text.contains("\"wheel\":0.025"), entry.run.text.constData());
        const NotebookFinding finding = *checkEntry(entry, withExamples());
        QVERIFY2(finding.result == NotebookFinding::Result::shown, qPrintable(finding.why));
    }

    void changedParameterValueIsDetected_data()
    {
        QTest::addColumn<QByteArray>("value");
        QTest::addColumn<QString>("why");
        QTest::newRow("as it begins") << QByteArray("0.1") << "does not do it";
        QTest::newRow("out of its range") << QByteArray("0.3") << "it can be 0 to 0.2";
    }
    void changedParameterValueIsDetected()
    {
        QFETCH(QByteArray, value);
        QFETCH(QString, why);
        NotebookEntry entry = parseNotebook(handedIn(), "ada", withExamples()).entries.front();
        entry.run.text.replace("\"wheel\":0.025", "\"wheel\":" + value);
        const NotebookFinding finding = *checkEntry(entry, withExamples());
        QVERIFY(finding.result == NotebookFinding::Result::notShown);
        QVERIFY2(finding.why.contains(why), qPrintable(finding.why));
    }

    void aTaskWhoseCodeReadsAParameterIsShown()
    {
        Record record;
        const lessons::Step &step = *withExamples().lesson("caterpillar")->step("pair");
        record.progress.markWritten("caterpillar", step.id, "pull");
        record.proofs.keep(
            Notes::keyOf("caterpillar", step.id, "code", "pull"),
            {.code = step.listing.with("pull", "double more = length(gap) - 80;\n"
                                               "Vec2 pull = more * k / length(gap) * gap;\n")});
        const Notebook book = collectNotebook({.lessons = {"caterpillar"}}, withExamples(), record.progress,
                                              record.notes, record.proofs);
        QCOMPARE(book.entries.size(), std::size_t(1));
        const NotebookFinding finding = *checkEntry(book.entries.front(), withExamples());
        QVERIFY2(finding.result == NotebookFinding::Result::shown, qPrintable(finding.why));
    }

    void theCommandLineTakesTheLessonBesideTheNotebook()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("ada.springstep-notebook"),
                      clock = pathOfExample("pendulum_clock");
        writeWholeFile(file, handedIn());
        const program::Answer checked = program::springstep({"notebook", "check", clock, file});
        QVERIFY2(checked.code == 0 && checked.err.isEmpty(), qPrintable(checked.out + checked.err));
        QVERIFY2(checked.out.simplified().contains("pendulum_clock/clock try quarter shown"),
                 qPrintable(checked.out));
        const program::Answer without = program::springstep({"notebook", "check", file});
        QCOMPARE(without.code, 2);
        QVERIFY2(without.err.contains("there is no lesson \"pendulum_clock\"") &&
                     without.err.contains(
                         "If it is a lesson without C++, name its folder or its zip beside the notebook."),
                 qPrintable(without.err));
        const program::Answer alone = program::springstep({"notebook", "check", clock});
        QCOMPARE(alone.code, 2);
        QVERIFY2(alone.err.contains("notebook check takes FILE...;"), qPrintable(alone.err));
    }
};

SUITE(tst_notebook_of_yours, NotebookOfYours)
#include "tst_notebook_of_yours.moc"
