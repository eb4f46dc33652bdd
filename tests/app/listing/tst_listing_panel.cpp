#include "tests/app/listing/listing_window.h"
#include "tests/suite.h"

#include "app/model/listing/listing_names.h"
#include "app/ui/code/engine/code_view.h"
#include "sim/run/script/composed_interval.h"

#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QSettings>

using namespace listing_window;

/// The panel where learners read and step through the listing of a step.
class TestListingPanel : public QObject
{
    Q_OBJECT

private slots:
    void stepWithAListingOpensOnTheListingPage()
    {
        const ListingFixture shown;
        QCOMPARE(shown.pages.page(), CodePages::Page::listing);
        QVERIFY(shown.editor.isVisible());
        QCOMPARE(shown.editor.text(), shown.session.step().listing.text);
        QVERIFY(shown.editor.text().contains("foot.velocity += k * (centre - foot.position);"));
    }

    void theEnginesPageIsOneClickAwayAndStaysInLaterWindows()
    {
        {
            const ListingFixture shown;
            QTest::mouseClick(shown.button("Engine"), Qt::LeftButton);
            QVERIFY(shown.part<CodeView>().isVisible());
            QVERIFY(!shown.editor.isVisible());
        }
        ListingFixture later("single_spring", "fixed_centre", {});
        QCOMPARE(later.pages.page(), CodePages::Page::engine);
        QTest::mouseClick(later.button("Listing"), Qt::LeftButton);
        QVERIFY(later.editor.isVisible());
    }

    void shiftAndArrowsGoFromLineToLine()
    {
        ListingFixture shown;
        shown.goTo(5);
        shown.view.setFocus();
        QList<int> lines{shown.next()};
        for (int i = 0; i < 6; ++i) {
            shown.key(Qt::Key_Right, Qt::ShiftModifier);
            lines << shown.next();
        }
        const int first = shown.line("if (foot.held)"), centre = shown.line("Vec2 centre"),
                  pull = shown.line("+= k *"), damping = shown.line("*= damp"),
                  move = shown.line("position += foot.velocity");
        const auto end = static_cast<int>(shown.editor.text().trimmed().count('\n')) +
                         1; // the brace that closes the function
        QCOMPARE(lines, QList<int>({first, centre, pull, damping, move, end, first}));
        QCOMPARE(shown.frame(), 6);
        shown.key(Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(shown.frame(), 5);
        QCOMPARE(shown.next(), end);
        for (int i = 0; i < 5; ++i)
            shown.key(Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(shown.next(), first);
        QCOMPARE(shown.session.lines().index(), 0);
    }

    void insideAFrameThePictureAndTheValuesAreThoseAfterTheLine()
    {
        ListingFixture shown;
        const sim::Vec2 foot = shown.position("foot");
        const double k = shown.session.editor().parameter("k");
        const double cx = shown.session.editor().parameter("centre_x");
        for (int i = 0; i < 3; ++i)
            shown.key(Qt::Key_Right, Qt::ShiftModifier);
        const sim::State state = shown.session.presentation().picture().state;
        QCOMPARE(state.velocityOf(0).x, k * (cx - foot.x));
        QCOMPARE(state.positionOf(0).x, foot.x);
        QVERIFY(!shown.editor.chipText(shown.line("+= k *")).isEmpty());
        QVERIFY(shown.editor.chipText(shown.line("position += foot.velocity")).isEmpty());
        shown.key(Qt::Key_Right); // to the end of the frame
        QCOMPARE(shown.session.lines().index(), 0);
        QCOMPARE(shown.frame(), 1);
        QVERIFY(!shown.editor.chipText(shown.line("position += foot.velocity")).isEmpty());
    }

    void stepsGoIntoCallsOverThemAndOutOfThem()
    {
        ListingFixture shown("multi_foot", "two_feet");
        const auto isInside = [&] { return !shown.panel.calls().isEmpty(); };
        for (int i = 0; i < 60 && !isInside(); ++i)
            shown.key(Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(isInside());
        QVERIFY2(shown.panel.calls().startsWith("frame › "), qPrintable(shown.panel.calls()));
        const int inside = shown.session.lines().index();
        shown.key(Qt::Key_F10, Qt::ControlModifier);
        QVERIFY(!isInside());
        QVERIFY(shown.session.lines().index() > inside);
        const int out = shown.session.lines().index();
        for (int i = shown.session.lines().index(); i > inside - 1; --i)
            shown.key(Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(!isInside());
        shown.key(Qt::Key_F10);
        QVERIFY(!isInside());
        QVERIFY(shown.session.lines().index() >= out);
    }

    void longLinesAreWrappedAndTheirValuesAreShown()
    {
        ListingFixture shown("walking_gait", "ground");
        shown.goTo(60);
        QCOMPARE(shown.editor.horizontalScrollBar()->maximum(), 0);
        const int width = shown.editor.viewport()->width();
        int wrapped = 0;
        for (int line = 1; line <= shown.editor.lines(); ++line) {
            const auto length = static_cast<int>(shown.editor.text(line - 1).trimmed().size());
            if (length == 0)
                continue;
            const auto last =
                static_cast<int>(shown.editor.text(line - 1).indexOf(shown.editor.text(line - 1).trimmed())) +
                length;
            const QRect letter = shown.editor.wordRect({line, last, 1});
            QVERIFY(letter.right() <= width);
            QVERIFY(shown.editor.lineRect(line).contains(letter.center()) ||
                    letter.bottom() > shown.editor.viewport()->height());
            wrapped += shown.editor.lineRect(line).height() > letter.height() ? 1 : 0;
        }
        QVERIFY(wrapped > 0);
        int shortChips = 0;
        for (const LineChip &chip : shown.editor.values().chips) {
            if (chip.shorter.last().size() > 4)
                continue;
            ++shortChips;
            QVERIFY2(shown.editor.chipText(chip.line) != "…", qPrintable(chip.text));
        }
        QVERIFY(shortChips > 0);
        QVERIFY(shown.editor.values().chips.size() > 3);
    }

    void loopShowsItsIteration()
    {
        ListingFixture shown("multi_foot", "any_number");
        const int body = shown.line("Body foot = feet[i]");
        shown.clickMargin(body);
        QCOMPARE(shown.next(), body);
        shown.clickMargin(body);
        const QString turn = shown.editor.chipText(shown.line("for (int i"));
        const auto feet = static_cast<int>(shown.session.editor().parameter("feet"));
        QCOMPARE(turn, QString("i = 1 of %1").arg(feet)); // the second turn: it counts from 0
    }

    void aClickInTheMarginRunsToTheLine()
    {
        ListingFixture shown;
        const int line = shown.line("*= damp");
        shown.clickMargin(line);
        QCOMPARE(shown.next(), line);
        QCOMPARE(shown.frame(), 0);
        shown.clickMargin(line); // again: in the next frame
        QCOMPARE(shown.next(), line);
        QCOMPARE(shown.frame(), 1);
    }

    void theStripShowsTheLinesOfTheFrame()
    {
        ListingFixture shown;
        const LineStrip &strip = shown.timeline.lines();
        QCOMPARE(strip.count(), 6); // with the brace that closes the function
        QCOMPARE(strip.lineOf(3), shown.line("*= damp"));
        QTest::mouseClick(&shown.timeline, Qt::LeftButton, {}, strip.areaOf(3).center().toPoint());
        QCOMPARE(shown.next(), shown.line("*= damp"));
        QVERIFY2(shown.timeline.sentence().contains("3 of 6 lines"), qPrintable(shown.timeline.sentence()));
        QTest::mouseClick(shown.button("Engine"), Qt::LeftButton);
        QVERIFY(
            shown.timeline.hintAt(shown.timeline.phases().areaOf(0).center().toPoint()).contains("phase 1"));
    }

    void underTheEnginesPageShiftAndArrowsGoByPhases()
    {
        ListingFixture shown("single_spring", "fixed_centre", "engine");
        shown.key(Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(shown.phase(), 1);
        QCOMPARE(shown.session.lines().index(), 0);
    }

    void afterAPhaseTimeGoesByPhasesAlsoUnderTheListing()
    {
        ListingFixture shown("single_spring", "fixed_centre", "engine");
        shown.key(Qt::Key_Right, Qt::ShiftModifier);
        QTest::mouseClick(shown.button("Listing"), Qt::LeftButton);
        QCOMPARE(shown.phase(), 1);
        const auto hint = [&shown](const QRectF &part) {
            return shown.timeline.hintAt(part.center().toPoint());
        };
        QVERIFY(hint(shown.timeline.phases().areaOf(0)).contains("phase 1"));
        shown.key(Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(shown.phase(), 2);
        shown.key(Qt::Key_Right);
        QCOMPARE(shown.phase(), 0);
        QVERIFY(hint(shown.timeline.lines().areaOf(0)).contains("Line"));
        shown.key(Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(shown.phase(), 0);
        QCOMPARE(shown.session.lines().index(), 1);
    }

    void resetBringsTheStepsListingBackAndUndoTheChange()
    {
        ListingFixture shown;
        const QString original = shown.editor.text();
        QAbstractButton &reset = shown.part<QToolButton>("resetListing");
        QVERIFY(!reset.isEnabled());
        shown.goTo(10);
        const sim::Vec2 before = shown.position("foot");
        shown.type("foot.velocity *= damp", "damp", "0.5");
        const QString changed = shown.editor.text();
        QVERIFY(reset.isEnabled());
        QTest::mouseClick(&reset, Qt::LeftButton);
        QCOMPARE(shown.editor.text(), original);
        QVERIFY(isNear(shown.position("foot"), before));
        QCOMPARE(shown.session.timeline().script().method->id(), std::string("published"));
        QTest::keyClick(&shown.view, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(shown.editor.text(), changed);
    }

    void pointingAtAVectorDrawsItInTheScene()
    {
        ListingFixture shown;
        shown.key(Qt::Key_Right);
        shown.point(shown.middleOf("+= k *", "centre"));
        const auto &place = shown.view.shown().vector;
        QVERIFY(place.has_value());
        QCOMPARE(place->kind, VectorMark::Kind::place);
        QCOMPARE(place->to.x, shown.session.editor().parameter("centre_x"));
        QCOMPARE(place->to.y, shown.session.editor().parameter("centre_y"));
        shown.point(shown.middleOf("*= damp", "velocity"));
        const auto &velocity = shown.view.shown().vector;
        QVERIFY(velocity.has_value());
        QCOMPARE(velocity->kind, VectorMark::Kind::difference);
        QCOMPARE(velocity->from.x, shown.position("foot").x);
        QCOMPARE(velocity->to.x - velocity->from.x, shown.session.timeline().state().velocityOf(0).x);
        const QImage with = shown.view.picture();
        shown.point(shown.middleOf("else", "else"));
        QVERIFY(!shown.view.shown().vector);
        QVERIFY(shown.view.picture() != with);
    }

    void markOfANameDisappearsWithItsStep()
    {
        ListingFixture shown("codeling", "motor");
        shown.key(Qt::Key_Right);
        shown.point(shown.middleOf("lead.velocity = hand", "velocity"));
        QVERIFY(shown.view.shown().vector.has_value());
        shown.session.openStep("codeling", "orientation"); // its listing has the same word in the same place
        tests::settle();
        QVERIFY(!shown.view.shown().vector);
    }

    void pointingAtABodyMarksWhereTheListingUsesIt()
    {
        ListingFixture shown;
        const TextRange use = shown.range("*= damp", "foot");
        QVERIFY(!shown.editor.isUse(use.line, use.column));
        QTest::mouseMove(shown.view.viewport(), shown.onScreen("foot"));
        QCoreApplication::processEvents();
        QVERIFY(shown.editor.isUse(use.line, use.column));
        const TextRange other = shown.range("Vec2 centre", "centre");
        QVERIFY(!shown.editor.isUse(other.line, other.column));
        QTest::mouseMove(shown.view.viewport(), QPoint(3, 3));
        QCoreApplication::processEvents();
        QVERIFY(!shown.editor.isUse(use.line, use.column));
    }

    void aParameterIsDraggedWithoutAChangeOfTheText()
    {
        ListingFixture shown;
        const QString before = shown.editor.text();
        const double k = shown.session.editor().parameter("k");
        tests::dragMouse(*shown.editor.viewport(), shown.middleOf("+= k *", "k"), {20, 0});
        QVERIFY(shown.session.editor().parameter("k") > k);
        QCOMPARE(shown.editor.text(), before);
        QTest::keyClick(&shown.view, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(shown.session.editor().parameter("k"), k);
    }

    void aVariableWithTheNameOfAParameterIsNotDragged()
    {
        ListingFixture shown;
        const double damp = shown.session.editor().parameter("damp");
        shown.session.code().write(shown.editor.text().replace(
            "    foot.velocity *= damp",
            "    // grün\n    foot.velocity *= damp;\n    double damp = 0.5;\n    "
            "foot.velocity.x *= damp"));
        tests::settle();
        QVERIFY(shown.session.code().program());
        const QString text = shown.editor.text();
        const QStringList parameters = {"k", "damp", "centre"};
        const std::vector<TextRange> uses = usesOfParameters(text, parameters);
        QCOMPARE(uses,
                 (std::vector<TextRange>{shown.range("+= k *", "k"), shown.range("y *= damp", "damp")}));
        QCOMPARE(usesOfParameters("void frame() { floor(1); a.k = k; }", {"floor", "k"}),
                 (std::vector<TextRange>{{1, 32, 1}}));
        tests::dragMouse(*shown.editor.viewport(), shown.middleOf("x *= damp", "damp"), {40, 0});
        QCOMPARE(shown.session.editor().parameter("damp"), damp);
        tests::dragMouse(*shown.editor.viewport(), shown.middleOf("y *= damp", "damp"), {-40, 0});
        QVERIFY(shown.session.editor().parameter("damp") < damp);
    }

    void aNumberIsDraggedInTheText()
    {
        ListingFixture shown;
        shown.type("foot.velocity *= damp", "damp", "0.50");
        tests::dragMouse(*shown.editor.viewport(), shown.middleOf("*= 0.50", "0.50"), {20, 0});
        tests::settle();
        QVERIFY2(shown.editor.text().contains("*= 0.60;"), qPrintable(shown.editor.text()));
        QVERIFY(shown.session.code().text().contains("*= 0.60;"));
    }

    void underAnotherMethodItsPageIsShownAndTheListingOffered()
    {
        ListingFixture shown;
        QPushButton &use = shown.part<QPushButton>("useListing");
        QVERIFY(!use.isVisible());
        shown.type("foot.velocity *= damp", "damp", "0.5");
        const QString changed = shown.editor.text();
        shown.session.editor().setMethod("rk4");
        QCOMPARE(shown.pages.page(), CodePages::Page::engine);
        QVERIFY(use.isVisible());
        QCOMPARE(use.text(), QString("Use your code"));
        QTest::mouseClick(&use, Qt::LeftButton);
        QCOMPARE(shown.session.timeline().script().method->id(), std::string("listing"));
        QCOMPARE(shown.pages.page(), CodePages::Page::listing);
        QCOMPARE(shown.editor.text(), changed);
        QVERIFY(!use.isVisible());
    }

    void yourCodeIsAmongTheMethods()
    {
        ListingFixture shown;
        QAction &own = shown.actionCalled("Your code");
        QVERIFY(own.isEnabled() && !own.isChecked());
        shown.type("foot.velocity *= damp", "damp", "0.5");
        QVERIFY(own.isChecked());
        shown.session.editor().setMethod("rk4");
        QVERIFY(!own.isChecked());
        own.trigger();
        QCOMPARE(shown.session.timeline().script().method->id(), std::string("listing"));
    }

    void aMistakeWhileItRunsIsShownOnItsLine()
    {
        ListingFixture shown;
        shown.goTo(3);
        shown.type("foot.velocity *= damp", "damp", "1 / (foot.position.x - foot.position.x)");
        shown.session.playback().frameForward();
        QVERIFY2(shown.panel.sentence().contains(QString("ine %1").arg(shown.line("1 / ("))),
                 qPrintable(shown.panel.sentence()));
        QCOMPARE(shown.editor.marks().failed, shown.line("1 / ("));
    }

    void theRunStopsWhenAVariableOfTheListingMeetsACondition()
    {
        ListingFixture shown;
        tests::typeInto(*shown.panel.stops().field(), "centre.x > 1");
        QCOMPARE(shown.panel.stops().errorText(), QString());
        shown.view.setFocus();
        shown.key(Qt::Key_Space);
        QTRY_VERIFY(shown.session.playback().breakHit());
        QVERIFY(!shown.session.playback().isPlaying());
        QVERIFY(shown.frame() <= 1);
    }

    void everythingIsReadableInGermanAt1280By800()
    {
        tests::WindowFixture german({.lesson = "single_spring",
                                     .step = "fixed_centre",
                                     .language = "de",
                                     .scheme = Scheme::dark,
                                     .codePage = "listing"});
        const QToolButton &reset = german.part<QToolButton>("resetListing");
        QVERIFY(reset.width() >= reset.sizeHint().width());
    }
};

SUITE(tst_listing_panel, TestListingPanel)
#include "tst_listing_panel.moc"
