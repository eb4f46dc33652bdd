// Work in slices: all slices are run, and moves of the cursor have priority.

#include "app/model/run/idle_task.h"
#include "tests/suite.h"

#include <QtTest>

#include <algorithm>
#include <vector>

using namespace app;

namespace {

/// Work of some slices, and the time that each slice was given.
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
    bool finishes()
    {
        return QTest::qWaitFor([this] { return isDone(); });
    }
};

}

class TestIdleTask : public QObject
{
    Q_OBJECT

private slots:
    void allSlicesAreRun()
    {
        Work work(5);
        work.later.run();
        QCOMPARE(work.taken.size(), std::size_t(1));
        QVERIFY(work.later.isDue());
        QVERIFY(work.finishes());
        QCOMPARE(work.taken.size(), std::size_t(5));
    }

    void slicesGrowWhenTheUserPauses()
    {
        Work work(4);
        work.later.runWhileMoved();
        QVERIFY(work.later.isDue());
        QVERIFY(work.finishes());
        QCOMPARE(work.taken.size(), std::size_t(4));
        QVERIFY(work.taken[0] < work.taken[1]);
        QVERIFY(work.taken[1] < work.taken[2]);
        QCOMPARE(work.taken[3], work.taken[2]);
    }

    void workContinuesDuringEndlessInput()
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
