#include "tests/app/listing/listing_window.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/suite.h"

#include <QSignalSpy>

using namespace listing_window;

/// Typing in the listing of a step: how it changes the run, and which keys the editor handles.
class TestTypingCode : public QObject
{
    Q_OBJECT

private slots:
    void aTypedChangeComputesTheRunAgainAndTheOldRunIsTheGhost()
    {
        ListingFixture shown;
        const sim::Vec2 start = shown.position("foot");
        const sim::Vec2 centre{shown.session.editor().parameter("centre_x"),
                               shown.session.editor().parameter("centre_y")};
        const double k = shown.session.editor().parameter("k"),
                     damp = shown.session.editor().parameter("damp");
        shown.goTo(30);
        QVERIFY(isNear(shown.position("foot"), footOnSpring(start, centre, k, damp, 30)));
        shown.type("foot.velocity *= damp", "damp", "0.5");
        QCOMPARE(shown.frame(), 30);
        QVERIFY(isNear(shown.position("foot"), footOnSpring(start, centre, k, 0.5, 30)));
        QVERIFY(shown.session.comparisons().shown());
        QVERIFY(shown.view.shown().comparison);
        QVERIFY(shown.session.code().isInUse());
    }

    void theFirstPauseAfterTheStartLeavesCaretAndFocus()
    {
        // The step is open before the panel is made, as when the program starts.
        tests::PanelFixture<ListingPanel> shown(LessonLibrary::load({LESSON_DIR}), QSize(600, 500));
        ListingEditor &editor = shown.panel.editor();
        const QSignalSpy left(&shown.panel, &ListingPanel::left);
        editor.setFocus();
        editor.setCursorPosition(5, static_cast<int>(editor.text(5).size()) - 1);
        QTest::keyClicks(&editor, " ");
        QTRY_VERIFY(shown.session.code().isInUse());
        tests::settle();
        QCOMPARE(left.count(), 0);
        QTest::keyClicks(&editor, "// here");
        QVERIFY2(editor.text(5).endsWith(" // here\n"), qPrintable(editor.text()));
    }

    void aPanelThatIsDeletedAppliesTheTypedText()
    {
        tests::SessionFixture world(LessonLibrary::load({LESSON_DIR}));
        {
            ListingPanel panel(world.session, world.theme);
            tests::show(panel, {600, 500});
            panel.editor().setFocus();
            QTest::keyClicks(&panel.editor(), "// last");
            QVERIFY(panel.editor().isPending());
        }
        QVERIFY2(world.session.code().text().startsWith("// last"), qPrintable(world.session.code().text()));
    }

    void aMistakeIsUnderlinedAndExplainedWhileTheLastGoodCodeGoesOn()
    {
        ListingFixture shown;
        shown.goTo(20);
        const sim::Vec2 before = shown.position("foot");
        shown.type("foot.velocity *= damp", "velocity", "velocty");
        QCOMPARE(shown.panel.sentence().left(8), QString("Line %1:").arg(shown.line("velocty")).left(8));
        QVERIFY2(shown.panel.sentence().contains("velocty") && shown.panel.sentence().contains("velocity"),
                 qPrintable(shown.panel.sentence()));
        const TextRange wrong = shown.range("velocty", "velocty");
        QVERIFY(shown.editor.isUnderlined(wrong.line, wrong.column));
        QVERIFY(!shown.editor.isUnderlined(1, 1));
        QVERIFY(isNear(shown.position("foot"), before));
        shown.session.playback().frameForward();
        QCOMPARE(shown.frame(), 21);
        shown.type("velocty", "velocty", "velocity");
        QVERIFY(shown.panel.sentence().isEmpty());
        QVERIFY(!shown.editor.isUnderlined(wrong.line, wrong.column));
    }

    void aMistakeOfAStepStaysWithItsStep()
    {
        ListingFixture shown;
        shown.type("foot.velocity *= damp", "velocity", "velocty");
        shown.session.openFollowing();
        QVERIFY(shown.panel.sentence().isEmpty());
        QCOMPARE(shown.editor.text(), shown.session.step().listing.text);
        shown.session.openPreceding();
        QVERIFY(shown.editor.text().contains("velocty"));
        QVERIFY(!shown.panel.sentence().isEmpty());
    }

    void undoTakesBackWhatWasTypedAndRedoBringsItBack()
    {
        ListingFixture shown;
        const QString original = shown.editor.text();
        shown.type("foot.velocity *= damp", "damp", "0.5");
        const QString changed = shown.editor.text();
        QVERIFY(changed != original);
        QTest::keyClick(&shown.editor, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(shown.editor.text(), original);
        QTest::keyClick(&shown.editor, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(shown.editor.text(), changed);
    }

    void undoRightAfterTypingRemovesOnlyTheTypedText()
    {
        ListingFixture shown;
        const QString original = shown.editor.text();
        const TextRange at = shown.range("*= damp", "damp");
        shown.editor.setFocus();
        shown.editor.setSelection(at.line - 1, at.column - 1, at.line - 1, at.column + 3);
        QTest::keyClicks(&shown.editor, "0.5");
        QVERIFY(shown.editor.isPending());
        QTest::keyClick(&shown.editor, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(shown.editor.text(), original);
        shown.compile();
        QCOMPARE(shown.editor.text(), original);
    }

    void theEditorIndentsAndSpacesDoNotPlay()
    {
        ListingFixture shown;
        const int line = shown.line("*= damp");
        shown.editor.setFocus();
        shown.editor.setCursorPosition(line - 1, static_cast<int>(shown.editor.text(line - 1).size()) - 1);
        QTest::keyClick(&shown.editor, Qt::Key_Return);
        QTest::keyClicks(&shown.editor, "if (foot.held) {");
        QTest::keyClick(&shown.editor, Qt::Key_Return);
        QTest::keyClicks(&shown.editor, "foot.velocity *= 2;");
        QTest::keyClick(&shown.editor, Qt::Key_Return);
        QTest::keyClicks(&shown.editor, "}");
        shown.compile();
        QCOMPARE(shown.editor.text(line), QString("        if (foot.held) {\n"));
        QCOMPARE(shown.editor.text(line + 1), QString("            foot.velocity *= 2;\n"));
        QCOMPARE(shown.editor.text(line + 2), QString("        }\n"));
        QVERIFY(!shown.session.playback().isPlaying());
        QVERIFY(shown.panel.sentence().isEmpty());
    }

    void theStatementOfAnIfWithoutBracesIsIndented()
    {
        ListingFixture shown;
        const int line = shown.line("*= damp");
        shown.editor.setFocus();
        shown.editor.setCursorPosition(line - 1, static_cast<int>(shown.editor.text(line - 1).size()) - 1);
        for (const char *typed :
             {"", "for (int i = 0; i < 2; i++) // twice", "if (foot.held)", "foot.velocity *= 2;",
              "if (foot.held)", "foot.velocity *= 3;", "else", "foot.velocity *= 4;"}) {
            QTest::keyClicks(&shown.editor, typed);
            QTest::keyClick(&shown.editor, Qt::Key_Return);
        }
        QTest::keyClicks(&shown.editor, "foot.velocity *= 5;");
        shown.compile();
        const QStringList wanted = {"        for (int i = 0; i < 2; i++) // twice",
                                    "            if (foot.held)",
                                    "                foot.velocity *= 2;",
                                    "        if (foot.held)",
                                    "            foot.velocity *= 3;",
                                    "        else",
                                    "            foot.velocity *= 4;",
                                    "        foot.velocity *= 5;"};
        QCOMPARE(shown.editor.text().split('\n').mid(line, wanted.size()), wanted);
        QVERIFY(shown.panel.sentence().isEmpty());
    }

    void aClosingBraceStandsBelowTheLineOfItsPartner()
    {
        ListingFixture shown;
        const int line = shown.line("*= damp");
        shown.editor.setFocus();
        shown.editor.setCursorPosition(line - 1, static_cast<int>(shown.editor.text(line - 1).size()) - 1);
        QTest::keyClick(&shown.editor, Qt::Key_Return);
        QTest::keyClicks(&shown.editor, "if (foot.held)");
        QTest::keyClick(&shown.editor, Qt::Key_Return);
        QTest::keyClicks(&shown.editor, "{");
        shown.editor.insert("\n        foot.velocity *= 2;\n        "); // not indented
        shown.editor.setCursorPosition(line + 3, 8);
        QTest::keyClicks(&shown.editor, "}");
        QCOMPARE(shown.editor.text(line + 1), QString("        {\n"));
        QCOMPARE(shown.editor.text(line + 3), QString("        }\n"));
    }

    void aSmallerSignIsNotMarkedAsABracketWithoutPartner()
    {
        ListingFixture shown;
        shown.type("*= damp", "damp", "k <");
        const QRect sign = shown.editor.wordRect(shown.range("k <", "<"));
        const QImage image = shown.editor.viewport()->grab(sign).toImage();
        int red = 0;
        for (int x = 0; x < image.width(); ++x) {
            for (int y = 0; y < image.height() * 3 / 4; ++y) // not the line under a mistake
                red += qRed(image.pixel(x, y)) > qGreen(image.pixel(x, y)) + 60 ? 1 : 0;
        }
        QCOMPARE(red, 0);
    }

    void namesAreNotCompletedInsideAWord()
    {
        ListingFixture shown;
        shown.window.move(-500, 0); // the screen without a display is 800 px wide
        const TextRange at = shown.range("*= damp", "damp");
        shown.editor.setFocus();
        shown.editor.setCursorPosition(at.line - 1, at.column + 1); // behind "da"
        QTest::keyClicks(&shown.editor, "m");
        tests::settle();
        QVERIFY(!shown.editor.isListActive());
    }

    void namesAreCompleted()
    {
        ListingFixture shown;
        shown.window.move(-500, 0); // the screen without a display is 800 px wide
        const int line = shown.line("*= damp");
        shown.editor.setFocus();
        shown.editor.setCursorPosition(line - 1, static_cast<int>(shown.editor.text(line - 1).size()) - 1);
        QTest::keyClick(&shown.editor, Qt::Key_Return);
        QTest::keyClicks(&shown.editor, "foot.vel");
        QTRY_VERIFY(shown.editor.isListActive());
        QTest::keyClick(&shown.editor, Qt::Key_Return);
        QTest::keyClicks(&shown.editor, " *= 1;");
        shown.compile();
        QCOMPARE(shown.editor.text(line).trimmed(), QString("foot.velocity *= 1;"));
    }

    void completionListIsNotOpenedOffScreen()
    {
        ListingFixture shown;
        shown.window.move(3000, 0);
        const int line = shown.line("*= damp");
        shown.editor.setFocus();
        shown.editor.setCursorPosition(line - 1, static_cast<int>(shown.editor.text(line - 1).size()) - 1);
        QTest::keyClicks(&shown.editor, " foot.vel");
        tests::settle();
        QVERIFY(!shown.editor.isListActive());
    }

    void tabPassesThroughTheEditorUntilTheLearnerTypes()
    {
        ListingFixture shown;
        const QString before = shown.editor.text();
        shown.editor.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&shown.editor, Qt::Key_Tab);
        QVERIFY(!shown.editor.hasFocus());
        QCOMPARE(shown.editor.text(), before);
        shown.editor.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&shown.editor, Qt::Key_Down);
        QTest::keyClick(&shown.editor, Qt::Key_Down);
        QTest::keyClick(&shown.editor, Qt::Key_Tab);
        QVERIFY(shown.editor.hasFocus());
        QCOMPARE(shown.editor.text(2), "    " + before.split('\n')[2] + '\n');
    }

    void escapeLeavesTheEditor()
    {
        ListingFixture shown;
        shown.editor.setFocus();
        QTest::keyClick(&shown.editor, Qt::Key_Escape);
        QVERIFY(shown.view.hasFocus());
    }

    void theNextStepTakesTheFocusFromTheEditorSoThatSpacePlaysIt()
    {
        ListingFixture shown;
        shown.editor.setFocus();
        shown.session.openFollowing();
        QVERIFY(shown.view.hasFocus());
        const QString before = shown.editor.text();
        QTest::keyClick(&shown.view, Qt::Key_Space);
        QVERIFY(shown.session.playback().isPlaying());
        QCOMPARE(shown.editor.text(), before);
    }
};

SUITE(tst_typing_code, TestTypingCode)
#include "tst_typing_code.moc"
