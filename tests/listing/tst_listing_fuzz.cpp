// Listings and rules with random mistakes. None may crash, hang or change anything but its own frame. Environment variables
// choose others:
//   SPRINGSTEP_RANDOM_SEED   the seed, 20 to begin with
//   SPRINGSTEP_RANDOM_COUNT  how many
//   SPRINGSTEP_RANDOM_FIRST  the number of the first, 1 to begin with

#include "app/listing/program.h"
#include "app/listing/rule_program.h"
#include "sim/effects/rules/rule_force.h"
#include "sim/methods/methods.h"
#include "sim/scene/values.h"
#include "tests/listing/listing_mutations.h"
#include "tests/listing/listing_support.h"
#include "tests/sizes.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <cstring>
#include <ctime>
#include <random>

using namespace listing_support;

namespace {

/// A listing to mutate, and the scene that it is for.
struct Original
{
    std::string text;
    sim::Scene scene;
};

/// Returns `scene` with further numbers, all 0.5.
sim::Scene withNumbers(sim::Scene scene, std::initializer_list<const char *> ids)
{
    sim::Values numbers = *scene.values;
    for (const char *id : ids)
        numbers.set(id, 0.5);
    scene.values = std::make_shared<const sim::Values>(numbers);
    return scene;
}

std::vector<Original> originals()
{
    sim::Scene feet = withNumbers(threeFeet(), {"offset"});
    feet.names = {"foot0", "foot1", "foot", "body"}; // the names of both lessons
    const sim::Scene creatures =
        withNumbers(threeCreatures(), {"leg", "drop", "damp", "push", "distance", "felt_by", "gravity",
                                       "ground", "bounce", "traction", "left", "right", "at_wall"});
    sim::Scene tree = withNumbers(swingingBush(), {"formula", "base_length", "ease", "wind", "turbulence"});
    tree.start.input.pointer = sim::Vec2{30, -20};
    tree.start.input.pointerDown = true;
    const sim::Scene sticks =
        withNumbers(twoSticks(), {"iterations", "gravity", "damp", "friction", "left", "right", "floor"});
    const std::string ofItsOwn =
        "double clock = 0;\nVec2 last = body.position;\n"
        "double grow(Vec2 from, double length, int depth)\n{\n    if (depth == 0)\n        return length;\n"
        "    Vec2 tip = from + length * Vec2(cos(clock), sin(clock));\n"
        "    return grow(tip, 0.7 * length, depth - 1) + grow(tip, 0.6 * length, depth - 1);\n}\n" +
        frameOf("clock += 0.1;\nlast = body.position;\nint n = 0;\nwhile (n < 3)\n    n++;\n"
                "body.position.x += grow(last, 40, 5) / n;");
    return {{fileText("lessons/multi_foot/any_number.code"), feet},
            {fileText("lessons/single_spring/offset.code"), feet},
            {fileText("lessons/walking_gait/company.code"), creatures},
            {fileText("lessons/swaying_tree/turbulence.code"), tree},
            {fileText("lessons/rigid_constraint/verlet.code"), sticks},
            {ofItsOwn, feet}};
}

const std::vector<std::string> &originalRules()
{
    static const std::vector<std::string> rules = {
        "Vec2 force(Body me)\n{\n    Vec2 sum(0, 0);\n    for (int i = 0; i < bodies.count; i++)\n    {\n"
        "        Body other = bodies[i];\n        if (other == me)\n            continue;\n"
        "        Vec2 to = other.position - me.position;\n"
        "        sum += 900 / pow(max(length(to), 5), 3) * to;\n    }\n    return sum;\n}\n",
        "Vec2 pull(Body me, Body other)\n{\n    Vec2 to = other.position - me.position;\n"
        "    double over = length(to) - 40;\n"
        "    return (0.02 * over + 0.0001 * pow(over, 3)) * direction(me, other);\n}\n",
        "double height(Vec2 place)\n{\n    return clamp(1 - place.y / 400, 0, 1);\n}\n\n"
        "Vec2 force(Body me)\n{\n    Vec2 wind = 3 * height(me.position) * Vec2(cos(time / 20), random(1));\n"
        "    wind -= me.velocity;\n    return 0.05 * length(wind) * wind + me.mass * Vec2(0, 0.1);\n}\n\n"
        "Vec2 pull(Body me, Body other)\n{\n    return 0.1 * (other.position - me.position);\n}\n"};
    return rules;
}

/// Returns a scene of three bodies, of which two are linked, with this rule.
sim::Scene sceneWith(const std::shared_ptr<const sim::Rule> &rule)
{
    sim::Scene scene;
    scene.start = sim::State::ofPoints(3);
    scene.groups = {{"points", {0, 3}}};
    scene.names = {"p0", "p1", "p2"};
    for (int i = 0; i < 3; ++i)
        scene.start.place(i, {30.0 * i, 7.0 * i * i});
    scene.start.gait = Eigen::ArrayXd::Constant(1, 0.5);
    scene.start.gaitSpeed = Eigen::ArrayXd::Constant(1, 1.0);
    const std::vector<double> parameters(rule->parameters().size(), 0.5);
    const sim::RuleScene constants = {Eigen::ArrayXd::Ones(3), Eigen::ArrayXd::Constant(3, 5.0), parameters,
                                      0, 7};
    scene.effects = {
        std::make_shared<sim::RuleForce>(rule, constants, std::vector<sim::RuleForce::Link>{{0, 1}})};
    return scene;
}

/// Returns the forces on all bodies, added up.
Eigen::ArrayX2d forcesIn(const sim::Scene &scene)
{
    Eigen::ArrayX2d forces = Eigen::ArrayX2d::Zero(3, 2);
    const auto &rule = dynamic_cast<const sim::RuleForce &>(*scene.effects.front());
    rule.add(scene.start, {0, 3}, 1.0, sim::DirectionRule::published, forces);
    return forces;
}

}

class ListingFuzz : public QObject
{
    Q_OBJECT

private slots:
    void mutatedListingsNeitherCrashNorHang_data() { addRows(); }
    void mutatedListingsNeitherCrashNorHang();
    void mutatedRulesNeitherCrashNorHang_data() { addRows(); }
    void mutatedRulesNeitherCrashNorHang();
    void enoughMutationsCompile();
    void deepNestingEndsInAProgramOrAMistake_data();
    void deepNestingEndsInAProgramOrAMistake();

private:
    void addRows();
    /// Calls `check` with each mutated text of the current row, of which `original` returns the original.
    template <class OriginalOf, class Check>
    void checkRow(const OriginalOf &original, const Check &check);
    void checkListing(const std::string &text, const sim::Scene &scene);
    void checkRule(const std::string &text);
    void checkTime(std::clock_t begin);
    void checkFrames(const listing::Program &program, const sim::Scene &scene);

    const std::vector<Original> m_originals = originals();
    const unsigned m_seed = tests::setting("SPRINGSTEP_RANDOM_SEED", 20u);
    const unsigned m_count = tests::setting<unsigned>("SPRINGSTEP_RANDOM_COUNT", LISTING_MUTATIONS);
    const unsigned m_first = tests::setting("SPRINGSTEP_RANDOM_FIRST", 1u);
    unsigned m_built = 0, m_failed = 0, m_builtRules = 0, m_failedRules = 0;
    double m_slowest = 0.0; ///< s
};

void ListingFuzz::addRows()
{
    QTest::addColumn<unsigned>("first");
    QTest::addColumn<unsigned>("end");
    constexpr unsigned inARow = 250;
    for (unsigned first = m_first; first < m_first + m_count; first += inARow) {
        const unsigned end = std::min(first + inARow, m_first + m_count);
        QTest::addRow("%u to %u", first, end - 1) << first << end;
    }
}

template <class OriginalOf, class Check>
void ListingFuzz::checkRow(const OriginalOf &original, const Check &check)
{
    QFETCH(unsigned, first);
    QFETCH(unsigned, end);
    for (unsigned number = first; number < end; ++number) {
        std::seed_seq seeds{m_seed, number};
        std::mt19937 random(seeds);
        const std::string text = mutated(original(number), random);
        const std::clock_t begin = std::clock();
        check(number, text);
        checkTime(begin);
        if (QTest::currentTestFailed()) {
            qWarning("Seed %u, number %u:\n%s", m_seed, number, text.c_str());
            return;
        }
    }
}

/// No listing hangs. Measures processor time, because other programs share the machine.
void ListingFuzz::checkTime(std::clock_t begin)
{
    const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    QVERIFY2(took < 1.0, qPrintable(QString::number(took) + " s"));
    m_slowest = std::max(m_slowest, took);
}

void ListingFuzz::mutatedListingsNeitherCrashNorHang()
{
    const auto of = [this](unsigned number) -> const Original & {
        return m_originals[number % m_originals.size()];
    };
    checkRow([&](unsigned number) { return of(number).text; },
             [&](unsigned number, const std::string &text) { checkListing(text, of(number).scene); });
}

void ListingFuzz::mutatedRulesNeitherCrashNorHang()
{
    checkRow([](unsigned number) { return originalRules()[number % originalRules().size()]; },
             [this](unsigned, const std::string &text) { checkRule(text); });
}

void ListingFuzz::checkListing(const std::string &text, const sim::Scene &scene)
{
    const listing::Compiled compiled = listing::Program::compile(text, listing::vocabularyOf(scene));
    QVERIFY(!compiled.program == !compiled.errors.empty());
    for (const listing::CompileError &error : compiled.errors) {
        QVERIFY(error.line >= 1 && error.column >= 1 && error.length >= 1);
        QVERIFY(!error.sentence.empty());
    }
    if (compiled.program)
        checkFrames(*compiled.program, scene);
}

void ListingFuzz::checkRule(const std::string &text)
{
    const listing::CompiledRule compiled = listing::compileRule(text);
    QVERIFY(!compiled.rule == !compiled.errors.empty());
    for (const listing::CompileError &error : compiled.errors) {
        QVERIFY(error.line >= 1 && error.column >= 1 && error.length >= 1);
        QVERIFY(!error.sentence.empty());
    }
    if (!compiled.rule)
        return;
    ++m_builtRules;
    const sim::Scene scene = sceneWith(compiled.rule);
    const Eigen::ArrayX2d forces = forcesIn(scene), again = forcesIn(scene);
    QVERIFY(std::memcmp(forces.data(), again.data(),
                        sizeof(double) * static_cast<std::size_t>(forces.size())) == 0);
    const sim::MethodPtr method = sim::findMethod("semi_implicit_euler");
    sim::State start = scene.start;
    method->prepareState(start);
    const std::optional<listing::RuleError> mistake =
        listing::ruleErrorIn(scene, *method, sim::StepSize(), start);
    if (mistake) {
        ++m_failedRules;
        QVERIFY(!mistake->error.sentence.empty() && !forces.isFinite().all());
    }
}

void ListingFuzz::checkFrames(const listing::Program &program, const sim::Scene &scene)
{
    ++m_built;
    const listing::Binding binding = listing::bind(program.vocabulary(), scene);
    sim::State state = scene.start;
    for (state.frame = 1; state.frame <= 3; ++state.frame) {
        const sim::State before = state;
        if (program.run(state, binding)) {
            ++m_failed;
            QVERIFY(sim::sameBits(state, before));
            break;
        }
        QVERIFY(state.position.isFinite().all() && state.velocity.isFinite().all());
        sim::State again = before; // the same frame has the same bits
        QVERIFY(!program.run(again, binding));
        QVERIFY(sim::sameBits(state, again));
    }
    QVERIFY(program.trace(scene.start, binding).lines.size() <= 10'000);
}

/// Makes sure that the tests above also run mutated programs.
void ListingFuzz::enoughMutationsCompile()
{
    qInfo("%u of %u compiled, %u stopped with an error, the slowest took %.0f ms", m_built, m_count, m_failed,
          1e3 * m_slowest);
    qInfo("%u of %u rules compiled, %u stopped with an error", m_builtRules, m_count, m_failedRules);
    QVERIFY(m_built > m_count / 20 && m_builtRules > m_count / 20);
}

void ListingFuzz::deepNestingEndsInAProgramOrAMistake_data()
{
    QTest::addColumn<QString>("part");
    for (const char *part : {"(",
                             "[",
                             "{",
                             "-",
                             "!",
                             "++",
                             "~",
                             "a=",
                             "a?b:",
                             "if(k>1)",
                             "if(k>1){}else ",
                             "for(;;)",
                             "while(k>1)",
                             "do ",
                             "else ",
                             "f(",
                             "a.",
                             "a,",
                             "//",
                             "/*",
                             "int a=1;",
                             "switch(1){case 1:",
                             "void f(){",
                             "a+",
                             "a**",
                             "\n",
                             "\t",
                             "Vec2(",
                             "feet[",
                             "const ",
                             "1.",
                             "0x",
                             "\xc3\xa4"})
        QTest::newRow(part) << QString::fromUtf8(part);
}

void ListingFuzz::deepNestingEndsInAProgramOrAMistake()
{
    QFETCH(QString, part);
    for (const char *prefix : {"", "void frame(){ double a = ", "void frame(){ "}) {
        std::string text = prefix;
        while (text.size() + static_cast<std::size_t>(part.toUtf8().size()) <= 20'000)
            text += part.toStdString();
        const listing::Compiled compiled =
            listing::Program::compile(text, listing::vocabularyOf(threeFeet()));
        QVERIFY2(!compiled.program == !compiled.errors.empty(), prefix);
    }
}

SUITE(tst_listing_fuzz, ListingFuzz)
#include "tst_listing_fuzz.moc"
