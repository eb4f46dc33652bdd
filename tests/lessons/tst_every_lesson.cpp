#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "sim/run/timeline.h"
#include "tests/lessons/support/support.h"
#include "tests/sizes.h"

#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>

using namespace support;

/// Tests that run for every step of every lesson plugin in the build. New lessons are included automatically.
class EveryLesson : public QObject
{
    Q_OBJECT

    /// Returns whether a run takes too long for these tests. In a large crowd, an implicit method solves for
    /// all points at once, and an adaptive method takes extra steps for each contact.
    static bool isTooSlow(const lessons::Step &step, const sim::Method &method)
    {
        const std::vector<std::string> needs = method.requirements();
        const bool isImplicit = std::find(needs.begin(), needs.end(), "jacobian") != needs.end();
        const sim::Script script = scriptOf(step, "semi_implicit_euler", 1.0);
        return (isImplicit || method.stepping() == sim::Stepping::adaptive) &&
               sim::sceneOf(script, script.values).start.pointCount() > 500;
    }

    /// Adds each step with the methods of the lessons and one other method. The other methods take turns.
    static void addStepAndSelectedMethodRows()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("method");
        std::size_t nextOther = 0;
        for (const QString &lesson : lessonIds()) {
            for (const lessons::Step &step : loadLesson(lesson).steps) {
                std::vector<sim::MethodPtr> taught, others;
                for (const sim::MethodPtr &method : sim::allMethods()) {
                    const bool isTaught =
                        method->id() == "published" || method->id() == "semi_implicit_euler";
                    if (fits(step, *method) && !isTooSlow(step, *method))
                        (isTaught ? taught : others).push_back(method);
                }
                if (!others.empty())
                    taught.push_back(others[nextOther++ % others.size()]);
                for (const sim::MethodPtr &method : taught)
                    QTest::addRow("%s/%s with %s", qPrintable(lesson), qPrintable(step.id),
                                  method->id().c_str())
                        << lesson << step.id << QString::fromStdString(method->id());
            }
        }
    }

    static sim::Script scriptOfRow(double h)
    {
        QFETCH(QString, method);
        return scriptOf(stepOfRow(), method.toStdString(), h);
    }

    /// Returns input that drags bodies and uses pointer, target and keys, as far as `step` accepts them.
    static std::vector<sim::Event> inputOfEveryKind(const sim::Scene &scene, const lessons::Step &step)
    {
        const std::string body = scene.names.back(), other = scene.names.front();
        const sim::Vec2 position = scene.start.positionOf(scene.find(body));
        std::vector<sim::Event> input = {{2, sim::Grab{other}},
                                         {2, sim::Move{{300, 300}}},
                                         {8, sim::Move{{250, 260}}},
                                         {9, sim::Move{{200, 240}}},
                                         {10, sim::Release{}},
                                         {14, sim::Grab{body}},
                                         {14, sim::Move{position}},
                                         {20, sim::Move{position + sim::Vec2{40, -30}}},
                                         {21, sim::Move{position + sim::Vec2{80, -40}}},
                                         {22, sim::Release{}}};
        if (step.accepts(lessons::Interaction::pointer)) {
            input.push_back({30, sim::Pointer{{200, 200}, true}});
            input.push_back({60, sim::Pointer{{320, 120}, false}});
        }
        if (step.accepts(lessons::Interaction::target))
            input.push_back({30, sim::Target{{400, 120}}});
        if (step.accepts(lessons::Interaction::keys))
            input.push_back({70, sim::Key{&sim::Keys::right, true}});
        return input;
    }

    /// Returns a value that differs from the default and that a learner can choose.
    static double otherValue(const lessons::Parameter &parameter)
    {
        if (!parameter.choices.isEmpty())
            return parameter.defaultValue == 0.0 ? 1.0 : 0.0;
        return parameter.defaultValue == parameter.sliderMax ? parameter.sliderMin : parameter.sliderMax;
    }

    static bool haveSameView(const lessons::View &a, const lessons::View &b)
    {
        const auto curves = [](const lessons::View &view) {
            std::vector<double> all{view.ground.value_or(0.0)};
            for (const lessons::LegView &leg : view.legs)
                all.push_back(leg.curve);
            for (const lessons::StickView &stick : view.sticks)
                all.push_back(stick.length);
            if (view.tree)
                all.insert(all.end(), view.tree->length.begin(), view.tree->length.end());
            if (view.room)
                all.insert(all.end(), {view.room->left, view.room->right, view.room->floor});
            return all;
        };
        return curves(a) == curves(b);
    }

    static bool runsDiffer(const sim::Script &first, const sim::Script &second, int frames)
    {
        sim::Timeline a(first), b(second);
        for (int frame = 0; frame < frames; ++frame) {
            if (!sim::sameBits(a.state(), b.state()))
                return true;
            a.nextOutputStep();
            b.nextOutputStep();
        }
        return false;
    }

    /// Returns the live values that the code panel shows for the first frame.
    static std::vector<std::variant<double, sim::Vec2>> valuesInCode(const sim::Script &script)
    {
        const sim::Scene scene = sim::sceneOf(script, script.values);
        sim::State state = scene.start;
        std::vector<std::variant<double, sim::Vec2>> all;
        for (const sim::Phase &phase : sim::compose(scene, *script.method, script.step).phases) {
            const sim::State before = state;
            phase.run(state);
            for (const sim::LiveValue &live : phase.explain(before, state, phase.points.first))
                all.push_back(live.value);
        }
        return all;
    }

    /// Returns whether another value of `parameter` changes the run, the view or the live values.
    static bool hasEffect(const lessons::Step &step, const lessons::Parameter &parameter)
    {
        sim::Script script = step.script(), other = script;
        other.values.set(parameter.id.toStdString(), otherValue(parameter));
        const sim::Scene scene = sim::sceneOf(script, script.values);
        const sim::Scene changed = sim::sceneOf(other, other.values);
        if (scene.names != changed.names ||
            !haveSameView(step.view(scene, script.values), step.view(changed, other.values)))
            return true;
        if (runsDiffer(script, other, 600) || valuesInCode(script) != valuesInCode(other))
            return true;
        script.input = other.input = inputOfEveryKind(scene, step);
        return runsDiffer(script, other, 200);
    }

    /// Returns the bodies that can be grabbed, or about a dozen of them.
    static std::vector<std::string> someBodies(const lessons::Step &step)
    {
        const sim::Scene scene = step.scene(step.defaultValues());
        const lessons::View view = step.view(scene, step.defaultValues());
        std::vector<std::string> names;
        for (std::size_t i = 0; i < scene.names.size(); i += 1 + scene.names.size() / 12) {
            if (view.bodies[i].shape != lessons::BodyView::Shape::none)
                names.push_back(scene.names[i]);
        }
        return names;
    }

private slots:
    void thereAreLessons()
    {
        QStringList folders;
        for (const QString &name : QDir(SOURCE_DIR "/lessons").entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            if (QFile::exists(QStringLiteral(SOURCE_DIR "/lessons/%1/lesson.json").arg(name)))
                folders << name;
        }
        QStringList loaded = lessonIds();
        loaded.sort();
        QCOMPARE(loaded, folders);
    }

    void onlyMethodsWithRequirementsRejectSteps()
    {
        QSet<QString> rejected;
        for (const QString &lesson : lessonIds()) {
            for (const lessons::Step &step : loadLesson(lesson).steps) {
                for (const sim::MethodPtr &method : sim::allMethods()) {
                    const std::vector<std::string> needs = method->requirements();
                    const bool acceptsEveryStep =
                        needs.empty() || needs == std::vector<std::string>{"groups"};
                    QVERIFY2(!acceptsEveryStep || fits(step, *method),
                             (method->id() + " " + step.id.toStdString()).c_str());
                    if (!fits(step, *method))
                        rejected << lesson;
                }
            }
        }
        // Some methods support neither stick constraints nor steering.
        QVERIFY(rejected.contains(QStringLiteral("rigid_constraint")));
        QVERIFY(rejected.contains(QStringLiteral("walking_gait")));
        for (const char *lesson : {"single_spring", "two_body", "multi_foot", "gravity_walls", "accuracy"})
            QVERIFY2(!rejected.contains(QString::fromUtf8(lesson)), lesson);
    }

    void defaultValuesAreInRange_data() { addStepRows(); }
    void defaultValuesAreInRange()
    {
        QSet<QString> ids;
        for (const lessons::Parameter &parameter : stepOfRow().parameters) {
            QVERIFY2(!ids.contains(parameter.id), qPrintable(parameter.id));
            ids << parameter.id;
            QVERIFY2(!parameter.name.isEmpty() && !parameter.help.isEmpty(), qPrintable(parameter.id));
            QVERIFY(parameter.min <= parameter.sliderMin && parameter.sliderMax <= parameter.max);
            QVERIFY(parameter.sliderMin <= parameter.defaultValue &&
                    parameter.defaultValue <= parameter.sliderMax);
            QVERIFY(!parameter.isInteger || parameter.defaultValue == std::round(parameter.defaultValue));
        }
    }

    void viewCoversTheScene_data() { addStepRows(); }
    void viewCoversTheScene()
    {
        const lessons::Step step = stepOfRow();
        const sim::Scene scene = step.scene(step.defaultValues());
        const int points = scene.start.pointCount();
        QCOMPARE(static_cast<int>(scene.names.size()), points);
        const lessons::View view = step.view(scene, step.defaultValues());
        QCOMPARE(static_cast<int>(view.bodies.size()), points);
        for (const lessons::LegView &leg : view.legs)
            QVERIFY(leg.from >= 0 && leg.from < points && leg.to >= 0 && leg.to < points);
        for (const lessons::SpringView &spring : view.springs)
            QVERIFY(spring.a >= 0 && spring.a < points && spring.b >= -1 && spring.b < points);
        for (int i = 0; i < points; ++i)
            QVERIFY(view.stage.contains(scene.start.positionOf(i).x, scene.start.positionOf(i).y));
    }

    void springsAreDrawnWhereTheyPull_data() { addStepRows(); }
    void springsAreDrawnWhereTheyPull()
    {
        QFETCH(QString, lesson);
        if (lesson == QStringLiteral("sandbox"))
            return; // its springs have different stiffnesses
        const lessons::Step step = stepOfRow();
        const sim::Values values = step.defaultValues();
        const sim::Scene scene = step.scene(values);
        sim::State state = scene.start;
        for (int i = 0; i < state.pointCount(); ++i) // displaced, so that no spring is at rest
            state.place(i, state.positionOf(i) + sim::Vec2{31.0 * (i % 3 - 1) + 7.0, 17.0 * (i % 5) - 40.0});
        Eigen::ArrayX2d forces = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
        for (const sim::EffectPtr &effect : scene.effects) {
            const auto *springForce = dynamic_cast<const sim::Force *>(effect.get());
            if (springForce && effect->kind() == sim::EffectKind::spring)
                springForce->add(state, {0, state.pointCount()}, 1.0, sim::DirectionRule::published, forces);
        }
        for (const lessons::SpringView &spring : step.view(scene, values).springs) {
            const sim::Vec2 end = spring.b < 0 ? spring.at : state.positionOf(spring.b) + spring.at;
            const sim::Vec2 toEnd = end - state.positionOf(spring.a);
            const sim::Vec2 extension = (1.0 - spring.length / sim::length(toEnd)) * toEnd;
            const sim::Vec2 force{forces(spring.a, 0), forces(spring.a, 1)};
            QVERIFY(sim::length(force) > 0.0);
            QVERIFY(sim::length(force - values["k"] * extension) < 1e-9 * sim::length(force));
        }
    }

    void overlaysAreAlwaysFinite_data() { addStepRows(); }
    void overlaysAreAlwaysFinite()
    {
        const lessons::Step step = stepOfRow();
        if (!step.overlays)
            return;
        const sim::Values values = step.defaultValues();
        const sim::Scene scene = step.scene(values);
        sim::State state = scene.start;
        const auto finite = [&] {
            for (const lessons::Overlay &overlay : step.overlays(scene, state, values)) {
                if (!std::isfinite(overlay.a.x + overlay.a.y + overlay.b.x + overlay.b.y + overlay.size))
                    return false;
            }
            return true;
        };
        QVERIFY(finite());
        state.position.setConstant(100.0); // all points coincide
        QVERIFY(finite());
    }

    void runWithoutInputCompletesNoThingToTry_data() { addStepRows(); }
    void runWithoutInputCompletesNoThingToTry()
    {
        const lessons::Step step = stepOfRow();
        sim::Timeline run(step.script());
        for (int frame = 0; frame <= 600; ++frame) {
            for (const lessons::Try &item : step.tries) {
                QVERIFY2(!item.isDone(run), qPrintable(u"frame %1: %2"_qs.arg(frame).arg(item.text)));
                QVERIFY2(!item.conditions.hasBegun(run), qPrintable(item.text)); // so no hint is shown
            }
            run.nextOutputStep();
        }
    }

    void clickOnABodyCompletesNoThingToTry_data() { addStepRows(); }
    void clickOnABodyCompletesNoThingToTry()
    {
        const lessons::Step step = stepOfRow();
        for (const std::string &body : someBodies(step)) {
            sim::Timeline run(step.script());
            run.seek({50, 0});
            const sim::Vec2 position = run.state().positionOf(run.track().interval().scene.find(body));
            run.applyInput(sim::Grab{body});
            run.applyInput(sim::Move{position});
            run.nextOutputStep();
            run.applyInput(sim::Release{});
            for (int frame = 0; frame < 300; ++frame) {
                for (const lessons::Try &item : step.tries)
                    QVERIFY2(!item.isDone(run), qPrintable(item.text));
                run.nextOutputStep();
            }
        }
    }

    void offeredParametersHaveAnEffect_data() { addStepRows(); }
    void offeredParametersHaveAnEffect()
    {
        const lessons::Step step = stepOfRow();
        const sim::Script script = step.script();
        const sim::Scene scene = sim::sceneOf(script, script.values);
        for (const lessons::Parameter &parameter : step.parameters) {
            const bool isOffered =
                parameter.effects.isEmpty() ||
                std::any_of(scene.effects.begin(), scene.effects.end(), [&](const sim::EffectPtr &effect) {
                    return parameter.effects.contains(QString::fromStdString(effect->id()));
                });
            if (isOffered)
                QVERIFY2(hasEffect(step, parameter), qPrintable(parameter.id));
        }
    }

    void conditionsAfterTheFirstHaveHints_data() { addStepRows(); }
    void conditionsAfterTheFirstHaveHints()
    {
        for (const lessons::Try &item : stepOfRow().tries) {
            const std::vector<lessons::Condition> &all = item.conditions.all();
            QVERIFY2(!all.empty(), qPrintable(item.text));
            for (std::size_t i = 1; i < all.size(); ++i) {
                QVERIFY2(all[i].todo.endsWith('.'), qPrintable(item.text));
                QVERIFY2(all[i].todo.front().isLower(), qPrintable(all[i].todo));
                QCOMPARE(all[i].todo.contains("%1"), all[i].measured != nullptr);
            }
        }
    }

    void textsMatchAnswersAndPauses_data() { addStepRows(); }
    void textsMatchAnswersAndPauses()
    {
        for (const lessons::Try &item : stepOfRow().tries) {
            const bool asks = item.text.contains('?');
            QVERIFY2(asks == !item.answer.isEmpty(), qPrintable(item.text));
            const bool stops = item.text.contains("and stop ") && !item.text.contains("stop inside a frame");
            QVERIFY2(item.onlyWhilePaused == stops, qPrintable(item.text));
        }
    }

    void seekingReproducesSequentialStates_data() { addStepAndSelectedMethodRows(); }
    void seekingReproducesSequentialStates()
    {
        constexpr int frames = 90;
        sim::Script script = scriptOfRow(0.5);
        const std::string body = script.build(script.values).names.front();
        script.input = {{5, sim::Pointer{{90, 210}, true}},
                        {10, sim::Grab{body}},
                        {10, sim::Move{{100, 90}}},
                        {12, sim::Move{{140, 110}}},
                        {13, sim::Release{}},
                        {20, sim::Target{{300, 120}}},
                        {25, sim::Gust{7.0}},
                        {26, sim::Key{&sim::Keys::right, true}},
                        {40, sim::Pointer{{300, 100}, false}},
                        {50, sim::Grab{body}},
                        {52, sim::Move{{9, 9}}}};
        for (const lessons::Parameter &parameter : stepOfRow().parameters) {
            const bool isHuge = parameter.scale == lessons::Scale::logarithmic;
            const double half = 0.5 * (parameter.defaultValue + (isHuge ? 0.0 : parameter.sliderMax));
            const double other = parameter.isInteger ? std::ceil(half) : half;
            if (parameter.choices.isEmpty())
                script.input.push_back({30, sim::Set{parameter.id.toStdString(), other}});
        }
        sim::sortByFrame(script.input);
        sim::Timeline reference(script);
        std::map<sim::Cursor, sim::State> states = {{reference.cursor(), reference.state()}};
        // Some runs stop before the last frame.
        for (bool isRunning = true; isRunning && reference.cursor().frame < frames;) {
            const sim::Cursor before = reference.cursor();
            reference.nextPhase();
            states[reference.cursor()] = reference.state();
            isRunning = reference.cursor() != before;
        }
        sim::Timeline seeker(script, 40'000); // so small that most keyframes are dropped
        std::mt19937 random(7);
        for (int i = 0; i < tests::sized(500, 40); ++i) {
            const auto chosen = std::uniform_int_distribution<std::size_t>(0, states.size() - 1)(random);
            const auto &[cursor, state] = *std::next(states.begin(), static_cast<std::ptrdiff_t>(chosen));
            seeker.seek(cursor);
            QVERIFY(seeker.cursor() == cursor);
            QVERIFY(sim::sameBits(seeker.state(), state));
        }
    }

    void phasesHaveSource_data() { addStepAndMethodRows(fits); }
    void phasesHaveSource()
    {
        const sim::Script script = scriptOfRow(1.0);
        std::vector<sim::Region> regions = {stepOfRow().sceneSource, script.method->region()};
        const sim::Scene scene = sim::sceneOf(script, script.values);
        for (const sim::Phase &phase : sim::compose(scene, *script.method, script.step).phases) {
            QVERIFY2(!phase.regions.empty() && !phase.title.empty(), phase.id.c_str());
            regions.insert(regions.end(), phase.regions.begin(), phase.regions.end());
        }
        static std::set<sim::Region> found; // also by earlier rows
        for (const sim::Region &region : regions) {
            if (!found.insert(region).second)
                continue;
            const std::optional<QString> text = regionText(region);
            QVERIFY2(text && !text->trimmed().isEmpty(), (region.file + " " + region.marker).c_str());
        }
    }

    void liveValuesAreNamedInTheSource_data() { addStepAndSelectedMethodRows(); }
    void liveValuesAreNamedInTheSource()
    {
        const sim::Script script = scriptOfRow(1.0);
        const sim::Scene scene = sim::sceneOf(script, script.values);
        const sim::Pipeline pipeline = sim::compose(scene, *script.method, script.step);
        sim::State state = scene.start;
        std::vector<std::set<std::string>> named(pipeline.phases.size());
        for (int frame = 0; frame < 40; ++frame) {
            for (std::size_t i = 0; i < named.size(); ++i) {
                const sim::Phase &phase = pipeline.phases[i];
                const sim::State before = state;
                phase.run(state);
                const int stride = 1 + phase.points.count / 12;
                for (int point = phase.points.first; point < phase.points.end(); point += stride) {
                    for (const sim::LiveValue &live : phase.explain(before, state, point))
                        named[i].insert(live.name);
                }
            }
        }
        for (std::size_t i = 0; i < named.size(); ++i)
            checkNames(pipeline.phases[i], named[i]);
    }

private:
    static void checkNames(const sim::Phase &phase, const std::set<std::string> &names)
    {
        QString source;
        for (const sim::Region &region : phase.regions)
            source += regionText(region).value_or(QString());
        for (const std::string &name : names) {
            const QRegularExpression word(u"\\b%1\\b"_qs.arg(QString::fromStdString(name)));
            QVERIFY2(source.contains(word), (phase.id + ": " + name).c_str());
        }
    }
};

SUITE(tst_every_lesson, EveryLesson)
#include "tst_every_lesson.moc"
