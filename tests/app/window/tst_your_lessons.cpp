// Lessons without C++ in the real window: opened, followed while they are written, begun with a scene.

#include "tests/app/support/files.h"
#include "tests/app/support/window_fixture.h"

#include "app/model/files/recent_files.h"
#include "app/model/lesson_folders/lesson_package.h"
#include "app/model/lesson_folders/your_lessons.h"
#include "app/ui/learn/lessons/lesson_desk.h"
#include "app/ui/learn/lessons/lesson_list.h"
#include "app/ui/learn/lessons/lesson_model.h"
#include "app/ui/learn/words/glossary_page.h"
#include "app/ui/map/concept_button.h"
#include "app/ui/map/map_page.h"
#include "app/ui/parameters/number_box.h"
#include "app/ui/parameters/parameter_row.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/app/support/zip_writer.h"
#include "tests/suite.h"

#include <QDesktopServices>
#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMimeData>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QTimer>

using namespace app;
using namespace tests;

namespace {

const QString clockLesson = QStringLiteral("pendulum_clock");

/// The lessons of the program, loaded once.
LessonLibrary programLessons()
{
    static const LessonLibrary lessons = LessonLibrary::load({LESSON_DIR});
    return lessons;
}

/// The window with lessons of the learner.
struct YoursFixture : WindowFixture
{
    explicit YoursFixture(const QString &lesson = "single_spring", const QString &step = "fixed_centre")
        : WindowFixture({.lesson = lesson, .step = step, .library = programLessons()}), yours(library)
    {
        desk.setLessons(yours);
    }
    void dropFile(const QString &path)
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window, &enter);
        QDropEvent event(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window, &event);
        QCoreApplication::processEvents();
    }
    /// Returns the texts of the rows of the lesson list.
    QStringList rows() const
    {
        QStringList texts;
        for (int row = 0; row < list.model()->rowCount(); ++row)
            texts << list.model()->index(row, 0).data().toString();
        return texts;
    }
    void clickRow(const QString &text)
    {
        const QModelIndex index = list.model()->index(static_cast<int>(rows().indexOf(text)), 0);
        list.scrollTo(index);
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(index).center());
        QCoreApplication::processEvents();
    }

    /// Begins a new lesson in a folder, with the dialog.
    void beginLesson(const QString &folder)
    {
        QTimer::singleShot(0, qApp, [&folder] {
            auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            auto *name = dialog->findChild<QLineEdit *>("fileNameEdit");
            name->setText(folder);
            QTest::keyClick(name, Qt::Key_Return);
        });
        desk.begin().trigger();
    }
    ParameterRow &row(const QString &id) const { return *rowOf(part<ParameterPanel>(), id); }

    YourLessons yours;
    LessonDesk &desk = part<LessonDesk>();
    LessonList &list = part<LessonList>();
};

/// A copy of an installed example, which the tests write into.
struct LessonCopy
{
    LessonCopy()
    {
        const QDir from(QStringLiteral(SOURCE_DIR "/lessons/examples/") + clockLesson);
        QDir().mkpath(path);
        for (const QString &file : from.entryList(QDir::Files))
            QFile::copy(from.filePath(file), at(file));
        for (const QString &file : QDir(path).entryList(QDir::Files))
            QFile::setPermissions(at(file), QFile::ReadOwner | QFile::WriteOwner);
    }
    QString at(const QString &file) const { return path + '/' + file; }
    QByteArray read(const QString &file) const { return contentsOf(at(file)); }
    void write(const QString &file, const QByteArray &text) const { writeFile(at(file), text); }

    QTemporaryDir folder;
    QString path = QFileInfo(folder.path()).canonicalFilePath() + '/' + clockLesson;
};

}

class YourLessonsTest : public QObject
{
    Q_OBJECT

public slots:
    void takeUrl(const QUrl &url) { m_url = url; }

private slots:
    void cleanup() { QSettings().clear(); }
    void aZipIsOpenedAndListedAndRemembered();
    void missingLessonIsForgottenWithAMessage();
    void mistakeIsReportedAndTheLastGoodStateStays();
    void aSavedLessonReloadsAtTheSameStepAndFrame();
    void aNewLessonBeginsWithTheSceneOfTheSandbox();
    void aNewLessonBeginsWithASceneOfYours();
    void aParameterIsARowThatFollowsItsFile();
    void theWordsAndTheMapFollow();
    void aLessonIsTakenOutOfTheListAndPutBack();

private:
    QUrl m_url;
};

void YourLessonsTest::aZipIsOpenedAndListedAndRemembered()
{
    const LessonCopy copy;
    const QString path = copy.at("lesson.springstep-lesson");
    tests::writeFile(path, tests::zipOf(readLessonFiles(copy.path).all));
    YoursFixture fixture;
    QVERIFY(!fixture.rows().contains("Yours"));
    fixture.session.editor().setParameter("k", 0.3); // nothing of it is lost, so nothing is asked
    fixture.dropFile(path);
    QCOMPARE(fixture.notice.sentence(), QString());
    QCOMPARE(fixture.session.lesson().id, clockLesson);
    QCOMPARE(fixture.session.step().id, QString("swing"));
    const QString title = fixture.session.lesson().title;
    const QStringList rows = fixture.rows();
    QCOMPARE(rows.indexOf(title), rows.indexOf("Yours") + 1);
    QVERIFY(rows.indexOf("Yours") > 0);
    QCOMPARE(recentFiles().value(0), path);

    fixture.clickRow(rows.front());
    QCOMPARE(fixture.session.lesson().id, QString("single_spring"));
    fixture.session.openStep("single_spring", "fixed_centre");
    QCOMPARE(fixture.session.editor().parameter("k"), 0.3);
    fixture.clickRow(title);
    QCOMPARE(fixture.session.lesson().id, clockLesson);

    LessonLibrary next = programLessons();
    const YourLessons again(next);
    QVERIFY(next.lesson(clockLesson));
    QCOMPARE(again.mistake() + again.farewell(), QString());
}

void YourLessonsTest::missingLessonIsForgottenWithAMessage()
{
    LessonLibrary library = programLessons();
    {
        const LessonCopy copy;
        YourLessons(library).open(copy.path);
    }
    LessonLibrary next = programLessons();
    const YourLessons yours(next);
    QVERIFY2(yours.farewell().contains(clockLesson), qPrintable(yours.farewell()));
    QVERIFY(next.yours.empty());
    QCOMPARE(YourLessons(next).farewell(), QString()); // it is told once
}

void YourLessonsTest::mistakeIsReportedAndTheLastGoodStateStays()
{
    const LessonCopy copy;
    const QByteArray scene = copy.read("two.json"), text = copy.read("swing.md");
    copy.write("two.json", "{");
    YoursFixture fixture;
    fixture.dropFile(copy.path);
    QVERIFY2(fixture.notice.sentence().contains("pendulum_clock/two.json"),
             qPrintable(fixture.notice.sentence()));
    QCOMPARE(fixture.session.step().id, QString("fixed_centre"));
    QVERIFY(!fixture.rows().contains("Yours"));

    copy.write("two.json", scene);
    fixture.dropFile(copy.at("lesson.json"));
    QCOMPARE(fixture.notice.sentence(), QString());
    QCOMPARE(recentFiles().value(0), copy.path);
    fixture.goTo(20);
    const QString title = fixture.session.step().title;
    copy.write("swing.md", "# Half\n\n## Tri\n\n" + text);
    QTRY_VERIFY(fixture.notice.sentence().contains("pendulum_clock/swing.md"));
    QCOMPARE(fixture.session.step().title, title);
    QCOMPARE(fixture.frame(), 20);
    copy.write("swing.md", text);
    QTRY_COMPARE(fixture.notice.sentence(), QString());
    QCOMPARE(fixture.session.step().title, title);
}

void YourLessonsTest::aSavedLessonReloadsAtTheSameStepAndFrame()
{
    const LessonCopy copy;
    YoursFixture fixture;
    fixture.dropFile(copy.path);
    fixture.goTo(30);
    fixture.session.openStep(clockLesson, "two");
    fixture.goTo(40);
    const auto isWhereItWas = [&] {
        return fixture.session.step().id == "two" && fixture.frame() == 40 && !fixture.isMarked();
    };
    const auto hasOwnValues = [&] {
        return fixture.session.timeline().script().values.all() ==
               fixture.session.step().script().values.all();
    };
    const sim::State state = fixture.session.timeline().state();
    copy.write("two.md", copy.read("two.md").replace("# Half the time", "# Another title"));
    QTRY_VERIFY(fixture.window.windowTitle().contains("Another title"));
    QVERIFY(isWhereItWas() && sim::sameBits(fixture.session.timeline().state(), state));

    for (const char *file : {"swing.json", "two.json"})
        copy.write(file, copy.read(file).replace("\"gravity\": 0.3", "\"gravity\": 0.2"));
    QTRY_VERIFY(!sim::sameBits(fixture.session.timeline().state(), state) && isWhereItWas());
    QVERIFY(hasOwnValues());

    copy.write("more.json", copy.read("two.json"));
    copy.write("more.md", copy.read("two.md"));
    QTRY_VERIFY(fixture.notice.sentence().contains("more")); // no step yet
    copy.write("lesson.json", copy.read("lesson.json").replace("[\"swing\"", "[\"more\", \"swing\""));
    QTRY_COMPARE(fixture.session.lesson().steps.size(), std::size_t(4));
    QTRY_COMPARE(fixture.notice.sentence(), QString());
    QVERIFY(isWhereItWas());
    const LessonModel &model = fixture.list.lessons();
    QCOMPARE(model.rowCount(model.openLesson()), 5); // with the summary
    QCOMPARE(fixture.list.currentIndex(), model.openRow());

    fixture.session.openStep(clockLesson, "swing"); // which was left with its old scene
    QVERIFY(hasOwnValues());
}

void YourLessonsTest::aNewLessonBeginsWithTheSceneOfTheSandbox()
{
    const QTemporaryDir folder;
    const QString path = QFileInfo(folder.path()).canonicalFilePath() + "/first_try";
    QDesktopServices::setUrlHandler("file", this, "takeUrl");
    YoursFixture fixture("sandbox", "build");
    fixture.beginLesson(path);
    QDesktopServices::unsetUrlHandler("file");
    QCOMPARE(fixture.notice.sentence(), QString());
    QCOMPARE(m_url, QUrl::fromLocalFile(path));
    QCOMPARE(fixture.session.lesson().id, QString("first_try"));
    QCOMPARE(fixture.session.step().id, QString("first"));
    QVERIFY(!fixture.session.step().tries.empty());
    QVERIFY(fixture.desk.begin().isEnabled());
}

void YourLessonsTest::aNewLessonBeginsWithASceneOfYours()
{
    const LessonCopy copy;
    const QTemporaryDir folder;
    const QString path = QFileInfo(folder.path()).canonicalFilePath() + "/second_clock";
    QDesktopServices::setUrlHandler("file", this, "takeUrl");
    YoursFixture fixture;
    fixture.dropFile(copy.path);
    fixture.session.openStep(clockLesson, "clock");
    fixture.session.editor().setParameter("wheel", 0.15);
    fixture.beginLesson(path);
    QDesktopServices::unsetUrlHandler("file");
    QCOMPARE(fixture.notice.sentence(), QString());
    QCOMPARE(fixture.session.lesson().id, QString("second_clock"));
    QCOMPARE(fixture.session.step().parameter("wheel")->defaultValue, 0.15);
    QCOMPARE(fixture.session.step().parameter("damp")->defaultValue, 0.998);

    fixture.session.openStep(clockLesson, "clock");
    copy.write("clock.json", "{");
    QTRY_VERIFY(!fixture.notice.sentence().isEmpty());
    fixture.notice.showMessage({});
    fixture.beginLesson(path + "_again");
    QVERIFY2(fixture.notice.sentence().contains("pendulum_clock/clock.json"),
             qPrintable(fixture.notice.sentence()));
    QVERIFY(!QFileInfo::exists(path + "_again"));
}

void YourLessonsTest::aParameterIsARowThatFollowsItsFile()
{
    const LessonCopy copy;
    YoursFixture fixture;
    fixture.dropFile(copy.path);
    fixture.session.openStep(clockLesson, "clock");
    typeInto(*fixture.row("wheel").findChild<NumberBox *>(), "0.05");
    QCOMPARE(fixture.session.editor().parameter("wheel"), 0.05);
    fixture.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(fixture.session.editor().parameter("wheel"), 0.1);
    fixture.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(fixture.session.editor().parameter("wheel"), 0.05);
    fixture.goTo(40);
    const sim::State state = fixture.session.timeline().state();

    copy.write("clock.md", copy.read("clock.md").replace("Parameter: Push", "Parameter: Kick"));
    QTRY_COMPARE(fixture.row("wheel").parameter().name, QString("Kick"));
    QCOMPARE(fixture.session.editor().parameter("wheel"), 0.05); // the run is the same
    QVERIFY(fixture.frame() == 40 && sim::sameBits(fixture.session.timeline().state(), state));

    copy.write("clock.md", copy.read("clock.md").replace("value: 0.1\n", "value: 0.3\n"));
    QTRY_VERIFY(fixture.notice.sentence().contains("outside its range from 0 to 0.2."));
    QCOMPARE(fixture.row("wheel").parameter().max, 0.2);
    copy.write("clock.md", copy.read("clock.md").replace("maximum: 0.2", "maximum: 0.4"));
    QTRY_COMPARE(fixture.row("wheel").parameter().max, 0.4);
    QTRY_COMPARE(fixture.notice.sentence(), QString());
    QCOMPARE(fixture.session.editor().parameter("wheel"), 0.3);
    QCOMPARE(fixture.frame(), 40);

    fixture.session.editor().setParameter("wheel", 0.15);
    fixture.key(Qt::Key_B, Qt::ControlModifier);
    QVERIFY(fixture.session.isSandbox());
    QVERIFY2(fixture.session.rule().text().contains("return Vec2(-0.15, 0);"),
             qPrintable(fixture.session.rule().text()));
    QVERIFY(fixture.session.rule().isActing() && fixture.session.rule().mistakes().empty());
}

void YourLessonsTest::theWordsAndTheMapFollow()
{
    const LessonCopy copy;
    YoursFixture fixture;
    fixture.actionCalled("Glossary").trigger();
    fixture.actionCalled("Map of concepts").trigger();
    const auto &words = *fixture.part<GlossaryPage>().findChild<QTextBrowser *>();
    const auto explains = [&words](const char *word) { return words.toPlainText().contains(word); };
    const auto node = [&fixture] {
        return fixture.part<MapPage>().findChild<ConceptButton *>("limit_swing");
    };
    QVERIFY(!explains("Escapement") && !node());

    fixture.dropFile(copy.path); // opened
    QVERIFY(explains("Escapement") && node());
    fixture.session.openStep(clockLesson, "clock");
    copy.write("clock.md", copy.read("clock.md")
                               .replace("## Word: Escapement", "## Word: Anchor")
                               .replace("{#limit_swing}", "{#own_swing}"));
    QTRY_VERIFY(explains("Anchor")); // changed
    QVERIFY(!explains("Escapement") && !node());
    QVERIFY(fixture.part<MapPage>().findChild<ConceptButton *>("own_swing"));

    fixture.desk.forget().trigger(); // removed
    QVERIFY(!explains("Anchor"));
    QVERIFY(!fixture.part<MapPage>().findChild<ConceptButton *>("own_swing"));
}

void YourLessonsTest::aLessonIsTakenOutOfTheListAndPutBack()
{
    const LessonCopy copy;
    YoursFixture fixture;
    QVERIFY(!fixture.desk.forget().isEnabled()); // a lesson of the program is open
    fixture.dropFile(copy.path);
    fixture.goTo(20);
    fixture.key(Qt::Key_Delete, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!fixture.rows().contains("Yours"));
    QCOMPARE(fixture.session.lesson().id, fixture.library.lessons.front().id);
    QVERIFY(QFileInfo::exists(copy.at("lesson.json")));
    LessonLibrary next = programLessons();
    QCOMPARE(YourLessons(next).farewell(), QString());
    QVERIFY(next.yours.empty());
    QVERIFY(fixture.answer("Put it back"));
    QCOMPARE(fixture.session.lesson().id, clockLesson);
    QVERIFY(fixture.rows().contains("Yours"));
    QVERIFY(fixture.desk.forget().isEnabled());
}

SUITE(tst_your_lessons, YourLessonsTest)
#include "tst_your_lessons.moc"
