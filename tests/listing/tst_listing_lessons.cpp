#include "app/listing/listing_method.h"
#include "app/listing/vocabulary.h"
#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/run/track.h"
#include "tests/lessons/support/support.h"
#include "tests/listing/listing_support.h"
#include "tests/sizes.h"
#include "tests/suite.h"

#include <QTest>

#include <array>
#include <cstring>
#include <random>

using namespace support;
using listing_support::fileText;

namespace {

constexpr int frames = 300;
constexpr unsigned inputs = tests::sized(10, 4);
/// Lines of most listings, and of those that add up all steps before them.
constexpr int mostLines = 60, mostLinesOfAll = 100;
/// Larger trees take longer than a listing may: see maxLinesPerFrame.
constexpr int mostBodies = 600;

/// Returns random movements of the pointer and its button, and of the arrow keys.
std::vector<sim::Event> randomSteering(unsigned seed)
{
    std::mt19937 random(seed);
    const auto number = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    constexpr std::array keys = {&sim::Keys::left, &sim::Keys::right, &sim::Keys::up, &sim::Keys::down};
    std::vector<sim::Event> input;
    for (std::int64_t frame = 20 + seed; frame < frames; ++frame) {
        const double chance = number(0, 1);
        if (chance < 0.05)
            input.push_back({frame, sim::Pointer{{number(0, 540), number(0, 400)}, chance < 0.02}});
        else if (chance < 0.15)
            input.push_back(
                {frame, sim::Key{keys[static_cast<std::size_t>(number(0, 4))], number(0, 1) < 0.5}});
    }
    return input;
}

/// Returns random targets, sometimes two in a frame, and random gusts.
std::vector<sim::Event> randomTargets(const lessons::Step &step, unsigned seed)
{
    std::mt19937 random(seed + 100);
    const auto number = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    std::vector<sim::Event> input;
    for (std::int64_t frame = 3; frame < frames; ++frame) {
        if (step.accepts(lessons::Interaction::target) && number(0, 1) < 0.04) {
            const int count = number(0, 1) < 0.2 ? 2 : 1;
            for (int i = 0; i < count; ++i)
                input.push_back({frame, sim::Target{{number(0, 540), number(0, 400)}}});
        }
        if (step.accepts(lessons::Interaction::gust) && number(0, 1) < 0.1)
            input.push_back({frame, sim::Gust{number(-90, 90)}});
    }
    return input;
}

/// Returns whether a scene with these values exists and is small enough.
bool isPossible(const sim::Script &script, const sim::Values &values)
{
    try {
        return sim::sceneOf(script, values).start.pointCount() <= mostBodies;
    } catch (const sim::Error &) { // a tree without an end
        return false;
    }
}

/// Returns random drags, throws and changes of parameters: input number `seed`.
std::vector<sim::Event> randomInput(const lessons::Step &step, const sim::Script &script, unsigned seed)
{
    const std::vector<std::string> bodies = sim::sceneOf(script, script.values).names;
    sim::Values values = script.values;
    std::mt19937 random(seed);
    const auto number = [&](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    const auto below = [&](std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
    };
    std::vector<sim::Event> input;
    bool holds = false;
    sim::Vec2 hand, velocity;
    for (std::int64_t frame = seed % 3; frame < frames; ++frame) {
        const double chance = number(0, 1);
        if (!holds && chance < 0.05) {
            input.push_back({frame, sim::Grab{bodies[below(bodies.size())]}});
            hand = {number(0, 540), number(0, 400)};
            velocity = {number(-15, 15), number(-15, 15)};
            holds = true;
        } else if (holds && chance < 0.06) {
            if (chance < 0.03) // the hand moves in the frame in which it lets go
                input.push_back({frame, sim::Move{hand + velocity}});
            input.push_back({frame, sim::Release{}});
            holds = false;
        } else if (holds && chance < 0.08) { // from hand to hand
            input.push_back({frame, sim::Grab{bodies[below(bodies.size())]}});
        } else if (holds && chance < 0.9) {
            hand = hand + velocity;
            input.push_back({frame, sim::Move{hand}});
        }
        if (chance > 0.985) {
            const lessons::Parameter &parameter = step.parameters[below(step.parameters.size())];
            double value = number(parameter.sliderMin, parameter.sliderMax);
            if (parameter.isInteger || !parameter.choices.isEmpty())
                value = std::round(value);
            sim::Values changed = values;
            changed.set(parameter.id.toStdString(), value);
            // A tree grows in the first frame of its listing. In a frame with a change, the pipeline turns branches by
            // the difference of two angles at rest, and the last bit of the sum can differ.
            if (frame < 2 || !isPossible(script, changed))
                continue;
            values = changed;
            input.push_back({frame, sim::Set{parameter.id.toStdString(), value}});
        }
    }
    return input;
}

/// Returns whether two states agree in all bits that count. A branch moves by its angle, so its velocity does not.
bool sameMotion(const sim::State &a, const sim::State &b)
{
    const auto same = [](const auto &x, const auto &y) {
        return x.rows() == y.rows() &&
               (x.size() == 0 ||
                std::memcmp(x.data(), y.data(), static_cast<std::size_t>(x.size()) * sizeof(double)) == 0);
    };
    return same(a.position, b.position) && (a.angle.rows() > 0 || same(a.velocity, b.velocity)) &&
           same(a.angle, b.angle) && same(a.spin, b.spin) && same(a.gait, b.gait) &&
           same(a.gaitSpeed, b.gaitSpeed) && a.gustExtent.front == b.gustExtent.front &&
           a.gustExtent.tail == b.gustExtent.tail;
}

}

/// The listings of the lessons, compared with the compiled pipeline under the method of their step.
class ListingLessons : public QObject
{
    Q_OBJECT

private slots:
    void computesTheBitsOfPublished_data();
    void computesTheBitsOfPublished();
    void listingIsShort_data() { addRows(false); }
    void listingIsShort();

private:
    static void addRows(bool withInputs);
};

void ListingLessons::addRows(bool withInputs)
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("id");
    QTest::addColumn<unsigned>("input");
    for (const QString &lesson : lessonIds()) {
        const std::vector<lessons::Step> steps = loadLesson(lesson).steps;
        const auto hasListing = [](const lessons::Step &step) { return !step.listing.isEmpty(); };
        if (std::none_of(steps.begin(), steps.end(), hasListing))
            continue; // otherwise each step has to have one
        for (const lessons::Step &step : steps) {
            for (unsigned input = 0; input < (withInputs ? inputs : 1); ++input)
                QTest::addRow("%s/%s, input %u", qPrintable(lesson), qPrintable(step.id), input)
                    << lesson << step.id << input;
        }
    }
}

void ListingLessons::computesTheBitsOfPublished_data()
{
    addRows(true);
}

void ListingLessons::computesTheBitsOfPublished()
{
    QFETCH(QString, lesson);
    QFETCH(QString, id);
    QFETCH(unsigned, input);
    const LoadedLesson loaded = loadLesson(lesson);
    const lessons::Step &step = loaded.step(id);
    sim::Script published = scriptOf(step, step.method.toStdString());
    const sim::Scene scene = sim::sceneOf(published, published.values);
    published.input = randomInput(step, published, input);
    for (const std::vector<sim::Event> &more : {randomSteering(input), randomTargets(step, input)})
        published.input.insert(published.input.end(), more.begin(), more.end());
    sim::sortByFrame(published.input);

    const std::string text = fileText(QStringLiteral("lessons/%1/%2.code").arg(lesson, id).toStdString());
    const listing::Compiled compiled = listing::Program::compile(text, listing::vocabularyOf(scene));
    QVERIFY2(compiled.program, compiled.errors.empty() ? "" : compiled.errors.front().sentence.c_str());
    sim::Script written = published;
    written.method = std::make_shared<listing::ListingMethod>(compiled.program);

    sim::Track pipeline(published, 1 << 20), program(written, 1 << 20);
    for (int frame = 1; frame <= frames; ++frame) {
        pipeline.seek({frame, 0});
        program.seek({frame, 0});
        QVERIFY2(program.cursor().frame == pipeline.cursor().frame,
                 qPrintable(QStringLiteral("frame %1").arg(frame)));
        if (pipeline.cursor().frame < frame)
            return; // both have ended here, because a number is not finite
        QVERIFY2(sameMotion(pipeline.state(), program.state()),
                 qPrintable(QStringLiteral("frame %1: %2 px")
                                .arg(frame)
                                .arg(largestDistance(pipeline.state(), program.state()))));
    }
}

void ListingLessons::listingIsShort()
{
    QFETCH(QString, lesson);
    QFETCH(QString, id);
    // As learners see it, without the markers of gaps.
    QStringList lines = loadLesson(lesson).step(id).listing.text.split('\n');
    QVERIFY(lines.takeLast().isEmpty());
    const QStringList addingUpAll = {"walking_gait/walls", "walking_gait/company", "rigid_constraint/ragdoll",
                                     "codeling/tentacles"};
    const bool addsUpAll = addingUpAll.contains(lesson + '/' + id);
    QVERIFY(lines.size() >= 5 && lines.size() <= (addsUpAll ? mostLinesOfAll : mostLines));
    for (const QString &line : lines)
        QVERIFY2(line.size() <= 96, qPrintable(line));
}

SUITE(tst_listing_lessons, ListingLessons)
#include "tst_listing_lessons.moc"
