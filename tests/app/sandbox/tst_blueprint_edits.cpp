// Edits of a blueprint: points, links, feet and their properties.

#include "app/model/sandbox/blueprint_edits.h"
#include "app/model/sandbox/sandbox_properties.h"
#include "tests/suite.h"

#include <QTest>

#include <numeric>

using namespace app;

namespace {

/// A triangle of points without anything else.
sim::Blueprint triangle()
{
    sim::Blueprint plan;
    plan.points = {{"p0", {0, 0}, {}}, {"p1", {30, 40}, {}}, {"p2", {0, 100}, {}}};
    return plan;
}

}

class BlueprintEdits : public QObject
{
    Q_OBJECT

private slots:
    void aNewPointHasTheFirstFreeName()
    {
        sim::Blueprint plan = triangle();
        plan.points[1].name = "p7";
        QCOMPARE(addPoint(plan, {5, 6}), std::optional(3));
        QCOMPARE(plan.points.back().name, std::string("p1"));
        QCOMPARE(plan.points.back().mass, 1.0);
    }

    void aNewLinkIsAsLongAsItsEndsAreApart()
    {
        sim::Blueprint plan = triangle();
        plan.points[1].mass = 3.0;
        QVERIFY(addSpring(plan, 0, 1));
        QCOMPARE(plan.springs.back().length, 50.0);
        QVERIFY(addStick(plan, 0, 1));
        QCOMPARE(plan.sticks.back().share, 0.75); // the light one makes good more of it
        QVERIFY(!addSpring(plan, 2, 2));
        QVERIFY(addFoot(plan, 2, 0));
        QCOMPARE(plan.feet.back().angle, -90.0); // 100 px below, and the legs' middle is 50 below
        QVERIFY(!addFoot(plan, 2, 1));           // a foot of one body only
    }

    void numberOfPointsIsLimited()
    {
        sim::Blueprint plan = triangle();
        while (addPoint(plan, {}))
            ;
        QCOMPARE(plan.points.size(), std::size_t(1000));
    }

    void linksThatLoseAnEndAreRemoved()
    {
        sim::Blueprint plan = triangle();
        addSpring(plan, 0, 1);
        addSpring(plan, 1, 2);
        addStick(plan, 2, 0);
        addFoot(plan, 2, 1);
        erase(plan, {{0}, {}, {}});
        QCOMPARE(plan.points.size(), std::size_t(2));
        QCOMPARE(plan.points[0].name, std::string("p1"));
        QCOMPARE(plan.springs.size(), std::size_t(1));
        QCOMPARE(plan.springs[0].a, 0);
        QCOMPARE(plan.springs[0].b, 1);
        QVERIFY(plan.sticks.empty());
        QCOMPARE(plan.feet[0].body, 0);
        erase(plan, {{}, {0}, {}});
        QVERIFY(plan.springs.empty());
        QCOMPARE(plan.points.size(), std::size_t(2));
    }

    void linksAtTheirRestLengthKeepItWhenAnEndMoves()
    {
        sim::Blueprint plan = triangle();
        addSpring(plan, 0, 1);
        addStick(plan, 0, 2);
        plan.sticks[0].length = 70.0; // it is 30 px too long as it stands
        moveBy(plan, {0}, {30, 0});
        QCOMPARE(plan.springs[0].length, 40.0);
        QCOMPARE(plan.sticks[0].length, 70.0);
    }

    void aFootThatIsMovedTakesItsAngleAlong()
    {
        sim::Blueprint plan = triangle();
        addFoot(plan, 2, 0);
        QCOMPARE(plan.feet[0].angle, -90.0);
        moveBy(plan, {2}, {-50, 0}); // 50 px left of the body and as far below the legs' middle
        QCOMPARE(plan.feet[0].angle, -45.0);
        moveBy(plan, {0}, {100, 0}); // the body alone
        QCOMPARE(plan.feet[0].angle, -45.0);
        moveBy(plan, {2}, {10, 0}); // a foot that does not stand at its angle
        QCOMPARE(plan.feet[0].angle, -45.0);
    }

    void typedPositionChangesLengthsLikeADrag()
    {
        sim::Blueprint typed = triangle();
        addSpring(typed, 0, 1);
        addStick(typed, 0, 2);
        typed.sticks[0].length = 70.0;
        addFoot(typed, 1, 2);
        sim::Blueprint dragged = typed;
        for (const SandboxProperty &one : propertiesOf(typed, {{0}, {}, {}})) {
            if (one.about.id == "x")
                one.set(typed, {{0}, {}, {}}, 30.0);
            else if (one.about.id == "y")
                one.set(typed, {{0}, {}, {}}, -20.0);
        }
        QCOMPARE(typed.springs[0].length, 60.0);
        QCOMPARE(typed.sticks[0].length, 70.0);
        moveBy(dragged, {0}, {30, -20});
        QVERIFY(typed == dragged);
    }

    void aCopyHasItsOwnNamesAndItsOwnLinks()
    {
        sim::Blueprint plan = triangle();
        plan.points[0].mass = 5.0;
        addSpring(plan, 0, 1);
        addSpring(plan, 1, 2);
        addFoot(plan, 1, 0);
        const std::optional<Selection> copies = duplicate(plan, {{0, 1}, {}, {}}, {20, 20});
        QVERIFY(copies == std::optional(Selection{{3, 4}, {2}, {}}));
        QCOMPARE(plan.points[3].mass, 5.0);
        QCOMPARE(plan.points[3].name, std::string("p3"));
        QVERIFY(plan.springs[2].a == 3 && plan.springs[2].b == 4);
        QCOMPARE(plan.feet.size(), std::size_t(2));
        QVERIFY(plan.feet[1].foot == 4 && plan.feet[1].body == 3);
    }

    void twoPointsHaveAtMostOneRuleLink()
    {
        sim::Blueprint plan = triangle();
        QCOMPARE(addRuleLink(plan, 0, 1), std::optional(0));
        QVERIFY(!addRuleLink(plan, 1, 0));
        QVERIFY(!addRuleLink(plan, 2, 2));
        QCOMPARE(addRuleLinksAmong(plan, {0, 1, 2}), std::optional(2)); // the other two sides of the triangle
        QCOMPARE(addRuleLinksAmong(plan, {0, 1, 2}), std::optional(0));
        QCOMPARE(plan.ruleLinks.size(), std::size_t(3));
    }

    void ruleLinksGoWithTheirPointsAndAreCopiedWithThem()
    {
        sim::Blueprint plan = triangle();
        addRuleLink(plan, 0, 1);
        addRuleLink(plan, 1, 2);
        const std::optional<Selection> copy = duplicate(plan, {{0, 1}, {}, {}}, {10, 0});
        QVERIFY(copy);
        QVERIFY(*copy == (Selection{{3, 4}, {}, {}, {2}}));
        QVERIFY(inBox(plan, {5, 0}, {45, 50}) == (Selection{{1, 3, 4}, {}, {}, {2}}));
        erase(plan, {{1}, {}, {}});
        QCOMPARE(plan.ruleLinks.size(), std::size_t(1));
        QCOMPARE(plan.ruleLinks[0].a, 2); // that of the copies, which have moved up
        QCOMPARE(plan.ruleLinks[0].b, 3);
        erase(plan, {{}, {}, {}, {0}});
        QVERIFY(plan.ruleLinks.empty());
        QCOMPARE(plan.points.size(), std::size_t(4));
    }

    void noRuleLinkIsAddedIfNotAllHaveRoom()
    {
        sim::Blueprint plan;
        plan.points.resize(142); // 142 * 141 / 2 = 10,011 pairs
        std::vector<int> all(plan.points.size());
        std::iota(all.begin(), all.end(), 0);
        QVERIFY(!addRuleLinksAmong(plan, all));
        QVERIFY(plan.ruleLinks.empty());
        all.pop_back(); // 141 * 140 / 2 = 9,870
        QCOMPARE(addRuleLinksAmong(plan, all), std::optional(9870));
    }

    void boxSelectsTheElementsInsideIt()
    {
        sim::Blueprint plan = triangle();
        addSpring(plan, 0, 1);
        addStick(plan, 1, 2);
        QVERIFY(inBox(plan, {50, 60}, {-10, -10}) == (Selection{{0, 1}, {0}, {}}));
        QVERIFY(inBox(plan, {200, 200}, {300, 300}).isEmpty());
    }

    void aPropertyIsSetOfAllThatIsChosen()
    {
        sim::Blueprint plan = triangle();
        plan.points[2].mass = 4.0;
        const Selection chosen{{0, 2}, {}, {}};
        for (const SandboxProperty &one : propertiesOf(plan, chosen)) {
            if (one.about.id != "mass")
                continue;
            QVERIFY(!one.get(plan, chosen)); // they differ
            one.set(plan, chosen, 2.0);
            QCOMPARE(one.get(plan, chosen), std::optional(2.0));
        }
        QCOMPARE(plan.points[0].mass, 2.0);
        QCOMPARE(plan.points[1].mass, 1.0);
        QCOMPARE(plan.points[2].mass, 2.0);
    }
};

SUITE(tst_blueprint_edits, BlueprintEdits)
#include "tst_blueprint_edits.moc"
