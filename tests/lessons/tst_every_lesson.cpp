#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "sim/run/timeline.h"
#include "tests/lessons/support.h"
#include "tests/sizes.h"

#include "sim/base/error.h"
#include "sim/methods/methods.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>

using namespace support;

/// What holds for every step of every lesson, found by walking the plugins: a new lesson is tested here at once.
class EveryLesson : public QObject
{
    Q_OBJECT

    /// Whether `method` can compute `step` at all: those that need more than forces refuse some.
    static bool fits(const lessons::Step &step, const sim::Method &method)
    {
        const sim::Script script = scriptOf(step, method.id(), 1.0);
        try {
            sim::compose(sim::sceneOf(script, script.values), method, script.step);
            return true;
        } catch (const sim::Error &) {
            return false;
        }
    }

    static void addStepAndMethodRows()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("method");
        for (const QString &lesson : lessonIds()) {
            for (const lessons::Step &step : loadLesson(lesson).steps) {
                for (const sim::MethodPtr &method : sim::allMethods()) {
                    if (!fits(step, *method))
                        continue;
                    const QString name = QString::fromStdString(method->id());
                    QTest::addRow("%s/%s with %s", qPrintable(lesson), qPrintable(step.id), qPrintable(name))
                        << lesson << step.id << name;
                }
            }
        }
    }

    /// An implicit method solves for all of a crowd together, and one that chooses its steps takes some for each touch:
    /// that takes too long here.
    static bool takesLong(const lessons::Step &step, const sim::Method &method)
    {
        const std::vector<std::string> needs = method.requirements();
        const bool solves = std::find(needs.begin(), needs.end(), "slopes") != needs.end();
        const sim::Script script = scriptOf(step, "semi_implicit_euler", 1.0);
        return (solves || method.stepping() == sim::Stepping::adaptive) &&
               sim::sceneOf(script, script.values).start.pointCount() > 500;
    }

    /// Each step with the methods that it is taught with and one other, in turn, so that each has its share of steps.
    static void addStepAndSomeMethodRows()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("method");
        std::size_t turn = 0;
        for (const QString &lesson : lessonIds()) {
            for (const lessons::Step &step : loadLesson(lesson).steps) {
                std::vector<sim::MethodPtr> taught, others;
                for (const sim::MethodPtr &method : sim::allMethods()) {
                    const bool isTaught =
                        method->id() == "published" || method->id() == "semi_implicit_euler";
                    if (fits(step, *method) && !takesLong(step, *method))
                        (isTaught ? taught : others).push_back(method);
                }
                if (!others.empty())
                    taught.push_back(others[turn++ % others.size()]);
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

    /// What hand, pointer, target and keys can do, all in one run; each step takes what it lets in.
    static std::vector<sim::Event> busyInput(const sim::Scene &scene, const lessons::Step &step)
    {
        const std::string body = scene.names.back(), other = scene.names.front();
        const sim::Vec2 at = scene.start.positionOf(scene.find(body));
        std::vector<sim::Event> input = {{2, sim::Grab{other}},
                                         {2, sim::Move{{300, 300}}},
                                         {8, sim::Move{{250, 260}}},
                                         {9, sim::Move{{200, 240}}},
                                         {10, sim::Release{}},
                                         {14, sim::Grab{body}},
                                         {14, sim::Move{at}},
                                         {20, sim::Move{at + sim::Vec2{40, -30}}},
                                         {21, sim::Move{at + sim::Vec2{80, -40}}},
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

    /// Another value than the preset that a learner can choose.
    static double otherValue(const lessons::Parameter &parameter)
    {
        if (!parameter.choices.isEmpty())
            return parameter.defaultValue == 0.0 ? 1.0 : 0.0;
        return parameter.defaultValue == parameter.sliderMax ? parameter.sliderMin : parameter.sliderMax;
    }

    static bool sameLook(const lessons::View &a, const lessons::View &b)
    {
        const auto curves = [](const lessons::View &look) {
            std::vector<double> all{look.ground.value_or(0.0)};
            for (const lessons::LegView &leg : look.legs)
                all.push_back(leg.curve);
            for (const lessons::StickView &stick : look.sticks)
                all.push_back(stick.length);
            if (look.tree)
                all.insert(all.end(), look.tree->length.begin(), look.tree->length.end());
            if (look.room)
                all.insert(all.end(), {look.room->left, look.room->right, look.room->floor});
            return all;
        };
        return curves(a) == curves(b);
    }

    static bool differInTime(const sim::Script &one, const sim::Script &other, int frames)
    {
        sim::Timeline a(one), b(other);
        for (int frame = 0; frame < frames; ++frame) {
            if (!sim::sameBits(a.state(), b.state()))
                return true;
            a.nextOutputStep();
            b.nextOutputStep();
        }
        return false;
    }

    /// What the code shows of the first frame.
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

    /// Whether another value of `parameter` makes another run, another picture of it, or other numbers in the code.
    static bool differsBy(const lessons::Step &step, const lessons::Parameter &parameter)
    {
        sim::Script script = step.script(), other = script;
        other.values.set(parameter.id.toStdString(), otherValue(parameter));
        const sim::Scene scene = sim::sceneOf(script, script.values);
        const sim::Scene changed = sim::sceneOf(other, other.values);
        if (scene.names != changed.names ||
            !sameLook(step.view(scene, script.values), step.view(changed, other.values)))
            return true;
        if (differInTime(script, other, 600) || valuesInCode(script) != valuesInCode(other))
            return true;
        script.input = other.input = busyInput(scene, step);
        return differInTime(script, other, 200);
    }

    /// What a hand can take, or a dozen of them where there are many.
    static std::vector<std::string> someBodies(const lessons::Step &step)
    {
        const sim::Scene scene = step.scene(step.defaultValues());
        const lessons::View look = step.view(scene, step.defaultValues());
        std::vector<std::string> names;
        for (std::size_t i = 0; i < scene.names.size(); i += 1 + scene.names.size() / 12) {
            if (look.bodies[i].shape != lessons::BodyView::Shape::none)
                names.push_back(scene.names[i]);
        }
        return names;
    }

private slots:
    void thereAreLessons() { QVERIFY(lessonIds().size() >= 4); }

    void onlyMethodsThatNeedMoreRefuseAStep()
    {
        QSet<QString> refused;
        for (const QString &lesson : lessonIds()) {
            for (const lessons::Step &step : loadLesson(lesson).steps) {
                for (const sim::MethodPtr &method : sim::allMethods()) {
                    const std::vector<std::string> needs = method->requirements();
                    const bool any = needs.empty() || needs == std::vector<std::string>{"groups"};
                    QVERIFY2(!any || fits(step, *method),
                             (method->id() + " " + step.id.toStdString()).c_str());
                    if (!fits(step, *method))
                        refused << lesson;
                }
            }
        }
        // sticks that constraints hold, and trees that only turn as they are told
        QVERIFY(refused.contains(QStringLiteral("rigid_constraint")));
        QVERIFY(refused.contains(QStringLiteral("walking_gait"))); // where a hand steers
        for (const char *smooth : {"single_spring", "two_body", "multi_foot", "gravity_walls", "accuracy"})
            QVERIFY2(!refused.contains(QString::fromUtf8(smooth)), smooth);
    }

    void presetsLieWhereTheyMay_data() { addStepRows(); }
    void presetsLieWhereTheyMay()
    {
        QSet<QString> ids;
        for (const lessons::Parameter &parameter : stepOfRow().parameters) {
            QVERIFY2(!ids.contains(parameter.id), qPrintable(parameter.id));
            ids << parameter.id;
            QVERIFY2(!parameter.name.isEmpty() && !parameter.help.isEmpty(), qPrintable(parameter.id));
            QVERIFY(parameter.min <= parameter.sliderMin && parameter.sliderMax <= parameter.max);
            QVERIFY(parameter.sliderMin <= parameter.defaultValue &&
                    parameter.defaultValue <= parameter.sliderMax);
            QVERIFY(!parameter.hasWholeValues() ||
                    parameter.defaultValue == std::round(parameter.defaultValue));
        }
    }

    void theSceneIsDrawnWhole_data() { addStepRows(); }
    void theSceneIsDrawnWhole()
    {
        const lessons::Step step = stepOfRow();
        const sim::Scene scene = step.scene(step.defaultValues());
        const int points = scene.start.pointCount();
        QCOMPARE(static_cast<int>(scene.names.size()), points);
        const lessons::View look = step.view(scene, step.defaultValues());
        QCOMPARE(static_cast<int>(look.bodies.size()), points);
        for (const lessons::LegView &leg : look.legs)
            QVERIFY(leg.from >= 0 && leg.from < points && leg.to >= 0 && leg.to < points);
        for (const lessons::SpringView &spring : look.springs)
            QVERIFY(spring.a >= 0 && spring.a < points && spring.b >= -1 && spring.b < points);
        for (int i = 0; i < points; ++i)
            QVERIFY(look.stage.contains(scene.start.positionOf(i).x, scene.start.positionOf(i).y));
    }

    void aSpringIsDrawnToWhereItPulls_data() { addStepRows(); }
    void aSpringIsDrawnToWhereItPulls()
    {
        QFETCH(QString, lesson);
        if (lesson == QStringLiteral("sandbox"))
            return; // there each spring has a stiffness of its own
        const lessons::Step step = stepOfRow();
        const sim::Values values = step.defaultValues();
        const sim::Scene scene = step.scene(values);
        sim::State state = scene.start;
        for (int i = 0; i < state.pointCount(); ++i) // anywhere, so that nothing is at rest
            state.place(i, state.positionOf(i) + sim::Vec2{31.0 * (i % 3 - 1) + 7.0, 17.0 * (i % 5) - 40.0});
        Eigen::ArrayX2d pulls = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
        for (const sim::EffectPtr &effect : scene.effects) {
            const auto *force = dynamic_cast<const sim::Force *>(effect.get());
            if (force && effect->kind() == sim::EffectKind::spring)
                force->add(state, {0, state.pointCount()}, 1.0, sim::DirectionRule::published, pulls);
        }
        for (const lessons::SpringView &spring : step.view(scene, values).springs) {
            const sim::Vec2 end = spring.b < 0 ? spring.at : state.positionOf(spring.b) + spring.at;
            const sim::Vec2 way = end - state.positionOf(spring.a);
            const sim::Vec2 missing = (1.0 - spring.length / sim::length(way)) * way;
            const sim::Vec2 pull{pulls(spring.a, 0), pulls(spring.a, 1)};
            QVERIFY(sim::length(pull) > 0.0);
            QVERIFY(sim::length(pull - values["k"] * missing) < 1e-9 * sim::length(pull));
        }
    }

    void guidesAreFiniteWhereverThePointsAre_data() { addStepRows(); }
    void guidesAreFiniteWhereverThePointsAre()
    {
        const lessons::Step step = stepOfRow();
        if (!step.overlays)
            return;
        const sim::Values values = step.defaultValues();
        const sim::Scene scene = step.scene(values);
        sim::State state = scene.start;
        const auto finite = [&] {
            for (const lessons::Overlay &guide : step.overlays(scene, state, values)) {
                if (!std::isfinite(guide.a.x + guide.a.y + guide.b.x + guide.b.y + guide.size))
                    return false;
            }
            return true;
        };
        QVERIFY(finite());
        state.position.setConstant(100.0); // all in one place
        QVERIFY(finite());
    }

    void anIdleRunDoesNoneOfTheTries_data() { addStepRows(); }
    void anIdleRunDoesNoneOfTheTries()
    {
        const lessons::Step step = stepOfRow();
        sim::Timeline run(step.script());
        for (int frame = 0; frame <= 600; ++frame) {
            for (const lessons::Try &one : step.tries) {
                QVERIFY2(!one.isDone(run), qPrintable(u"frame %1: %2"_qs.arg(frame).arg(one.text)));
                QVERIFY2(!one.conditions.hasBegun(run),
                         qPrintable(one.text)); // and nothing is said to be missing
            }
            run.nextOutputStep();
        }
    }

    void aMereClickOnABodyDoesNoneOfTheTries_data() { addStepRows(); }
    void aMereClickOnABodyDoesNoneOfTheTries()
    {
        const lessons::Step step = stepOfRow();
        for (const std::string &body : someBodies(step)) {
            sim::Timeline run(step.script());
            run.seek({50, 0});
            const sim::Vec2 at = run.state().positionOf(run.track().interval().scene.find(body));
            run.applyInput(sim::Grab{body});
            run.applyInput(sim::Move{at});
            run.nextOutputStep();
            run.applyInput(sim::Release{});
            for (int frame = 0; frame < 300; ++frame) {
                for (const lessons::Try &one : step.tries)
                    QVERIFY2(!one.isDone(run), qPrintable(one.text));
                run.nextOutputStep();
            }
        }
    }

    void everyParameterThatIsOfferedActs_data() { addStepRows(); }
    void everyParameterThatIsOfferedActs()
    {
        const lessons::Step step = stepOfRow();
        const sim::Script script = step.script();
        const sim::Scene scene = sim::sceneOf(script, script.values);
        for (const lessons::Parameter &parameter : step.parameters) {
            const bool isOffered =
                parameter.effects.isEmpty() ||
                std::any_of(scene.effects.begin(), scene.effects.end(), [&](const sim::EffectPtr &one) {
                    return parameter.effects.contains(QString::fromStdString(one->id()));
                });
            if (isOffered)
                QVERIFY2(differsBy(step, parameter), qPrintable(parameter.id));
        }
    }

    void everyConditionButTheFirstSaysWhatIsMissing_data() { addStepRows(); }
    void everyConditionButTheFirstSaysWhatIsMissing()
    {
        for (const lessons::Try &one : stepOfRow().tries) {
            const std::vector<lessons::Condition> &all = one.conditions.all();
            QVERIFY2(!all.empty(), qPrintable(one.text));
            for (std::size_t i = 1; i < all.size(); ++i) {
                QVERIFY2(all[i].todo.endsWith('.'), qPrintable(one.text));
                QVERIFY2(all[i].todo.front().isLower(), qPrintable(all[i].todo));
                QCOMPARE(all[i].todo.contains("%1"), all[i].measured != nullptr);
            }
        }
    }

    void whatStopsAtAMomentAndWhatAsksSomethingSaySo_data() { addStepRows(); }
    void whatStopsAtAMomentAndWhatAsksSomethingSaySo()
    {
        for (const lessons::Try &one : stepOfRow().tries) {
            const bool asks = one.text.contains('?');
            QVERIFY2(asks == !one.answer.isEmpty(), qPrintable(one.text));
            const bool stops = one.text.contains("and stop ") && !one.text.contains("stop inside a frame");
            QVERIFY2(one.onlyWhilePaused == stops, qPrintable(one.text));
        }
    }

    void anySeekGivesTheBitsOfAStraightRun_data() { addStepAndSomeMethodRows(); }
    void anySeekGivesTheBitsOfAStraightRun()
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
            const double other = parameter.hasWholeValues() ? std::ceil(half) : half;
            if (parameter.choices.isEmpty())
                script.input.push_back({30, sim::Set{parameter.id.toStdString(), other}});
        }
        sim::sortByFrame(script.input);
        sim::Timeline straight(script);
        std::map<sim::Cursor, sim::State> states = {{straight.cursor(), straight.state()}};
        for (bool goesOn = true; goesOn && straight.cursor().frame < frames;) { // some runs end before
            const sim::Cursor before = straight.cursor();
            straight.nextPhase();
            states[straight.cursor()] = straight.state();
            goesOn = straight.cursor() != before;
        }
        sim::Timeline seeker(script, 40'000); // so small that most states are dropped
        std::mt19937 random(7);
        for (int i = 0; i < tests::sized(500, 100); ++i) {
            const auto chosen = std::uniform_int_distribution<std::size_t>(0, states.size() - 1)(random);
            const auto &[cursor, state] = *std::next(states.begin(), static_cast<std::ptrdiff_t>(chosen));
            seeker.seek(cursor);
            QVERIFY(seeker.cursor() == cursor);
            QVERIFY(sim::sameBits(seeker.state(), state));
        }
    }

    void everyPhaseHasSourceToShow_data() { addStepAndMethodRows(); }
    void everyPhaseHasSourceToShow()
    {
        const sim::Script script = scriptOfRow(1.0);
        std::vector<sim::Region> regions = {stepOfRow().sceneSource, script.method->region()};
        const sim::Scene scene = sim::sceneOf(script, script.values);
        for (const sim::Phase &phase : sim::compose(scene, *script.method, script.step).phases) {
            QVERIFY2(!phase.regions.empty() && !phase.title.empty(), phase.id.c_str());
            regions.insert(regions.end(), phase.regions.begin(), phase.regions.end());
        }
        for (const sim::Region &region : regions) {
            const std::optional<QString> text = regionText(region);
            QVERIFY2(text && !text->trimmed().isEmpty(), (region.file + " " + region.marker).c_str());
        }
    }

    void everyLiveValueIsNamedInThatSource_data() { addStepAndSomeMethodRows(); }
    void everyLiveValueIsNamedInThatSource()
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

QTEST_GUILESS_MAIN(EveryLesson)
#include "tst_every_lesson.moc"
