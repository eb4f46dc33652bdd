// Experiments as files and as text, in the real window.

#include "tests/app/support/window_fixture.h"

#include "app/model/experiment/experiment_line.h"
#include "app/model/files/recent_files.h"
#include "tests/suite.h"

#include <QClipboard>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>

using namespace app;
using namespace tests;

namespace {

constexpr auto ctrl = Qt::ControlModifier;
constexpr auto ctrlShift = Qt::ControlModifier | Qt::ShiftModifier;

/// The menu of recent files, as it opens.
QList<QAction *> recentIn(const WindowFixture &fixture)
{
    for (QMenu *menu : fixture.window.findChildren<QMenu *>()) {
        if (menu->title() != "Open &recent")
            continue;
        emit menu->aboutToShow();
        return menu->actions();
    }
    return {};
}

void drop(QWidget &target, const QList<QUrl> &urls)
{
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&target, &enter);
    QDropEvent event(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&target, &event);
    QCoreApplication::processEvents();
}

/// Answers the next box that asks, by its button.
void answerBox(QMessageBox::StandardButton button, QString *asked)
{
    QTimer::singleShot(0, qApp, [button, asked] {
        auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
        QVERIFY(box);
        *asked = box->text();
        QTest::mouseClick(box->button(button), Qt::LeftButton);
    });
}

}

class FilesTest : public QObject
{
    Q_OBJECT

private slots:
    void theTitleHasAMarkWhileTheRunIsNotSaved();
    void aRunThatIsKeptIsSavedAndOpenedWithTheFile();
    void goingOnToAnotherStepKeepsEachStepsFile();
    void aNameWithoutAnEndingIsOneOfAnExperiment();
    void newIsTheStepAsPublishedAndUndoBringsItBack();
    void openingAFileAsksAboutUnsavedChanges();
    void escapeCancelsTheQuestion();
    void aDroppedFileIsOpenedWhereverItFalls_data();
    void aDroppedFileIsOpenedWhereverItFalls();
    void twoFilesAtOnceAreNotTaken();
    void theLatestEightFilesAreInTheMenu();
    void missingRecentFileIsReportedAndRemoved();
    void aRunIsCopiedAndPastedWithAllItsBits();
    void pastedTextThatIsNoExperimentIsRefusedWithASentence_data();
    void pastedTextThatIsNoExperimentIsRefusedWithASentence();
    void closingAsksForAFileThatIsNotSaved();
    void closingAsksNothingWithoutAFile();

private:
    QString saved(const char *name, const char *step);
    QTemporaryDir m_folder;
};

/// Saves a run of 20 frames in which the foot was dragged.
QString FilesTest::saved(const char *name, const char *step)
{
    WindowFixture fixture({"single_spring", step});
    fixture.drag("foot", {30, 20});
    fixture.goTo(20);
    const QString path = m_folder.filePath(name);
    return fixture.window.saveFile(path) ? path : QString();
}

void FilesTest::aNameWithoutAnEndingIsOneOfAnExperiment()
{
    QTemporaryDir folder;
    QSettings().setValue("files/folder", folder.path()); // the one used last
    WindowFixture fixture;
    fixture.drag("foot", {30, 20});
    QTimer::singleShot(0, qApp, [&] {
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        QVERIFY(dialog);
        QCOMPARE(dialog->directory().path(), folder.path());
        for (const QPushButton *button : dialog->findChildren<QPushButton *>())
            QVERIFY2(button->icon().isNull(), qPrintable(button->text()));
        auto *name = dialog->findChild<QLineEdit *>("fileNameEdit");
        QCOMPARE(name->text(), QString("fixed_centre.springstep"));
        name->setText("my walk");
        QTest::keyClick(name, Qt::Key_Return);
    });
    fixture.key(Qt::Key_S, ctrl);
    QVERIFY(QFile::exists(folder.filePath("my walk.springstep")));
    QVERIFY(!fixture.isMarked());
}

void FilesTest::theTitleHasAMarkWhileTheRunIsNotSaved()
{
    WindowFixture fixture;
    QVERIFY(!fixture.isMarked());
    fixture.goTo(30);
    QVERIFY(!fixture.isMarked()); // time alone changes nothing
    fixture.drag("foot", {40, 10});
    QVERIFY(fixture.isMarked());
    QVERIFY(fixture.window.windowTitle().contains("[*]"));
    fixture.key(Qt::Key_Z, ctrl);
    QVERIFY(!fixture.isMarked());
    fixture.key(Qt::Key_Z, ctrlShift);
    QVERIFY(fixture.isMarked());
    QVERIFY(fixture.window.saveFile(m_folder.filePath("marked.json")));
    QVERIFY(!fixture.isMarked());
    QVERIFY(fixture.window.windowTitle().contains("marked.json"));
    fixture.session.editor().setParameter("k", 0.3);
    QVERIFY(fixture.isMarked());
    fixture.key(Qt::Key_S, ctrl);
    QVERIFY(!fixture.isMarked());
    QCOMPARE(readExperiment(m_folder.filePath("marked.json"), fixture.library).script.input,
             fixture.session.timeline().script().input);
}

void FilesTest::aRunThatIsKeptIsSavedAndOpenedWithTheFile()
{
    const QString path = m_folder.filePath("branches.json");
    sim::State old;
    {
        WindowFixture fixture({"multi_foot", "two_feet"});
        fixture.goTo(50);
        old = fixture.session.timeline().state();
        fixture.goTo(20);
        fixture.drag("foot0", {40, 10});
        QVERIFY(fixture.window.saveFile(path));
        QVERIFY(!fixture.isMarked());
        const int branch = fixture.session.comparisons().branches().all().front().id;
        fixture.session.comparisons().keep(branch, true); // so that the file is no longer all there is
        QVERIFY(fixture.isMarked());
        fixture.key(Qt::Key_Z, ctrl);
        QVERIFY(!fixture.isMarked());
        fixture.key(Qt::Key_Z, ctrlShift);
        fixture.key(Qt::Key_S, ctrl);
        QVERIFY(!fixture.isMarked());
    }
    WindowFixture fixture;
    fixture.window.openFile(path);
    QVERIFY(!fixture.isMarked());
    QCOMPARE(fixture.session.comparisons().branches().all().size(), std::size_t(1));
    fixture.goTo(50);
    fixture.session.editor().goBackTo(fixture.session.comparisons().branches().all().front().id);
    QVERIFY(sim::sameBits(fixture.session.timeline().state(), old));
    QVERIFY(fixture.isMarked());
}

void FilesTest::goingOnToAnotherStepKeepsEachStepsFile()
{
    const QString path = saved("kept.json", "fixed_centre");
    WindowFixture fixture;
    fixture.window.openFile(path);
    fixture.key(Qt::Key_PageDown, {});
    QVERIFY(!fixture.window.windowTitle().contains("kept.json"));
    fixture.session.editor().setParameter("k", 0.3);
    QVERIFY(fixture.isMarked());
    fixture.key(Qt::Key_PageUp, {});
    QVERIFY(fixture.window.windowTitle().contains("kept.json"));
    QVERIFY(!fixture.isMarked());
}

void FilesTest::newIsTheStepAsPublishedAndUndoBringsItBack()
{
    WindowFixture fixture;
    fixture.session.editor().setParameter("k", 0.3);
    fixture.key(Qt::Key_N, ctrl);
    QCOMPARE(fixture.session.editor().parameter("k"), 0.2);
    QVERIFY(!fixture.isMarked());
    QVERIFY(fixture.notice.sentence().isEmpty());
    fixture.key(Qt::Key_Z, ctrl);
    QCOMPARE(fixture.session.editor().parameter("k"), 0.3);
    QVERIFY(fixture.isMarked());
}

void FilesTest::openingAFileAsksAboutUnsavedChanges()
{
    const QString path = saved("asked.json", "radial");
    const QString mine = saved("mine.json", "fixed_centre");
    WindowFixture fixture;
    fixture.window.openFile(mine);
    fixture.session.editor().setParameter("k", 0.3);
    const auto open = [&] { drop(fixture.window, {QUrl::fromLocalFile(path)}); };
    open();
    QVERIFY2(fixture.notice.sentence().contains("mine.json"), qPrintable(fixture.notice.sentence()));
    QCOMPARE(fixture.session.step().id, QString("fixed_centre"));
    QVERIFY(!QApplication::activeModalWidget());
    QVERIFY(fixture.answer("Save"));
    QCOMPARE(fixture.session.step().id, QString("radial"));
    QVERIFY(fixture.notice.sentence().isEmpty());
    QVERIFY(readExperiment(mine, fixture.library).script.input.size() > 2);
    fixture.session.editor().setParameter("k", 0.4);
    drop(fixture.window, {QUrl::fromLocalFile(mine)});
    QVERIFY(fixture.answer("Discard changes"));
    QCOMPARE(fixture.session.step().id, QString("fixed_centre"));
}

void FilesTest::escapeCancelsTheQuestion()
{
    const QString path = saved("never.json", "radial");
    WindowFixture fixture;
    fixture.session.editor().setParameter("k", 0.3);
    drop(fixture.window, {QUrl::fromLocalFile(path)});
    QCOMPARE(fixture.notice.sentence(), QString("“A fixed centre” has unsaved changes."));
    fixture.key(Qt::Key_Escape, {});
    QTRY_VERIFY(!fixture.notice.isVisible());
    QCOMPARE(fixture.session.step().id, QString("fixed_centre"));
    QCOMPARE(fixture.session.editor().parameter("k"), 0.3);
}

void FilesTest::aDroppedFileIsOpenedWhereverItFalls_data()
{
    QTest::addColumn<QByteArray>("on");
    for (const char *on : {"app::MainWindow", "app::SceneView", "app::TimelineStrip", "app::NumberBox"})
        QTest::newRow(on) << QByteArray(on);
}

void FilesTest::aDroppedFileIsOpenedWhereverItFalls()
{
    QFETCH(QByteArray, on);
    const QString path = saved("dropped.json", "radial");
    WindowFixture fixture;
    QWidget *target = &fixture.window;
    for (QWidget *widget : fixture.window.findChildren<QWidget *>()) {
        if (on == widget->metaObject()->className() && widget->isVisible())
            target = widget;
    }
    QCOMPARE(QByteArray(target->metaObject()->className()), on);
    drop(*target, {QUrl::fromLocalFile(path)});
    QCOMPARE(fixture.session.step().id, QString("radial"));
    QVERIFY(fixture.window.windowTitle().contains("dropped.json"));
}

void FilesTest::twoFilesAtOnceAreNotTaken()
{
    const QUrl file = QUrl::fromLocalFile(saved("two.json", "radial"));
    WindowFixture fixture;
    drop(fixture.window, {file, file});
    QCOMPARE(fixture.session.step().id, QString("fixed_centre"));
}

void FilesTest::theLatestEightFilesAreInTheMenu()
{
    QSettings().remove("files/recent");
    WindowFixture fixture;
    QCOMPARE(recentIn(fixture).size(), 1);
    QVERIFY(!recentIn(fixture).front()->isEnabled());
    for (int i = 1; i <= 10; ++i)
        QVERIFY(fixture.window.saveFile(m_folder.filePath(QString("r%1.json").arg(i))));
    fixture.window.openFile(m_folder.filePath("r5.json"));
    QStringList names;
    for (const QAction *one : recentIn(fixture))
        names << one->text().section("  ", 1);
    QCOMPARE(names, QStringList({"r5.json", "r10.json", "r9.json", "r8.json", "r7.json", "r6.json", "r4.json",
                                 "r3.json"}));
    recentIn(fixture).at(2)->trigger();
    QVERIFY(fixture.window.windowTitle().contains("r9.json"));
}

void FilesTest::missingRecentFileIsReportedAndRemoved()
{
    WindowFixture fixture;
    const QString path = m_folder.filePath("gone.json");
    QVERIFY(fixture.window.saveFile(path));
    QVERIFY(QFile::remove(path));
    recentIn(fixture).front()->trigger();
    QVERIFY(fixture.notice.sentence().contains("gone.json"));
    QVERIFY(!recentFiles().contains(path));
}

void FilesTest::aRunIsCopiedAndPastedWithAllItsBits()
{
    WindowFixture fixture({"multi_foot", "any_number"});
    fixture.session.editor().setParameter("feet", 7);
    fixture.drag("foot0", {51, 17});
    fixture.goTo(60);
    const sim::State end = fixture.session.timeline().state();
    fixture.key(Qt::Key_C, ctrlShift);
    const QString line = QGuiApplication::clipboard()->text();
    QVERIFY(!line.contains('\n') && !line.contains(' '));
    QVERIFY2(line.size() > 100 && line.size() < 400, qPrintable(line));
    fixture.session.openStep("single_spring", "drag");
    QGuiApplication::clipboard()->setText("\n " + line.left(50) + "\n  " + line.mid(50) + "\n");
    fixture.key(Qt::Key_V, ctrlShift);
    QCOMPARE(fixture.notice.sentence(), QString());
    QCOMPARE(fixture.session.step().id, QString("any_number"));
    fixture.goTo(60);
    QVERIFY(sim::sameBits(fixture.session.timeline().state(), end));
    QVERIFY(fixture.isMarked());
    QVERIFY(!fixture.window.windowTitle().contains(".json"));
}

void FilesTest::pastedTextThatIsNoExperimentIsRefusedWithASentence_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("names");
    QTest::newRow("nothing") << "  \n"
                             << "no text to paste";
    QTest::newRow("a letter") << "Dear Eve"
                              << "not an experiment";
    QTest::newRow("cut off") << "springstep:eNqrVkrLL"
                             << "incomplete";
    QTest::newRow("no base64") << "springstep:***"
                               << "incomplete";
    QTest::newRow("nothing in it") << "springstep:"
                                   << "incomplete";
    QTest::newRow("bad JSON") << "{\"format\":"
                              << "line 1";
    const QByteArray zeros = qCompress(QByteArray(qsizetype(100) << 20, '\0'), 9).mid(4);
    QTest::newRow("a bomb") << "springstep:" +
                                   QString::fromLatin1(zeros.toBase64(QByteArray::Base64UrlEncoding))
                            << "32 MiB";
}

void FilesTest::pastedTextThatIsNoExperimentIsRefusedWithASentence()
{
    QFETCH(QString, text);
    QFETCH(QString, names);
    WindowFixture fixture;
    fixture.session.editor().setParameter("k", 0.3);
    const QByteArray before = experimentText(fixture.session.experiment(), fixture.library);
    QGuiApplication::clipboard()->setText(text);
    fixture.key(Qt::Key_V, ctrlShift);
    const QString said = fixture.notice.sentence();
    QVERIFY2(said.startsWith("Could not open the experiment: ") && said.contains(names), qPrintable(said));
    QCOMPARE(said.count('\n'), 0);
    QCOMPARE(experimentText(fixture.session.experiment(), fixture.library), before);
}

void FilesTest::closingAsksForAFileThatIsNotSaved()
{
    const QString path = saved("closing.json", "fixed_centre");
    WindowFixture fixture;
    fixture.window.openFile(path);
    fixture.session.editor().setParameter("k", 0.3);
    fixture.key(Qt::Key_PageDown, {}); // it need not be open
    QString asked;
    answerBox(QMessageBox::Cancel, &asked);
    QVERIFY(!fixture.window.close());
    QVERIFY(asked.contains("closing.json"));
    answerBox(QMessageBox::Save, &asked);
    QVERIFY(fixture.window.close());
    fixture.window.show();
    fixture.window.openFile(path);
    QCOMPARE(fixture.session.editor().parameter("k"), 0.3);
}

void FilesTest::closingAsksNothingWithoutAFile()
{
    WindowFixture fixture;
    fixture.session.editor().setParameter("k", 0.3);
    QVERIFY(fixture.window.close());
}

SUITE(tst_files, FilesTest)
#include "tst_files.moc"
