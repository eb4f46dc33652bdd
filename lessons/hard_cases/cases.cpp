#include "cases.h"

#include "lessons/api/parameters.h"
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

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(HardCases)
};

constexpr double mostForks = 12.0; ///< 8191 branches

/// A text of sim, in the learner's language.
QString phrase(const std::string &text)
{
    return QCoreApplication::translate("sim", text.c_str());
}

/// Why a method does not claim a case, in a few words.
QString reasonOf(const sim::Error &why)
{
    const std::string &id = why.id();
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

/// What does not change while a case runs.
struct Told
{
    sim::HardCase hard;
    sim::RunSize size;
    sim::Scene first;
    QString claim;
};

Told toldOf(const sim::Script &script)
{
    Told told{caseNumber(script.values.integer("case")), {}, {}, {}};
    told.size = told.hard.brief;
    told.size.h = script.step.h;
    if (script.step.isAdaptive())
        told.size.tolerance = script.step.tolerance;
    told.first = sim::sceneOf(script, script.values);
    const sim::Claim claim = sim::claimOf(told.hard, script.method, told.size);
    const QString method = phrase(script.method->title());
    told.claim =
        !isAsTold(script) ? Text::tr("You have changed it: nobody claims this.")
        : claim.isMade
            ? Text::tr("%1 claims this case.").arg(method)
            : Text::tr("%1 does not claim it: %2.").arg(method, claim.why ? reasonOf(*claim.why) : QString());
    return told;
}

/// Looks at every row of a run once, the earlier ones first.
class Judge
{
public:
    /// Goes on from where it was to the cursor. After a jump there may be much to look at: then it leaves some for the
    /// next time.
    void follow(const Told &told, const sim::Track &run)
    {
        const int points = std::max(1, told.first.start.pointCount());
        for (int left = std::max(1, mostPlaces / points);
             left > 0 && !m_wrongAt && m_judged < run.cursor().frame; --left) {
            m_judged += run.framesPerOutput();
            const bool isHere = m_judged == run.cursor().frame && run.cursor().phase == 0;
            if (sim::findViolation(told.hard, told.first, run.interval().scene,
                                   isHere ? run.state() : run.stateAt(m_judged), m_judged))
                m_wrongAt = m_judged;
        }
    }
    /// The row up to which all is well, or what is wrong has been found.
    std::int64_t judged() const { return m_judged; }
    bool isWrongAt(std::int64_t frame) const { return m_wrongAt && *m_wrongAt <= frame; }
    std::int64_t wrongAt() const { return *m_wrongAt; }

private:
    static constexpr int mostPlaces = 20'000; ///< looked at in one go
    std::int64_t m_judged = 0;
    std::optional<std::int64_t> m_wrongAt;
};

/// How the run is up to the cursor, in a few words.
QString judgement(const Told &told, const Judge &judge, const sim::Track &run)
{
    const std::int64_t frame = run.cursor().frame;
    if (judge.isWrongAt(frame))
        return Text::tr("out of its bounds since frame %1").arg(judge.wrongAt());
    if (judge.judged() < frame)
        return Text::tr("within its bounds up to frame %1, the rest is not looked at yet")
            .arg(judge.judged());
    if (!told.hard.rest || frame == 0)
        return Text::tr("within its bounds so far");
    const sim::State before = run.stateAt(frame - run.framesPerOutput());
    return sim::findRestViolation(told.hard, run.interval().scene, before, run.state(), run.framesPerOutput())
               ? Text::tr("within its bounds so far, not at rest yet")
               : Text::tr("within its bounds so far, and at rest, as it should be");
}

bool sameRun(const sim::Script &a, const sim::Script &b)
{
    return a.values == b.values && a.method->id() == b.method->id() && a.step == b.step &&
           a.input == b.input && a.bodies == b.bodies && a.effectsOff == b.effectsOff;
}

}

std::vector<sim::HardCase> shownCases()
{
    std::vector<sim::HardCase> all = sim::hardCases();
    std::erase_if(all,
                  [](const sim::HardCase &one) { return one.hasRequirement(sim::Requirement::refused); });
    for (sim::HardCase &one : all) {
        if (one.script.values.has("levels"))
            one.script.values.set("levels", std::min(one.script.values["levels"], mostForks));
    }
    return all;
}

sim::HardCase caseNumber(int number)
{
    return shownCases().at(static_cast<std::size_t>(number));
}

int numberOf(const char *id)
{
    const std::vector<sim::HardCase> all = shownCases();
    const auto found =
        std::find_if(all.begin(), all.end(), [id](const sim::HardCase &one) { return one.id == id; });
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

Parameter caseParameter()
{
    QStringList ids, titles, helps;
    for (const sim::HardCase &one : shownCases()) {
        ids << QString::fromStdString(one.id);
        titles << lessons::grouped(phrase(one.family), phrase(one.title));
        helps << phrase(one.story);
    }
    Parameter parameter = choice("case", Text::tr("Case"),
                                 Text::tr("The experiment that runs. Another one begins at frame 0."), ids);
    parameter.choiceTitles = titles;
    parameter.choiceHelps = helps;
    parameter.defaultValue = numberOf("runaway_pair");
    parameter.restartsRun = true;
    return parameter;
}

Parameter stiffnessOfCase()
{
    Parameter parameter = stiffness(0.0);
    parameter.help = Text::tr("How hard the springs of the case pull. 0: as hard as the case has it.");
    parameter.sliderMax = 10.0;
    return parameter;
}

void openCase(sim::Script &script)
{
    const sim::HardCase hard = caseNumber(script.values.integer("case"));
    script.input = hard.script.input;
    script.bodies = hard.script.bodies;
    script.step = sim::scriptOf(hard, script.method, hard.brief).step;
}

bool isAsTold(const sim::Script &script)
{
    const sim::HardCase hard = caseNumber(script.values.integer("case"));
    return script.values["k"] == 0.0 && script.input == hard.script.input &&
           script.bodies == hard.script.bodies && script.effectsOff.empty();
}

std::function<QString(const sim::Track &)> caseNote()
{
    struct Kept
    {
        sim::Script script;
        Told told;
        Judge judge;
    };
    // What a claim is worth takes some computing: it is kept as long as the run is the same.
    const auto kept = std::make_shared<std::optional<Kept>>();
    return [kept](const sim::Track &run) {
        if (!*kept || !sameRun((*kept)->script, run.script()))
            *kept = Kept{run.script(), toldOf(run.script()), {}};
        const Told &told = (*kept)->told;
        (*kept)->judge.follow(told, run);
        return Text::tr("%1\n%2 Frame %3 of %4: %5.")
            .arg(phrase(told.hard.story), told.claim)
            .arg(run.cursor().frame)
            .arg(told.hard.brief.frames)
            .arg(judgement(told, (*kept)->judge, run));
    };
}

}
