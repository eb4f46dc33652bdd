#include "lessons/api/view/view.h"
#include "sim/scene/scene.h"
#include "tests/lessons/support/published_files.h"
#include "tests/lessons/support/support.h"
#include "tests/lessons/support/tutorial_match.h"

#include "lessons/api/checks/run_queries.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>

using namespace support;

class TwoBody : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("two_body"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    static sim::Vec2 momentum(const sim::State &state)
    {
        return {state.velocity.col(0).sum(), state.velocity.col(1).sum()};
    }

    /// Returns the pair with a total momentum that is not zero.
    sim::Script thrownPair(const std::string &method, const Changes &changes) const
    {
        sim::Script script = scriptOf(step("mutual"), method, 1.0, changes);
        script.bodies["foot"] = {{330, 260}, sim::Vec2{3, -2}};
        script.bodies["body"] = {{270, 200}, sim::Vec2{1, 4}};
        return script;
    }

private slots:
    void publishedTrajectories_data() { addPublishedRows(QStringLiteral("two_body")); }
    void publishedTrajectories() { checkPublished(m_lesson); }
    void matchesTutorialCode_data();
    void matchesTutorialCode();
    void simultaneousMoveKeepsMomentum();
    void simultaneousMoveDampsMomentumExponentially();
    void sequentialMoveCreatesMomentum();
    void publishedPairFliesAwayOrCalmsDown_data();
    void publishedPairFliesAwayOrCalmsDown();
    void pairRestsOneRadiusApart();
    void methodsConvergeWithOrderOne();
    void legChangesOnlyTheView();
};

void TwoBody::matchesTutorialCode_data()
{
    QTest::addColumn<Match>("match");
    std::mt19937 random(2);
    for (int run = 0; run < 30; ++run) {
        for (const char *id : {"mutual", "leg_line"})
            QTest::addRow("%s, random drags %d", id, run)
                << Match{id, randomTutorial(Tutorial::Kind::mutual, 1, random)};
    }
}

void TwoBody::matchesTutorialCode()
{
    QFETCH(Match, match);
    QVERIFY(largestDifference(step(match.step), match.tutorial, 200) <= 1e-9);
}

void TwoBody::simultaneousMoveKeepsMomentum()
{
    const sim::State state = stateAfter(thrownPair("semi_implicit_euler", {{"damp", 1.0}}), 2000);
    QVERIFY(sim::length(momentum(state) - sim::Vec2{4, 2}) < 1e-10);
}

void TwoBody::simultaneousMoveDampsMomentumExponentially()
{
    sim::Track track(thrownPair("semi_implicit_euler", {{"damp", 0.9}}), 0);
    for (int frame = 1; frame <= 60; ++frame) {
        track.seek({frame, 0});
        const double share = std::pow(0.9, frame);
        QVERIFY(sim::length(momentum(track.state()) - share * sim::Vec2{4, 2}) < 1e-12);
    }
}

void TwoBody::sequentialMoveCreatesMomentum()
{
    const auto afterOneFrame = [&](const std::string &method) {
        return sim::length(momentum(stateAfter(scriptOf(step("mutual"), method), 1)));
    };
    QVERIFY(afterOneFrame("published") > 1.0);
    QVERIFY(afterOneFrame("semi_implicit_euler") < 1e-12);
}

void TwoBody::publishedPairFliesAwayOrCalmsDown_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("damp");
    QTest::addColumn<bool>("flies");
    QTest::newRow("k 0.3, damping 0.9: flies") << 0.3 << 0.9 << true;
    QTest::newRow("k 0.3, damping 0.85: calms down") << 0.3 << 0.85 << false;
    QTest::newRow("k 0.2, damping 0.9: calms down slowly") << 0.2 << 0.9 << false;
}

void TwoBody::publishedPairFliesAwayOrCalmsDown()
{
    QFETCH(double, k);
    QFETCH(double, damp);
    QFETCH(bool, flies);
    const sim::Script script = scriptOf(step("mutual"), "published", 1.0, {{"k", k}, {"damp", damp}});
    const double later = sim::length(momentum(stateAfter(script, 3000)));
    if (flies)
        QVERIFY(later > 10.0);
    else
        QVERIFY(later < 1e-6);
}

void TwoBody::pairRestsOneRadiusApart()
{
    for (const char *method : {"published", "semi_implicit_euler"}) {
        const sim::State rest = stateAfter(scriptOf(step("mutual"), method, 1.0, {{"radius", 80.0}}), 2000);
        QVERIFY(std::abs(sim::length(rest.positionOf(0) - rest.positionOf(1)) - 80.0) < 1e-9);
    }
}

void TwoBody::methodsConvergeWithOrderOne()
{
    const OrderRange order = observedOrders(
        [&](double h) {
            sim::Script published = thrownPair("published", {});
            sim::Script semiImplicit = thrownPair("semi_implicit_euler", {});
            published.step = semiImplicit.step = sim::StepSize::ofLength(h);
            return largestDistance(stateAfter(published, 20), stateAfter(semiImplicit, 20));
        },
        4, 9);
    QVERIFY(order.min > 0.9 && order.max < 1.1);
}

void TwoBody::legChangesOnlyTheView()
{
    const lessons::Step &without = step("mutual"), &with = step("leg_line");
    QVERIFY(sim::sameBits(stateAfter(without.script(), 100), stateAfter(with.script(), 100)));
    const sim::Values values = with.defaultValues();
    QVERIFY(without.view(without.scene(values), values).legs.empty());
    QCOMPARE(with.view(with.scene(values), values).legs.size(), std::size_t{1});
}

SUITE(tst_two_body, TwoBody)
#include "tst_two_body.moc"
