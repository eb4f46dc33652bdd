// File > Export > Web page, in the real window. `tests/web` opens such pages in a browser.

#include "tests/app/support/window_fixture.h"

#include "app/ui/film/web_page_dialog.h"
#include "tests/suite.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QtEndian>

using namespace app;
using namespace tests;

class WebPageDialogTest : public QObject
{
    Q_OBJECT

private slots:
    void aPageIsMadeWhileTheWindowGoesOn();
    void thePageShowsWhatTheWindowShows();
    void aPageThatIsCancelledLeavesNoFile();
    void badInputIsNamed();

private:
    WebPageDialog &openDialog(WindowFixture &fixture)
    {
        fixture.key(Qt::Key_W, Qt::ControlModifier | Qt::ShiftModifier);
        return *fixture.window.findChild<WebPageDialog *>();
    }
    QString path(const char *name) { return m_folder.filePath(name); }
    /// Makes the page, and returns the texts of its run.
    QJsonObject made(WebPageDialog &dialog, const char *name)
    {
        dialog.makePage(path(name));
        if (!QTest::qWaitFor([&] { return !dialog.isMaking(); }, 20'000))
            qFatal("The page is not made.");
        dialog.close();
        QFile file(path(name));
        if (!file.open(QFile::ReadOnly))
            qFatal("There is no page: %s", qPrintable(dialog.message()));
        const QByteArray page = file.readAll();
        const qsizetype from = page.indexOf("id=\"run\">") + 9;
        const QByteArray packed = QByteArray::fromBase64(page.mid(from, page.indexOf('<', from) - from));
        const QByteArray data = qUncompress(QByteArray("\x00\x10\x00\x00", 4) + packed); // expects 1 MiB
        return QJsonDocument::fromJson(data.mid(4, qFromLittleEndian<quint32>(data.constData()))).object();
    }
    QTemporaryDir m_folder;
};

void WebPageDialogTest::aPageIsMadeWhileTheWindowGoesOn()
{
    WindowFixture fixture({"walking_gait", "ground"});
    fixture.goTo(40);
    WebPageDialog &dialog = openDialog(fixture);
    QVERIFY(dialog.isVisible() && !dialog.isModal());
    QCOMPARE(dialog.findChildren<QSpinBox *>().last()->value(), 40);
    dialog.makePage(path("walk.html"));
    QVERIFY(dialog.isMaking());
    fixture.session.openStep("single_spring", "drag"); // the window may show another step
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.message().startsWith("walk.html is saved"), qPrintable(dialog.message()));
    QFile file(path("walk.html"));
    QVERIFY(file.open(QFile::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.startsWith("<!doctype html>"));
    QVERIFY(text.contains("default-src 'none'") && text.contains("<springstep-run") &&
            !text.contains("@script@"));
}

void WebPageDialogTest::thePageShowsWhatTheWindowShows()
{
    WindowFixture fixture({"walking_gait", "ground"});
    fixture.goTo(20);
    const QJsonObject plain = made(openDialog(fixture), "plain.html");
    QCOMPARE(plain["shows"]["velocities"], QJsonValue(false));
    QCOMPARE(plain["shows"]["trails"], QJsonValue(true));
    QVERIFY(!plain.contains("ghost"));
    fixture.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
    Extras extras = fixture.view.extras();
    extras.velocities = extras.onion = true;
    extras.trails = extras.unitCircle = extras.grid = false;
    fixture.view.setExtras(extras);
    fixture.goTo(10);
    fixture.session.editor().setParameter("damp", 0.5);
    fixture.session.editor().endGesture();
    fixture.goTo(20);
    QVERIFY(fixture.session.comparisons().shown());
    const QJsonObject more = made(openDialog(fixture), "more.html");
    for (const char *name : {"velocities", "onion", "ghost", "guides", "eyes"})
        QCOMPARE(more["shows"][name], QJsonValue(true));
    for (const char *name : {"trails", "unitCircle", "grid"})
        QCOMPARE(more["shows"][name], QJsonValue(false));
    QCOMPARE(more["ghost"]["name"].toString(), fixture.session.comparisons().shown()->name);
    QVERIFY(more["ghost"]["parts"][0]["first"].toInt() > 10);
}

void WebPageDialogTest::aPageThatIsCancelledLeavesNoFile()
{
    WindowFixture fixture({"walking_gait", "ground"});
    WebPageDialog &dialog = openDialog(fixture);
    dialog.findChildren<QSpinBox *>().last()->setValue(90'000);
    dialog.makePage(path("never.html"));
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
    dialog.makePage(path("nowhere/walk.html"));
    QTRY_VERIFY(!dialog.isMaking());
    QVERIFY2(dialog.message().contains("nowhere/walk.html: the file could not be written"),
             qPrintable(dialog.message()));
    dialog.findChildren<QSpinBox *>().first()->setValue(9);
    dialog.makePage(path("back.html"));
    QVERIFY(!dialog.isMaking());
    QVERIFY2(dialog.message().contains("Swap them"), qPrintable(dialog.message()));
}

SUITE(tst_web_page_dialog, WebPageDialogTest)
#include "tst_web_page_dialog.moc"
