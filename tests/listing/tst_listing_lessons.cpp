#include "app/listing/listing_method.h"
#include "app/listing/vocabulary.h"
#include "sim/methods/methods.h"
#include "sim/run/track.h"
#include "tests/lessons/support/support.h"
#include "tests/listing/listing_support.h"
#include "tests/suite.h"

#include <QTest>

#include <array>
#include <cstring>
#include <random>

using namespace support;
using listing_support::fileText;

namespace {

constexpr int frames = 300;
constexpr unsigned inputs = 10;
/// Lines of most listings, and of those that add up all steps before them.
constexpr int mostLines = 60, mostLinesOfAll = 100;
constexpr std::array lessonsWithListings = {"single_spring", "two_body", "multi_foot", "gravity_walls",
                                            "walking_gait"};

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

/// Returns random drags, throws and changes of parameters: input number `seed`.
std::vector<sim::Event> randomInput(const lessons::Step &step, const std::vector<std::string> &bodies,
                                    unsigned seed)
{
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
            if (parameter.isInteger)
                value = std::round(value);
            input.push_back({frame, sim::Set{parameter.id.toStdString(), value}});
        }
    }
    return input;
}

bool sameMotion(const sim::State &a, const sim::State &b)
{
    const auto same = [](const auto &x, const auto &y) {
        return x.rows() == y.rows() &&
               std::memcmp(x.data(), y.data(), static_cast<std::size_t>(x.size()) * sizeof(double)) == 0;
    };
    return same(a.position, b.position) && same(a.velocity, b.velocity) && same(a.gait, b.gait) &&
           same(a.gaitSpeed, b.gaitSpeed);
}

}

/// The listings of the lessons, compared with the compiled pipeline under `published`.
class ListingLessons : public QObject
{
    Q_OBJECT

private slots:
    void computesTheBitsOfPublished_data();
    void computesTheBitsOfPublished();
    void isShort_data() { addRows(false); }
    void isShort();

private:
    static void addRows(bool withInputs);
};

void ListingLessons::addRows(bool withInputs)
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("id");
    QTest::addColumn<unsigned>("input");
    for (const char *const id : lessonsWithListings) {
        const QString lesson = QString::fromLatin1(id);
        for (const lessons::Step &step : loadLesson(lesson).steps) {
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
    sim::Script published = scriptOf(step);
    const sim::Scene scene = sim::sceneOf(published, published.values);
    published.input = randomInput(step, scene.names, input);
    for (const sim::Event &event : randomSteering(input))
        published.input.push_back(event);
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

void ListingLessons::isShort()
{
    QFETCH(QString, lesson);
    QFETCH(QString, id);
    const std::string text = fileText(QStringLiteral("lessons/%1/%2.code").arg(lesson, id).toStdString());
    QStringList lines = QString::fromStdString(text).split('\n');
    QVERIFY(lines.takeLast().isEmpty());
    const bool addsUpAll = lesson == QLatin1String("walking_gait") &&
                           (id == QLatin1String("walls") || id == QLatin1String("company"));
    QVERIFY(lines.size() >= 5 && lines.size() <= (addsUpAll ? mostLinesOfAll : mostLines));
    for (const QString &line : lines)
        QVERIFY2(line.size() <= 96, qPrintable(line));
}

SUITE(tst_listing_lessons, ListingLessons)
#include "tst_listing_lessons.moc"
