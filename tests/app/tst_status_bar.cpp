// What the status bar says, and for how long.

#include "app/ui/window/status_figures.h"
#include "quick_bench.h"

#include <QLabel>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>

using namespace app;
using quick_bench::Bench;

namespace {

QString shownIn(const Bench &bench)
{
    return bench.window.statusBar()->findChild<QLabel *>()->text();
}

}

class StatusBarTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void theStatusBarTellsTheWorkOfAFrame_data();
    void theStatusBarTellsTheWorkOfAFrame();
    void theStatusBarTellsWhatWasMeasuredAndNothingElse();
    void figuresGiveWayToTheSentence();
    void aSentenceIsThereWhileTheRunPlaysOn();
    void aSentenceGivesWayWhenTheLearnerGoesOn();

private:
    QTemporaryDir m_folder;
};

void StatusBarTest::initTestCase()
{
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
}

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
    Bench bench("accuracy", "halve");
    bench.session.setMethod(method);
    bench.session.setStepSize(h);
    const auto &figures = *bench.window.findChild<StatusFigures *>();
    QCOMPARE(figures.figures(), QStringList({"6 points", work}));
}

void StatusBarTest::theStatusBarTellsWhatWasMeasuredAndNothingElse()
{
    Bench bench;
    const auto &figures = *bench.window.findChild<StatusFigures *>();
    QCOMPARE(figures.figures().size(), 2);
    bench.window.setMode(MainWindow::Mode::measure);
    QTRY_COMPARE(bench.window.study().stage(), AccuracyStudy::Stage::done);
    QCOMPARE(figures.figures().mid(2),
             QStringList({"0.25\u2009µs a frame", "3.7\u2009px off over 200 frames"}));
    bench.session.setParameter("k", 0.31); // another scene
    QCOMPARE(figures.figures().size(), 2);
    // What chooses its own work is counted as it goes.
    bench.session.setMethod("dormand_prince");
    QCOMPARE(figures.figures().size(), 1);
    bench.session.goTo({10, 0});
    QVERIFY(figures.figures().at(1).endsWith("times a frame until now"));
}

void StatusBarTest::figuresGiveWayToTheSentence()
{
    Bench bench;
    const auto &figures = *bench.window.findChild<StatusFigures *>();
    bench.window.setMode(MainWindow::Mode::measure);
    QTRY_COMPARE(bench.window.study().stage(), AccuracyStudy::Stage::done);
    QTRY_COMPARE(figures.figures().size(), 4);
    bench.window.resize(760, 600);
    QTest::qWait(20);
    QVERIFY(figures.figures().size() < 4);
    QVERIFY(!figures.figures().contains("2 points"));
    auto *sentence = bench.window.statusBar()->findChild<QLabel *>(QString(), Qt::FindDirectChildrenOnly);
    QVERIFY2(sentence->width() >= sentence->sizeHint().width(), qPrintable(sentence->text()));
    bench.window.resize(1280, 800);
    QTRY_COMPARE(figures.figures().size(), 4);
}

void StatusBarTest::aSentenceIsThereWhileTheRunPlaysOn()
{
    Bench bench;
    bench.session.play();
    emit bench.session.said("Saved as a.json.");
    QCOMPARE(shownIn(bench), QString("Saved as a.json."));
    QSignalSpy moved(&bench.session, &Session::moved);
    QTRY_VERIFY(moved.size() > 5);
    QCOMPARE(shownIn(bench), QString("Saved as a.json."));
    QTRY_VERIFY_WITH_TIMEOUT(shownIn(bench).startsWith("Playing."), 20'000);
}

void StatusBarTest::aSentenceGivesWayWhenTheLearnerGoesOn()
{
    Bench bench;
    bench.session.setParameter("k", 0.31);
    bench.session.undo();
    QVERIFY2(shownIn(bench).startsWith("Undone:"), qPrintable(shownIn(bench)));
    bench.session.phaseForward();
    QVERIFY2(shownIn(bench).startsWith("Inside frame 0"), qPrintable(shownIn(bench)));
}

QTEST_MAIN(StatusBarTest)
#include "tst_status_bar.moc"
