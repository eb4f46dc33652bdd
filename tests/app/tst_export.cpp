// File > Export, in the real window: films by the dialog, and pictures.

#include "film_bench.h"
#include "window_bench.h"

#include "app/ui/film/film_dialog.h"

#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QProgressBar>
#include <QSpinBox>
#include <QSvgRenderer>
#include <QTemporaryDir>

using namespace app;
using namespace film_bench;
using window_bench::Bench;

namespace {

/// The field for the film's file.
QLineEdit &fileOf(const FilmDialog &dialog)
{
    const auto all = dialog.findChildren<QLineEdit *>();
    return **std::find_if(all.begin(), all.end(),
                          [](const QLineEdit *one) { return one->accessibleName() == "File"; });
}

}

class ExportTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { window_bench::keepSettingsIn(m_folder.path()); }
    void theDialogMakesAFilmWhileTheWindowGoesOn();
    void aFilmThatIsStoppedLeavesNoFile();
    void aFolderThatIsNotThereIsSaid();
    void thePictureIsCopiedAndSaved();
    void theSvgLooksAsThePictureDoes_data();
    void theSvgLooksAsThePictureDoes();

private:
    FilmDialog &openDialog(Bench &bench);
    QTemporaryDir m_folder;
};

FilmDialog &ExportTest::openDialog(Bench &bench)
{
    bench.press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    return *bench.window.findChild<FilmDialog *>();
}

void ExportTest::theDialogMakesAFilmWhileTheWindowGoesOn()
{
    Bench bench("multi_foot", "two_feet");
    bench.drag("foot0", {30, 10});
    bench.session.goTo({40, 0});
    FilmDialog &dialog = openDialog(bench);
    QVERIFY(dialog.isVisible() && !dialog.isModal());
    const QString path = m_folder.filePath("dialog.gif");
    const auto boxes = dialog.findChildren<QSpinBox *>();
    QCOMPARE(boxes.at(1)->value(), 40);
    boxes.at(0)->setFocus();
    boxes.at(0)->selectAll();
    QTest::keyClicks(boxes.at(0), "5");
    QLineEdit &file = fileOf(dialog);
    file.selectAll();
    QTest::keyClicks(&file, path);
    dialog.findChild<QComboBox *>()->setCurrentIndex(0);
    QTest::keyClick(&file, Qt::Key_Return);
    QVERIFY(dialog.isMaking());
    bench.session.openStep("single_spring", "drag"); // whatever the window shows meanwhile
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.said().startsWith("dialog.gif is made"), qPrintable(dialog.said()));
    const Decoded film = decoded(path);
    QCOMPARE(film.pictures.size(), std::size_t(36));
    QCOMPARE(film.pictures.front().size(), QSize(320, 240));
}

void ExportTest::aFilmThatIsStoppedLeavesNoFile()
{
    Bench bench("multi_foot", "two_feet");
    bench.session.goTo({300, 0});
    FilmDialog &dialog = openDialog(bench);
    const QString path = m_folder.filePath("stopped.gif");
    fileOf(dialog).setText(path);
    QTest::keyClick(&dialog, Qt::Key_Return);
    auto *bar = dialog.findChild<QProgressBar *>();
    QTRY_VERIFY(bar->value() > bar->maximum() / 5);
    QVERIFY(dialog.isMaking());
    QTest::keyClick(&dialog, Qt::Key_Escape);
    QVERIFY(!dialog.isMaking());
    QVERIFY(dialog.said().startsWith("Stopped."));
    QCOMPARE(QDir(m_folder.path()).entryList({"stopped*"}), QStringList());
}

void ExportTest::aFolderThatIsNotThereIsSaid()
{
    Bench bench;
    FilmDialog &dialog = openDialog(bench);
    fileOf(dialog).setText(m_folder.filePath("nowhere/film.gif"));
    QTest::keyClick(&dialog, Qt::Key_Return);
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.said().contains("cannot be written"), qPrintable(dialog.said()));
}

void ExportTest::thePictureIsCopiedAndSaved()
{
    Bench bench;
    bench.press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    const QImage copied = QGuiApplication::clipboard()->image();
    QCOMPARE(copied.size(), 2 * bench.view.viewport()->size());
    const QString path = m_folder.filePath("scene.png");
    QVERIFY(bench.window.savePictureAs(path));
    QCOMPARE(difference(QImage(path), copied).worst, 0);
    QVERIFY(!bench.window.savePictureAs(m_folder.filePath("nowhere/scene.png")));
    QVERIFY(bench.notice.sentence().startsWith("Picture not saved: "));
}

void ExportTest::theSvgLooksAsThePictureDoes_data()
{
    QTest::addColumn<QByteArray>("lesson");
    QTest::addColumn<QByteArray>("step");
    QTest::newRow("creature") << QByteArray("multi_foot") << QByteArray("any_number");
    QTest::newRow("walker") << QByteArray("walking_gait") << QByteArray("ground");
    QTest::newRow("codeling") << QByteArray("codeling") << QByteArray("tentacles");
    QTest::newRow("tree") << QByteArray("swaying_tree") << QByteArray("turbulence");
}

void ExportTest::theSvgLooksAsThePictureDoes()
{
    QFETCH(QByteArray, lesson);
    QFETCH(QByteArray, step);
    Bench bench(lesson, step);
    bench.session.goTo({20, 0});
    const QString path = m_folder.filePath("scene.svg");
    QVERIFY(bench.window.savePictureAs(path));
    QSvgRenderer svg(path);
    QVERIFY(svg.isValid());
    QImage drawn(bench.view.viewport()->size(), QImage::Format_RGB32);
    drawn.fill(Qt::white);
    QPainter painter(&drawn);
    svg.render(&painter);
    painter.end();
    const Difference found = difference(drawn, bench.view.picture());
    QVERIFY2(found.mean < 2.0, qPrintable(QString::number(found.mean)));
}

QTEST_MAIN(ExportTest)
#include "tst_export.moc"
