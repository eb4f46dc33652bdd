// The messages and figures of the status bar, and how long they stay.

#include "app/ui/parameters/number_box.h"
#include "app/ui/status/status_figures.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QLabel>
#include <QStatusBar>

using namespace app;
using namespace tests;

namespace {

QString shownIn(const WindowFixture &fixture)
{
    return fixture.window.statusBar()->findChild<QLabel *>()->text();
}

}

class StatusBarTest : public QObject
{
    Q_OBJECT

private slots:
    void theStatusBarTellsTheWorkOfAFrame_data();
    void theStatusBarTellsTheWorkOfAFrame();
    void theStatusBarTellsWhatWasMeasuredAndNothingElse();
    void longSentenceHidesSomeFigures();
    void pointsAreThoseOfThePicture();
    void theRangeOfAParameterIsThereToRead();
    void aSentenceIsThereWhileTheRunPlaysOn();
    void aSentenceGivesWayWhenTheLearnerGoesOn();
    void aSentenceOfThePauseGivesWayWhenTheRunPlays();
    void draggingInThePastTellsHowToGoOn();
};

void StatusBarTest::theStatusBarTellsTheWorkOfAFrame_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("h");
    QTest::addColumn<QString>("work");
    QTest::newRow("once a step") << "semi_implicit_euler" << 1.0 << "forces once a frame";
    QTest::newRow("four times a step, two steps") << "rk4" << 0.5 << "forces 8 times a frame";
    QTest::newRow("four times a step, a step of two frames") << "rk4" << 2.0 << "forces 2 times a frame";
}

void StatusBarTest::theStatusBarTellsTheWorkOfAFrame()
{
    QFETCH(QString, method);
    QFETCH(double, h);
    QFETCH(QString, work);
    WindowFixture fixture({"accuracy", "halve"});
    fixture.session.editor().setMethod(method);
    fixture.session.editor().setStepSize(h);
    const auto &figures = *fixture.window.findChild<StatusFigures *>();
    QCOMPARE(figures.figures(), QStringList({"6 points", work}));
}

void StatusBarTest::theStatusBarTellsWhatWasMeasuredAndNothingElse()
{
    WindowFixture fixture({.study = quickStudy});
    const auto &figures = *fixture.window.findChild<StatusFigures *>();
    QCOMPARE(figures.figures().size(), 2);
    fixture.window.setMode(MainWindow::Mode::measure);
    QTRY_COMPARE(fixture.window.study().stage(), AccuracyStudy::Stage::done);
    QCOMPARE(figures.figures().mid(2),
             QStringList({"0.25\u2009µs a frame", "error 3.7\u2009px over 200 frames"}));
    fixture.session.editor().setParameter("k", 0.31); // another scene
    QCOMPARE(figures.figures().size(), 2);
    // An adaptive method chooses its number of evaluations, so they are counted during the run.
    fixture.session.editor().setMethod("dormand_prince");
    QCOMPARE(figures.figures().size(), 1);
    fixture.goTo(10);
    QVERIFY(figures.figures().at(1).endsWith("times a frame so far"));
}

void StatusBarTest::longSentenceHidesSomeFigures()
{
    WindowFixture fixture({.study = quickStudy});
    auto &figures = *fixture.window.findChild<StatusFigures *>();
    fixture.window.setMode(MainWindow::Mode::measure);
    QTRY_COMPARE(fixture.window.study().stage(), AccuracyStudy::Stage::done);
    const QStringList all = figures.figures();
    const auto &sentence = *fixture.window.statusBar()->findChild<QLabel *>();
    fixture.session.showMessage(QString("Such a long sentence. ").repeated(6).trimmed());
    QTRY_VERIFY(sentence.width() >= sentence.sizeHint().width());
    const QStringList some = figures.figures();
    QVERIFY(some.size() < all.size());
    QCOMPARE(some, all.mid(all.size() - some.size())); // those that were measured stay longest
    fixture.session.playback().phaseForward();
    QTRY_COMPARE(figures.figures(), all);
    fixture.window.resize(1000, 800);
    QTRY_VERIFY(figures.figures().size() < all.size());
    QTRY_VERIFY(sentence.width() >= sentence.sizeHint().width());
}

void StatusBarTest::pointsAreThoseOfThePicture()
{
    WindowFixture fixture({"multi_foot", "any_number"});
    fixture.goTo(3);
    fixture.session.editor().setParameter("feet", 1); // seen at once, although it acts on the next frame
    QCOMPARE(fixture.session.presentation().picture().state.pointCount(), 2);
    QCOMPARE(fixture.part<StatusFigures>().figures().front(), QString("2 points"));
    fixture.session.playback().frameForward();
    QCOMPARE(fixture.part<StatusFigures>().figures().front(), QString("2 points"));
}

void StatusBarTest::theRangeOfAParameterIsThereToRead()
{
    WindowFixture fixture({"multi_foot", "any_number"});
    fixture.goTo(3);
    for (NumberBox *box : fixture.window.findChildren<NumberBox *>()) {
        if (box->accessibleName() != "Feet")
            continue;
        box->setFocus(Qt::TabFocusReason);
        QTest::keyClick(box, Qt::Key_0);
        QTest::keyClick(box, Qt::Key_Return);
    }
    QCOMPARE(fixture.session.editor().parameter("feet"), 1.0);
    QCOMPARE(shownIn(fixture), QString("Feet can be 1 to 100."));
}

void StatusBarTest::aSentenceIsThereWhileTheRunPlaysOn()
{
    WindowFixture fixture;
    fixture.session.playback().play();
    fixture.session.showMessage("Saved as a.json.");
    QCOMPARE(shownIn(fixture), QString("Saved as a.json."));
    QSignalSpy changed(&fixture.session.changes(), &ChangeNotifier::changed);
    QTRY_VERIFY(changed.size() > 5);
    QCOMPARE(shownIn(fixture), QString("Saved as a.json."));
    QTRY_VERIFY_WITH_TIMEOUT(shownIn(fixture).startsWith("Playing."), 20'000);
}

void StatusBarTest::aSentenceGivesWayWhenTheLearnerGoesOn()
{
    WindowFixture fixture;
    fixture.session.editor().setParameter("k", 0.31);
    fixture.session.editor().undo();
    QVERIFY2(shownIn(fixture).startsWith("Undone:"), qPrintable(shownIn(fixture)));
    fixture.session.playback().phaseForward();
    QVERIFY2(shownIn(fixture).startsWith("Inside frame 0"), qPrintable(shownIn(fixture)));
}

void StatusBarTest::aSentenceOfThePauseGivesWayWhenTheRunPlays()
{
    WindowFixture fixture;
    Playback &playback = fixture.session.playback();
    playback.reportIfPaused();
    QVERIFY2(shownIn(fixture).startsWith("The run is paused."), qPrintable(shownIn(fixture)));
    playback.play();
    QVERIFY2(shownIn(fixture).startsWith("Playing."), qPrintable(shownIn(fixture)));
}

void StatusBarTest::draggingInThePastTellsHowToGoOn()
{
    WindowFixture fixture;
    Playback &playback = fixture.session.playback();
    playback.goTo({20, 0});
    playback.goTo({10, 0});
    fixture.drag("foot", {30, 20});
    QVERIFY(!playback.isPlaying());
    QVERIFY2(shownIn(fixture).startsWith("The run is paused."), qPrintable(shownIn(fixture)));
    playback.frameForward();
    QVERIFY2(!shownIn(fixture).startsWith("The run is paused."), qPrintable(shownIn(fixture)));
}

SUITE(tst_status_bar, StatusBarTest)
#include "tst_status_bar.moc"
