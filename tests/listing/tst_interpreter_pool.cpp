#include "sim/scene/state.h"
#include "tests/listing/listing_support.h"
#include "tests/suite.h"

#include <QTest>

#include <thread>

using namespace listing_support;

/// Each thread that runs a program has its own interpreter.
class InterpreterPoolSuite : public QObject
{
    Q_OBJECT

private slots:
    void threadsShareAProgram()
    {
        Bench bench("double clock = 0;\n" + frameOf("clock += random(1); body.position += Vec2(clock, k);"));
        sim::State expected = bench.state;
        const auto compute = [&](sim::State &state) {
            for (int i = 0; i < 500; ++i) {
                ++state.frame;
                if (bench.program->run(state, bench.binding))
                    return;
            }
        };
        std::vector<sim::State> states(4, bench.state);
        std::vector<std::thread> threads;
        for (sim::State &state : states)
            threads.emplace_back([&compute, &state] { compute(state); });
        for (std::thread &thread : threads)
            thread.join();
        compute(expected);
        QCOMPARE(expected.frame, std::int64_t{500});
        for (const sim::State &state : states)
            QVERIFY(sim::sameBits(state, expected));
    }
};

SUITE(tst_interpreter_pool, InterpreterPoolSuite)
#include "tst_interpreter_pool.moc"
