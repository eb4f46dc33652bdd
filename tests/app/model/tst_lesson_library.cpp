#include "app/model/catalog/lesson_library.h"
#include "tests/app/support/files.h"
#include "tests/suite.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace app;

class TestLessonLibrary : public QObject
{
    Q_OBJECT

private slots:
    void everyLessonLoads()
    {
        const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
        QVERIFY(library.problems.empty());
        QCOMPARE(library.entries(), std::size_t(QDir(LESSON_DIR).entryList({"*.so"}).size()));
        for (std::size_t i = 1; i < library.lessons.size(); ++i)
            QVERIFY(library.lessons[i - 1].order <= library.lessons[i].order);
        const LessonEntry *first = library.lesson("single_spring");
        QVERIFY(first && first->step("radial") && !first->step("sideways"));
        QVERIFY(!library.lesson("double_spring"));
    }

    void sandboxIsNotListedAmongTheLessons()
    {
        const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
        QCOMPARE(library.lessons.size(), std::size_t(10));
        QCOMPARE(library.sandboxes.size(), std::size_t(1));
        QCOMPARE(library.lesson("sandbox"), &library.sandboxes.front());
        QCOMPARE(&library.entry(10), &library.sandboxes.front());
    }

    void aLessonIsOneFolderAndOneLine()
    {
        const LessonLibrary library = LessonLibrary::load({LESSON_DIR, FIXTURES "/lessons"});
        QVERIFY(library.problems.empty());
        QCOMPARE(library.lessons.back().id, "fixture");
        QCOMPARE(library.lessons.back().steps.front().id, "only");
    }

    void aBrokenLessonIsNamed_data()
    {
        QTest::addColumn<QString>("sentence");
        QTest::newRow("older_version")
            << "It is a lesson for another version of the program (org.springstep.Lesson/0, not "
               "org.springstep.Lesson/2); build it again for this one.";
        QTest::newRow("other_program")
            << "It is a plugin of another program (org.example.Filter/1); move it to another folder.";
        QTest::newRow("no_description")
            << "It is not a lesson that can be used: its description has no text \"id\".";
        QTest::newRow("other_steps")
            << "It is not a lesson that can be used: its description lists the steps "
               "\"only\", its code has \"only\", \"second\".";
        QTest::newRow("throws")
            << "It is not a lesson that can be used: its steps could not be created (no steps).";
        QTest::newRow("unknown_method") << "It is not a lesson that can be used: the step \"only\" needs the "
                                           "method \"guesswork\", which does not exist.";
    }
    void aBrokenLessonIsNamed()
    {
        QFETCH(QString, sentence);
        const LessonLibrary library = LessonLibrary::load({FIXTURES "/broken"});
        QVERIFY(library.lessons.empty());
        for (const LessonProblem &problem : library.problems) {
            if (problem.file.contains(QTest::currentDataTag())) {
                QCOMPARE(problem.why, sentence);
                return;
            }
        }
        QFAIL("the file is not among the problems");
    }

    void theRestLoadsBesideBrokenOnes()
    {
        const LessonLibrary library = LessonLibrary::load({FIXTURES "/broken", LESSON_DIR});
        QCOMPARE(library.problems.size(), std::size_t(6));
        QVERIFY(library.lesson("single_spring"));
    }

    void aFileThatIsNoPluginIsNamed_data()
    {
        const QString plugin = QDir(LESSON_DIR).filePath("liblesson_single_spring.so");
        const QByteArray whole = tests::contentsOf(plugin);
        QVERIFY(whole.size() > 1000);
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("text") << QByteArray("not a library");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("the first bytes of a plugin") << whole.left(64);
        for (const int bytes : {500, 1000, 5000, 20000, 60000}) // what is loaded is longer; symbols follow it
            QTest::addRow("the first %d bytes of a plugin", bytes) << whole.left(bytes);
        QTest::newRow("a library without a plugin")
            << tests::contentsOf(QString(LESSON_DIR) + "/../libsim.so");
    }
    void aFileThatIsNoPluginIsNamed()
    {
        QFETCH(QByteArray, content);
        const QTemporaryDir folder;
        tests::writeFile(folder.filePath("libhalf.so"), content);
        const LessonLibrary library = LessonLibrary::load({folder.path()});
        QVERIFY(library.lessons.empty());
        QCOMPARE(library.problems.size(), std::size_t(1));
        QCOMPARE(QFileInfo(library.problems.front().file).fileName(), "libhalf.so");
        QCOMPARE(library.problems.front().why,
                 "It is not a plugin, or it is damaged; install it again, or move it to another folder.");
    }

    void otherFilesAndFoldersAreNoProblem()
    {
        const QTemporaryDir folder;
        tests::writeFile(folder.filePath("README.txt"), "read me");
        QVERIFY(QDir(folder.path()).mkdir("folder.so"));
        const LessonLibrary library = LessonLibrary::load({folder.path(), folder.filePath("nowhere"), ""});
        QVERIFY(library.lessons.empty() && library.problems.empty());
    }

    void firstOfTwoLessonsWithOneIdIsUsed()
    {
        const QTemporaryDir folder;
        QVERIFY(QFile::copy(QDir(LESSON_DIR).filePath("liblesson_single_spring.so"),
                            folder.filePath("libcopy.so")));
        const LessonLibrary library = LessonLibrary::load({LESSON_DIR, folder.path(), LESSON_DIR});
        QVERIFY(library.problems.empty());
        QCOMPARE(library.entries(), std::size_t(QDir(LESSON_DIR).entryList({"*.so"}).size()));
    }

    void foldersComeFromTheEnvironmentFirst()
    {
        const QByteArray before = qgetenv("SPRINGSTEP_LESSONS");
        qputenv("SPRINGSTEP_LESSONS", "/first:/second");
        const QStringList folders = LessonLibrary::folders();
        qputenv("SPRINGSTEP_LESSONS", before);
        QCOMPARE(folders.mid(0, 2), QStringList({"/first", "/second"}));
        QCOMPARE(folders.at(2), QCoreApplication::applicationDirPath() + "/lessons");
        QVERIFY(folders.at(3).endsWith("/springstep/lessons"));
    }
};

SUITE(tst_lesson_library, TestLessonLibrary)
#include "tst_lesson_library.moc"
