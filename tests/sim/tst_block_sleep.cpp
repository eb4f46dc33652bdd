// Blocks of a large scene that have come to rest sleep one by one, and no bit of the run differs.

#include "counting.h"
#include "sim/run/script/composed_interval.h"
#include "support.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/run/sleeping/sleep.h"

#include <QTest>

using namespace sim;
using std::make_shared;
using support::Counting;

namespace {

constexpr std::size_t budget = std::size_t{1} << 24;

/// Many pairs that nothing ties to each other: "pair0" and its other end, and so on.
Scene pairs(const std::shared_ptr<std::int64_t> &count)
{
    constexpr int number = 4000;
    Scene scene;
    scene.start = State::ofPoints(2 * number);
    support::scatter(scene.start, 9, 400.0);
    std::vector<Link> links;
    for (int i = 0; i < 2 * number; i += 2) {
        links.insert(links.end(), {{i, i + 1}, {i + 1, i}});
        scene.names.push_back("pair" + std::to_string(i / 2));
        scene.names.push_back("end" + std::to_string(i / 2));
    }
    scene.groups = {{"all", {0, 2 * number}}};
    scene.effects = {make_shared<BodySpring>(links, 0.2), make_shared<Counting>(count),
                     make_shared<Damping>(0.3)};
    return scene;
}

}

class TestBlockSleep : public QObject
{
    Q_OBJECT

private slots:
    void blocksThatRestSleepWhileOneIsDragged_data()
    {
        QTest::addColumn<double>("h");
        for (const double h : {1.0, 0.5, 2.0})
            QTest::addRow("h = %g", h) << h;
    }
    void blocksThatRestSleepWhileOneIsDragged()
    {
        QFETCH(double, h);
        const auto count = make_shared<std::int64_t>(0);
        Script script = support::script(pairs(count), "semi_implicit_euler", h);
        for (int frame = 900; frame < 1200; ++frame) {
            if (frame == 900)
                script.input.push_back({frame, Grab{"pair7"}});
            if (frame == 1100)
                script.input.push_back({frame, Grab{"pair3999"}}); // far away, in another block
            if (frame == 1104) {                                   // taken and left at once
                script.input.push_back({frame, Grab{"pair2000"}});
                script.input.push_back({frame, Move{{0.0, 0.0}}});
                script.input.push_back({frame, Grab{"pair3999"}});
            }
            script.input.push_back({frame, Move{{frame * 0.5, 90.0}}});
        }
        script.input.push_back({1200, Release{}});
        Track track(script, budget), awake(script, budget, Sleeping::never);
        QVERIFY(track.nextInterval()->pipeline.blocks.size() > 2);
        const std::int64_t points = track.state().pointCount();
        std::int64_t least = points;
        for (std::int64_t frame = 0; frame < 1300; frame += track.framesPerOutput()) {
            const std::int64_t before = *count;
            track.seek({frame, 0});
            if (frame > 1060 && frame < 1100)
                least = std::min(least, *count - before);
            awake.seek({frame, 0});
            const std::string what = support::difference(track.state(), awake.state());
            QVERIFY2(sameBits(track.state(), awake.state()), (std::to_string(frame) + ": " + what).c_str());
            if (frame % 250 == 0) { // into a frame, and out again
                for (Track *one : {&track, &awake}) {
                    one->seek({frame, 1});
                    one->seek({frame, 2});
                }
                QVERIFY(sameBits(track.state(), awake.state()));
            }
        }
        const auto steps = std::int64_t(track.script().step.stepsPerOutput);
        QVERIFY2(least <= steps * points / 2, std::to_string(least).c_str());
        QVERIFY(least > 0);
        track.seek({20, 0});
        awake.seek({1400, 0});
        track.seek({1400, 0});
        QVERIFY(sameBits(track.state(), awake.state()));
    }
};

QTEST_APPLESS_MAIN(TestBlockSleep)
#include "tst_block_sleep.moc"
