// File > Export, in the real window: films by the dialog, and pictures.

#include "film_bench.h"
#include "window_bench.h"

#include "app/ui/film/film_dialog.h"
#include "app/ui/film/film_size.h"

#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QSvgRenderer>
#include <QTemporaryDir>

using namespace app;
using namespace film_bench;
using window_bench::Bench;

namespace {

QSpinBox &boxOf(const FilmDialog &dialog, const QString &name)
{
    const auto all = dialog.findChildren<QSpinBox *>();
    return **std::find_if(all.begin(), all.end(),
                          [&](const QSpinBox *one) { return one->accessibleName() == name; });
}

/// The field for the film's file.
QLineEdit &fileOf(const FilmDialog &dialog)
{
    const auto all = dialog.findChildren<QLineEdit *>();
    return **std::find_if(all.begin(), all.end(),
                          [](const QLineEdit *one) { return one->accessibleName() == "File"; });
}

void write(const QString &path, const QByteArray &text)
{
    QFile file(path);
    QVERIFY(file.open(QFile::WriteOnly));
    file.write(text);
}

QByteArray contents(const QString &path)
{
    QFile file(path);
    return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
}

QPushButton *defaultButton(const FilmDialog &dialog)
{
    const auto all = dialog.findChildren<QPushButton *>();
    return *std::find_if(all.begin(), all.end(), [](const QPushButton *one) { return one->isDefault(); });
}

}

class ExportTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { window_bench::keepSettingsIn(m_folder.path()); }
    void theDialogMakesAFilmWhileTheWindowGoesOn();
    void aFilmIsAsWideAsIsTypedAndKeepsItsShape_data();
    void aFilmIsAsWideAsIsTypedAndKeepsItsShape();
    void aFilmCanHaveTheShapeOfTheScene();
    void aFilmThatIsStoppedLeavesNoFile();
    void aFilmThatIsThereIsWrittenOverWhenThatIsWanted();
    void picturesThatAreThereAreAskedAboutToo();
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
    QCOMPARE(boxOf(dialog, "Last frame").value(), 40);
    QSpinBox &first = boxOf(dialog, "First frame");
    first.setFocus();
    first.selectAll();
    QTest::keyClicks(&first, "5");
    QLineEdit &file = fileOf(dialog);
    file.selectAll();
    QTest::keyClicks(&file, path);
    FilmSize &size = *dialog.findChild<FilmSize *>();
    size.width().setFocus();
    size.width().selectAll();
    QTest::keyClicks(&size.width(), "320");
    QTest::keyClick(&file, Qt::Key_Return);
    QVERIFY(dialog.isMaking());
    bench.session.openStep("single_spring", "drag"); // whatever the window shows meanwhile
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.said().startsWith("dialog.gif is made"), qPrintable(dialog.said()));
    const Decoded film = decoded(path);
    QCOMPARE(film.pictures.size(), std::size_t(36));
    QCOMPARE(film.pictures.front().size(), QSize(320, 240));
}

void ExportTest::aFilmIsAsWideAsIsTypedAndKeepsItsShape_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<int>("shape");
    QTest::addColumn<QSize>("size");
    QTest::newRow("4 : 3") << "500" << 0 << QSize(500, 375);
    QTest::newRow("16 : 9") << "1920" << 1 << QSize(1920, 1080);
    QTest::newRow("a height between two pixels") << "1001" << 1 << QSize(1001, 563);
    QTest::newRow("square") << "300" << 2 << QSize(300, 300);
    QTest::newRow("too narrow") << "12" << 0 << QSize(200, 150);
    QTest::newRow("too wide") << "9000" << 0 << QSize(900, 675); // the last digit is not taken
}

void ExportTest::aFilmIsAsWideAsIsTypedAndKeepsItsShape()
{
    QFETCH(QString, typed);
    QFETCH(int, shape);
    Bench bench;
    FilmDialog &dialog = openDialog(bench);
    FilmSize &size = *dialog.findChild<FilmSize *>();
    QCOMPARE(size.size(), QSize(640, 480));
    size.width().setFocus();
    size.width().selectAll();
    QTest::keyClicks(&size.width(), typed);
    QTest::keyClick(&size.width(), Qt::Key_Tab);
    auto &shapes = *size.findChild<QComboBox *>();
    for (int i = 0; i < shape; ++i)
        QTest::keyClick(&shapes, Qt::Key_Down);
    QTEST(size.size(), "size");
    const QString height = QString::number(size.size().height());
    QCOMPARE(size.findChild<QLabel *>()->text(), "× " + height);
}

void ExportTest::aFilmCanHaveTheShapeOfTheScene()
{
    Bench bench;
    FilmDialog &dialog = openDialog(bench);
    FilmSize &size = *dialog.findChild<FilmSize *>();
    size.findChild<QComboBox *>()->setCurrentIndex(3);
    const QSize scene = bench.view.viewport()->size();
    size.width().setValue(scene.width());
    QCOMPARE(size.size(), scene);
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

void ExportTest::aFilmThatIsThereIsWrittenOverWhenThatIsWanted()
{
    Bench bench;
    FilmDialog &dialog = openDialog(bench);
    boxOf(dialog, "Last frame").setValue(3);
    const QString path = m_folder.filePath("there.gif");
    write(path, "precious");
    QLineEdit &file = fileOf(dialog);
    file.setFocus();
    file.selectAll();
    QTest::keyClicks(&file, path);
    QTest::keyClick(&file, Qt::Key_Return);
    QVERIFY(!dialog.isMaking());
    QCOMPARE(dialog.said(), QString("there.gif is there already. Replace it, or give another name."));
    QPushButton &make = *defaultButton(dialog);
    QCOMPARE(make.text(), QString("&Replace"));
    QTest::keyClick(&file, Qt::Key_End);
    QTest::keyClick(&file, Qt::Key_Backspace); // another name, and the same again: it is asked about anew
    QCOMPARE(make.text(), QString("&Make the film"));
    QVERIFY(dialog.said().isEmpty());
    QTest::keyClicks(&file, "f");
    QTest::mouseClick(&make, Qt::LeftButton);
    QVERIFY(!dialog.isMaking());
    QCOMPARE(contents(path), QByteArray("precious"));
    QTest::mouseClick(&make, Qt::LeftButton);
    QVERIFY(dialog.isMaking());
    QTRY_VERIFY(!dialog.isMaking());
    QCOMPARE(decoded(path).pictures.size(), std::size_t(4));
    QTest::mouseClick(&make, Qt::LeftButton); // and the one that was just made
    QVERIFY(!dialog.isMaking());
}

void ExportTest::picturesThatAreThereAreAskedAboutToo()
{
    Bench bench;
    FilmDialog &dialog = openDialog(bench);
    boxOf(dialog, "Last frame").setValue(3);
    write(m_folder.filePath("walk_0003.png"), "precious");
    fileOf(dialog).setText(m_folder.filePath("walk_%04d.png"));
    QPushButton &make = *defaultButton(dialog);
    QTest::mouseClick(&make, Qt::LeftButton);
    QVERIFY(!dialog.isMaking());
    QVERIFY2(dialog.said().contains("walk_0003.png"), qPrintable(dialog.said()));
    boxOf(dialog, "Last frame").setValue(2); // that one is not among them now
    QTest::mouseClick(&make, Qt::LeftButton);
    QVERIFY(dialog.isMaking());
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY(QFile::exists(m_folder.filePath("walk_0002.png")));
    QCOMPARE(contents(m_folder.filePath("walk_0003.png")), QByteArray("precious"));
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
