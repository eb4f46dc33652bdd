#include "app/listing/program.h"
#include "sim/scene/values.h"
#include "tests/listing/listing_support.h"
#include "tests/suite.h"

#include <QTest>

#include <array>
#include <ctime>
#include <random>

using namespace listing_support;

/// Listings with random mistakes. None may crash, hang or change anything but its own frame.
class ListingFuzz : public QObject
{
    Q_OBJECT

private slots:
    void mutatedListingsNeitherCrashNorHang();
    void deepNestingEndsInAProgramOrAMistake_data();
    void deepNestingEndsInAProgramOrAMistake();
};

namespace {

std::string mutated(std::string text, std::mt19937 &random)
{
    static constexpr std::array<const char *, 88> pieces = {"sticks[i].a",
                                                            "Stick s;",
                                                            "branches[0].children[i]",
                                                            "direction(body, feet[i])",
                                                            "new_targets[0]",
                                                            "random(1, 2)",
                                                            "before",
                                                            "{",
                                                            "}",
                                                            "(",
                                                            ")",
                                                            ";",
                                                            "@",
                                                            "&in",
                                                            "[]",
                                                            "double",
                                                            "Vec2",
                                                            "Body",
                                                            "for",
                                                            "while",
                                                            "if",
                                                            "return",
                                                            "class",
                                                            "funcdef",
                                                            "const",
                                                            "null",
                                                            "cast<Body>",
                                                            "is",
                                                            "0x",
                                                            "1e308",
                                                            "-",
                                                            "*",
                                                            "%",
                                                            "/",
                                                            "<<",
                                                            "?",
                                                            ":",
                                                            "::",
                                                            "namespace",
                                                            "import",
                                                            "interface",
                                                            "mixin",
                                                            "auto",
                                                            "private",
                                                            "enum",
                                                            "typedef",
                                                            "operator",
                                                            "opCall",
                                                            "this",
                                                            "super",
                                                            "array",
                                                            "string",
                                                            "try",
                                                            "catch",
                                                            "feet[i]",
                                                            "body",
                                                            "body = body",
                                                            "Body b;",
                                                            "Body b = body;",
                                                            "int f(){return f();}",
                                                            "1/0",
                                                            "1%0",
                                                            "\"x\"",
                                                            "'c'",
                                                            "~",
                                                            "^^",
                                                            "&&",
                                                            "get_x",
                                                            "set",
                                                            "property",
                                                            "shared",
                                                            "external",
                                                            "abstract",
                                                            "final",
                                                            "feet.count",
                                                            "creatures[i]",
                                                            "Creature c;",
                                                            "me.body",
                                                            "while (true)",
                                                            "do",
                                                            "switch (1) {",
                                                            "case 1:",
                                                            "default:",
                                                            "**",
                                                            "random(-1)",
                                                            "double g = 1;",
                                                            "break;",
                                                            "continue;"};
    const auto below = [&](std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
    };
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    /// Returns the position and the length of a random word of the text.
    const auto randomWord = [&] {
        std::size_t at = below(text.size());
        while (at < text.size() && !isLetter(text[at]))
            ++at;
        std::size_t first = at;
        while (first > 0 && first <= text.size() && isLetter(text[first - 1]))
            --first;
        while (at < text.size() && isLetter(text[at]))
            ++at;
        return std::pair(first, at - first);
    };
    std::size_t mutations = 1;
    while (mutations < 4 && below(2) == 0)
        ++mutations;
    for (std::size_t i = 0; i < mutations; ++i) {
        if (text.empty())
            text = " ";
        const std::size_t at = below(text.size());
        switch (below(8)) {
        case 0:
            text[at] = static_cast<char>(below(256));
            break;
        case 1:
            text.erase(at, 1 + below(12));
            break;
        case 2:
            text.insert(at, " " + std::string(pieces[below(pieces.size())]) + " ");
            break;
        case 3:
            text.insert(at, text.substr(below(text.size()), below(40)));
            break;
        case 4: { // a line twice, or not at all
            const std::size_t first = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
            const std::size_t end = std::min(text.find('\n', first), text.size() - 1) + 1;
            if (below(2) == 0)
                text.insert(first, text.substr(first, end - first));
            else
                text.erase(first, end - first);
            break;
        }
        case 5: { // another sign
            static constexpr std::string_view signs = "+-*/%<>=!&|^";
            const std::size_t sign = text.find_first_of(signs, at);
            if (sign != std::string::npos)
                text[sign] = signs[below(signs.size())];
            break;
        }
        case 6: { // another number
            static constexpr std::array<const char *, 10> numbers = {
                "0", "1", "-1", "2", "7", "1e308", "1e-308", "2147483647", "0.5", "100"};
            const std::size_t digit = text.find_first_of("0123456789", at);
            if (digit != std::string::npos)
                text.replace(digit, 1, numbers[below(numbers.size())]);
            break;
        }
        default: { // a word of the listing in the place of another one
            const auto [from, length] = randomWord();
            const std::string word = text.substr(std::min(from, text.size()), length);
            const auto [to, replaced] = randomWord();
            text.replace(std::min(to, text.size()), replaced, word);
        }
        }
    }
    return text;
}

}

void ListingFuzz::mutatedListingsNeitherCrashNorHang()
{
    const std::string ofCreatures = fileText("lessons/walking_gait/company.code"),
                      ofTree = fileText("lessons/swaying_tree/turbulence.code"),
                      ofSticks = fileText("lessons/rigid_constraint/verlet.code");
    const std::vector<std::string> listings = {
        fileText("lessons/multi_foot/any_number.code"),
        fileText("lessons/single_spring/offset.code"),
        ofCreatures,
        ofTree,
        ofSticks,
        "double clock = 0;\nVec2 last = body.position;\n"
        "double grow(Vec2 from, double length, int depth)\n{\n    if (depth == 0)\n        return length;\n"
        "    Vec2 tip = from + length * Vec2(cos(clock), sin(clock));\n"
        "    return grow(tip, 0.7 * length, depth - 1) + grow(tip, 0.6 * length, depth - 1);\n}\n" +
            frameOf("clock += 0.1;\nlast = body.position;\nint n = 0;\nwhile (n < 3)\n    n++;\n"
                    "body.position.x += grow(last, 40, 5) / n;")};
    sim::Scene feetScene = threeFeet();
    feetScene.names = {"foot0", "foot1", "foot", "body"}; // the names of both lessons
    sim::Values values = *feetScene.values;
    values.set("offset", 50);
    feetScene.values = std::make_shared<const sim::Values>(values);
    const auto withNumbers = [](sim::Scene scene, std::initializer_list<const char *> ids) {
        sim::Values numbers = *scene.values;
        for (const char *id : ids)
            numbers.set(id, 0.5);
        scene.values = std::make_shared<const sim::Values>(numbers);
        return scene;
    };
    const sim::Scene creatureScene =
        withNumbers(threeCreatures(), {"leg", "drop", "damp", "push", "distance", "felt_by", "gravity",
                                       "ground", "bounce", "traction", "left", "right", "at_wall"});
    sim::Scene treeScene =
        withNumbers(swingingBush(), {"formula", "base_length", "ease", "wind", "turbulence"});
    treeScene.start.input.pointer = sim::Vec2{30, -20};
    treeScene.start.input.pointerDown = true;
    const sim::Scene stickScene =
        withNumbers(twoSticks(), {"iterations", "gravity", "damp", "friction", "left", "right", "floor"});
    std::mt19937 random(20);
    int built = 0, failed = 0;
    double slowest = 0.0;
    for (int i = 0; i < LISTING_MUTATIONS; ++i) {
        const std::string &original = listings[static_cast<std::size_t>(i) % listings.size()];
        const std::string text = mutated(original, random);
        const sim::Scene &scene = original == ofCreatures ? creatureScene
                                  : original == ofTree    ? treeScene
                                  : original == ofSticks  ? stickScene
                                                          : feetScene;
        const listing::Vocabulary vocabulary = listing::vocabularyOf(scene);
        const std::clock_t begin = std::clock();
        const listing::Compiled compiled = listing::Program::compile(text, vocabulary);
        QVERIFY(!compiled.program == !compiled.errors.empty());
        for (const listing::CompileError &error : compiled.errors) {
            QVERIFY(error.line >= 1 && error.column >= 1 && error.length >= 1);
            QVERIFY(!error.sentence.empty());
        }
        if (compiled.program) {
            ++built;
            const listing::Binding binding = listing::bind(vocabulary, scene);
            sim::State state = scene.start;
            for (state.frame = 1; state.frame <= 3; ++state.frame) {
                const sim::State before = state;
                if (compiled.program->run(state, binding)) {
                    ++failed;
                    QVERIFY(sim::sameBits(state, before));
                    break;
                }
                QVERIFY(state.position.isFinite().all() && state.velocity.isFinite().all());
                sim::State again = before; // the same frame has the same bits
                QVERIFY(!compiled.program->run(again, binding));
                QVERIFY(sim::sameBits(state, again));
            }
            QVERIFY(compiled.program->trace(scene.start, binding).lines.size() <= 10'000);
        }
        // None hangs. Processor time: others share the machine.
        slowest = std::max(slowest, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        QVERIFY2(slowest < 1.0, text.c_str());
    }
    qInfo("%d of %d compiled, %d stopped with an error, the slowest took %.0f ms", built, LISTING_MUTATIONS,
          failed, 1e3 * slowest);
    QVERIFY(built > LISTING_MUTATIONS / 20);
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
