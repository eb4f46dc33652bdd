// Step `torture`: each hard case with any method, and a note on the claim of the method and the verdict.

#include "lessons/api/view/view.h"
#include "sim/catalogue/hard_cases.h"
#include "sim/catalogue/judge.h"
#include "sim/methods/methods.h"
#include "sim/run/track.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QTest>

using namespace support;

class Torture : public QObject
{
    Q_OBJECT

    const lessons::Step m_step = loadLesson(QStringLiteral("hard_cases")).step(QStringLiteral("torture"));

private slots:
    void casesMatchTheCatalogue_data() { addCaseRows(); }
    void casesMatchTheCatalogue();
    void viewsCoverTheCases_data() { addCaseRows(); }
    void viewsCoverTheCases();
    void noteTellsTheClaim();
    void noteTellsAFailedCase();
    void noMethodClaimsAChangedCase();

private:
    void addCaseRows() const
    {
        QTest::addColumn<int>("number");
        const QStringList ids = m_step.parameter(QStringLiteral("case"))->choices;
        for (int i = 0; i < ids.size(); ++i)
            QTest::newRow(qPrintable(ids[i])) << i;
    }
    sim::Script caseScript(const QString &id, const char *method) const
    {
        sim::Values values = m_step.defaultValues();
        const auto position = m_step.parameter(QStringLiteral("case"))->choices.indexOf(id);
        values.set("case", static_cast<double>(position));
        return m_step.scriptWith(values, sim::findMethod(method));
    }
    QString noteAt(const sim::Script &script, std::int64_t frame) const
    {
        sim::Track track(script, 0);
        track.seek({frame, 0});
        return m_step.note(track);
    }
};

void Torture::casesMatchTheCatalogue()
{
    QFETCH(int, number);
    const lessons::Parameter &parameter = *m_step.parameter(QStringLiteral("case"));
    QVERIFY(parameter.restartsRun);
    const std::string id = parameter.choices[number].toStdString();
    const std::optional<sim::HardCase> hardCase = sim::findHardCase(id);
    QVERIFY(hardCase);
    QVERIFY(!parameter.choiceTitles[number].isEmpty() && !parameter.choiceHelps[number].isEmpty());
    if (id == "branches_16_deep") // the lesson has a smaller tree
        return;
    const sim::Script script = caseScript(parameter.choices[number], "published");
    const sim::Script expected = sim::scriptOf(*hardCase, script.method, hardCase->brief);
    QVERIFY(script.input == expected.input);
    QVERIFY(script.step == expected.step);
    const std::int64_t frames =
        std::min<std::int64_t>(hardCase->brief.frames, 5 * expected.step.framesPerOutput);
    QVERIFY(sim::sameBits(stateAfter(script, frames), stateAfter(expected, frames)));
}

void Torture::viewsCoverTheCases()
{
    QFETCH(int, number);
    const sim::Script script =
        caseScript(m_step.parameter(QStringLiteral("case"))->choices[number], "published");
    const sim::Scene scene = script.build(script.values);
    const lessons::View view = m_step.view(scene, script.values);
    QCOMPARE(static_cast<int>(view.bodies.size()), scene.start.pointCount());
    for (const lessons::LegView &leg : view.legs)
        QVERIFY(std::max(leg.from, leg.to) < scene.start.pointCount());
    for (const lessons::StickView &stick : view.sticks)
        QVERIFY(std::max(stick.a, stick.b) < scene.start.pointCount());
    if (scene.start.angle.rows() > 0)
        QVERIFY(view.tree && static_cast<int>(view.tree->length.size()) == scene.start.pointCount());
    const auto actsFromAfar = [](const sim::EffectPtr &effect) { return effect->id() == "charges"; };
    if (scene.start.angle.rows() == 0 && scene.start.pointCount() > 1 &&
        std::none_of(scene.effects.begin(), scene.effects.end(), actsFromAfar))
        QVERIFY(!view.legs.empty() || !view.sticks.empty());
}

void Torture::noteTellsTheClaim()
{
    const QString stiff = QStringLiteral("stiffness_1e6");
    const QString backwardEuler = noteAt(caseScript(stiff, "backward_euler"), 100);
    QVERIFY2(backwardEuler.contains(u"Backward Euler claims this case."_qs), qPrintable(backwardEuler));
    QVERIFY2(backwardEuler.contains(u"at rest, as it should be"_qs), qPrintable(backwardEuler));
    QVERIFY(backwardEuler.startsWith(u"A spring of stiffness a million"_qs));
    const QString midpoint = noteAt(caseScript(stiff, "implicit_midpoint"), 100);
    QVERIFY2(midpoint.contains(u"within its bounds"_qs), qPrintable(midpoint));
}

void Torture::noteTellsAFailedCase()
{
    const sim::Script script = caseScript(QStringLiteral("stiffness_1e6"), "semi_implicit_euler");
    const QString note = noteAt(script, 5);
    QVERIFY2(note.contains(u"Semi-implicit Euler does not claim it: its steps are too long"_qs),
             qPrintable(note));
    QVERIFY2(note.contains(u"out of its bounds"_qs), qPrintable(note));
    const QString pair = noteAt(caseScript(QStringLiteral("runaway_pair"), "published"), 300);
    QVERIFY2(pair.contains(u"it moves one body after the other"_qs), qPrintable(pair));
    // The verdict covers the run so far. So the note knows the first frame out of bounds, as sim::judge()
    // does.
    const sim::HardCase hardCase = sim::findHardCase("runaway_pair").value();
    const sim::Verdict verdict = sim::judge(hardCase, sim::findMethod("published"), hardCase.brief);
    const QString since = QString::fromStdString(verdict.why->values().at("frame"));
    QVERIFY2(since.toInt() < 300, qPrintable(since));
    QVERIFY2(pair.contains("out of its bounds since frame " + since + '.'), qPrintable(pair));
}

void Torture::noMethodClaimsAChangedCase()
{
    sim::Script script = caseScript(QStringLiteral("feet_60"), "backward_euler");
    QVERIFY(noteAt(script, 10).contains(u"claims this case"_qs));
    script.input.push_back({5, sim::Grab{"body"}});
    QVERIFY(noteAt(script, 10).contains(u"nobody claims this"_qs));
    sim::Script stiffer = caseScript(QStringLiteral("feet_60"), "backward_euler");
    stiffer.values.set("k", 3.0);
    QVERIFY(noteAt(stiffer, 10).contains(u"nobody claims this"_qs));
}

SUITE(tst_torture, Torture)
#include "tst_torture.moc"
