// File > Export, in the real window: films by the dialog, and pictures.

#include "tests/app/film/film_support.h"
#include "tests/app/support/files.h"
#include "tests/app/support/window_fixture.h"

#include "app/ui/film/film_dialog.h"
#include "app/ui/film/film_size.h"
#include "tests/suite.h"

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
using namespace tests;
using namespace film_support;

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
    void filmIsMadeWhileTheWindowStaysUsable();
    void aFilmIsAsWideAsIsTypedAndKeepsItsShape_data();
    void aFilmIsAsWideAsIsTypedAndKeepsItsShape();
    void aFilmCanHaveTheShapeOfTheScene();
    void aFilmThatIsStoppedLeavesNoFile();
    void theLineOfTheCodeThatEndsAFilmIsNamed();
    void existingFilmIsReplacedOnlyAfterConfirmation();
    void existingPicturesAreReplacedOnlyAfterConfirmation();
    void missingFolderIsReported();
    void aLongMessageSqueezesNoText();
    void thePictureIsCopiedAndSaved();
    void aPictureHasAKnownEnding();
    void svgLooksLikeThePicture_data();
    void svgLooksLikeThePicture();

private:
    FilmDialog &openDialog(WindowFixture &fixture);
    QTemporaryDir m_folder;
};

FilmDialog &ExportTest::openDialog(WindowFixture &fixture)
{
    fixture.key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    return *fixture.window.findChild<FilmDialog *>();
}

void ExportTest::filmIsMadeWhileTheWindowStaysUsable()
{
    WindowFixture fixture({"multi_foot", "two_feet"});
    fixture.drag("foot0", {30, 10});
    fixture.goTo(40);
    FilmDialog &dialog = openDialog(fixture);
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
    fixture.session.openStep("single_spring", "drag"); // the window may show another step
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.message().startsWith("dialog.gif is saved"), qPrintable(dialog.message()));
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
    WindowFixture fixture;
    FilmDialog &dialog = openDialog(fixture);
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
    WindowFixture fixture;
    FilmDialog &dialog = openDialog(fixture);
    FilmSize &size = *dialog.findChild<FilmSize *>();
    size.findChild<QComboBox *>()->setCurrentIndex(3);
    const QSize scene = fixture.view.viewport()->size();
    size.width().setValue(scene.width());
    QCOMPARE(size.size(), scene);
}

void ExportTest::theLineOfTheCodeThatEndsAFilmIsNamed()
{
    WindowFixture fixture;
    QString code = fixture.session.code().text();
    const int line = static_cast<int>(code.section("foot.position +=", 0, 0).count('\n')) + 1;
    code.replace("foot.position += foot.velocity;", "foot.position += foot.velocity / (5 - frame_number);");
    fixture.session.code().write(code);
    fixture.goTo(4);
    FilmDialog &dialog = openDialog(fixture);
    boxOf(dialog, "Last frame").setValue(20);
    QLineEdit &file = fileOf(dialog);
    file.selectAll();
    QTest::keyClicks(&file, m_folder.filePath("ends.gif"));
    QTest::keyClick(&file, Qt::Key_Return);
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.message().startsWith("ends.gif is saved") && dialog.message().contains("frame 4") &&
                 dialog.message().contains(QString("Line %1 of your code").arg(line)),
             qPrintable(dialog.message()));
    QCOMPARE(decoded(m_folder.filePath("ends.gif")).pictures.size(), std::size_t(5));
}

void ExportTest::aFilmThatIsStoppedLeavesNoFile()
{
    WindowFixture fixture({"multi_foot", "two_feet"});
    fixture.goTo(300);
    FilmDialog &dialog = openDialog(fixture);
    const QString path = m_folder.filePath("stopped.gif");
    fileOf(dialog).setText(path);
    QTest::keyClick(&dialog, Qt::Key_Return);
    auto *bar = dialog.findChild<QProgressBar *>();
    QTRY_VERIFY(bar->value() > bar->maximum() / 5);
    QVERIFY(dialog.isMaking());
    QTest::keyClick(&dialog, Qt::Key_Escape);
    QVERIFY(!dialog.isMaking());
    QVERIFY(dialog.message().startsWith("Cancelled."));
    QCOMPARE(QDir(m_folder.path()).entryList({"stopped*"}), QStringList());
}

void ExportTest::existingFilmIsReplacedOnlyAfterConfirmation()
{
    WindowFixture fixture;
    FilmDialog &dialog = openDialog(fixture);
    boxOf(dialog, "Last frame").setValue(3);
    const QString path = m_folder.filePath("there.gif");
    writeFile(path, "precious");
    QLineEdit &file = fileOf(dialog);
    file.setFocus();
    file.selectAll();
    QTest::keyClicks(&file, path);
    QTest::keyClick(&file, Qt::Key_Return);
    QVERIFY(!dialog.isMaking());
    QCOMPARE(dialog.message(), QString("there.gif already exists. Replace it, or choose another name."));
    QPushButton &make = *defaultButton(dialog);
    QCOMPARE(make.text(), QString("&Replace"));
    QTest::keyClick(&file, Qt::Key_End);
    QTest::keyClick(&file, Qt::Key_Backspace); // another name, and the same again: the dialog asks again
    QCOMPARE(make.text(), QString("&Make the film"));
    QVERIFY(dialog.message().isEmpty());
    QTest::keyClicks(&file, "f");
    QTest::mouseClick(&make, Qt::LeftButton);
    QVERIFY(!dialog.isMaking());
    QCOMPARE(contentsOf(path), QByteArray("precious"));
    QTest::mouseClick(&make, Qt::LeftButton);
    QVERIFY(dialog.isMaking());
    QTRY_VERIFY(!dialog.isMaking());
    QCOMPARE(decoded(path).pictures.size(), std::size_t(4));
    QTest::mouseClick(&make, Qt::LeftButton); // and the one that was just made
    QVERIFY(!dialog.isMaking());
}

void ExportTest::existingPicturesAreReplacedOnlyAfterConfirmation()
{
    WindowFixture fixture;
    FilmDialog &dialog = openDialog(fixture);
    boxOf(dialog, "Last frame").setValue(3);
    writeFile(m_folder.filePath("walk_0003.png"), "precious");
    fileOf(dialog).setText(m_folder.filePath("walk_%04d.png"));
    QPushButton &make = *defaultButton(dialog);
    QTest::mouseClick(&make, Qt::LeftButton);
    QVERIFY(!dialog.isMaking());
    QVERIFY2(dialog.message().contains("walk_0003.png"), qPrintable(dialog.message()));
    boxOf(dialog, "Last frame").setValue(2); // that one is not among them now
    QTest::mouseClick(&make, Qt::LeftButton);
    QVERIFY(dialog.isMaking());
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY(QFile::exists(m_folder.filePath("walk_0002.png")));
    QCOMPARE(contentsOf(m_folder.filePath("walk_0003.png")), QByteArray("precious"));
}

void ExportTest::missingFolderIsReported()
{
    WindowFixture fixture;
    FilmDialog &dialog = openDialog(fixture);
    fileOf(dialog).setText(m_folder.filePath("nowhere/film.gif"));
    QTest::keyClick(&dialog, Qt::Key_Return);
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.message().contains("Could not write"), qPrintable(dialog.message()));
}

void ExportTest::aLongMessageSqueezesNoText()
{
    WindowFixture fixture;
    FilmDialog &dialog = openDialog(fixture);
    fileOf(dialog).setText("/a/folder/with/a/long/name/that/wraps/film.abc");
    QTest::keyClick(&dialog, Qt::Key_Return);
    QVERIFY(!dialog.message().isEmpty());
    for (const QLabel *text : dialog.findChildren<QLabel *>()) {
        if (text->wordWrap())
            QTRY_VERIFY2(text->height() >= text->heightForWidth(text->width()), qPrintable(text->text()));
    }
}

void ExportTest::thePictureIsCopiedAndSaved()
{
    WindowFixture fixture;
    fixture.key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    const QImage copied = QGuiApplication::clipboard()->image();
    QCOMPARE(copied.size(), 2 * fixture.view.viewport()->size());
    const QString path = m_folder.filePath("scene.png");
    QVERIFY(fixture.window.savePictureAs(path));
    QCOMPARE(difference(QImage(path), copied).worst, 0);
    QVERIFY(!fixture.window.savePictureAs(m_folder.filePath("nowhere/scene.png")));
    QVERIFY(fixture.notice.sentence().startsWith("Could not save the picture: "));
}

void ExportTest::aPictureHasAKnownEnding()
{
    WindowFixture fixture;
    const QString path = m_folder.filePath("scene.bmp");
    QVERIFY(!fixture.window.savePictureAs(path));
    QVERIFY(!QFile::exists(path));
    QCOMPARE(fixture.notice.sentence(),
             QString("Could not save the picture: \"scene.bmp\" is not the name of a "
                     "picture; it ends in .png or .svg."));
}

void ExportTest::svgLooksLikeThePicture_data()
{
    QTest::addColumn<QByteArray>("lesson");
    QTest::addColumn<QByteArray>("step");
    QTest::newRow("creature") << QByteArray("multi_foot") << QByteArray("any_number");
    QTest::newRow("walker") << QByteArray("walking_gait") << QByteArray("ground");
    QTest::newRow("codeling") << QByteArray("codeling") << QByteArray("tentacles");
    QTest::newRow("tree") << QByteArray("swaying_tree") << QByteArray("turbulence");
}

void ExportTest::svgLooksLikeThePicture()
{
    QFETCH(QByteArray, lesson);
    QFETCH(QByteArray, step);
    WindowFixture fixture({lesson, step});
    fixture.goTo(20);
    const QString path = m_folder.filePath("scene.svg");
    QVERIFY(fixture.window.savePictureAs(path));
    QSvgRenderer svg(path);
    QVERIFY(svg.isValid());
    QImage drawn(fixture.view.viewport()->size(), QImage::Format_RGB32);
    drawn.fill(Qt::white);
    QPainter painter(&drawn);
    svg.render(&painter);
    painter.end();
    const Difference found = difference(drawn, fixture.view.picture());
    QVERIFY2(found.mean < 2.0, qPrintable(QString::number(found.mean)));
}

SUITE(tst_export, ExportTest)
#include "tst_export.moc"
