#include "tests/app/code/code_support.h"
#include "tests/app/support/waiting.h"
#include "tests/suite.h"

#include <QApplication>
#include <QClipboard>
#include <QSignalSpy>

using namespace code_support;
using namespace tests;

/// The panel with the code that runs: values, buttons, and its behaviour while the run plays.
class TestCodePanel : public QObject
{
    Q_OBJECT

private slots:
    void theShownCodeCannotBeChanged()
    {
        CodeFixture shown;
        const QString before = shown.view().text();
        shown.view().setFocus();
        QTest::keyClicks(&shown.view(), "x = 1;");
        QTest::keyClick(&shown.view(), Qt::Key_Delete);
        QTest::keyClick(&shown.view(), Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(shown.view().text(), before);
    }

    void aFoldedSectionStaysFoldedInTheNextStep()
    {
        CodeFixture shown;
        shown.click(shown.heading("Scene"));
        shown.session.openFollowing();
        QVERIFY(shown.view().isFolded(0));
        QVERIFY(shown.view().rowRect(1).isEmpty());
    }

    void valuesFollowTheSelectedBody()
    {
        CodeFixture shown;
        QSignalSpy captions(shown.panel, &CodePanel::captionChanged);
        shown.session.playback().frameForward();
        QCOMPARE(shown.panel->caption(), QString("values of foot 0"));
        const QString before = shown.view().chipText(shown.row("x = x + h * v"));
        QVERIFY(!before.isEmpty());
        shown.session.select("foot3");
        QCOMPARE(captions.count(), 1);
        QCOMPARE(shown.panel->caption(), QString("values of foot 3"));
        QVERIFY(shown.view().chipText(shown.row("x = x + h * v")) != before);
        shown.session.select("body");
        QCOMPARE(shown.panel->caption(), QString("values of the body"));
    }

    void whileItPlaysNothingIsMarkedAndAStopMarksTheLastPhase()
    {
        CodeFixture shown;
        const auto isMarked = [&](const char *line) { return shown.view().wash(shown.row(line)).isValid(); };
        shown.session.playback().frameForward();
        QVERIFY(isMarked("x = x + h * v"));
        QVERIFY(!isMarked("v = keep * v"));
        shown.session.playback().play();
        QVERIFY(!isMarked("x = x + h * v"));
        shown.session.playback().pause();
        QVERIFY(isMarked("x = x + h * v"));
    }

    void aLineThatIsClickedIsTheOneThatIsMarked()
    {
        CodeFixture shown("single_spring", "fixed_centre");
        const std::size_t row = shown.row("d = target - mover");
        shown.view().showPlace(shown.view().placeOf(row));
        shown.click(row);
        const QColor strong = shown.theme.tokens().wash;
        QCOMPARE(shown.view().wash(row), strong);
        QVERIFY(shown.view().wash(shown.row("pull = k * d")) != strong);
        shown.session.playback().frameForward();
        shown.session.playback().phaseForward();
        QCOMPARE(shown.view().wash(shown.row("pull = k * d")), strong);
    }

    void howTheMethodAddsUpIsFoldedAndUnfoldingIsRemembered()
    {
        {
            CodeFixture shown("single_spring", "fixed_centre");
            const std::size_t adds = shown.row("force.add(");
            QVERIFY(adds < shown.view().rows().size());
            QVERIFY(shown.view().isPlumbingFolded());
            QVERIFY(shown.view().rowRect(adds).isEmpty());
            QVERIFY(!shown.view().rowRect(shown.row("pull = k * d")).isEmpty());
            shown.click(shown.row("added up by the method", CodeRow::Kind::file));
            QVERIFY(!shown.view().rowRect(adds).isEmpty());
            QVERIFY(shown.view().isQuiet(adds)); // still pale
        }
        CodeFixture again("single_spring", "fixed_centre", Settings::kept);
        QVERIFY(!again.view().rowRect(again.row("force.add(")).isEmpty());
        const std::size_t name = again.row("added up by the method", CodeRow::Kind::file);
        while (again.view().row() != name) // the keyboard comes there, too
            QTest::keyClick(&again.view(), Qt::Key_Down);
        QTest::keyClick(&again.view(), Qt::Key_Return);
        QVERIFY(again.view().rowRect(again.row("force.add(")).isEmpty());
    }

    void linesThatComputeNothingArePale()
    {
        CodeFixture shown("single_spring", "fixed_centre");
        QVERIFY(!shown.view().isQuiet(shown.row("d = target - mover")));
        QVERIFY(!shown.view().isQuiet(shown.row("pull = k * d")));
        for (const char *line : {"SpringPull spring(", "return {d, pull};"})
            QVERIFY2(shown.view().isQuiet(shown.row(line)), line);
        QVERIFY(!shown.view().isQuiet(shown.row("Scene scene"))); // the set-up is all to be read
    }

    void breakpointShowsNoEarlierValueOfItsLine()
    {
        CodeFixture shown; // springs of the feet, then the same lines for the body
        const std::size_t row = shown.row("pull = k * d");
        shown.session.playback().breakpoints().toggle(shown.view().placeOf(row));
        shown.session.playback().frameForward();
        QVERIFY(shown.session.playback().breakHit());
        QCOMPARE(shown.session.timeline().cursor(), (sim::Cursor{0, 3}));
        QCOMPARE(shown.view().chipText(row), QString());
        shown.session.playback().phaseForward();
        QVERIFY(!shown.view().chipText(row).isEmpty());
    }

    void anotherBodyIsShownWhileTheMouseRestsOnTheCode()
    {
        CodeFixture shown;
        shown.session.playback().goTo({4, 5});
        const std::size_t row = shown.row("pull = k * d");
        QTest::mouseMove(shown.view().viewport(), shown.view().rowRect(row).center());
        QTRY_VERIFY(shown.session.preview().isActive());
        const QString before = shown.view().chipText(row);
        shown.session.select("foot3");
        QVERIFY(shown.view().chipText(row) != before);
    }

    void aParameterThatChangesChangesItsChip()
    {
        CodeFixture shown;
        const std::size_t row = shown.row("values[\"k\"]");
        const QString before = shown.view().chipText(row);
        shown.session.editor().setParameter("k", 0.35);
        QVERIFY(shown.view().chipText(row) != before);
        QVERIFY(shown.view().chipText(row).contains("0.35"));
    }

    void anotherMethodShowsItsOwnCode()
    {
        CodeFixture shown;
        QVERIFY(shown.heading("Published") < shown.view().rows().size());
        shown.session.editor().setMethod("semi_implicit_euler");
        QVERIFY(shown.heading("Published") == shown.view().rows().size());
        QVERIFY(shown.heading("Kick") < shown.view().rows().size());
    }

    void theButtonGoesThroughTheNewLines()
    {
        CodeFixture shown;
        QToolButton *button = shown.button("new");
        QVERIFY(button && !button->isHidden());
        const QString count = QString::number(shown.panel->listing().newLines());
        QCOMPARE(button->accessibleName(), count + " lines new");
        QSet<QString> blocks;
        for (int i = 0; i < 40; ++i) {
            QTest::mouseClick(button, Qt::LeftButton);
            const QString selected = shown.view().selectedText();
            QVERIFY(!selected.isEmpty());
            blocks << selected;
        }
        const QStringList went = QStringList(blocks.begin(), blocks.end()).join('\n').split('\n');
        QStringList fresh;
        for (const CodeSection &section : shown.panel->listing().sections) {
            for (const CodeLine &line : section.lines) {
                if (line.isNew)
                    fresh << line.source.text;
            }
        }
        QCOMPARE(QSet<QString>(went.begin(), went.end()), QSet<QString>(fresh.begin(), fresh.end()));
    }

    void theFirstStepOfAllHasNoNewLines()
    {
        const LessonEntry &first = library().lessons.front();
        CodeFixture shown(first.id, first.steps.front().id);
        QCOMPARE(shown.panel->listing().newLines(), 0);
        QVERIFY(shown.button("new")->isHidden());
    }

    void removedLinesAreShownOnDemand()
    {
        CodeFixture shown("single_spring", "radial");
        const int gone = shown.panel->listing().goneLines();
        QVERIFY(gone > 0);
        QToolButton *button = shown.button("removed");
        QVERIFY(button && !button->isHidden() && button->isCheckable());
        QVERIFY(!button->toolTip().isEmpty());
        QCOMPARE(button->text(), QString("−%1").arg(gone));
        QVERIFY(button->accessibleName().startsWith(QString::number(gone)));
        const auto rows = shown.view().rows();
        const auto count = [&] {
            const auto &all = shown.view().rows();
            return static_cast<int>(std::count_if(
                all.begin(), all.end(), [](const CodeRow &row) { return row.kind == CodeRow::Kind::gone; }));
        };
        QCOMPARE(count(), 0);
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(count(), gone);
        const CodeRow &row = shown.view().rows()[shown.view().row()];
        QVERIFY(row.kind == CodeRow::Kind::gone); // it goes to the first one
        QVERIFY(!shown.view().rowRect(shown.view().row()).isEmpty());
        // The text has the removed line. It is not part of the run, so no phase can run to it.
        QCOMPARE(shown.view().text(static_cast<int>(shown.view().row())).trimmed(), row.text.trimmed());
        QVERIFY(!shown.view().lineAt(shown.view().row()));
        QVERIFY(shown.view().chipText(shown.view().row()).isEmpty());
        QVERIFY(!shown.view().shownText().contains(row.text)); // nor is it copied
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(count(), 0);
        QCOMPARE(shown.view().rows().size(), rows.size());
    }

    void f8ShowsAndHidesRemovedLines()
    {
        CodeFixture shown("single_spring", "radial");
        shown.view().showPlace(shown.view().placeOf(shown.row("radius * out")));
        const CodePlace place = shown.view().placeOf(shown.view().row());
        QTest::keyClick(&shown.view(), Qt::Key_F8);
        QCOMPARE(shown.view().gone(), Gone::shown);
        const std::size_t first = shown.view().row();
        QVERIFY(shown.view().rows()[first].kind == CodeRow::Kind::gone);
        QTest::keyClick(&shown.view(), Qt::Key_Return); // asks for nothing
        QTest::keyClick(&shown.view(), Qt::Key_F9);
        QVERIFY(shown.session.playback().breakpoints().all().empty());
        QTest::keyClick(&shown.view(), Qt::Key_Down);
        QVERIFY(shown.view().row() > first);
        shown.view().showPlace(place);
        QTest::keyClick(&shown.view(), Qt::Key_F8);
        QCOMPARE(shown.view().gone(), Gone::hidden);
        QVERIFY(shown.view().placeOf(shown.view().row()) == place); // where the keyboard was
    }

    void aStepWithoutRemovedLinesSaysSo()
    {
        const LessonEntry &first = library().lessons.front();
        CodeFixture shown(first.id, first.steps.front().id);
        QVERIFY(shown.button("removed")->isHidden());
        QSignalSpy said(&shown.session.changes(), &ChangeNotifier::messageRequested);
        QTest::keyClick(&shown.view(), Qt::Key_F8);
        QCOMPARE(said.size(), 1);
        QCOMPARE(shown.view().gone(), Gone::hidden);
    }

    void ctrlCTakesTheRegionThatTheKeyboardIsOn()
    {
        CodeFixture shown;
        shown.view().showPlace(shown.view().placeOf(shown.row("x = x + h * v")));
        QTest::keyClick(&shown.view(), Qt::Key_C, Qt::ControlModifier);
        const QString text = QApplication::clipboard()->text();
        QVERIFY(text.contains("    x = x + h * v;\n"));
        QVERIFY(!text.contains("keep"));
    }

    void copyTakesTheShownCodeWithItsFiles()
    {
        CodeFixture shown;
        QApplication::clipboard()->clear();
        QTest::mouseClick(shown.button("Copy"), Qt::LeftButton);
        const QString text = QApplication::clipboard()->text();
        QVERIFY(text.contains("// sim/effects/springs/radial_spring.h:"));
        QVERIFY(text.contains("    x = x + h * v;\n"));
        QVERIFY(!text.contains("step.forces")); // the order is folded
        QVERIFY(!text.contains("//!"));
    }

    void selectedTextIsCopiedAlone()
    {
        CodeFixture shown;
        const int row = int(shown.row("pull = k * d"));
        shown.view().setSelection(row, 4, row, 9);
        QTest::keyClick(&shown.view(), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), shown.view().text(row).mid(4, 5));
    }

    void whilePlayingValuesChangeAtMostTenTimesASecond()
    {
        CodeFixture shown;
        std::vector<CodeChip> last;
        int changes = 0;
        QElapsedTimer clock;
        shown.session.onChange(ChangeKind::cursor, this, [&] {
            changes += shown.view().values() != last;
            last = shown.view().values();
        });
        clock.start();
        shown.session.playback().play();
        QTRY_VERIFY(changes >= 5);
        shown.session.playback().pause();
        QVERIFY2(changes <= clock.elapsed() / 100 + 1, qPrintable(QString::number(changes)));
        // When the run stops, the values of that moment are shown at once.
        const sim::ComposedInterval &interval = shown.session.timeline().track().interval();
        const auto current =
            chipsOf(shown.panel->listing(), shown.session.presentation().explanations(), interval, 0);
        QVERIFY(!current.empty());
        const auto &values = shown.view().values();
        QVERIFY(std::equal(current.begin(), current.end(), values.begin()));
    }

    void playingDoesNotScroll()
    {
        CodeFixture shown;
        shown.session.playback().frameForward();
        const QRect before = shown.view().rowRect(0);
        shown.session.playback().play();
        QTRY_VERIFY(shown.session.timeline().cursor().frame > 15);
        shown.session.playback().pause();
        QCOMPARE(shown.view().rowRect(0), before);
    }

    void theCodeOfAFrameScrollsIntoViewWhenTheRunBegins()
    {
        CodeFixture shown;
        QCOMPARE(shown.view().rowRect(0).top(), 0);
        shown.session.playback().frameForward();
        QCOMPARE(shown.view().rowRect(shown.heading("1 Springs")).top(), 0);
    }

    void nothingRunsWhileNothingMoves()
    {
        CodeFixture shown;
        QVERIFY(QTest::qWaitForWindowActive(&shown.window));
        shown.view().setFocus(Qt::TabFocusReason);
        shown.session.playback().phaseForward();
        QVERIFY(Activity().comesToRest(1200)); // longer than a cursor takes to blink
    }

    void screenReadersGetNamesForTheCodeAndItsButtons()
    {
        CodeFixture shown;
        QCOMPARE(shown.view().accessibleName(), QString("Code that runs"));
        const auto buttons = shown.panel->titleActions()->findChildren<QToolButton *>();
        QVERIFY(!buttons.isEmpty());
        for (const QToolButton *button : buttons) {
            QVERIFY(!button->accessibleName().isEmpty());
            QVERIFY(!button->toolTip().isEmpty());
        }
    }
};

SUITE(tst_code_panel, TestCodePanel)
#include "tst_code_panel.moc"
