// File > Export > Web page, in the real window. `tests/web` opens such pages in a browser.

#include "tests/app/support/window_fixture.h"

#include "app/ui/film/web_page_dialog.h"
#include "tests/suite.h"

#include <QDir>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>

using namespace app;
using namespace tests;

class WebPageDialogTest : public QObject
{
    Q_OBJECT

private slots:
    void aPageIsMadeWhileTheWindowGoesOn();
    void aPageThatIsCancelledLeavesNoFile();
    void badInputIsNamed();

private:
    WebPageDialog &openDialog(WindowFixture &fixture)
    {
        fixture.key(Qt::Key_W, Qt::ControlModifier | Qt::ShiftModifier);
        return *fixture.window.findChild<WebPageDialog *>();
    }
    QString path(const char *name) { return m_folder.filePath(name); }
    QTemporaryDir m_folder;
};

void WebPageDialogTest::aPageIsMadeWhileTheWindowGoesOn()
{
    WindowFixture fixture({"walking_gait", "ground"});
    fixture.session.playback().goTo({40, 0});
    WebPageDialog &dialog = openDialog(fixture);
    QVERIFY(dialog.isVisible() && !dialog.isModal());
    QCOMPARE(dialog.findChildren<QSpinBox *>().last()->value(), 40);
    dialog.make(path("walk.html"));
    QVERIFY(dialog.isMaking());
    fixture.session.openStep("single_spring", "drag"); // whatever the window shows meanwhile
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.message().startsWith("walk.html is saved"), qPrintable(dialog.message()));
    QFile file(path("walk.html"));
    QVERIFY(file.open(QFile::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.startsWith("<!doctype html>"));
    QVERIFY(text.contains("default-src 'none'") && text.contains("<springstep-run") &&
            !text.contains("@script@"));
}

void WebPageDialogTest::aPageThatIsCancelledLeavesNoFile()
{
    WindowFixture fixture({"walking_gait", "ground"});
    WebPageDialog &dialog = openDialog(fixture);
    dialog.findChildren<QSpinBox *>().last()->setValue(90'000);
    dialog.make(path("never.html"));
    QVERIFY(dialog.isMaking());
    QTest::keyClick(&dialog, Qt::Key_Escape);
    QVERIFY(!dialog.isMaking());
    QCOMPARE(dialog.message(), QString("Cancelled. No file was written."));
    QCOMPARE(QDir(m_folder.path()).entryList({"never*"}), QStringList());
}

void WebPageDialogTest::badInputIsNamed()
{
    WindowFixture fixture;
    WebPageDialog &dialog = openDialog(fixture);
    dialog.findChildren<QSpinBox *>().last()->setValue(3);
    dialog.make(path("nowhere/walk.html"));
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.message().contains("nowhere/walk.html: the file could not be written"),
             qPrintable(dialog.message()));
    dialog.findChildren<QSpinBox *>().first()->setValue(9);
    dialog.make(path("back.html"));
    QVERIFY(!dialog.isMaking());
    QVERIFY2(dialog.message().contains("Swap them"), qPrintable(dialog.message()));
}

SUITE(tst_web_page_dialog, WebPageDialogTest)
#include "tst_web_page_dialog.moc"
