#include "cases.h"

#include "lessons/api/parameters.h"
#include "lessons/hard_cases/text.h"
#include "sim/analysis/accuracy/study_run.h"
#include "sim/catalogue/hard_cases.h"
#include "sim/catalogue/judge.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/tree/joints.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>

#include <algorithm>
#include <memory>
#include <optional>

using namespace lessons;

namespace hard_cases {

namespace {

constexpr double maxLevels = 12.0; ///< of forks; 8191 branches

/// Returns a text of sim in the learner's language.
QString translated(const std::string &text)
{
    return QCoreApplication::translate("sim", text.c_str());
}

/// Returns in a few words why a method does not claim a case.
QString reasonOf(const sim::Error &reason)
{
    const std::string &id = reason.id();
    if (id == "claim-grows")
        return Text::tr("its steps are too long for what is so stiff");
    if (id == "claim-longer-step")
        return Text::tr("its steps are longer than those that the case’s sticks are measured by");
    if (id == "claim-rings")
        return Text::tr("it swings on for longer than the run");
    if (id == "claim-one-by-one")
        return Text::tr("it moves one body after the other");
    if (id == "claim-too-many-steps")
        return Text::tr("it would need too many steps");
    if (id == "claim-adds-up")
        return Text::tr("its errors add up");
    if (id == "claim-stirs")
        return Text::tr("its errors keep it stirring");
    if (id == "claim-no-room")
        return Text::tr("no place there is free");
    return Text::tr("it cannot compute all of it");
}

/// The facts about a case that stay the same during a run.
struct CaseFacts
{
    sim::HardCase hard;
    sim::RunSize size;
    sim::Scene firstScene;
    QString claim; ///< whether the method claims the case
};

CaseFacts factsOf(const sim::Script &script)
{
    CaseFacts facts{caseNumber(script.values.integer("case")), {}, {}, {}};
    facts.size = facts.hard.brief;
    facts.size.h = script.step.h;
    if (script.step.isAdaptive())
        facts.size.tolerance = script.step.tolerance;
    facts.firstScene = sim::sceneOf(script, script.values);
    const sim::Claim claim = sim::claimOf(facts.hard, script.method, facts.size);
    const QString method = translated(script.method->title());
    facts.claim =
        !isUnchangedCase(script) ? Text::tr("You have changed it: nobody claims this.")
        : claim.isMade
            ? Text::tr("%1 claims this case.").arg(method)
            : Text::tr("%1 does not claim it: %2.").arg(method, claim.why ? reasonOf(*claim.why) : QString());
    return facts;
}

/// Checks each output step of a run once, in order of time.
class Judge
{
public:
    /// Checks the output steps from the last one checked to the cursor. After a jump there may be many, so
    /// each call checks only a limited number.
    void checkUpTo(const CaseFacts &facts, const sim::Track &run)
    {
        const int points = std::max(1, facts.firstScene.start.pointCount());
        for (int remaining = std::max(1, maxPositions / points);
             remaining > 0 && !m_violationFrame && m_checkedFrame < run.cursor().frame; --remaining) {
            m_checkedFrame += run.framesPerOutput();
            const bool isAtCursor = m_checkedFrame == run.cursor().frame && run.cursor().phase == 0;
            if (sim::findViolation(facts.hard, facts.firstScene, run.interval().scene,
                                   isAtCursor ? run.state() : run.stateAt(m_checkedFrame), m_checkedFrame))
                m_violationFrame = m_checkedFrame;
        }
    }
    /// Returns the last frame that was checked.
    std::int64_t checkedFrame() const { return m_checkedFrame; }
    bool isViolatedAt(std::int64_t frame) const { return m_violationFrame && *m_violationFrame <= frame; }
    std::int64_t violationFrame() const { return *m_violationFrame; }

private:
    static constexpr int maxPositions = 20'000; ///< checked in one call
    std::int64_t m_checkedFrame = 0;
    std::optional<std::int64_t> m_violationFrame;
};

/// Returns in a few words whether the run has met the requirements up to the cursor.
QString judgement(const CaseFacts &facts, const Judge &judge, const sim::Track &run)
{
    const std::int64_t frame = run.cursor().frame;
    if (judge.isViolatedAt(frame))
        return Text::tr("out of its bounds since frame %1").arg(judge.violationFrame());
    if (judge.checkedFrame() < frame)
        return Text::tr("within its bounds up to frame %1, the rest is not looked at yet")
            .arg(judge.checkedFrame());
    if (!facts.hard.rest || frame == 0)
        return Text::tr("within its bounds so far");
    const sim::State before = run.stateAt(frame - run.framesPerOutput());
    return sim::findRestViolation(facts.hard, run.interval().scene, before, run.state(),
                                  run.framesPerOutput())
               ? Text::tr("within its bounds so far, not at rest yet")
               : Text::tr("within its bounds so far, and at rest, as it should be");
}

bool sameRun(const sim::Script &a, const sim::Script &b)
{
    return a.values == b.values && a.method->id() == b.method->id() && a.step == b.step &&
           a.input == b.input && a.bodies == b.bodies && a.effectsOff == b.effectsOff;
}

}

const std::vector<sim::HardCase> &shownCases()
{
    static const std::vector<sim::HardCase> shown = [] {
        std::vector<sim::HardCase> all = sim::hardCases();
        std::erase_if(
            all, [](const sim::HardCase &hard) { return hard.hasRequirement(sim::Requirement::rejected); });
        for (sim::HardCase &hard : all) {
            if (hard.script.values.has("levels"))
                hard.script.values.set("levels", std::min(hard.script.values["levels"], maxLevels));
        }
        return all;
    }();
    return shown;
}

const sim::HardCase &caseNumber(int index)
{
    return shownCases().at(static_cast<std::size_t>(index));
}

int caseIndex(const char *id)
{
    const std::vector<sim::HardCase> &all = shownCases();
    const auto found =
        std::find_if(all.begin(), all.end(), [id](const sim::HardCase &hard) { return hard.id == id; });
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

Parameter caseParameter()
{
    QStringList ids, titles, helps;
    for (const sim::HardCase &hard : shownCases()) {
        ids << QString::fromStdString(hard.id);
        titles << lessons::grouped(translated(hard.family), translated(hard.title));
        helps << translated(hard.story);
    }
    Parameter parameter = choice("case", Text::tr("Case"),
                                 Text::tr("The experiment that runs. Another one begins at frame 0."), ids);
    parameter.choiceTitles = titles;
    parameter.choiceHelps = helps;
    parameter.defaultValue = caseIndex("runaway_pair");
    parameter.restartsRun = true;
    return parameter;
}

Parameter caseStiffness()
{
    Parameter parameter = stiffness(0.0);
    parameter.help = Text::tr("How hard the springs of the case pull. 0: as hard as the case has it.");
    parameter.sliderMax = 10.0;
    return parameter;
}

void prepareCase(sim::Script &script)
{
    const sim::HardCase &hard = caseNumber(script.values.integer("case"));
    script.input = hard.script.input;
    script.bodies = hard.script.bodies;
    script.step = sim::scriptOf(hard, script.method, hard.brief).step;
}

bool isUnchangedCase(const sim::Script &script)
{
    const sim::HardCase &hard = caseNumber(script.values.integer("case"));
    return script.values["k"] == 0.0 && script.input == hard.script.input &&
           script.bodies == hard.script.bodies && script.effectsOff.empty();
}

std::function<QString(const sim::Track &)> caseNote()
{
    struct Cached
    {
        sim::Script script;
        CaseFacts facts;
        Judge judge;
    };
    // A claim takes some time to compute, so it is cached as long as the run is the same.
    const auto cached = std::make_shared<std::optional<Cached>>();
    return [cached](const sim::Track &run) {
        if (!*cached || !sameRun((*cached)->script, run.script()))
            *cached = Cached{run.script(), factsOf(run.script()), {}};
        const CaseFacts &facts = (*cached)->facts;
        (*cached)->judge.checkUpTo(facts, run);
        return Text::tr("%1\n%2 Frame %3 of %4: %5.")
            .arg(translated(facts.hard.story), facts.claim)
            .arg(run.cursor().frame)
            .arg(facts.hard.brief.frames)
            .arg(judgement(facts, (*cached)->judge, run));
    };
}

}
