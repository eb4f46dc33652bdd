#include "tests/app/time_bench.h"

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
    void atAStopOnlyThePastIsOpen();
    void aTypedFrameIsGoneTo_data();
    void aTypedFrameIsGoneTo();
    void aTypedFrameThatIsNoneIsRefused_data();
    void aTypedFrameThatIsNoneIsRefused();
    void escapeLeavesTheEditorAndChangesNothing();
    void goingFarShowsTheGoalAndEscapeEndsIt();
    void manyGoalsDoNotHoldTheWindowUp();
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
    TimeBench bench;
    bench.goTo(20, 2);
    QVERIFY(!bench.button(name)->accessibleName().isEmpty());
    QVERIFY(bench.button(name)->toolTip().startsWith(bench.button(name)->accessibleName() + " ("));
    QTest::mouseClick(bench.button(name), Qt::LeftButton);
    QVERIFY(bench.arrive());
    QCOMPARE(bench.at(), expected);
    QVERIFY(bench.isStraightRun());
}

void TestTransport::buttonsAreEnabledWhereTheyCanAct()
{
    TimeBench bench;
    const auto enabled = [&] {
        QString names;
        for (const char *name : {"reset", "phaseBack", "frameBack", "play", "frameForward", "phaseForward"})
            names += bench.button(name)->isEnabled() ? QString(name) + ' ' : QString();
        return names;
    };
    QCOMPARE(enabled(), "play frameForward phaseForward ");
    QVERIFY(bench.button("frameBack")->toolTip().contains("frame 0"));
    bench.session.phaseForward();
    QCOMPARE(enabled(), "reset phaseBack frameBack play frameForward phaseForward ");
    QVERIFY(!bench.button("frameBack")->toolTip().contains("frame 0"));
    QCOMPARE(bench.button("play")->accessibleName(), "Play");
    QTest::mouseClick(bench.button("play"), Qt::LeftButton);
    QVERIFY(bench.session.isPlaying());
    QCOMPARE(bench.button("play")->accessibleName(), "Pause");
    QTest::mouseClick(bench.button("play"), Qt::LeftButton);
    QVERIFY(!bench.session.isPlaying());
}

void TestTransport::atAStopOnlyThePastIsOpen()
{
    TimeBench bench;
    bench.session.setParameter("k", 1e300);
    bench.session.goTo({100, 0});
    QVERIFY(bench.arrive());
    QVERIFY(bench.session.timeline().stop());
    QCOMPARE(bench.at().frame, bench.session.timeline().stop()->frame);
    for (const char *name : {"play", "frameForward", "phaseForward"}) {
        QVERIFY2(!bench.button(name)->isEnabled(), name);
        QVERIFY2(bench.button(name)->toolTip().contains("not finite"), name);
    }
    bench.session.setParameter("k", 0.2);
    QVERIFY(bench.button("play")->isEnabled());
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
    TimeBench bench;
    bench.goTo(30, 2);
    QTest::keyClick(&bench.window, Qt::Key_G, Qt::ControlModifier);
    QVERIFY(bench.editor());
    QVERIFY(bench.editor()->hasFocus());
    QTest::keyClicks(bench.editor(), typed);
    QTest::keyClick(bench.editor(), Qt::Key_Return);
    QVERIFY(!bench.counter()->isEditing());
    QVERIFY(bench.arrive());
    QCOMPARE(bench.at(), (sim::Cursor{frame, 0}));
    QVERIFY(bench.isStraightRun());
}

void TestTransport::aTypedFrameThatIsNoneIsRefused_data()
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

void TestTransport::aTypedFrameThatIsNoneIsRefused()
{
    QFETCH(QString, typed);
    TimeBench bench;
    bench.goTo(30, 2);
    const QSignalSpy said(&bench.session, &Session::said);
    QTest::mouseClick(bench.counter(), Qt::LeftButton);
    QVERIFY(bench.editor());
    bench.editor()->clear();
    QTest::keyClicks(bench.editor(), typed);
    if (said.isEmpty())
        QTest::keyClick(bench.editor(), Qt::Key_Return);
    QVERIFY(!said.isEmpty());
    QVERIFY(said.constLast().constFirst().toString().contains("10000000"));
    QVERIFY(bench.counter()->isEditing());
    QCOMPARE(bench.at(), (sim::Cursor{30, 2}));
    QVERIFY(!bench.session.goingTo());
}

void TestTransport::escapeLeavesTheEditorAndChangesNothing()
{
    TimeBench bench;
    bench.goTo(30, 2);
    bench.strip->setFocus(Qt::TabFocusReason);
    bench.bar->goToFrameAction()->trigger();
    QTest::keyClicks(bench.editor(), "99");
    QTest::keyClick(bench.editor(), Qt::Key_Escape);
    QVERIFY(!bench.counter()->isEditing());
    QVERIFY(bench.strip->hasFocus());
    QCOMPARE(bench.at(), (sim::Cursor{30, 2}));
}

void TestTransport::goingFarShowsTheGoalAndEscapeEndsIt()
{
    TimeBench bench;
    bench.bar->editFrame();
    QTest::keyClicks(bench.editor(), "10000000");
    QTest::keyClick(bench.editor(), Qt::Key_Return);
    QVERIFY(!bench.counter()->isEditing());
    QCOMPARE(bench.session.goingTo().value_or(-1), 10'000'000);
    QVERIFY(bench.counter()->text().contains("going to 10000000…"));
    QCOMPARE(bench.button("play")->accessibleName(), "Stop here");
    QTest::keyClick(&bench.window, Qt::Key_Escape);
    QVERIFY(!bench.session.goingTo());
    QTRY_VERIFY(!bench.counter()->text().contains("going to"));
    QCOMPARE(bench.counter()->text(), QString("Frame %1").arg(bench.at().frame));
    QVERIFY(bench.at().frame < 10'000'000);
    QCOMPARE(bench.button("play")->accessibleName(), "Play");
}

void TestTransport::manyGoalsDoNotHoldTheWindowUp()
{
    TimeBench bench;
    for (int i = 0; i < 100; ++i)
        bench.session.goTo({9'000'000 + i, 0});
    QCoreApplication::processEvents();
    const QSignalSpy slices(&bench.session, &Session::moved);
    QCoreApplication::processEvents();
    QCoreApplication::processEvents();
    // Two slices of the way, not two hundred.
    QVERIFY2(slices.count() <= 2, qPrintable(QString::number(slices.count())));
    bench.session.pause();
}

void TestTransport::speedNeverChangesTheStep()
{
    TimeBench bench;
    bench.session.setStepSize(0.5);
    QList<double> seen;
    for (int i = 0; i < 6; ++i) {
        bench.bar->slower();
        seen << bench.session.speed();
        QCOMPARE(bench.session.timeline().script().step.h, 0.5);
    }
    QCOMPARE(seen, QList<double>({0.5, 0.25, 0.1, 0.1, 0.1, 0.1}));
    for (int i = 0; i < 6; ++i) {
        bench.bar->faster();
        QCOMPARE(bench.session.timeline().script().step.h, 0.5);
    }
    QCOMPARE(bench.session.speed(), 4.0);
    bench.session.setSpeed(3.0);
    bench.bar->slower();
    QCOMPARE(bench.session.speed(), 2.0);
}

void TestTransport::theSpeedMenuSetsTheSpeed()
{
    TimeBench bench;
    SpeedButton *button = bench.bar->findChild<SpeedButton *>();
    QStringList names;
    for (QAction *action : button->menu()->actions()) {
        names << action->text();
        action->trigger();
        QCOMPARE(bench.session.speed(), action->data().toDouble());
        action->trigger();
        QVERIFY(action->isChecked());
        QVERIFY(button->accessibleName().contains(action->text()));
    }
    QCOMPARE(names.join(' '), "0.1× 0.25× 0.5× 1× 2× 4×");
    QVERIFY(button->accessibleName().contains("120 frames/s"));
    QCOMPARE(bench.session.timeline().script().step.h, 1.0);
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
    TimeBench bench;
    bench.session.setStepSize(h);
    bench.goTo(frame, phase);
    QCOMPARE(bench.counter()->text(), text);
}

void TestTransport::whilePlayingTheCounterFollows()
{
    TimeBench bench;
    bench.session.setSpeed(4.0);
    bench.session.play();
    QTRY_VERIFY(bench.at().frame > 20);
    QVERIFY(bench.counter()->text() != "Frame 0");
    bench.session.pause();
    QCOMPARE(bench.counter()->text(), QString("Frame %1").arg(bench.at().frame));
}

SPRINGSTEP_TIME_MAIN(TestTransport)
#include "tst_transport.moc"
