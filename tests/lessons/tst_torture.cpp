// The torture panel: each hard case under any method, with a note on what the method claims and what came of it.

#include "lessons/api/view/view.h"
#include "sim/catalogue/hard_cases.h"
#include "sim/catalogue/judge.h"
#include "sim/methods/methods.h"
#include "sim/run/track.h"
#include "tests/lessons/support.h"

#include <QTest>

using namespace support;

class Torture : public QObject
{
    Q_OBJECT

    const lessons::Step m_step = loadLesson(QStringLiteral("hard_cases")).step(QStringLiteral("torture"));

private slots:
    void everyCaseOpensAsTheCatalogueHasIt_data() { addCaseRows(); }
    void everyCaseOpensAsTheCatalogueHasIt();
    void everyCaseIsDrawnWhole_data() { addCaseRows(); }
    void everyCaseIsDrawnWhole();
    void theNoteTellsWhatAMethodClaims();
    void theNoteTellsWhenACaseIsLost();
    void aChangedCaseIsNobodysClaim();

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

void Torture::everyCaseOpensAsTheCatalogueHasIt()
{
    QFETCH(int, number);
    const lessons::Parameter &parameter = *m_step.parameter(QStringLiteral("case"));
    QVERIFY(parameter.restartsRun);
    const std::string id = parameter.choices[number].toStdString();
    const std::optional<sim::HardCase> hard = sim::findHardCase(id);
    QVERIFY(hard);
    QVERIFY(!parameter.choiceTitles[number].isEmpty() && !parameter.choiceHelps[number].isEmpty());
    if (id == "branches_16_deep") // smaller here
        return;
    const sim::Script script = caseScript(parameter.choices[number], "published");
    const sim::Script told = sim::scriptOf(*hard, script.method, hard->brief);
    QVERIFY(script.input == told.input);
    QVERIFY(script.step == told.step);
    const std::int64_t frames = std::min<std::int64_t>(hard->brief.frames, 5 * told.step.framesPerOutput);
    QVERIFY(sim::sameBits(stateAfter(script, frames), stateAfter(told, frames)));
}

void Torture::everyCaseIsDrawnWhole()
{
    QFETCH(int, number);
    const sim::Script script =
        caseScript(m_step.parameter(QStringLiteral("case"))->choices[number], "published");
    const sim::Scene scene = script.build(script.values);
    const lessons::View look = m_step.view(scene, script.values);
    QCOMPARE(static_cast<int>(look.bodies.size()), scene.start.pointCount());
    for (const lessons::LegView &leg : look.legs)
        QVERIFY(std::max(leg.from, leg.to) < scene.start.pointCount());
    for (const lessons::StickView &stick : look.sticks)
        QVERIFY(std::max(stick.a, stick.b) < scene.start.pointCount());
    if (scene.start.angle.rows() > 0)
        QVERIFY(look.tree && static_cast<int>(look.tree->length.size()) == scene.start.pointCount());
    const auto actsFromAfar = [](const sim::EffectPtr &effect) { return effect->id() == "charges"; };
    if (scene.start.angle.rows() == 0 && scene.start.pointCount() > 1 &&
        std::none_of(scene.effects.begin(), scene.effects.end(), actsFromAfar))
        QVERIFY(!look.legs.empty() || !look.sticks.empty());
}

void Torture::theNoteTellsWhatAMethodClaims()
{
    const QString stiff = QStringLiteral("stiffness_1e6");
    const QString claimed = noteAt(caseScript(stiff, "backward_euler"), 100);
    QVERIFY2(claimed.contains(u"Backward Euler claims this case."_qs), qPrintable(claimed));
    QVERIFY2(claimed.contains(u"at rest, as it should be"_qs), qPrintable(claimed));
    QVERIFY(claimed.startsWith(u"A spring of stiffness a million"_qs));
    const QString midpoint = noteAt(caseScript(stiff, "implicit_midpoint"), 100);
    QVERIFY2(midpoint.contains(u"within its bounds"_qs), qPrintable(midpoint));
}

void Torture::theNoteTellsWhenACaseIsLost()
{
    const sim::Script script = caseScript(QStringLiteral("stiffness_1e6"), "semi_implicit_euler");
    const QString note = noteAt(script, 5);
    QVERIFY2(note.contains(u"Semi-implicit Euler does not claim it: its steps are too long"_qs),
             qPrintable(note));
    QVERIFY2(note.contains(u"out of its bounds"_qs), qPrintable(note));
    const QString pair = noteAt(caseScript(QStringLiteral("runaway_pair"), "published"), 300);
    QVERIFY2(pair.contains(u"it moves one body after the other"_qs), qPrintable(pair));
    // The whole run is judged, not the moment: so it knows since when, as the judge of the tests does.
    const sim::HardCase hard = sim::findHardCase("runaway_pair").value();
    const sim::Verdict verdict = sim::judge(hard, sim::findMethod("published"), hard.brief);
    const QString since = QString::fromStdString(verdict.why->values().at("frame"));
    QVERIFY2(since.toInt() < 300, qPrintable(since));
    QVERIFY2(pair.contains("out of its bounds since frame " + since + '.'), qPrintable(pair));
}

void Torture::aChangedCaseIsNobodysClaim()
{
    sim::Script script = caseScript(QStringLiteral("feet_60"), "backward_euler");
    QVERIFY(noteAt(script, 10).contains(u"claims this case"_qs));
    script.input.push_back({5, sim::Grab{"body"}});
    QVERIFY(noteAt(script, 10).contains(u"nobody claims this"_qs));
    sim::Script stiffer = caseScript(QStringLiteral("feet_60"), "backward_euler");
    stiffer.values.set("k", 3.0);
    QVERIFY(noteAt(stiffer, 10).contains(u"nobody claims this"_qs));
}

QTEST_GUILESS_MAIN(Torture)
#include "tst_torture.moc"
