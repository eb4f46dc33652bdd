#include "app/ui/theme/focus_ring.h"
#include "app/ui/time/timeline_painter.h"
#include "tests/app/support/waiting.h"
#include "tests/app/time/time_support.h"
#include "tests/suite.h"

#include <QAccessible>
#include <QMenu>
#include <QPaintEvent>
#include <QTest>
#include <QWheelEvent>

using namespace app;
using namespace tests;

namespace {

/// Collects what a widget repaints.
struct PaintLog : QObject
{
    QRegion painted;
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() == QEvent::Paint)
            painted += static_cast<QPaintEvent *>(event)->region();
        return false;
    }
};

void turnWheel(QWidget *widget, int delta, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
{
    QWheelEvent event(QPointF(100, 25), widget->mapToGlobal(QPointF(100, 25)), {}, {0, delta}, Qt::NoButton,
                      modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
}

}

class TestTime : public QObject
{
    Q_OBJECT

private slots:
    void scrubbingGivesTheBitsOfAStraightRun();
    void pressingOnTheTrackPauses();
    void everyKeyOfTheTimelineWorks_data();
    void everyKeyOfTheTimelineWorks();
    void otherKeysAreLeftToTheWindow_data();
    void otherKeysAreLeftToTheWindow();
    void aClickedPhaseHasJustRun_data();
    void aClickedPhaseHasJustRun();
    void theWheelTurnsFramesAndWithShiftPhases();
    void theGhostAppearsAfterAChangeInThePastAndCanBeForgotten();
    void whilePlayingThePhaseStripIsNotPainted();
    void onlyThePhaseThatJustRanIsAmber();
    void namesThatDoNotFitBecomeMarks();
    void theCurrentPhaseAlwaysHasItsName_data();
    void theCurrentPhaseAlwaysHasItsName();
    void namesComeBackWhereThereIsRoomAgain();
    void theNameOfTheOldRunIsWholeWhileThatRunGrows();
    void theFocusRingTouchesNoNumber();
    void screenReadersHearFrameAndPhase();
    void nothingRunsWhileNothingMoves();
};

void TestTime::scrubbingGivesTheBitsOfAStraightRun()
{
    TimeFixture fixture;
    QTest::mousePress(fixture.strip, Qt::LeftButton, {}, fixture.onTrack(100));
    for (const std::int64_t frame : {100, 73, 74, 12, 0, 119, 41}) {
        QTest::mouseMove(fixture.strip, fixture.onTrack(frame));
        QVERIFY(fixture.arrive());
        QCOMPARE(fixture.at(), (sim::Cursor{frame, 0}));
        QVERIFY(fixture.isStraightRun());
    }
    QTest::mouseRelease(fixture.strip, Qt::LeftButton, {}, fixture.onTrack(41));
    QTest::mouseMove(fixture.strip, fixture.onTrack(90));
    QCOMPARE(fixture.at().frame, 41);
}

void TestTime::pressingOnTheTrackPauses()
{
    TimeFixture fixture;
    fixture.session.playback().play();
    QTest::mousePress(fixture.strip, Qt::LeftButton, {}, fixture.onTrack(30));
    QVERIFY(!fixture.session.playback().isPlaying());
    QVERIFY(fixture.arrive());
    QCOMPARE(fixture.at().frame, 30);
    QTest::mouseRelease(fixture.strip, Qt::LeftButton, {}, fixture.onTrack(30));
}

void TestTime::everyKeyOfTheTimelineWorks_data()
{
    QTest::addColumn<int>("key");
    QTest::addColumn<bool>("shift");
    QTest::addColumn<int>("frame");
    QTest::addColumn<int>("phase");
    QTest::newRow("Right: the next frame") << int(Qt::Key_Right) << false << 42 << 0;
    QTest::newRow("Left: the start of the frame") << int(Qt::Key_Left) << false << 41 << 0;
    QTest::newRow("Shift+Right: the next phase") << int(Qt::Key_Right) << true << 41 << 3;
    QTest::newRow("Shift+Left: the phase before") << int(Qt::Key_Left) << true << 41 << 1;
    QTest::newRow("Home: frame 0") << int(Qt::Key_Home) << false << 0 << 0;
    QTest::newRow("End: the last computed frame") << int(Qt::Key_End) << false << 60 << 0;
}

void TestTime::everyKeyOfTheTimelineWorks()
{
    QFETCH(int, key);
    QFETCH(bool, shift);
    QFETCH(int, frame);
    QFETCH(int, phase);
    TimeFixture fixture;
    fixture.goTo(60);
    fixture.goTo(41, 2);
    fixture.strip->setFocus(Qt::TabFocusReason);
    QTest::keyClick(fixture.strip, Qt::Key(key), shift ? Qt::ShiftModifier : Qt::NoModifier);
    QVERIFY(fixture.arrive());
    QCOMPARE(fixture.at(), (sim::Cursor{frame, phase}));
    QVERIFY(fixture.isStraightRun());
}

void TestTime::otherKeysAreLeftToTheWindow_data()
{
    QTest::addColumn<int>("key");
    QTest::newRow("Page Up") << int(Qt::Key_PageUp);
    QTest::newRow("Page Down") << int(Qt::Key_PageDown);
    QTest::newRow("Space") << int(Qt::Key_Space);
    QTest::newRow("Escape") << int(Qt::Key_Escape);
}

void TestTime::otherKeysAreLeftToTheWindow()
{
    QFETCH(int, key);
    TimeFixture fixture;
    fixture.goTo(20, 1);
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
    QApplication::sendEvent(fixture.strip, &event);
    QVERIFY(!event.isAccepted());
    QCOMPARE(fixture.at(), (sim::Cursor{20, 1}));
}

void TestTime::aClickedPhaseHasJustRun_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<double>("h");
    QTest::addColumn<int>("before");
    QTest::addColumn<int>("phase");
    QTest::addColumn<sim::Cursor>("expected");
    QTest::newRow("from between two frames") << "at_once" << 1.0 << 0 << 1 << sim::Cursor{41, 2};
    QTest::newRow("back inside a frame") << "at_once" << 1.0 << 4 << 0 << sim::Cursor{41, 1};
    QTest::newRow("the last one ends the frame") << "at_once" << 1.0 << 2 << 4 << sim::Cursor{42, 0};
    QTest::newRow("in the second group") << "grouped" << 1.0 << 0 << 5 << sim::Cursor{41, 6};
    QTest::newRow("of the second of four steps") << "at_once" << 0.25 << 7 << 3 << sim::Cursor{41, 9};
    QTest::newRow("of a step all done") << "at_once" << 0.25 << 5 << 1 << sim::Cursor{41, 2};
}

void TestTime::aClickedPhaseHasJustRun()
{
    QFETCH(QString, step);
    QFETCH(double, h);
    QFETCH(int, before);
    QFETCH(int, phase);
    QFETCH(sim::Cursor, expected);
    TimeFixture fixture(step);
    fixture.session.editor().setStepSize(h);
    fixture.goTo(41, before);
    const QPoint place = fixture.strip->phases().areaOf(phase).center().toPoint();
    const QString hint = fixture.strip->hintAt(place);
    QVERIFY2(hint.contains(fixture.strip->phases().titleOf(phase) + ": phase "), qPrintable(hint));
    QTest::mouseClick(fixture.strip, Qt::LeftButton, {}, place);
    QVERIFY(fixture.arrive());
    QCOMPARE(fixture.at(), expected);
    QVERIFY(fixture.isStraightRun());
}

void TestTime::theWheelTurnsFramesAndWithShiftPhases()
{
    TimeFixture fixture;
    fixture.goTo(10);
    turnWheel(fixture.strip, 120);
    QCOMPARE(fixture.at(), (sim::Cursor{11, 0}));
    turnWheel(fixture.strip, -240);
    QCOMPARE(fixture.at(), (sim::Cursor{9, 0}));
    turnWheel(fixture.strip, 60);
    QCOMPARE(fixture.at(), (sim::Cursor{9, 0}));
    turnWheel(fixture.strip, 60);
    QCOMPARE(fixture.at(), (sim::Cursor{10, 0}));
    turnWheel(fixture.strip, 120, Qt::ShiftModifier);
    QCOMPARE(fixture.at(), (sim::Cursor{10, 1}));
    turnWheel(fixture.strip, -120, Qt::ShiftModifier);
    QCOMPARE(fixture.at(), (sim::Cursor{10, 0}));
}

void TestTime::theGhostAppearsAfterAChangeInThePastAndCanBeForgotten()
{
    TimeFixture fixture;
    fixture.goTo(100);
    fixture.goTo(50);
    const QPoint dots(fixture.onTrack(80).x(), 40);
    QCOMPARE(fixture.strip->hintAt(dots), "frame 80");
    const QImage without = fixture.strip->grab().toImage();
    fixture.session.editor().setParameter("damp", 0.5);
    QVERIFY(fixture.session.timeline().comparison());
    QVERIFY(fixture.strip->hintAt(dots).contains("before: damping 0.9"));
    QVERIFY(fixture.strip->grab().toImage().copy(0, 32, 600, 14) != without.copy(0, 32, 600, 14));
    QContextMenuEvent ask(QContextMenuEvent::Mouse, dots, fixture.strip->mapToGlobal(dots));
    QApplication::sendEvent(fixture.strip, &ask);
    QMenu *menu = fixture.strip->findChild<QMenu *>();
    QVERIFY(menu);
    QCOMPARE(menu->actions().last()->text(), "&Delete");
    menu->actions().last()->trigger();
    menu->close();
    QVERIFY(!fixture.session.timeline().comparison());
    QCOMPARE(fixture.strip->hintAt(dots), "frame 80");
    QCOMPARE(fixture.strip->grab().toImage().copy(0, 32, 600, 14), without.copy(0, 32, 600, 14));
}

void TestTime::whilePlayingThePhaseStripIsNotPainted()
{
    TimeFixture fixture;
    const QRect phases(0, TimelinePlaces::strip, 600, TimelinePlaces::stripHeight);
    fixture.session.playback().play();
    QTRY_VERIFY(fixture.at().frame >= 3);
    PaintLog log;
    fixture.strip->installEventFilter(&log);
    const std::int64_t from = fixture.at().frame;
    QTRY_VERIFY(fixture.at().frame >= from + 20);
    QCoreApplication::processEvents();
    QVERIFY(log.painted.contains(fixture.onTrack(from + 10)));
    QVERIFY(!log.painted.intersects(phases));
    QVERIFY(!log.painted.contains(QPoint(550, 25)));
    fixture.session.playback().pause();
    QTRY_VERIFY(log.painted.intersects(phases));
}

void TestTime::onlyThePhaseThatJustRanIsAmber()
{
    TimeFixture fixture;
    const PhaseStrip &phases = fixture.strip->phases();
    const auto amber = [&] { // -1: none
        int found = -1;
        const QImage image = fixture.strip->grab().toImage();
        for (int i = 0; i < phases.count(); ++i) {
            const QPoint underName(qRound(phases.areaOf(i).center().x()), 85);
            if (image.pixelColor(underName) == fixture.theme.tokens().now)
                found = found < 0 ? i : phases.count(); // more than one is wrong, too
        }
        return found;
    };
    QCOMPARE(amber(), -1); // before the first frame nothing has run
    fixture.goTo(41);
    const int last = phases.count() - 1;
    QCOMPARE(amber(), last); // the frame just done ended with it
    for (int done = 0; done <= last; ++done) {
        fixture.session.playback().phaseForward();
        QCOMPARE(amber(), done);
    }
    QCOMPARE(fixture.at(), (sim::Cursor{42, 0})); // what files and commands call this moment
    fixture.session.playback().phaseForward();
    QCOMPARE(amber(), 0);
    fixture.session.playback().phaseBack();
    QCOMPARE(amber(), last);
    fixture.session.playback().play();
    QCOMPARE(amber(), -1);
}

void TestTime::namesThatDoNotFitBecomeMarks()
{
    TimeFixture wide("grouped", 1200);
    QVERIFY(wide.strip->phases().showsNames());
    TimeFixture narrow("grouped", 420);
    QVERIFY(!narrow.strip->phases().showsNames());
    const PhaseStrip &phases = narrow.strip->phases();
    QCOMPARE(phases.count(), 8);
    double end = 16;
    for (int i = 0; i < phases.count(); ++i) {
        QVERIFY(phases.areaOf(i).left() >= end);
        QVERIFY(phases.areaOf(i).width() >= 24);
        end = phases.areaOf(i).right() - 1e-6;
        const QString hint = narrow.strip->hintAt(phases.areaOf(i).center().toPoint());
        QVERIFY(hint.contains(
            QString("%1: phase %2 of %3").arg(phases.titleOf(i)).arg(i + 1).arg(phases.count())));
    }
    QVERIFY(end <= 420 - 16);
}

void TestTime::theCurrentPhaseAlwaysHasItsName_data()
{
    QTest::addColumn<int>("width");
    for (const int width : {400, 420, 460, 500, 600, 700, 900, 1200})
        QTest::newRow(qPrintable(QString("%1 px").arg(width))) << width;
}

void TestTime::theCurrentPhaseAlwaysHasItsName()
{
    QFETCH(const int, width);
    TimeFixture fixture("grouped", width);
    fixture.goTo(41);
    const PhaseStrip &phases = fixture.strip->phases();
    const QFontMetricsF metrics(fixture.theme.ui(12.5, QFont::DemiBold));
    QCOMPARE(phases.count(), 8);
    for (int now = 0; now + 1 < phases.count(); ++now) {
        fixture.session.playback().phaseForward();
        QVERIFY(phases.showsName(now));
        double end = 16.0;
        for (int i = 0; i < phases.count(); ++i) {
            const QRectF area = phases.areaOf(i);
            QVERIFY(area.left() >= end - 1e-6 && area.width() >= 23.9); // each can be clicked
            end = area.right();
            const double name = metrics.horizontalAdvance(phases.titleOf(i)) + 14.0; // with its mark
            QVERIFY2(!phases.showsName(i) || name <= area.width(), qPrintable(phases.titleOf(i)));
        }
        QVERIFY(end <= fixture.strip->width() - 16 + 1e-6);
    }
}

void TestTime::namesComeBackWhereThereIsRoomAgain()
{
    TimeFixture fixture("grouped", 1200);
    const QImage before = fixture.strip->grab().toImage();
    fixture.window.resize(420, fixture.window.height());
    QTRY_COMPARE(fixture.strip->width(), 420);
    QVERIFY(!fixture.strip->phases().showsNames());
    fixture.window.resize(1200, fixture.window.height());
    QTRY_COMPARE(fixture.strip->width(), 1200);
    QVERIFY(fixture.strip->phases().showsNames());
    QCOMPARE(fixture.strip->grab().toImage(), before);
}

void TestTime::theNameOfTheOldRunIsWholeWhileThatRunGrows()
{
    const Theme theme{Scheme::light};
    TimelineAxis axis;
    axis.setWidth(600);
    RunView was;
    was.at = was.computed = 50;
    was.comparison = ComparisonRun{20, 50, "before: damp 0.85", 1};
    RunView is = was;
    is.at = is.computed = is.comparison->end = 53;
    const auto paint = [&](const RunView &view, QImage image, const QRegion &region) {
        QPainter painter(&image);
        painter.setClipRegion(region);
        painter.fillRect(image.rect(), theme.tokens().panel);
        paintTimeline(painter, axis, view, theme, Below::fan);
        return image;
    };
    const QImage empty(600, TimelinePlaces::height, QImage::Format_RGB32);
    const QImage before = paint(was, empty, empty.rect());
    QCOMPARE(paint(is, before, changedByMove(axis, was, is, theme)), paint(is, empty, empty.rect()));
}

void TestTime::theFocusRingTouchesNoNumber()
{
    TimeFixture fixture;
    fixture.window.activateWindow();
    fixture.strip->setFocus(Qt::TabFocusReason);
    const QImage image = fixture.strip->grab().toImage();
    const QColor ink = fixture.theme.tokens().ink, panel = fixture.theme.tokens().panel;
    const int middle = image.width() / 2;
    QCOMPARE(image.pixelColor(middle, 0), ink);
    for (int x = 12; x < image.width() - 12; ++x) {
        for (int y = FocusRing::width; y < FocusRing::width + 2; ++y)
            QCOMPARE(image.pixelColor(x, y), panel);
    }
}

void TestTime::screenReadersHearFrameAndPhase()
{
    TimeFixture fixture;
    fixture.goTo(41, 2);
    QAccessibleInterface *access = QAccessible::queryAccessibleInterface(fixture.strip);
    QVERIFY(access);
    QVERIFY(access->valueInterface());
    QCOMPARE(access->text(QAccessible::Name), "Timeline");
    QCOMPARE(access->text(QAccessible::Value), "Frame 41, after gravity, 2 of 5 phases done");
    QCOMPARE(access->valueInterface()->currentValue().toLongLong(), 41);
    QCOMPARE(access->valueInterface()->maximumValue().toLongLong(), 120);
    access->valueInterface()->setCurrentValue(7);
    QVERIFY(fixture.arrive());
    QCOMPARE(access->text(QAccessible::Value), "Frame 7");
}

void TestTime::nothingRunsWhileNothingMoves()
{
    TimeFixture fixture;
    fixture.goTo(41, 2);
    settle();
    PaintLog log;
    fixture.strip->installEventFilter(&log);
    fixture.bar->installEventFilter(&log);
    fixture.counter()->installEventFilter(&log);
    QVERIFY(Activity().comesToRest(300));
    QVERIFY(log.painted.isEmpty());
}

SUITE(tst_time, TestTime)
#include "tst_time.moc"
