// The map of concepts without its window: known and next concepts, mistakes, and the layout.

#include "app/model/learning/concept_map.h"
#include "app/model/learning/layered_layout.h"
#include "lessons/api/text/document.h"
#include "tests/app/support/two_lessons.h"
#include "tests/suite.h"

#include <QHash>
#include <QSet>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace app;

namespace {

using Bases = std::vector<std::vector<std::size_t>>;

/// Returns the two lessons with concepts: "one" to "first", "second" and "many", in the order of the steps.
LessonLibrary lessonsWithConcepts(std::vector<lessons::Concept> first,
                                  std::vector<lessons::Concept> second = {},
                                  std::vector<lessons::Concept> many = {})
{
    LessonLibrary library = tests::twoLessons();
    library.lessons[0].steps[0].explanation.concepts = std::move(first);
    library.lessons[0].steps[1].explanation.concepts = std::move(second);
    library.lessons[1].steps[0].explanation.concepts = std::move(many);
    return library;
}

lessons::Concept conceptOf(const QString &id, const QStringList &restsOn = {})
{
    return {
        .id = id, .title = id.toUpper(), .text = "It is.", .restsOn = restsOn, .file = "one.md", .line = 7};
}

QStringList idsIn(const ConceptMap &map)
{
    QStringList ids;
    for (const ConceptNode &node : map.nodes())
        ids << node.id;
    return ids;
}

/// Returns what() of the mistake in the concepts of a library. Empty if there is none.
QString conceptMistake(const LessonLibrary &library)
{
    try {
        checkConcepts(library);
    } catch (const lessons::DocumentError &error) {
        return QString::fromStdString(error.what());
    }
    return {};
}

Bases basesIn(const ConceptMap &map)
{
    Bases bases;
    for (const ConceptNode &node : map.nodes())
        bases.push_back(node.restsOn);
    return bases;
}

/// Returns whether node `i` rests on `base` by way of any number of others. Independent of the layout.
bool isBasedOn(const Bases &bases, std::size_t i, std::size_t base)
{
    return std::any_of(bases[i].begin(), bases[i].end(),
                       [&](std::size_t one) { return one == base || isBasedOn(bases, one, base); });
}

/// Graphs of different shapes, by name.
std::vector<std::pair<const char *, Bases>> graphs()
{
    Bases chain = {{}}, fan = {{}}, grid;
    for (std::size_t i = 1; i < 9; ++i) {
        chain.push_back({i - 1});
        fan.push_back({0});
    }
    for (std::size_t i = 0; i < 36; ++i) {
        grid.emplace_back();
        for (const std::size_t back : {std::size_t{4}, std::size_t{7}, std::size_t{15}}) {
            if (i >= back)
                grid.back().push_back(i - back);
        }
    }
    return {{"nothing", {}},
            {"one node", {{}}},
            {"nodes without edges", {{}, {}, {}, {}, {}, {}, {}}},
            {"a chain", chain},
            {"a fan", fan},
            {"a shortcut", {{}, {0}, {0, 1}, {0, 2}}},
            {"36 nodes", grid},
            {"the lessons", basesIn(ConceptMap(LessonLibrary::load({LESSON_DIR})))}};
}

}

class ConceptLayoutTest : public QObject
{
    Q_OBJECT

private slots:
    void conceptsFollowTheirPrerequisites();
    void wrongReferencesAreLeftOut();
    void knownFollowsTheStepsThatAreDone();
    void aMistakeIsNamedWithItsFile_data();
    void aMistakeIsNamedWithItsFile();
    void theConceptsOfTheLessonsHaveNoMistake();
    void theLessonsHaveAboutThreeDozenConcepts();
    void edgesGoDown_data() { addGraphRows(); }
    void edgesGoDown();
    void transitiveEdgesAreLeftOut_data() { addGraphRows(); }
    void transitiveEdgesAreLeftOut();
    void nothingOverlaps_data() { addGraphRows(); }
    void nothingOverlaps();
    void theSameGraphIsDrawnTheSame();

private:
    static constexpr int inRow = 5;
    static void addGraphRows();
};

void ConceptLayoutTest::conceptsFollowTheirPrerequisites()
{
    const ConceptMap map(
        lessonsWithConcepts({conceptOf("b", {"a"}), conceptOf("a")}, {conceptOf("c", {"b", "a"})}));
    QCOMPARE(idsIn(map), QStringList({"a", "b", "c"}));
    QCOMPARE(map.nodes()[0].carries, std::vector<std::size_t>({1, 2}));
    QCOMPARE(map.nodes()[2].restsOn, std::vector<std::size_t>({1, 0}));
    QCOMPARE(map.nodes()[2].lesson, QString("one"));
    QCOMPARE(map.nodes()[2].step, QString("second"));
    QCOMPARE(map.nodes()[2].where, QString("Lesson one: The second step"));
    QVERIFY(ConceptMap(tests::twoLessons()).nodes().empty());
}

void ConceptLayoutTest::wrongReferencesAreLeftOut()
{
    const ConceptMap map(lessonsWithConcepts({conceptOf("a", {"b", "d", "x", "a"}), conceptOf("b", {"a"})},
                                             {conceptOf("c", {"a", "a"})}, {conceptOf("d"), conceptOf("a")}));
    QCOMPARE(map.nodes().size(), 4u);
    for (std::size_t i = 0; i < map.nodes().size(); ++i) {
        for (const std::size_t base : map.nodes()[i].restsOn)
            QVERIFY(base < i);
    }
    QCOMPARE(map.nodes()[2].restsOn.size(), 1u);
}

void ConceptLayoutTest::knownFollowsTheStepsThatAreDone()
{
    using State = ConceptState;
    const ConceptMap map(lessonsWithConcepts({conceptOf("a"), conceptOf("b", {"a"})}, {conceptOf("c", {"b"})},
                                             {conceptOf("d", {"c"}), conceptOf("e")}));
    QStringList done;
    const auto states = [&] {
        return map.states(
            [&](const QString &lesson, const QString &step) { return done.contains(lesson + '/' + step); });
    };
    QCOMPARE(states(), std::vector({State::next, State::later, State::later, State::later, State::next}));
    done << "one/first";
    QCOMPARE(states(), std::vector({State::known, State::known, State::next, State::later, State::next}));
    done << "two/many"; // also out of order
    QCOMPARE(states(), std::vector({State::known, State::known, State::next, State::known, State::known}));
    done << "one/second";
    QCOMPARE(states(), std::vector(5, State::known));
}

void ConceptLayoutTest::aMistakeIsNamedWithItsFile_data()
{
    QTest::addColumn<LessonLibrary>("library");
    QTest::addColumn<QString>("says");
    QTest::newRow("none") << lessonsWithConcepts({conceptOf("a")}, {conceptOf("b", {"a"})}) << "";
    QTest::newRow("an unknown id") << lessonsWithConcepts({conceptOf("a", {"x"})})
                                   << "the concept “a” rests on “x”, which no step explains.";
    QTest::newRow("a later step") << lessonsWithConcepts({conceptOf("a", {"b"})}, {}, {conceptOf("b")})
                                  << "the concept “a” rests on “b”, which comes later, in one.md.";
    QTest::newRow("itself") << lessonsWithConcepts({conceptOf("a", {"a"})})
                            << "the concept “a” rests on itself.";
    QTest::newRow("a cycle") << lessonsWithConcepts(
                                    {conceptOf("a", {"c"}), conceptOf("b", {"a"}), conceptOf("c", {"b"})})
                             << "the concept “a” rests on one that rests on it.";
    QTest::newRow("an id twice") << lessonsWithConcepts({conceptOf("a")}, {conceptOf("a")})
                                 << "the id “a” is that of a concept in one.md, too.";
}

void ConceptLayoutTest::aMistakeIsNamedWithItsFile()
{
    QFETCH(LessonLibrary, library);
    QFETCH(QString, says);
    const QString mistake = conceptMistake(library);
    QCOMPARE(mistake.isEmpty(), says.isEmpty());
    QVERIFY2(mistake.isEmpty() || mistake.startsWith("one.md, line 7: "), qPrintable(mistake));
    QVERIFY2(mistake.contains(says), qPrintable(mistake));
}

void ConceptLayoutTest::theConceptsOfTheLessonsHaveNoMistake()
{
    QCOMPARE(conceptMistake(LessonLibrary::load({LESSON_DIR})), QString());
}

void ConceptLayoutTest::theLessonsHaveAboutThreeDozenConcepts()
{
    const ConceptMap map(LessonLibrary::load({LESSON_DIR}));
    QVERIFY2(map.nodes().size() >= 30 && map.nodes().size() <= 36,
             qPrintable(QString::number(map.nodes().size())));
    QHash<QString, int> counts;
    for (const ConceptNode &node : map.nodes())
        ++counts[node.lesson];
    for (auto at = counts.begin(); at != counts.end(); ++at)
        QVERIFY2(at.value() <= 7, qPrintable(at.key()));
    QCOMPARE(counts.size(), 10);
}

void ConceptLayoutTest::addGraphRows()
{
    QTest::addColumn<Bases>("bases");
    for (const auto &[name, bases] : graphs())
        QTest::newRow(name) << bases;
}

void ConceptLayoutTest::edgesGoDown()
{
    QFETCH(Bases, bases);
    const LayeredLayout layout = layeredLayout(bases, inRow);
    QCOMPARE(layout.nodes.size(), bases.size());
    for (std::size_t i = 0; i < bases.size(); ++i) {
        for (const std::size_t base : bases[i])
            QVERIFY(layout.nodes[base].row < layout.nodes[i].row);
    }
    for (const LayeredLayout::Edge &edge : layout.edges) {
        int row = layout.nodes[edge.from].row;
        for (const LayeredLayout::Place &place : edge.between)
            QCOMPARE(place.row, ++row);
        QCOMPARE(layout.nodes[edge.to].row, row + 1);
    }
}

void ConceptLayoutTest::transitiveEdgesAreLeftOut()
{
    QFETCH(Bases, bases);
    QSet<std::pair<std::size_t, std::size_t>> wanted, drawn;
    for (std::size_t i = 0; i < bases.size(); ++i) {
        for (const std::size_t base : bases[i]) {
            const bool follows = std::any_of(bases[i].begin(), bases[i].end(), [&](std::size_t other) {
                return other != base && isBasedOn(bases, other, base);
            });
            if (!follows)
                wanted.insert({base, i});
        }
    }
    for (const LayeredLayout::Edge &edge : layeredLayout(bases, inRow).edges)
        drawn.insert({edge.from, edge.to});
    QCOMPARE(drawn, wanted);
}

void ConceptLayoutTest::nothingOverlaps()
{
    QFETCH(Bases, bases);
    constexpr double rounding = 1e-9;
    const LayeredLayout layout = layeredLayout(bases, inRow);
    std::vector<int> counts(static_cast<std::size_t>(layout.rows), 0);
    for (std::size_t i = 0; i < bases.size(); ++i) {
        const LayeredLayout::Place &place = layout.nodes[i];
        QVERIFY(place.x >= -rounding && place.x <= layout.width + rounding);
        ++counts[static_cast<std::size_t>(place.row)];
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(layout.nodes[j].row != place.row ||
                    std::abs(layout.nodes[j].x - place.x) >= 1.0 - rounding);
        for (const LayeredLayout::Edge &edge : layout.edges) {
            for (const LayeredLayout::Place &other : edge.between)
                QVERIFY(other.row != place.row ||
                        std::abs(other.x - place.x) >= LayeredLayout::passing - rounding);
        }
    }
    for (const int count : counts)
        QVERIFY(count >= 1 && count <= inRow);
}

void ConceptLayoutTest::theSameGraphIsDrawnTheSame()
{
    const Bases bases = graphs().back().second;
    const LayeredLayout one = layeredLayout(bases, inRow), other = layeredLayout(bases, inRow);
    for (std::size_t i = 0; i < bases.size(); ++i) {
        QCOMPARE(one.nodes[i].row, other.nodes[i].row);
        QCOMPARE(one.nodes[i].x, other.nodes[i].x);
    }
}

SUITE(tst_concept_layout, ConceptLayoutTest)
#include "tst_concept_layout.moc"
