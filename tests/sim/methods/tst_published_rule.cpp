// The published method, v = (v + a) damp, x += v, one body after the other. The test computes it with plain
// code and compares every bit.

#include "sim/scene/scene.h"
#include "tests/sim/support/support.h"

#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>

using namespace sim;
using support::Dice;

namespace {

struct Parameters
{
    int feet = 5;
    double k = 0.2, damp = 0.85, radius = 50, gravity = 0.5, bounce = 1.0;
};

struct Body
{
    double x, y, vx, vy, half;
};

void pull(Body &mover, const Body &anchor, const Parameters &n)
{
    const double angle = std::atan2(mover.y - anchor.y, mover.x - anchor.x);
    mover.vx += (anchor.x + n.radius * std::cos(angle) - mover.x) * n.k;
    mover.vy += (anchor.y + n.radius * std::sin(angle) - mover.y) * n.k;
}

void moveBody(Body &body, const Parameters &n)
{
    body.vy += n.gravity;
    body.vx *= n.damp;
    body.vy *= n.damp;
    body.x += body.vx;
    body.y += body.vy;
    if (body.x > 520 - body.half) {
        body.x = 520 - body.half;
        body.vx *= -n.bounce;
    }
    if (body.x < 20 + body.half) {
        body.x = 20 + body.half;
        body.vx *= -n.bounce;
    }
    if (body.y > 380 - body.half) {
        body.y = 380 - body.half;
        body.vy *= -n.bounce;
    }
}

void computeFrame(std::vector<Body> &bodies, const Parameters &n)
{
    Body &body = bodies.back();
    for (int i = 0; i < n.feet; ++i) {
        pull(bodies[std::size_t(i)], body, n);
        moveBody(bodies[std::size_t(i)], n);
    }
    for (int i = 0; i < n.feet; ++i)
        pull(body, bodies[std::size_t(i)], n);
    moveBody(body, n);
}

Parameters randomParameters(Dice &dice)
{
    Parameters n;
    n.feet = dice.whole(1, 12);
    n.k = dice.real(0.01, 0.4);
    n.damp = dice.real(0.6, 1.0);
    n.radius = dice.real(0, 120);
    n.gravity = dice.chance(0.3) ? 0.0 : dice.real(-0.5, 2.0);
    n.bounce = dice.chance(0.5) ? 1.0 : dice.real(0.0, 1.2);
    return n;
}

Scene sceneWith(const Parameters &n, std::uint64_t seed, bool isCoincident)
{
    Scene scene = scenes::springCreature(n.feet, n.k, n.radius);
    if (!isCoincident)
        support::scatter(scene.start, seed, 600.0);
    scenes::add<Gravity>(scene, n.gravity);
    scenes::add<Damping>(scene, n.damp);
    scenes::add<Walls>(scene, Room{20, 520, 380, n.bounce}, scenes::halfWidths(scene));
    return scene;
}

}

class TestPublishedRule : public QObject
{
    Q_OBJECT

private slots:
    void creaturesAreComputedAsPublished_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 60; ++seed)
            QTest::addRow("creature %d", seed) << seed;
    }
    void creaturesAreComputedAsPublished()
    {
        QFETCH(int, seed);
        Dice dice(static_cast<std::uint64_t>(seed));
        const Parameters n = randomParameters(dice);
        const Scene scene = sceneWith(n, std::uint64_t(seed), seed % 10 == 0);
        std::vector<Body> bodies;
        for (int i = 0; i <= n.feet; ++i)
            bodies.push_back(
                {scene.start.positionOf(i).x, scene.start.positionOf(i).y, 0, 0, i == n.feet ? 15.0 : 5.0});
        Track track(support::script(scene, "published"), 0);
        for (int frame = 1; frame <= 400; ++frame) {
            computeFrame(bodies, n);
            track.seek({frame, 0});
            QVERIFY(!track.stop());
            for (int i = 0; i <= n.feet; ++i) {
                const Body &b = bodies[std::size_t(i)];
                QVERIFY2(track.state().positionOf(i) == (Vec2{b.x, b.y}),
                         qPrintable(QString("frame %1").arg(frame)));
                QVERIFY(track.state().velocityOf(i) == (Vec2{b.vx, b.vy}));
            }
        }
    }
};

SUITE(tst_published_rule, TestPublishedRule)
#include "tst_published_rule.moc"
