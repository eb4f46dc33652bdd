// The gallery: its files, and its use with mouse and keys.

#include "tests/app/support/files.h"
#include "tests/app/support/window_fixture.h"

#include "app/model/files/gallery.h"
#include "app/model/text/user_error.h"
#include "app/ui/dialogs/gallery_page.h"
#include "tests/suite.h"

#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>

using namespace app;
using namespace tests;

namespace {

struct GalleryFixture : WindowFixture
{
    GalleryFixture() { window.keepGalleryIn(folder.path()); }

    void open()
    {
        activate();
        QTest::keyClick(&view, Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        settle();
        QVERIFY(page().isVisible());
    }
    void keep()
    {
        QTest::keyClick(&view, Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
        settle();
    }
    GalleryPage &page() const { return part<GalleryPage>(); }
    QListWidget &cards() const { return part<QListWidget>("galleryCards"); }
    QStringList titles() const
    {
        QStringList all;
        for (int i = 0; i < cards().count(); ++i)
            all << cards().item(i)->text();
        return all;
    }
    void click(const char *name)
    {
        QTest::mouseClick(&part<QPushButton>(name), Qt::LeftButton);
        settle();
    }
    void press(int key, Qt::KeyboardModifiers held = {})
    {
        QTest::keyClick(&cards(), Qt::Key(key), held);
        settle();
    }
    QStringList files() const { return QDir(folder.path()).entryList({"*.json"}, QDir::Files); }

    QTemporaryDir folder;
};

}

class GalleryTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void anEmptyGallerySaysWhatToDo();
    void keepingStoresTitleDateAndPicture();
    void keptTwiceHasANumber();
    void keepsTheSameBits();
    void opensOneByKeysAndMouse();
    void openingInTheSandboxCanBeUndone();
    void renamesWithTheKeyboard();
    void anEmptyTitleChangesNothing();
    void removesAndTakesBack();
    void everyChangeCanBeTakenBack();
    void damagedFilesAreNamedAndLeftAlone_data();
    void damagedFilesAreNamedAndLeftAlone();
    void anExperimentThatCannotBeReadIsNamed();
    void aFolderThatCannotBeWrittenIsNamed();
    void withoutAFolderThereIsNoGallery();
    void theListFollowsTheFolder();
};

void GalleryTest::anEmptyGallerySaysWhatToDo()
{
    GalleryFixture window;
    window.open();
    auto &empty = window.part<QLabel>("galleryEmpty");
    QVERIFY(empty.isVisible());
    QVERIFY(empty.text().contains("Keep this one"));
    QVERIFY(!window.part<QPushButton>("galleryOpen").isEnabled());
    QVERIFY(!window.part<QPushButton>("galleryUndo").isEnabled());
    window.click("galleryKeep");
    QVERIFY(!empty.isVisible());
    QCOMPARE(window.titles(), QStringList{"A fixed centre"});
}

void GalleryTest::keepingStoresTitleDateAndPicture()
{
    GalleryFixture window;
    const QDateTime before = QDateTime::currentDateTime();
    window.keep();
    QCOMPARE(window.files().size(), 1);
    const Gallery gallery(window.folder.path());
    QCOMPARE(gallery.all().size(), 1U);
    const KeptExperiment &kept = gallery.all().front();
    QCOMPARE(kept.title, "A fixed centre");
    QVERIFY(kept.when >= before.addMSecs(-1) && kept.when <= QDateTime::currentDateTime());
    QVERIFY(!kept.picture.isNull());
    QVERIFY(kept.picture.width() <= Gallery::pictureSize.width());
    QVERIFY(gallery.mistakes().isEmpty());
}

void GalleryTest::keptTwiceHasANumber()
{
    GalleryFixture window;
    window.keep();
    window.keep();
    window.open();
    QStringList titles = window.titles();
    titles.sort();
    QCOMPARE(titles, (QStringList{"A fixed centre", "A fixed centre 2"}));
}

void GalleryTest::keepsTheSameBits()
{
    GalleryFixture window;
    window.session.editor().setParameter("k", 0.1 + 0.2);
    window.keep();
    const Gallery gallery(window.folder.path());
    const Experiment read = Gallery::experimentOf(gallery.all().front(), window.library);
    QVERIFY(read.script.values == window.session.timeline().script().values);
}

void GalleryTest::opensOneByKeysAndMouse()
{
    GalleryFixture window;
    window.session.editor().setParameter("k", 0.3);
    window.keep();
    window.session.editor().setParameter("k", 0.5);
    window.session.openStep("two_body", "mutual");
    window.open();
    window.press(Qt::Key_Return);
    QVERIFY(!window.page().isVisible());
    QCOMPARE(window.session.step().id, "fixed_centre");
    QCOMPARE(window.session.editor().parameter("k"), 0.3);
    window.session.editor().undo();
    QCOMPARE(window.session.editor().parameter("k"), 0.5);
    window.session.openStep("two_body", "mutual");
    window.open();
    window.click("galleryOpen");
    QCOMPARE(window.session.step().id, "fixed_centre");
}

void GalleryTest::openingInTheSandboxCanBeUndone()
{
    GalleryFixture window;
    window.session.openStep("sandbox", "build");
    window.keep();
    sim::Blueprint plan = *window.session.editor().blueprint();
    plan.points.back().mass = 3.0;
    QVERIFY(window.session.editor().build({"heavier", {}, {}}, plan));
    window.open();
    window.press(Qt::Key_Return);
    QCOMPARE(window.session.editor().blueprint()->points.back().mass, 1.0);
    window.session.editor().undo();
    QCOMPARE(window.session.editor().blueprint()->points.back().mass, 3.0);
}

void GalleryTest::renamesWithTheKeyboard()
{
    GalleryFixture window;
    window.keep();
    window.open();
    window.press(Qt::Key_F2);
    QWidget *field = window.cards().findChild<QLineEdit *>();
    QVERIFY(field);
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, "My spring");
    QTest::keyClick(field, Qt::Key_Return);
    settle();
    QVERIFY(window.page().isVisible()); // Return has not opened the experiment
    QCOMPARE(window.titles(), QStringList{"My spring"});
    QCOMPARE(Gallery(window.folder.path()).all().front().title, "My spring");
}

void GalleryTest::anEmptyTitleChangesNothing()
{
    GalleryFixture window;
    window.keep();
    window.open();
    window.cards().item(0)->setText("  ");
    settle();
    QCOMPARE(window.titles(), QStringList{"A fixed centre"});
}

void GalleryTest::removesAndTakesBack()
{
    GalleryFixture window;
    window.keep();
    const QByteArray before = contentsOf(window.folder.filePath(window.files().front()));
    window.open();
    window.press(Qt::Key_Delete);
    QVERIFY(window.files().isEmpty());
    QVERIFY(window.titles().isEmpty());
    auto &undo = window.part<QPushButton>("galleryUndo");
    QVERIFY(undo.isEnabled());
    QVERIFY(undo.toolTip().contains("remove \"A fixed centre\""));
    window.press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(window.titles(), QStringList{"A fixed centre"});
    QCOMPARE(contentsOf(window.folder.filePath(window.files().front())), before);
}

void GalleryTest::everyChangeCanBeTakenBack()
{
    GalleryFixture window;
    window.keep();
    window.open();
    window.cards().item(0)->setText("Other");
    settle();
    window.click("galleryRemove");
    QVERIFY(window.titles().isEmpty());
    window.click("galleryUndo");
    QCOMPARE(window.titles(), QStringList{"Other"});
    window.click("galleryUndo");
    QCOMPARE(window.titles(), QStringList{"A fixed centre"});
    window.click("galleryUndo");
    QVERIFY(window.files().isEmpty());
    QVERIFY(!window.part<QPushButton>("galleryUndo").isEnabled());
}

void GalleryTest::damagedFilesAreNamedAndLeftAlone_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("no JSON") << QByteArray("hello");
    QTest::newRow("no object") << QByteArray("[]");
    QTest::newRow("another format") << QByteArray("{\"format\": \"springstep-experiment/1\"}");
    QTest::newRow("fields are missing")
        << QByteArray("{\"format\": \"springstep-gallery/1\", \"title\": \"x\"}");
    QTest::newRow("a wrong type") << QByteArray(
        "{\"format\": \"springstep-gallery/1\", \"title\": 3, \"kept\": \"\", \"picture\": \"\"}");
}

void GalleryTest::damagedFilesAreNamedAndLeftAlone()
{
    QFETCH(QByteArray, content);
    GalleryFixture window;
    window.keep();
    writeFile(window.folder.filePath("broken.json"), content);
    window.open();
    QCOMPARE(window.titles(), QStringList{"A fixed centre"});
    const QString said = window.part<QLabel>("galleryMistakes").text();
    QVERIFY2(said.contains("broken.json") && said.contains("left alone") && !said.contains('\n'),
             qPrintable(said));
    QCOMPARE(contentsOf(window.folder.filePath("broken.json")), content);
}

void GalleryTest::anExperimentThatCannotBeReadIsNamed()
{
    GalleryFixture window;
    writeFile(
        window.folder.filePath("other.json"),
        "{\"format\": \"springstep-gallery/1\", \"title\": \"Old\", \"kept\": \"2026-01-02T03:04:05.000\", "
        "\"picture\": \"\", \"experiment\": \"{}\"}");
    window.open();
    QCOMPARE(window.titles(), QStringList{"Old"});
    window.press(Qt::Key_Return);
    QVERIFY(window.notice.sentence().contains("Could not open the experiment"));
    QCOMPARE(window.session.step().id, "fixed_centre");
}

void GalleryTest::aFolderThatCannotBeWrittenIsNamed()
{
    GalleryFixture window;
    writeFile(window.folder.filePath("file"), "x");
    window.window.keepGalleryIn(window.folder.filePath("file/gallery"));
    window.keep();
    QVERIFY(window.notice.sentence().contains("Could not keep the experiment"));
}

void GalleryTest::withoutAFolderThereIsNoGallery()
{
    WindowFixture window;
    QVERIFY(!window.actionCalled("Keep in gallery").isEnabled());
    QVERIFY(!window.actionCalled("Gallery…").isEnabled());
}

void GalleryTest::theListFollowsTheFolder()
{
    GalleryFixture window;
    window.keep();
    window.open();
    QCOMPARE(window.titles().size(), 1);
    window.page().reject();
    QVERIFY(QFile::remove(window.folder.filePath(window.files().front())));
    window.open();
    QVERIFY(window.titles().isEmpty());
}

SUITE(tst_gallery_page, GalleryTest)
#include "tst_gallery_page.moc"
