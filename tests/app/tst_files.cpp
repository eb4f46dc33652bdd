// Experiments as files and as text, in the real window.

#include "window_bench.h"

#include "app/model/experiment_line.h"
#include "app/model/recent_files.h"

#include <QClipboard>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QTemporaryDir>
#include <QTimer>

using namespace app;
using window_bench::Bench;

namespace {

constexpr auto ctrl = Qt::ControlModifier;
constexpr auto ctrlShift = Qt::ControlModifier | Qt::ShiftModifier;

/// The menu of recent files, as it opens.
QList<QAction *> recentIn(const Bench &bench)
{
    for (QMenu *menu : bench.window.findChildren<QMenu *>()) {
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
    void initTestCase();
    void theTitleHasAMarkWhileTheRunIsNotSaved();
    void aRunThatIsKeptIsSavedAndOpenedWithTheFile();
    void goingOnToAnotherStepKeepsEachStepsFile();
    void aNameWithoutAnEndingIsOneOfAnExperiment();
    void newIsTheStepAsPublishedAndUndoBringsItBack();
    void openingAsksBeforeItTakesTheSceneAway();
    void theQuestionGoesAwayUnanswered();
    void aDroppedFileIsOpenedWhereverItFalls_data();
    void aDroppedFileIsOpenedWhereverItFalls();
    void twoFilesAtOnceAreNotTaken();
    void theLatestEightFilesAreInTheMenu();
    void aFileThatIsGoneIsSaidAndTakenOut();
    void aRunIsCopiedAndPastedWithAllItsBits();
    void whatIsPastedAndNoExperimentIsRefusedWithASentence_data();
    void whatIsPastedAndNoExperimentIsRefusedWithASentence();
    void closingAsksForAFileThatIsNotSaved();
    void closingAsksNothingWithoutAFile();

private:
    QString saved(const char *name, const char *step);
    QTemporaryDir m_folder;
};

void FilesTest::initTestCase()
{
    window_bench::keepSettingsIn(m_folder.path());
}

/// A file with a run of 20 frames in which a hand has moved the foot.
QString FilesTest::saved(const char *name, const char *step)
{
    Bench bench("single_spring", step);
    bench.drag("foot", {30, 20});
    bench.session.goTo({20, 0});
    const QString path = m_folder.filePath(name);
    return bench.window.saveFile(path) ? path : QString();
}

void FilesTest::aNameWithoutAnEndingIsOneOfAnExperiment()
{
    QTemporaryDir folder;
    QSettings().setValue("files/folder", folder.path()); // the one used last
    Bench bench;
    bench.drag("foot", {30, 20});
    QTimer::singleShot(0, qApp, [&] {
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        QVERIFY(dialog);
        QCOMPARE(dialog->directory().path(), folder.path());
        auto *name = dialog->findChild<QLineEdit *>("fileNameEdit");
        QCOMPARE(name->text(), QString("fixed_centre.json"));
        name->setText("my walk");
        QTest::keyClick(name, Qt::Key_Return);
    });
    bench.press(Qt::Key_S, ctrl);
    QVERIFY(QFile::exists(folder.filePath("my walk.json")));
    QVERIFY(!bench.isMarked());
}

void FilesTest::theTitleHasAMarkWhileTheRunIsNotSaved()
{
    Bench bench;
    QVERIFY(!bench.isMarked());
    bench.session.goTo({30, 0});
    QVERIFY(!bench.isMarked()); // time alone changes nothing
    bench.drag("foot", {40, 10});
    QVERIFY(bench.isMarked());
    QVERIFY(bench.window.windowTitle().contains("[*]"));
    bench.press(Qt::Key_Z, ctrl);
    QVERIFY(!bench.isMarked());
    bench.press(Qt::Key_Z, ctrlShift);
    QVERIFY(bench.isMarked());
    QVERIFY(bench.window.saveFile(m_folder.filePath("marked.json")));
    QVERIFY(!bench.isMarked());
    QVERIFY(bench.window.windowTitle().contains("marked.json"));
    bench.session.setParameter("k", 0.3);
    QVERIFY(bench.isMarked());
    bench.press(Qt::Key_S, ctrl);
    QVERIFY(!bench.isMarked());
    QCOMPARE(readExperiment(m_folder.filePath("marked.json"), bench.library).script.input,
             bench.session.timeline().script().input);
}

void FilesTest::aRunThatIsKeptIsSavedAndOpenedWithTheFile()
{
    const QString path = m_folder.filePath("branches.json");
    sim::State old;
    {
        Bench bench("multi_foot", "two_feet");
        bench.session.goTo({50, 0});
        old = bench.session.timeline().state();
        bench.session.goTo({20, 0});
        bench.drag("foot0", {40, 10});
        QVERIFY(bench.window.saveFile(path));
        QVERIFY(!bench.isMarked());
        const int branch = bench.session.branches().all().front().id;
        bench.session.keepBranch(branch, true); // so that the file is no longer all there is
        QVERIFY(bench.isMarked());
        bench.press(Qt::Key_Z, ctrl);
        QVERIFY(!bench.isMarked());
        bench.press(Qt::Key_Z, ctrlShift);
        bench.press(Qt::Key_S, ctrl);
        QVERIFY(!bench.isMarked());
    }
    Bench bench;
    bench.window.openFile(path);
    QVERIFY(!bench.isMarked());
    QCOMPARE(bench.session.branches().all().size(), std::size_t(1));
    bench.session.goTo({50, 0});
    bench.session.goBackTo(bench.session.branches().all().front().id);
    QVERIFY(sim::sameBits(bench.session.timeline().state(), old));
    QVERIFY(bench.isMarked());
}

void FilesTest::goingOnToAnotherStepKeepsEachStepsFile()
{
    const QString path = saved("kept.json", "fixed_centre");
    Bench bench;
    bench.window.openFile(path);
    bench.press(Qt::Key_PageDown, {});
    QVERIFY(!bench.window.windowTitle().contains("kept.json"));
    bench.session.setParameter("k", 0.3);
    QVERIFY(bench.isMarked());
    bench.press(Qt::Key_PageUp, {});
    QVERIFY(bench.window.windowTitle().contains("kept.json"));
    QVERIFY(!bench.isMarked());
}

void FilesTest::newIsTheStepAsPublishedAndUndoBringsItBack()
{
    Bench bench;
    bench.session.setParameter("k", 0.3);
    bench.press(Qt::Key_N, ctrl);
    QCOMPARE(bench.session.parameter("k"), 0.2);
    QVERIFY(!bench.isMarked());
    QVERIFY(bench.notice.sentence().isEmpty());
    bench.press(Qt::Key_Z, ctrl);
    QCOMPARE(bench.session.parameter("k"), 0.3);
    QVERIFY(bench.isMarked());
}

void FilesTest::openingAsksBeforeItTakesTheSceneAway()
{
    const QString path = saved("asked.json", "radial");
    const QString mine = saved("mine.json", "fixed_centre");
    Bench bench;
    bench.window.openFile(mine);
    bench.session.setParameter("k", 0.3);
    const auto open = [&] { drop(bench.window, {QUrl::fromLocalFile(path)}); };
    open();
    QVERIFY2(bench.notice.sentence().contains("mine.json"), qPrintable(bench.notice.sentence()));
    QCOMPARE(bench.session.step().id, QString("fixed_centre"));
    QVERIFY(!QApplication::activeModalWidget());
    QVERIFY(bench.answer("Save it first"));
    QCOMPARE(bench.session.step().id, QString("radial"));
    QVERIFY(bench.notice.sentence().isEmpty());
    QVERIFY(readExperiment(mine, bench.library).script.input.size() > 2);
    bench.session.setParameter("k", 0.4);
    drop(bench.window, {QUrl::fromLocalFile(mine)});
    QVERIFY(bench.answer("Go on without"));
    QCOMPARE(bench.session.step().id, QString("fixed_centre"));
}

void FilesTest::theQuestionGoesAwayUnanswered()
{
    const QString path = saved("never.json", "radial");
    Bench bench;
    bench.session.setParameter("k", 0.3);
    drop(bench.window, {QUrl::fromLocalFile(path)});
    QVERIFY(!bench.notice.sentence().isEmpty());
    bench.press(Qt::Key_Escape, {});
    QTRY_VERIFY(!bench.notice.isVisible());
    QCOMPARE(bench.session.step().id, QString("fixed_centre"));
    QCOMPARE(bench.session.parameter("k"), 0.3);
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
    Bench bench;
    QWidget *target = &bench.window;
    for (QWidget *widget : bench.window.findChildren<QWidget *>()) {
        if (on == widget->metaObject()->className() && widget->isVisible())
            target = widget;
    }
    QCOMPARE(QByteArray(target->metaObject()->className()), on);
    drop(*target, {QUrl::fromLocalFile(path)});
    QCOMPARE(bench.session.step().id, QString("radial"));
    QVERIFY(bench.window.windowTitle().contains("dropped.json"));
}

void FilesTest::twoFilesAtOnceAreNotTaken()
{
    const QUrl file = QUrl::fromLocalFile(saved("two.json", "radial"));
    Bench bench;
    drop(bench.window, {file, file});
    QCOMPARE(bench.session.step().id, QString("fixed_centre"));
}

void FilesTest::theLatestEightFilesAreInTheMenu()
{
    QSettings().remove("files/recent");
    Bench bench;
    QCOMPARE(recentIn(bench).size(), 1);
    QVERIFY(!recentIn(bench).front()->isEnabled());
    for (int i = 1; i <= 10; ++i)
        QVERIFY(bench.window.saveFile(m_folder.filePath(QString("r%1.json").arg(i))));
    bench.window.openFile(m_folder.filePath("r5.json"));
    QStringList names;
    for (const QAction *one : recentIn(bench))
        names << one->text().section("  ", 1);
    QCOMPARE(names, QStringList({"r5.json", "r10.json", "r9.json", "r8.json", "r7.json", "r6.json", "r4.json",
                                 "r3.json"}));
    recentIn(bench).at(2)->trigger();
    QVERIFY(bench.window.windowTitle().contains("r9.json"));
}

void FilesTest::aFileThatIsGoneIsSaidAndTakenOut()
{
    Bench bench;
    const QString path = m_folder.filePath("gone.json");
    QVERIFY(bench.window.saveFile(path));
    QVERIFY(QFile::remove(path));
    recentIn(bench).front()->trigger();
    QVERIFY(bench.notice.sentence().contains("gone.json"));
    QVERIFY(!recentFiles().contains(path));
}

void FilesTest::aRunIsCopiedAndPastedWithAllItsBits()
{
    Bench bench("multi_foot", "any_number");
    bench.session.setParameter("feet", 7);
    bench.drag("foot0", {51, 17});
    bench.session.goTo({60, 0});
    const sim::State end = bench.session.timeline().state();
    bench.press(Qt::Key_C, ctrlShift);
    const QString line = QGuiApplication::clipboard()->text();
    QVERIFY(!line.contains('\n') && !line.contains(' '));
    QVERIFY2(line.size() < 400, qPrintable(line));
    bench.session.openStep("single_spring", "drag");
    QGuiApplication::clipboard()->setText("\n " + line.left(50) + "\n  " + line.mid(50) + "\n");
    bench.press(Qt::Key_V, ctrlShift);
    QCOMPARE(bench.notice.sentence(), QString());
    QCOMPARE(bench.session.step().id, QString("any_number"));
    bench.session.goTo({60, 0});
    QVERIFY(sim::sameBits(bench.session.timeline().state(), end));
    QVERIFY(bench.isMarked());
    QVERIFY(!bench.window.windowTitle().contains(".json"));
}

void FilesTest::whatIsPastedAndNoExperimentIsRefusedWithASentence_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("names");
    QTest::newRow("nothing") << "  \n"
                             << "no text to paste";
    QTest::newRow("a letter") << "Dear Eve"
                              << "no experiment";
    QTest::newRow("cut off") << "springstep:eNqrVkrLL"
                             << "not whole";
    QTest::newRow("no base64") << "springstep:***"
                               << "not whole";
    QTest::newRow("nothing in it") << "springstep:"
                                   << "not whole";
    QTest::newRow("bad JSON") << "{\"format\":"
                              << "line 1";
    const QByteArray zeros = qCompress(QByteArray(qsizetype(100) << 20, '\0'), 9).mid(4);
    QTest::newRow("a bomb") << "springstep:" +
                                   QString::fromLatin1(zeros.toBase64(QByteArray::Base64UrlEncoding))
                            << "32 MiB";
}

void FilesTest::whatIsPastedAndNoExperimentIsRefusedWithASentence()
{
    QFETCH(QString, text);
    QFETCH(QString, names);
    Bench bench;
    bench.session.setParameter("k", 0.3);
    const QByteArray before = experimentText(bench.session.experiment(), bench.library);
    QGuiApplication::clipboard()->setText(text);
    bench.press(Qt::Key_V, ctrlShift);
    const QString said = bench.notice.sentence();
    QVERIFY2(said.startsWith("Experiment not opened: ") && said.contains(names), qPrintable(said));
    QCOMPARE(said.count('\n'), 0);
    QCOMPARE(experimentText(bench.session.experiment(), bench.library), before);
}

void FilesTest::closingAsksForAFileThatIsNotSaved()
{
    const QString path = saved("closing.json", "fixed_centre");
    Bench bench;
    bench.window.openFile(path);
    bench.session.setParameter("k", 0.3);
    bench.press(Qt::Key_PageDown, {}); // it need not be open
    QString asked;
    answerBox(QMessageBox::Cancel, &asked);
    QVERIFY(!bench.window.close());
    QVERIFY(asked.contains("closing.json"));
    answerBox(QMessageBox::Save, &asked);
    QVERIFY(bench.window.close());
    bench.window.show();
    bench.window.openFile(path);
    QCOMPARE(bench.session.parameter("k"), 0.3);
}

void FilesTest::closingAsksNothingWithoutAFile()
{
    Bench bench;
    bench.session.setParameter("k", 0.3);
    QVERIFY(bench.window.close());
}

QTEST_MAIN(FilesTest)
#include "tst_files.moc"
