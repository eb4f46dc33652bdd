// Cache blocks of a large scene sleep separately once they rest, and the run has the same bits.

#include "sim/run/script/composed_interval.h"
#include "tests/sim/support/counting.h"
#include "tests/sim/support/support.h"
#include "tests/sizes.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/run/sleeping/sleep.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;
using std::make_shared;
using support::CountingForce;

namespace {

constexpr int pairCount = tests::sized(4000, 2500);

/// Returns many separate pairs of points, "pair0" and "end0", "pair1" and "end1", and so on.
Scene pairs(const std::shared_ptr<std::int64_t> &count)
{
    Scene scene;
    scene.start = State::ofPoints(2 * pairCount);
    support::scatter(scene.start, 9, 400.0);
    std::vector<Link> links;
    for (int i = 0; i < 2 * pairCount; i += 2) {
        links.insert(links.end(), {{i, i + 1}, {i + 1, i}});
        scene.names.push_back("pair" + std::to_string(i / 2));
        scene.names.push_back("end" + std::to_string(i / 2));
    }
    scene.groups = {{"all", {0, 2 * pairCount}}};
    scene.effects = {make_shared<BodySpring>(links, 0.2), make_shared<CountingForce>(count),
                     make_shared<Damping>(0.3)};
    return scene;
}

}

class TestBlockSleep : public QObject
{
    Q_OBJECT

    static constexpr std::size_t budget = std::size_t{1} << 24;

private slots:
    void restingBlocksSleepWhileOneIsDragged_data()
    {
        QTest::addColumn<double>("h");
        for (const double h : {1.0, 0.5, 2.0})
            QTest::addRow("h = %g", h) << h;
    }
    void restingBlocksSleepWhileOneIsDragged()
    {
        QFETCH(double, h);
        const auto count = make_shared<std::int64_t>(0);
        Script script = support::script(pairs(count), "semi_implicit_euler", h);
        const std::string last = "pair" + std::to_string(pairCount - 1);
        for (int frame = 900; frame < 1200; ++frame) {
            if (frame == 900)
                script.input.push_back({frame, Grab{"pair7"}});
            if (frame == 1100)
                script.input.push_back({frame, Grab{last}}); // in another block
            if (frame == 1104) {                             // grabbed and released in the same frame
                script.input.push_back({frame, Grab{"pair" + std::to_string(pairCount / 2)}});
                script.input.push_back({frame, Move{{0.0, 0.0}}});
                script.input.push_back({frame, Grab{last}});
            }
            script.input.push_back({frame, Move{{frame * 0.5, 90.0}}});
        }
        script.input.push_back({1200, Release{}});
        Track track(script, budget), reference(script, budget, Sleeping::never);
        QVERIFY(track.nextInterval()->pipeline.blocks.size() > 2);
        const std::int64_t points = track.state().pointCount();
        std::int64_t minPoints = points;
        for (std::int64_t frame = 0; frame < 1300; frame += track.framesPerOutput()) {
            const std::int64_t before = *count;
            track.seek({frame, 0});
            if (frame > 1060 && frame < 1100)
                minPoints = std::min(minPoints, *count - before);
            reference.seek({frame, 0});
            const std::string found = support::difference(track.state(), reference.state());
            QVERIFY2(sameBits(track.state(), reference.state()),
                     (std::to_string(frame) + ": " + found).c_str());
            if (frame % 250 == 0) { // to a phase within the frame
                for (Track *run : {&track, &reference}) {
                    run->seek({frame, 1});
                    run->seek({frame, 2});
                }
                QVERIFY(sameBits(track.state(), reference.state()));
            }
        }
        const auto steps = std::int64_t(track.script().step.stepsPerOutput);
        QVERIFY2(minPoints <= steps * points / 2, std::to_string(minPoints).c_str());
        QVERIFY(minPoints > 0);
        track.seek({20, 0});
        reference.seek({1400, 0});
        track.seek({1400, 0});
        QVERIFY(sameBits(track.state(), reference.state()));
    }
};

SUITE(tst_block_sleep, TestBlockSleep)
#include "tst_block_sleep.moc"
