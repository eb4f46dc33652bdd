// An effect that only this suite knows, in the sandbox: it has a setting of the scene and one of points, and nothing but
// its description names them.

#include "app/model/analysis/effect_lines.h"
#include "app/model/experiment/experiment.h"
#include "app/model/sandbox/sandbox.h"
#include "app/model/sandbox/sandbox_editor.h"
#include "app/model/sandbox/sandbox_properties.h"
#include "app/model/session/offered_parameters.h"
#include "lessons/api/blueprint_of.h"
#include "lessons/api/parameters.h"
#include "sim/scene/blueprint_draft.h"
#include "tests/suite.h"

#include <QTest>

using namespace app;

namespace described {

extern const sim::EffectDescription sail;

}

namespace {

/// A steady push to the right on points that carry a sail, by its area.
class Sail : public sim::DescribedEffect<sim::Force, described::sail>
{
public:
    Sail(double strength, Eigen::ArrayXd area) : m_strength(strength), m_area(std::move(area)) {}

    std::vector<sim::Region> regions(sim::DirectionRule) const override { return {}; }
    int count(const sim::State &, sim::PointRange points) const override { return points.count; }
    void add(const sim::State &state, sim::PointRange movers, double scale, sim::DirectionRule,
             Eigen::ArrayX2d &into) const override
    {
        for (int i = movers.first; i < movers.end(); ++i)
            into(i, 0) += scale * state.inverseMass[i] * m_strength * m_area[i];
    }
    std::vector<sim::LiveValue> explain(const sim::State &, int, sim::DirectionRule) const override
    {
        return {};
    }
    bool addToDraft(sim::BlueprintDraft &draft) const override;

private:
    double m_strength;
    Eigen::ArrayXd m_area;
};

constexpr sim::ParameterSpec sailSettings[] = {
    {"strength", "Strength", "s", "px/frame²", "How hard it blows.", 0.1, 0.0, 10.0, 0.0, 1.0}};
constexpr sim::ParameterSpec sailOfPoints[] = {
    {"area", "Area", "", "px²", "How large its sail is.", 0.0, -4.0, 4.0, -4.0, 4.0, 1}};

sim::EffectPtr buildSail(const sim::Blueprint &plan, const sim::Values &values)
{
    return std::make_shared<Sail>(values["strength"], sim::valuesOf(plan, sailOfPoints[0]));
}

bool Sail::addToDraft(sim::BlueprintDraft &draft) const
{
    draft.addEffect("sail", {{"strength", m_strength}});
    for (int i = 0; i < draft.state.pointCount(); ++i)
        sim::setValue(draft.blueprint.points[std::size_t(i)], sailOfPoints[0], m_area[i]);
    return true;
}

}

namespace described {

constinit const sim::EffectDescription sail = {.id = "sail",
                                               .title = "sail",
                                               .kind = sim::EffectKind::wind,
                                               .purpose = "Pushes what carries a sail.",
                                               .parameters = sailSettings,
                                               .pointProperties = sailOfPoints,
                                               .make = buildSail};

}

namespace {

/// The sandbox with this effect added.
LessonLibrary libraryWithSail()
{
    static constexpr const sim::EffectDescription *more[] = {&described::sail};
    LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    lessons::Step &step = library.sandboxes.front().steps.front();
    step.addParameters(lessons::parametersOf(more));
    step.availableEffects.push_back(more[0]);
    step.scene = [old = step.scene](const sim::Values &values) {
        sim::Scene scene = old(values);
        if (values.blueprint) {
            for (const sim::EffectPtr &one : sim::chosenEffects(more, *values.blueprint, values).beforeMove)
                scene.effects.push_back(one);
        }
        return scene;
    };
    return library;
}

const LessonLibrary &sailLibrary()
{
    static const LessonLibrary known = libraryWithSail();
    return known;
}

struct SailWorld
{
    SailWorld()
    {
        session.openStep("sandbox", "build");
        editor.change("Set up", [](sim::Blueprint &plan) {
            plan = {};
            plan.points = {{"a", {0, 0}, {}, 2.0}, {"b", {0, 50}, {}}, {"c", {0, 100}, {}}};
        });
    }
    const sim::Blueprint &plan() const { return editor.plan(); }
    const sim::ParameterSpec &area() const { return sailOfPoints[0]; }
    /// The area of the chosen points, as a property; none where they have no such property.
    std::optional<SandboxProperty> property() const
    {
        for (const SandboxProperty &one :
             propertiesOf(plan(), editor.chosen(), session.step().availableEffects)) {
            if (one.about.id == "area")
                return one;
        }
        return {};
    }
    void setArea(const Selection &chosen, double value)
    {
        editor.choose(chosen);
        const SandboxProperty one = *property();
        editor.change("Change area", [&](sim::Blueprint &plan) { one.set(plan, chosen, value); });
    }
    bool offersStrength() const
    {
        const std::vector<const lessons::Parameter *> all =
            offeredParameters(session.run(), session.editor());
        return std::any_of(all.begin(), all.end(), [](const auto *one) { return one->id == "strength"; });
    }
    QByteArray text() const { return experimentText(session.experiment(), sailLibrary()); }

    Session session{sailLibrary()};
    SandboxEditor editor{session};
};

/// A file of a scene with a point that has this, from line 5 on.
QByteArray fileWith(const QByteArray &property)
{
    return "{\n\"format\": \"springstep-experiment/1\",\n\"lesson\": \"sandbox\",\n\"step\": \"build\",\n"
           "\"scene\": { \"bodies\": { \"a\": { \"x\": 1, \"y\": 2, " +
           property + " } } }\n}\n";
}

QString errorOf(const QByteArray &text, const LessonLibrary &known)
{
    try {
        parseExperiment(text, "x.json", known);
        return {};
    } catch (const UserError &error) {
        return error.sentence();
    }
}

}

class DescribedEffect : public QObject
{
    Q_OBJECT

private slots:
    void itsSettingsAreOfferedWhileItIsInTheScene()
    {
        SailWorld world;
        world.editor.choose({{0}, {}, {}});
        QVERIFY(!world.property() && !world.offersStrength());
        world.editor.setEffect("sail", true);
        QVERIFY(world.property() && world.offersStrength());
        QCOMPARE(world.property()->about.name, QString("Area"));
        QCOMPARE(world.property()->about.unit, QString("px²"));
        QCOMPARE(world.property()->about.min, -4.0);
        QCOMPARE(world.property()->get(world.plan(), world.editor.chosen()), std::optional(0.0));
        world.editor.setEffect("sail", false);
        QVERIFY(!world.property() && !world.offersStrength());
    }

    void aPropertyOfPointsIsSetOfAllThatIsChosenAndUndone()
    {
        SailWorld world;
        world.editor.setEffect("sail", true);
        const sim::Blueprint before = world.plan();
        world.setArea({{0, 2}, {}, {}}, 3.0);
        QCOMPARE(sim::valuesOf(world.plan(), world.area()).sum(), 6.0);
        QCOMPARE(sim::valueOf(world.plan().points[1], world.area()), 0.0);
        world.editor.choose({{0, 1}, {}, {}});
        QVERIFY(!world.property()->get(world.plan(), world.editor.chosen())); // they differ
        world.session.editor().undo();
        QVERIFY(world.plan() == before);
        world.session.editor().redo();
        QCOMPARE(sim::valueOf(world.plan().points[2], world.area()), 3.0);
        world.setArea({{0, 2}, {}, {}}, 0.0);
        QVERIFY(world.plan() == before); // default values are not stored
    }

    void copiesKeepThePropertyOfThePoint()
    {
        SailWorld world;
        world.editor.setEffect("sail", true);
        world.setArea({{0}, {}, {}}, 1.5);
        world.editor.duplicateChosen();
        QCOMPARE(world.plan().points.size(), std::size_t(4));
        QCOMPARE(sim::valueOf(world.plan().points[3], world.area()), 1.5);
        QVERIFY(world.plan().points[3].name != "a");
    }

    void filesKeepTheSettingAndTheProperty()
    {
        SailWorld world;
        world.editor.setEffect("sail", true);
        world.session.editor().setParameter("strength", 0.7);
        world.setArea({{1}, {}, {}}, 0.1 + 0.2);
        const QByteArray text = world.text();
        QVERIFY(text.contains("\"area\": 0.30000000000000004") && text.count("\"area\"") == 1);
        const Experiment back = parseExperiment(text, "x.json", sailLibrary());
        QVERIFY(*back.script.values.blueprint == world.plan());
        QCOMPARE(back.script.values["strength"], 0.7);
        QCOMPARE(experimentText(back, sailLibrary()), text);
    }

    void filesRefuseWhatItCannotBe()
    {
        QVERIFY(errorOf(fileWith("\"area\": -4"), sailLibrary()).isEmpty());
        QCOMPARE(errorOf(fileWith("\"area\": 5"), sailLibrary()),
                 QString("x.json: line 5: \"area\" is 5; it can be -4 to 4."));
        const QString unknown = errorOf(fileWith("\"area\": 1"), LessonLibrary::load({LESSON_DIR}));
        QVERIFY2(unknown.contains("has no field \"area\""), qPrintable(unknown));
    }

    /// By x = a t^2 / 2 with a = strength * area / mass.
    void pointsWithThePropertyMove()
    {
        SailWorld world;
        world.session.editor().setMethod("velocity_verlet");
        world.editor.setEffect("sail", true);
        world.setArea({{0}, {}, {}}, 3.0);
        world.session.playback().goTo({20, 0});
        const sim::State &now = world.session.timeline().state();
        QVERIFY(std::abs(now.positionOf(0).x - 0.5 * (0.1 * 3.0 / 2.0) * 400.0) < 1e-9);
        QCOMPARE(now.positionOf(1).x, 0.0);
    }

    void aSceneThatHasItCanBeTakenOver()
    {
        SailWorld world;
        world.editor.setEffect("sail", true);
        world.setArea({{2}, {}, {}}, -2.5);
        const Picture picture = world.session.presentation().picture();
        const auto draft = lessons::blueprintOf(picture.interval->scene, picture.state, *picture.view);
        QVERIFY(draft && draft->omitted.empty());
        QCOMPARE(draft->parameters.at("strength"), 0.1);
        QVERIFY(draft->blueprint.points[2].properties == world.plan().points[2].properties);
        QVERIFY(sim::hasEffect(draft->blueprint, "sail"));
    }

    void theListOfEffectsOffersIt()
    {
        SailWorld world;
        EffectFacts facts;
        facts.offered = world.session.step().availableEffects;
        const std::vector<EffectLine> lines = effectLines(facts);
        const auto line =
            std::find_if(lines.begin(), lines.end(), [](const EffectLine &one) { return one.id == "sail"; });
        QVERIFY(line != lines.end() && line->role == EffectRole::offered);
        QCOMPARE(line->title, QString("Sail"));
        QVERIFY(line->help.contains("Pushes what carries a sail."));
    }

    void noTwoEffectsShareAnIdAndSharedSettingsAgree()
    {
        QStringList ids;
        std::map<std::string, const sim::ParameterSpec *> settings;
        for (const sim::EffectDescription *one : sim::allEffects()) {
            ids << one->id;
            for (const sim::ParameterSpec &parameter : one->parameters) {
                const auto [known, isNew] = settings.emplace(parameter.id, &parameter);
                QVERIFY2(isNew || (std::string(known->second->help) == parameter.help &&
                                   known->second->defaultValue == parameter.defaultValue &&
                                   known->second->max == parameter.max),
                         parameter.id);
                QVERIFY2(parameter.defaultValue >= parameter.min && parameter.defaultValue <= parameter.max,
                         parameter.id);
            }
        }
        QCOMPARE(ids.removeDuplicates(), 0);
    }
};

SUITE(tst_described_effect, DescribedEffect)
#include "tst_described_effect.moc"
