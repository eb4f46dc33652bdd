// The names that a listing can use: the common ones, and the ones of creatures, branches and sticks.

#include "app/listing/program.h"
#include "tests/listing/listing_support.h"
#include "tests/suite.h"

#include <QTest>

using namespace listing_support;

class ListingVocabulary : public QObject
{
    Q_OBJECT

private slots:
    void everyNameOfTheVocabularyCompiles();
    void vocabularyFollowsTheNamesOfTheScene();
    void reservedNamesAreLeftOutOfTheVocabulary();
    void creaturesAreInTheVocabulary();
    void mistakeWithCreaturesIsReportedInOneSentence_data();
    void mistakeWithCreaturesIsReportedInOneSentence();
    void branchesAndSticksAreInTheVocabulary();
    void mistakeWithBranchesOrSticksIsReportedInOneSentence_data();
    void mistakeWithBranchesOrSticksIsReportedInOneSentence();
};

void ListingVocabulary::everyNameOfTheVocabularyCompiles()
{
    QCOMPARE(errorsOf(frameOf(R"(
        Vec2 v = body.position + feet[0].velocity - Vec2(1, 2);
        v = -v;
        v *= 2; v /= 2; v += v; v -= v;
        v = 2 * v; v = v * 2; v = v / 2;
        bool same = v == Vec2() && v != Vec2(1, 1);
        double all = length(v) + dot(v, v) + v.x + v.y + sin(1) + cos(1) + atan2(1, 2) + sqrt(2) + pow(2, 3) +
                     hypot(3, 4) + remainder(5, 3) + random(1, 2) + abs(-1) + min(1, 2) + max(1, 2) + clamp(3, 1, 2) + floor(1.5) + random(0) + pi;
        all += k + damp + radius + frame_number + body.mass + body.radius + feet.count;
        v = direction(body, feet[0]) + direction(body, v) + direction(v, pointer, body) + body.before;
        all += new_targets.count > 0 ? new_targets[0].x : 0;
        all += hand.x + pointer.x + target.y;
        if (keys.left || keys.right || keys.up || keys.down || pointer_down || pointer_known || body.held || same)
            all += 1;
        auto whole = 3 % 2;
        for (int i = 0; i < feet.count; ++i) { if (i == 1) continue; if (i == 2) break; }
        while (all > 1e9) all /= 2;
        do { all -= 1; } while (all > 1e9);
        if (whole == 1) all = 1;
        body.velocity.x = all > 0 ? 1 : 2;)")),
             std::string());
}

void ListingVocabulary::vocabularyFollowsTheNamesOfTheScene()
{
    const listing::Vocabulary found = listing::vocabularyOf(threeFeet());
    QVERIFY(found.bodies == std::vector<std::string>{"body"});
    QVERIFY((found.arrays == std::vector<listing::Vocabulary::Array>{{"feet", "foot"}}));
    QVERIFY((found.parameters == std::vector<std::string>{"damp", "k", "radius"}));
    QVERIFY(!found.bodiesTurn && !found.hasGait);
    const listing::Binding binding = listing::bind(found, threeFeet());
    QVERIFY(binding.bodies == std::vector<int>{3});
    QVERIFY((binding.arrays == std::vector<std::vector<int>>{{0, 1, 2}}));
    QVERIFY((binding.parameters == std::vector<double>{0.5, 0.25, 50}));
    QCOMPARE(binding.seed, std::uint64_t{7});
    QCOMPARE(listing::pluralOf("branch"), std::string("branches"));
    QCOMPARE(listing::pluralOf("p"), std::string("points"));
    QCOMPARE(listing::pluralOf("arm"), std::string("arms"));
}

void ListingVocabulary::reservedNamesAreLeftOutOfTheVocabulary()
{
    sim::Scene scene = threeFeet();
    scene.names = {"creature0.foot0", "out", "pointer", "body"};
    const listing::Vocabulary found = listing::vocabularyOf(scene);
    QVERIFY(found.bodies == std::vector<std::string>{"body"});
    QVERIFY(found.arrays.empty());
}

void ListingVocabulary::creaturesAreInTheVocabulary()
{
    const listing::Vocabulary found = listing::vocabularyOf(threeCreatures());
    QVERIFY(found.hasCreatures && found.hasGait);
    QVERIFY(found.bodies.empty() && found.arrays.empty());
    QVERIFY((found.parameters == std::vector<std::string>{"floor", "k"}));
    const listing::Binding binding = listing::bind(found, threeCreatures());
    QCOMPARE(binding.creatures.size(), std::size_t{3});
    QCOMPARE(binding.creatures[1].body, 5);
    QVERIFY((binding.creatures[1].feet == std::vector<int>{3, 4}));
}

void ListingVocabulary::mistakeWithCreaturesIsReportedInOneSentence_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("error");
    const auto row = [](const char *name, const char *line, const char *error) {
        QTest::newRow(name) << QString::fromUtf8(line) << QString::fromUtf8(error);
    };
    row("none", "Creature one = creatures[0]; one.gait += one.gait_speed; one.feet[0].position.x = floor;",
        "");
    row("member of a creature", "creatures[0].velocity *= k;",
        "3:14+8 'velocity' is not a member of Creature. It has body, feet, gait and gait_speed.");
    row("array instead of a creature", "creatures.gait = 0;",
        "3:11+4 'gait' is not a member of the array of creatures. Choose one of them first, for example with "
        "[0].");
    row("clock of the scene", "gait = 0;",
        "3:1+4 There is no 'gait'. A new variable needs a type: 'double gait', 'int gait' or 'Vec2 gait'.");
    row("misspelt type", "Creatre one = creatures[0];",
        "3:1+7 There is no type 'Creatre'. Did you mean 'Creature'?");
    row("unknown type", "Animal one = creatures[0];",
        "3:1+6 There is no type 'Animal'. The types are double, int, bool, Vec2, Body and Creature.");
    row("function that a number replaces", "double a = floor(1.5);",
        "3:12+5 'floor' is a double here, not a function. To multiply, write '*'.");
}

void ListingVocabulary::mistakeWithCreaturesIsReportedInOneSentence()
{
    QFETCH(QString, line);
    QFETCH(QString, error);
    QCOMPARE(QString::fromStdString(errorsOf(frameOf(line.toStdString()), threeCreatures())), error);
}

void ListingVocabulary::branchesAndSticksAreInTheVocabulary()
{
    const listing::Vocabulary ofTree = listing::vocabularyOf(swingingBush());
    QVERIFY(ofTree.hasTree && ofTree.hasGust && ofTree.bodiesTurn && !ofTree.hasSticks);
    QVERIFY((ofTree.arrays == std::vector<listing::Vocabulary::Array>{{"branches", "branch"}}));
    const listing::Vocabulary ofSticks = listing::vocabularyOf(twoSticks());
    QVERIFY(ofSticks.hasSticks && !ofSticks.hasTree && !ofSticks.hasGust);
    QVERIFY((ofSticks.arrays == std::vector<listing::Vocabulary::Array>{{"points", "p"}}));
    const listing::Binding binding = listing::bind(ofSticks, twoSticks());
    QVERIFY((binding.sticks == std::vector<sim::Stick>{{0, 1, 10, 0.25}, {1, 2, 7, 0.5}}));
    QVERIFY(binding.otherBodies == std::vector<int>{2}); // reached by a stick only
    const listing::Vocabulary ofFeet = listing::vocabularyOf(threeFeet());
    QVERIFY(!ofFeet.hasTree && !ofFeet.hasGust && !ofFeet.hasSticks);
}

void ListingVocabulary::mistakeWithBranchesOrSticksIsReportedInOneSentence_data()
{
    QTest::addColumn<bool>("hasTree");
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("error");
    const auto row = [](const char *name, bool hasTree, const char *line, const char *error) {
        QTest::newRow(name) << hasTree << QString::fromUtf8(line) << QString::fromUtf8(error);
    };
    row("names of a tree", true,
        "Body trunk = branches[0]; trunk.angle = trunk.rest + trunk.scale * trunk.length / trunk.inertia;\n"
        "if (gust_known && trunk.number < trunk.children.count) gust_front = gust_tail + gust;",
        "");
    row("names of sticks", false,
        "Stick one = sticks[0]; one.a.position.x = one.length * one.share + one.b.position.x;", "");
    row("member of a branch", true, "branches[0].kids[0].spin = 1;",
        "3:13+4 'kids' is not a member of Body. It has position, velocity, before, held, mass, radius, "
        "angle, spin, "
        "number, rest, scale, length, inertia and children.");
    row("number of a branch is set", true, "branches[0].scale = 1;",
        "3:13+5 This cannot be changed. A listing changes positions, velocities and its own variables.");
    row("children instead of a child", true, "branches[0].children.spin = 1;",
        "3:22+4 'spin' is not a member of an array of bodies. Choose one of them first, for example with "
        "[0].");
    row("member of a stick", false, "sticks[0].lenght *= k;",
        "3:11+6 'lenght' is not a member of Stick. Did you mean 'length'?");
    row("sticks instead of a stick", false, "double a = sticks.length;",
        "3:19+6 'length' is not a member of the array of sticks. Choose one of them first, for example with "
        "[0].");
    row("length of a stick is set", false, "sticks[0].length = 2;",
        "3:11+6 This cannot be changed. A listing changes positions, velocities and its own variables.");
    row("unknown name", false, "points[0].position.x = wobble;",
        "3:24+6 There is no 'wobble'. This scene has points and sticks, and the number k.");
    row("unknown type", false, "Rope one = sticks[0];",
        "3:1+4 There is no type 'Rope'. The types are double, int, bool, Vec2, Body and Stick.");
    row("gust of a scene without one", false, "gust_front += 1;",
        "3:1+10 There is no 'gust_front'. This scene has points and sticks, and the number k.");
}

void ListingVocabulary::mistakeWithBranchesOrSticksIsReportedInOneSentence()
{
    QFETCH(bool, hasTree);
    QFETCH(QString, line);
    QFETCH(QString, error);
    const sim::Scene scene = hasTree ? swingingBush() : twoSticks();
    QCOMPARE(QString::fromStdString(errorsOf(frameOf(line.toStdString()), scene)), error);
}

SUITE(tst_listing_vocabulary, ListingVocabulary)
#include "tst_listing_vocabulary.moc"
