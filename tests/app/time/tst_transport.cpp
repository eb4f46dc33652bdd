#include "tests/app/time/time_support.h"
#include "tests/suite.h"

#include "app/ui/time/speed_button.h"

#include <QMenu>
#include <QSignalSpy>
#include <QTest>

using namespace app;

class TestTransport : public QObject
{
    Q_OBJECT

private slots:
    void everyButtonDoesWhatItSays_data();
    void everyButtonDoesWhatItSays();
    void buttonsAreEnabledWhereTheyCanAct();
    void stoppedRunCannotGoForward();
    void aTypedFrameIsGoneTo_data();
    void aTypedFrameIsGoneTo();
    void invalidFrameIsRefused_data();
    void invalidFrameIsRefused();
    void escapeLeavesTheEditorAndChangesNothing();
    void goingFarShowsTheGoalAndEscapeEndsIt();
    void manyGoalsDoNotBlockTheWindow();
    void speedNeverChangesTheStep();
    void theSpeedMenuSetsTheSpeed();
    void theCounterShowsWhatTheTimelineHas_data();
    void theCounterShowsWhatTheTimelineHas();
    void whilePlayingTheCounterFollows();
};

void TestTransport::everyButtonDoesWhatItSays_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<sim::Cursor>("expected");
    QTest::newRow("back to frame 0") << "reset" << sim::Cursor{0, 0};
    QTest::newRow("phase back") << "phaseBack" << sim::Cursor{20, 1};
    QTest::newRow("frame back") << "frameBack" << sim::Cursor{20, 0};
    QTest::newRow("frame forward") << "frameForward" << sim::Cursor{21, 0};
    QTest::newRow("phase forward") << "phaseForward" << sim::Cursor{20, 3};
}

void TestTransport::everyButtonDoesWhatItSays()
{
    QFETCH(QString, name);
    QFETCH(sim::Cursor, expected);
    TimeFixture fixture;
    fixture.goTo(20, 2);
    QVERIFY(!fixture.button(name)->accessibleName().isEmpty());
    QVERIFY(fixture.button(name)->toolTip().startsWith(fixture.button(name)->accessibleName() + " ("));
    QTest::mouseClick(fixture.button(name), Qt::LeftButton);
    QVERIFY(fixture.arrive());
    QCOMPARE(fixture.at(), expected);
    QVERIFY(fixture.isStraightRun());
}

void TestTransport::buttonsAreEnabledWhereTheyCanAct()
{
    TimeFixture fixture;
    const auto enabled = [&] {
        QString names;
        for (const char *name : {"reset", "phaseBack", "frameBack", "play", "frameForward", "phaseForward"})
            names += fixture.button(name)->isEnabled() ? QString(name) + ' ' : QString();
        return names;
    };
    QCOMPARE(enabled(), "play frameForward phaseForward ");
    QVERIFY(fixture.button("frameBack")->toolTip().contains("frame 0"));
    fixture.session.playback().phaseForward();
    QCOMPARE(enabled(), "reset phaseBack frameBack play frameForward phaseForward ");
    QVERIFY(!fixture.button("frameBack")->toolTip().contains("frame 0"));
    QCOMPARE(fixture.button("play")->accessibleName(), "Play");
    QTest::mouseClick(fixture.button("play"), Qt::LeftButton);
    QVERIFY(fixture.session.playback().isPlaying());
    QCOMPARE(fixture.button("play")->accessibleName(), "Pause");
    QTest::mouseClick(fixture.button("play"), Qt::LeftButton);
    QVERIFY(!fixture.session.playback().isPlaying());
}

void TestTransport::stoppedRunCannotGoForward()
{
    TimeFixture fixture;
    fixture.session.editor().setParameter("k", 1e300);
    fixture.session.playback().goTo({100, 0});
    QVERIFY(fixture.arrive());
    QVERIFY(fixture.session.timeline().stop());
    QCOMPARE(fixture.at().frame, fixture.session.timeline().stop()->frame);
    for (const char *name : {"play", "frameForward", "phaseForward"}) {
        QVERIFY2(!fixture.button(name)->isEnabled(), name);
        QVERIFY2(fixture.button(name)->toolTip().contains("not finite"), name);
    }
    fixture.session.editor().setParameter("k", 0.2);
    QVERIFY(fixture.button("play")->isEnabled());
}

void TestTransport::aTypedFrameIsGoneTo_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<int>("frame");
    QTest::newRow("forward") << "150" << 150;
    QTest::newRow("to the start") << "0" << 0;
    QTest::newRow("with blanks") << " 7 " << 7;
    QTest::newRow("with leading zeros") << "00012" << 12;
}

void TestTransport::aTypedFrameIsGoneTo()
{
    QFETCH(QString, typed);
    QFETCH(int, frame);
    TimeFixture fixture;
    fixture.goTo(30, 2);
    QTest::keyClick(&fixture.window, Qt::Key_G, Qt::ControlModifier);
    QVERIFY(fixture.editor());
    QVERIFY(fixture.editor()->hasFocus());
    QTest::keyClicks(fixture.editor(), typed);
    QTest::keyClick(fixture.editor(), Qt::Key_Return);
    QVERIFY(!fixture.counter()->isEditing());
    QVERIFY(fixture.arrive());
    QCOMPARE(fixture.at(), (sim::Cursor{frame, 0}));
    QVERIFY(fixture.isStraightRun());
}

void TestTransport::invalidFrameIsRefused_data()
{
    QTest::addColumn<QString>("typed");
    QTest::newRow("words") << "soon";
    QTest::newRow("nothing") << "";
    QTest::newRow("negative") << "-";
    QTest::newRow("a fraction") << "1.";
    QTest::newRow("one more than there can be") << "10000001";
    QTest::newRow("huge") << "99999999999999999999";
    QTest::newRow("longer than any number") << "123456789012345678901234567890";
}

void TestTransport::invalidFrameIsRefused()
{
    QFETCH(QString, typed);
    TimeFixture fixture;
    fixture.goTo(30, 2);
    const QSignalSpy said(&fixture.session.changes(), &ChangeNotifier::messageRequested);
    QTest::mouseClick(fixture.counter(), Qt::LeftButton);
    QVERIFY(fixture.editor());
    fixture.editor()->clear();
    QTest::keyClicks(fixture.editor(), typed);
    if (said.isEmpty())
        QTest::keyClick(fixture.editor(), Qt::Key_Return);
    QVERIFY(!said.isEmpty());
    QVERIFY(said.constLast().constFirst().toString().contains("10000000"));
    QVERIFY(fixture.counter()->isEditing());
    QCOMPARE(fixture.at(), (sim::Cursor{30, 2}));
    QVERIFY(!fixture.session.playback().goal());
}

void TestTransport::escapeLeavesTheEditorAndChangesNothing()
{
    TimeFixture fixture;
    fixture.goTo(30, 2);
    fixture.strip->setFocus(Qt::TabFocusReason);
    fixture.run.goToFrame->trigger();
    QTest::keyClicks(fixture.editor(), "99");
    QTest::keyClick(fixture.editor(), Qt::Key_Escape);
    QVERIFY(!fixture.counter()->isEditing());
    QVERIFY(fixture.strip->hasFocus());
    QCOMPARE(fixture.at(), (sim::Cursor{30, 2}));
}

void TestTransport::goingFarShowsTheGoalAndEscapeEndsIt()
{
    TimeFixture fixture;
    fixture.bar->editFrame();
    QTest::keyClicks(fixture.editor(), "10000000");
    QTest::keyClick(fixture.editor(), Qt::Key_Return);
    QVERIFY(!fixture.counter()->isEditing());
    QCOMPARE(fixture.session.playback().goal().value_or(-1), 10'000'000);
    QVERIFY(fixture.counter()->text().contains("going to 10000000…"));
    QCOMPARE(fixture.button("play")->accessibleName(), "Stop here");
    QTest::keyClick(&fixture.window, Qt::Key_Escape);
    QVERIFY(!fixture.session.playback().goal());
    QTRY_VERIFY(!fixture.counter()->text().contains("going to"));
    QCOMPARE(fixture.counter()->text(), QString("Frame %1").arg(fixture.at().frame));
    QVERIFY(fixture.at().frame < 10'000'000);
    QCOMPARE(fixture.button("play")->accessibleName(), "Play");
}

void TestTransport::manyGoalsDoNotBlockTheWindow()
{
    TimeFixture fixture;
    for (int i = 0; i < 100; ++i)
        fixture.session.playback().goTo({9'000'000 + i, 0});
    QCoreApplication::processEvents();
    const QSignalSpy slices(&fixture.session.changes(), &ChangeNotifier::changed);
    QCoreApplication::processEvents();
    QCoreApplication::processEvents();
    // Two slices of work are run, not two hundred.
    QVERIFY2(slices.count() > 0 && slices.count() <= 2, qPrintable(QString::number(slices.count())));
    fixture.session.playback().pause();
}

void TestTransport::speedNeverChangesTheStep()
{
    TimeFixture fixture;
    fixture.session.editor().setStepSize(0.5);
    QList<double> seen;
    for (int i = 0; i < 6; ++i) {
        fixture.bar->slower();
        seen << fixture.session.playback().speed();
        QCOMPARE(fixture.session.timeline().script().step.h, 0.5);
    }
    QCOMPARE(seen, QList<double>({0.5, 0.25, 0.1, 0.1, 0.1, 0.1}));
    for (int i = 0; i < 6; ++i) {
        fixture.bar->faster();
        QCOMPARE(fixture.session.timeline().script().step.h, 0.5);
    }
    QCOMPARE(fixture.session.playback().speed(), 4.0);
    fixture.session.playback().setSpeed(3.0);
    fixture.bar->slower();
    QCOMPARE(fixture.session.playback().speed(), 2.0);
}

void TestTransport::theSpeedMenuSetsTheSpeed()
{
    TimeFixture fixture;
    SpeedButton *button = fixture.bar->findChild<SpeedButton *>();
    QStringList names;
    for (QAction *action : button->menu()->actions()) {
        names << action->text();
        action->trigger();
        QCOMPARE(fixture.session.playback().speed(), action->data().toDouble());
        action->trigger();
        QVERIFY(action->isChecked());
        QVERIFY(button->accessibleName().contains(action->text()));
    }
    QCOMPARE(names.join(' '), "0.1× 0.25× 0.5× 1× 2× 4×");
    QVERIFY(button->accessibleName().contains("120 frames/s"));
    QCOMPARE(fixture.session.timeline().script().step.h, 1.0);
}

void TestTransport::theCounterShowsWhatTheTimelineHas_data()
{
    QTest::addColumn<double>("h");
    QTest::addColumn<int>("frame");
    QTest::addColumn<int>("phase");
    QTest::addColumn<QString>("text");
    QTest::newRow("the start") << 1.0 << 0 << 0 << "Frame 0";
    QTest::newRow("between two frames") << 1.0 << 41 << 0 << "Frame 41";
    QTest::newRow("inside a frame") << 1.0 << 41 << 2 << "Frame 41 · 2 of 5 phases done";
    QTest::newRow("inside a step") << 0.125 << 41 << 12 << "Frame 41 · step 3 of 8, 2 of 5 phases done";
    QTest::newRow("after a step") << 0.125 << 41 << 10 << "Frame 41 · step 2 of 8, 5 of 5 phases done";
    QTest::newRow("a long step") << 2.0 << 42 << 0 << "Frame 42";
}

void TestTransport::theCounterShowsWhatTheTimelineHas()
{
    QFETCH(double, h);
    QFETCH(int, frame);
    QFETCH(int, phase);
    QFETCH(QString, text);
    TimeFixture fixture;
    fixture.session.editor().setStepSize(h);
    fixture.goTo(frame, phase);
    QCOMPARE(fixture.counter()->text(), text);
}

void TestTransport::whilePlayingTheCounterFollows()
{
    TimeFixture fixture;
    fixture.session.playback().setSpeed(4.0);
    fixture.session.playback().play();
    QTRY_VERIFY(fixture.at().frame > 20);
    QVERIFY(fixture.counter()->text() != "Frame 0");
    fixture.session.playback().pause();
    QCOMPARE(fixture.counter()->text(), QString("Frame %1").arg(fixture.at().frame));
}

SUITE(tst_transport, TestTransport)
#include "tst_transport.moc"
