// Edits of the listing and of the rule.

#include "app/model/run/run_program.h"
#include "app/model/run/same_run.h"
#include "app/model/session/run_editor.h"
#include "app/model/text/sentences.h"
#include "sim/base/error.h"

#include <QElapsedTimer>

#include <algorithm>
#include <utility>

namespace app {

namespace {

/// Computing at once, in ms: most runs are back at their frame then, before they are painted.
constexpr qint64 millisecondsAtOnce = 60;
constexpr std::int64_t framesAtOnce = 8;

}

void RunEditor::setListing(const EditLabel &label, std::optional<QString> draft, const sim::MethodPtr &method,
                           sim::StepSize step)
{
    sim::Script script = m_run.timeline().script();
    if (!sameMethod(script.method, method))
        script.method = method;
    script.step = step;
    setCode(label, std::move(draft), std::move(script));
}

void RunEditor::setRule(const EditLabel &label, std::optional<QString> draft, sim::BlueprintRule rule)
{
    sim::Script script = m_run.timeline().script();
    sim::Blueprint blueprint = *script.values.blueprint;
    blueprint.rule = std::move(rule);
    script.values.blueprint = std::make_shared<const sim::Blueprint>(std::move(blueprint));
    keepListedOff(script);
    setCode(label, std::move(draft), std::move(script));
}

void RunEditor::setCode(const EditLabel &label, std::optional<QString> draft, sim::Script script)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    RunSnapshot before = m_comparisons.snapshot();
    if (!sameRun(*before.script, script) && !replaceCode(label, std::move(script)))
        return;
    m_run.setDraft(std::move(draft));
    m_run.changes().announce(ChangeKind::code);
    m_history.add(label, std::move(before), m_comparisons.snapshot());
}

bool RunEditor::replaceCode(const EditLabel &label, sim::Script script)
{
    sim::Timeline &timeline = m_run.timeline();
    const RunSnapshot before = m_comparisons.snapshot();
    const bool corrects = m_history.continues(label.gesture) && m_comparisons.branches().find(m_typedOver);
    const std::int64_t computed = timeline.computed();
    const sim::Cursor was = timeline.cursor();
    // The next text can come while the run is still on its way, or has ended early because of a mistake.
    const bool hasEnded = timeline.stop() && timeline.stop()->frame == was.frame;
    const std::int64_t goal =
        std::max(m_playback.goal().value_or(was.frame), hasEnded ? m_wantedFrame : std::int64_t{0});
    m_wantedFrame = goal;
    bool isComparison = false;
    try {
        timeline.seek({}); // the frame may be far away, and the whole run is another
        if (corrects)
            timeline.correctScript(std::move(script));
        else
            isComparison = timeline.replaceScript(std::move(script));
    } catch (const sim::Error &error) {
        timeline.seek(was);
        m_run.showMessage(sentenceFor(error));
        return false;
    }
    const bool leavesBranch = isComparison || (!corrects && before.branches.own().end > 0);
    m_comparisons.recordEdit(label, before, computed,
                             isComparison   ? Replaced::comparison
                             : leavesBranch ? Replaced::branch
                                            : Replaced::forgotten);
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < millisecondsAtOnce && timeline.cursor().frame < goal && !timeline.stop())
        timeline.seek({std::min(goal, timeline.cursor().frame + framesAtOnce), 0});
    m_run.setEdited(true);
    m_run.changes().announce(ChangeKind::run | ChangeKind::cursor, 0);
    m_playback.goTo({goal, 0});
    if (leavesBranch)
        m_comparisons.showNewest();
    const Branch *branch = m_comparisons.shown();
    if (!corrects)
        m_typedOver = leavesBranch && branch ? branch->id : 0;
    if (leavesBranch && branch)
        m_run.showMessage(tr("The old run stays beside this one as “%1”.").arg(branch->name));
    return true;
}

}
