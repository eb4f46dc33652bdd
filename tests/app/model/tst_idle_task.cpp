// Work in slices: all of it is done, and a hand that moves the cursor comes first.

#include "app/model/run/idle_task.h"
#include "tests/suite.h"

#include <QtTest>

#include <algorithm>
#include <vector>

using namespace app;

namespace {

/// Work of so many slices, and how long each of them could take.
struct Work
{
    explicit Work(int slices) : left(slices) {}

    int left;
    std::vector<double> taken; ///< ms
    IdleTask later{[this](double milliseconds) {
        taken.push_back(milliseconds);
        if (--left > 0)
            later.goOn();
    }};

    bool isDone() { return left <= 0 && !later.isDue(); }
    bool comesToItsEnd()
    {
        return QTest::qWaitFor([this] { return isDone(); });
    }
};

}

class TestIdleTask : public QObject
{
    Q_OBJECT

private slots:
    void allOfItIsDone()
    {
        Work work(5);
        work.later.run();
        QCOMPARE(work.taken.size(), std::size_t(1));
        QVERIFY(work.later.isDue());
        QVERIFY(work.comesToItsEnd());
        QCOMPARE(work.taken.size(), std::size_t(5));
    }

    void aMoveTakesLittleAtOnceAndLittleAfterABreath()
    {
        Work work(4);
        work.later.runWhileMoved();
        QVERIFY(work.later.isDue());
        QVERIFY(work.comesToItsEnd());
        QCOMPARE(work.taken.size(), std::size_t(4));
        QVERIFY(work.taken[0] < work.taken[1]);
        QVERIFY(work.taken[1] < work.taken[2]);
        QCOMPARE(work.taken[3], work.taken[2]);
    }

    void aHandThatMovesOnDoesNotPutItOffForEver()
    {
        Work work(1'000'000);
        work.later.runWhileMoved();
        const double atOnce = work.taken.front();
        QVERIFY(QTest::qWaitFor([&] {
            work.later.runWhileMoved();
            return work.taken.back() == atOnce &&
                   std::any_of(work.taken.begin(), work.taken.end(), [&](double ms) { return ms > atOnce; });
        }));
    }

    void aStoppedTaskDoesNotContinue()
    {
        Work work(3);
        work.later.run();
        work.later.stop();
        QVERIFY(!work.later.isDue());
        QCoreApplication::processEvents();
        QCOMPARE(work.left, 2);
    }
};

SUITE(tst_idle_task, TestIdleTask)
#include "tst_idle_task.moc"
