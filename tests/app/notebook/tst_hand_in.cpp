// A learner hands in her notebook by mouse and keys, and a teacher checks it from the command line.

#include "tests/app/by_hand/learner.h"
#include "tests/app/cli/program.h"
#include "tests/app/notebook/notebook_maker.h"
#include "tests/app/support/files.h"
#include "tests/app/support/window_fixture.h"
#include "tests/lessons/attempts/attempts.h"

#include "app/model/files/whole_file.h"
#include "app/model/notebook/notebook_file.h"
#include "app/ui/notebook/hand_in_dialog.h"
#include "tests/suite.h"

#include <QCheckBox>
#include <QDir>
#include <QJsonArray>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>

using namespace app;
using namespace tests;

namespace {

/// The window of a learner who has done nothing yet.
struct HandInFixture : WindowFixture
{
    explicit HandInFixture(WindowSetup setup = {}) : WindowFixture(std::move(setup))
    {
        window.keepGalleryIn(folder.filePath("gallery"));
    }

    /// Does the first thing to try of the step by hand.
    void tryFirst()
    {
        support::Learner learner(session, window);
        const QString step = session.step().id;
        for (const support::Attempt &attempt : support::attemptsOf(session.lesson().id.toStdString())) {
            if (step != attempt.step || attempt.number != 0 || attempt.isNearMiss())
                continue;
            learner.begin(0);
            attempt.act(learner);
            settle();
            QTRY_VERIFY(learner.sees(0));
            return;
        }
        QFAIL("no attempt");
    }
    void open()
    {
        activate();
        QTest::keyClick(&view, Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
        settle();
        QVERIFY(dialog().isVisible());
    }
    HandInDialog &dialog() const { return part<HandInDialog>(); }
    QPushButton &write() const { return part<QPushButton>("handInWrite"); }
    void type(const char *field, const QString &text)
    {
        auto &edit = part<QLineEdit>(field);
        edit.setFocus();
        edit.selectAll();
        QTest::keyClicks(&edit, text);
        settle();
    }
    void press(const char *box)
    {
        auto &check = part<QCheckBox>(box);
        check.setFocus();
        QTest::keyClick(&check, Qt::Key_Space);
        settle();
    }
    void clickWrite()
    {
        QTest::mouseClick(&write(), Qt::LeftButton);
        settle();
    }
    /// Also writes the page and the PDF, without a name.
    void writePages()
    {
        type("handInName", " ");
        type("handInFile", path("page.html")); // its ending is not doubled
        press("handInNotebook");
        press("handInPage");
        press("handInPdf");
        QCOMPARE(dialog().message(), QString("This writes page.html, page.pdf."));
        clickWrite();
        QCOMPARE(files(), QStringList({"ada.springstep-notebook", "page.html", "page.pdf"}));
        const QString page = contentsOf(path("page.html"));
        QVERIFY(page.contains("<h1>Notebook</h1>"));
        QVERIFY(page.contains("✓ "));
        QVERIFY(page.contains("data:image/png"));
        QVERIFY(contentsOf(path("page.pdf")).startsWith("%PDF-"));
    }
    QString path(const char *name) const { return folder.filePath(name); }
    QStringList files() const { return QDir(folder.path()).entryList(QDir::Files); }

    QTemporaryDir folder;
};

}

class HandInTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { forgetRecords(); }
    void emptyNotebookShowsWhatToDo();
    void handedInWorkIsVerifiedAndShownOnPages();
    void existingNotebookIsReplacedOnlyAfterConfirmation();
    void theWindowNamesANotebookThatItCannotOpen();
    void theTeacherChecksSeveral();
    void badUseIsNamed_data();
    void badUseIsNamed();
    void thePageVerbWritesAPage();
};

void HandInTest::emptyNotebookShowsWhatToDo()
{
    HandInFixture fixture;
    fixture.open();
    QVERIFY(fixture.dialog().message().startsWith("There is nothing to hand in yet."));
    QVERIFY(!fixture.write().isEnabled());
    QCOMPARE(fixture.part<QListWidget>("handInLessons").count(), 0);
    QVERIFY(fixture.part<QListWidget>("handInLessons").isHidden());
}

void HandInTest::handedInWorkIsVerifiedAndShownOnPages()
{
    HandInFixture fixture;
    fixture.tryFirst();
    fixture.open();
    auto &lessons = fixture.part<QListWidget>("handInLessons");
    QCOMPARE(lessons.count(), 1);
    QVERIFY(lessons.isVisible());
    QCOMPARE(fixture.part<QLineEdit>("handInName").x(), fixture.part<QLineEdit>("handInFile").x());
    QVERIFY(fixture.part<QLineEdit>("handInName").hasFocus());
    fixture.type("handInName", "Ada");
    fixture.type("handInFile", fixture.path("ada"));
    QCOMPARE(fixture.dialog().message(), QString("This writes ada.springstep-notebook."));
    lessons.setFocus();
    QTest::keyClick(&lessons, Qt::Key_Space);
    QVERIFY(!fixture.write().isEnabled()); // nothing is chosen
    QTest::keyClick(&lessons, Qt::Key_Space);
    QTest::keyClick(&fixture.dialog(), Qt::Key_Return);
    settle();
    QVERIFY2(fixture.dialog().message().startsWith("ada.springstep-notebook written to "),
             qPrintable(fixture.dialog().message()));
    QCOMPARE(fixture.files(), QStringList{"ada.springstep-notebook"});
    fixture.writePages();
    const program::Answer answer =
        program::springstep({"notebook", "check", fixture.path("ada.springstep-notebook"), "--json"});
    QCOMPARE(answer.err, QString());
    QCOMPARE(answer.code, 0);
    const QJsonObject book = program::json(answer)["notebooks"].toArray()[0].toObject();
    QCOMPARE(book["name"].toString(), QString("Ada"));
    QVERIFY(book["sealed"].toBool());
    const QJsonArray entries = book["entries"].toArray();
    QVERIFY(!entries.isEmpty());
    for (const QJsonValue &entry : entries)
        QCOMPARE(entry.toObject()["result"].toString(), QString("shown"));
}

void HandInTest::existingNotebookIsReplacedOnlyAfterConfirmation()
{
    HandInFixture fixture;
    fixture.session.progress().markDone("single_spring", "drag", 0);
    fixture.open();
    fixture.type("handInFile", fixture.path("ada"));
    fixture.clickWrite();
    const QByteArray first = contentsOf(fixture.path("ada.springstep-notebook"));
    QVERIFY(!first.isEmpty());
    fixture.clickWrite();
    QVERIFY(fixture.dialog().message().contains("already exists"));
    QCOMPARE(fixture.write().text(), QString("&Replace"));
    fixture.type("handInName", "Eve");
    QCOMPARE(fixture.write().text(), QString("&Replace"));
    fixture.clickWrite();
    QVERIFY(contentsOf(fixture.path("ada.springstep-notebook")).contains("\"name\": \"Eve\""));
    fixture.type("handInFile", "/nowhere/at/all");
    fixture.clickWrite();
    QVERIFY2(fixture.dialog().message().startsWith("Could not write: "),
             qPrintable(fixture.dialog().message()));
}

void HandInTest::theWindowNamesANotebookThatItCannotOpen()
{
    HandInFixture fixture;
    writeWholeFile(fixture.path("a.springstep-notebook"),
                   notebookText({.when = QDateTime::currentDateTimeUtc()}));
    fixture.window.openFile(fixture.path("a.springstep-notebook"));
    QVERIFY2(fixture.notice.sentence().contains("this is a notebook, not an experiment"),
             qPrintable(fixture.notice.sentence()));
}

void HandInTest::theTeacherChecksSeveral()
{
    const QTemporaryDir folder;
    Notebook book{.name = "Ada", .when = QDateTime::currentDateTimeUtc()};
    book.entries = {{.kind = NotebookEntry::Kind::code,
                     .lesson = "single_spring",
                     .step = "fixed_centre",
                     .id = "pull",
                     .code = "void frame() {}\n"}};
    writeWholeFile(folder.filePath("forged"), notebookText(book));
    book.entries.clear();
    writeWholeFile(folder.filePath("empty"), notebookText(book));
    writeWholeFile(folder.filePath("half"), notebookText(book).left(60));
    const auto check = [&](const QStringList &names) {
        QStringList arguments{"notebook", "check", "--csv"};
        for (const QString &name : names)
            arguments << folder.filePath(name);
        return program::springstep(arguments);
    };
    const program::Answer forged = check({"forged", "empty"});
    QCOMPARE(forged.code, 1);
    QCOMPARE(forged.err, QString());
    QVERIFY2(forged.out.contains("\"not shown\""), qPrintable(forged.out));
    const program::Answer half = check({"half", "forged"});
    QCOMPARE(half.code, 2);
    QVERIFY(half.out.contains("\"not shown\"")); // the other one is checked nevertheless
    QCOMPARE(half.err.count('\n'), 2);
    QVERIFY2(half.err.startsWith("half: line ") && half.err.endsWith("1 of 2 notebooks could not be read.\n"),
             qPrintable(half.err));
}

void HandInTest::badUseIsNamed_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const QStringList &arguments, const char *sentence) {
        QTest::newRow(qPrintable(arguments.join(' '))) << arguments << QString(sentence);
    };
    row({"check"}, "notebook takes ACTION FILE...; see springstep notebook --help.");
    row({"grade", "a"}, "notebook cannot \"grade\"; it can \"check\", \"page\" or \"write\".");
    row({"page", "a", "b.doc"}, "\"b.doc\" is not the name of a page; it can end in .html or .pdf.");
    row({"page", "a", "b.html", "--name", "Ada"}, "--name is for notebook write. Leave it out.");
    row({"write", "a.springstep-notebook", "--json"}, "--json is for notebook check. Leave it out.");
    row({"check", "a", "--json", "--csv"}, "--json and --csv are two forms of the result. Leave one out.");
    row({"write", "a", "b"}, "notebook write takes OUT; see springstep notebook --help.");
    row({"write", "a.txt"}, "\"a.txt\" is not the name of a notebook; it ends in .springstep-notebook.");
}

void HandInTest::badUseIsNamed()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, sentence);
    const program::Answer answer = program::springstep(QStringList{"notebook"} + arguments);
    QCOMPARE(answer.err, "springstep: " + sentence + '\n');
    QCOMPARE(answer.out, QString());
    QCOMPARE(answer.code, 2);
}

void HandInTest::thePageVerbWritesAPage()
{
    const QTemporaryDir folder;
    const QString book = folder.filePath("a.springstep-notebook"), page = folder.filePath("a.html");
    writeWholeFile(book, notebookText({.name = "Ada", .when = QDateTime::currentDateTimeUtc()}));
    QCOMPARE(program::springstep({"notebook", "page", book, page}).code, 0);
    QVERIFY(contentsOf(page).contains("<h1>Notebook of Ada</h1>"));
}

SUITE(tst_hand_in, HandInTest)
#include "tst_hand_in.moc"
