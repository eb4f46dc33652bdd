#include "app/model/session/run_editor.h"

#include "app/model/run/run_program.h"
#include "app/model/run/same_run.h"
#include "app/model/text/sentences.h"
#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

/// Returns the input that a run of `step` with the values of `script` begins with.
std::vector<sim::Event> openingInput(const lessons::Step &step, const sim::Script &script)
{
    return step.scriptWith(script.values, script.method).input;
}

/// Returns the kinds of the change from one run to another. The listing computes only one of them if the methods differ.
ChangeKinds kindsOf(const sim::Script &before, const sim::Script &after)
{
    const ChangeKinds kinds = ChangeKind::run | ChangeKind::cursor;
    const bool isSameCode =
        sameMethod(before.method, after.method) && before.step == after.step && sameRule(before, after);
    return isSameCode ? kinds : kinds | ChangeKind::code;
}

}

void keepListedOff(sim::Script &script)
{
    const std::vector<sim::EffectPtr> listed = script.build(script.values).effects;
    std::erase_if(script.effectsOff, [&](const std::string &id) {
        return std::none_of(listed.begin(), listed.end(),
                            [&](const sim::EffectPtr &one) { return one->id() == id; });
    });
}

RunEditor::RunEditor(OpenRun &run, Preview &preview, CompanionFollower &companion, Playback &playback,
                     ComparisonRuns &comparisons, EditHistory &history)
    : m_run(run), m_preview(preview), m_companion(companion), m_playback(playback),
      m_comparisons(comparisons), m_history(history), m_input(run, preview, *this)
{
    m_history.setRestore([this](const RunSnapshot &to, const QString &replacedName, KeepRun keepReplaced) {
        restore(to, replacedName, keepReplaced);
    });
}

void RunEditor::begin(sim::Script script, sim::Cursor at, Branches branches, std::optional<QString> draft)
{
    auto timeline = std::make_unique<sim::Timeline>(std::move(script)); // throws before anything has changed
    const ChangeNotifier::Batch batch(m_run.changes());
    m_preview.end();
    m_input.forget();
    m_comparisons.reset(std::move(branches));
    m_otherStep.reset();
    m_typedOver = 0;
    m_wantedFrame = 0;
    m_run.setTimeline(std::move(timeline));
    m_run.setEdited(false);
    m_run.setDraft(std::move(draft));
    m_companion.open();
    m_playback.open();
    m_run.changes().announce(ChangeKind::step, 0);
    m_playback.goTo(at);
}

void RunEditor::edit(const EditLabel &label, const Edit &edit)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    m_playback.stopSeeking();
    sim::Timeline &timeline = m_run.timeline();
    RunSnapshot before = m_comparisons.snapshot();
    const std::int64_t computed = timeline.computed();
    bool isComparison = false;
    try {
        isComparison = edit(timeline);
    } catch (const sim::Error &error) {
        m_run.showMessage(sentenceFor(error));
        return;
    }
    Replaced replaced = Replaced::forgotten;
    if (isComparison)
        replaced = Replaced::comparison;
    else if (before.branches.own().end > timeline.cursor().frame)
        replaced = Replaced::branch;
    m_comparisons.recordEdit(label, before, computed, replaced);
    m_run.setEdited(true);
    m_run.setDraft(draftBeside(timeline.script(), before));
    m_run.changes().announce(kindsOf(*before.script, timeline.script()),
                             firstDifferent(*before.script, timeline.script()));
    if (replaced != Replaced::forgotten) {
        m_comparisons.showNewest();
        if (const Branch *branch = m_comparisons.shown())
            m_run.showMessage(tr("The old run stays beside this one as “%1”.").arg(branch->name));
    }
    m_history.add(label, std::move(before), m_comparisons.snapshot());
}

std::optional<QString> RunEditor::draftBeside(const sim::Script &script, const RunSnapshot &before) const
{
    const std::shared_ptr<const listing::Program> was = programOf(before.script->method);
    const std::shared_ptr<const listing::Program> is = programOf(script.method);
    if (m_run.isSandbox()) // the draft is that of a rule, or that of a listing
        return sameRule(script, *before.script) && !was == !is ? before.draft : std::nullopt;
    if (is && !(was && was->text() == is->text()))
        return std::nullopt; // another listing computes the run, and is shown
    if (!was || is || before.draft)
        return before.draft;
    return QString::fromStdString(was->text());
}

void RunEditor::startWith(const lessons::Preset &preset)
{
    sim::Values values = m_run.step().defaultValues();
    for (const auto &[id, value] : preset.values)
        values.set(id.toStdString(), value);
    startAnew({tr("Choose “%1”").arg(preset.title), preset.title, {}, preset.title}, values, ownMethods());
}

std::vector<sim::MethodPtr> RunEditor::ownMethods() const
{
    const sim::MethodPtr own = sim::findMethod(m_run.step().method.toStdString());
    const sim::MethodPtr &now = m_run.timeline().script().method;
    return programOf(now) ? std::vector{now, own} : std::vector{own};
}

void RunEditor::startAfresh()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    m_playback.pause();
    startAnew({tr("Reset run and parameters"), {}}, m_run.step().script());
}

void RunEditor::startAnew(const EditLabel &label, const sim::Values &values,
                          const std::vector<sim::MethodPtr> &methods)
{
    for (const sim::MethodPtr &method : methods) {
        try {
            startAnew(label, m_run.step().scriptWith(values, method));
            return;
        } catch (const sim::Error &error) {
            m_run.showMessage(sentenceFor(error)); // another method may be able to compute it
        }
    }
}

void RunEditor::startAnew(const EditLabel &label, sim::Script script)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    const bool wasPlaying = m_playback.isPlaying();
    RunSnapshot before = m_comparisons.snapshot();
    const std::int64_t computed = m_run.timeline().computed();
    m_playback.pause();
    std::optional<QString> draft = draftBeside(script, before);
    begin(std::move(script), {}, before.branches, std::move(draft));
    m_run.setEdited(true);
    const bool hadFrames = std::max(computed, before.branches.own().end) > 0;
    m_comparisons.recordEdit(label, before, computed, hadFrames ? Replaced::branch : Replaced::forgotten);
    m_history.add(label, std::move(before), m_comparisons.snapshot());
    m_run.changes().announce(ChangeKind::run | ChangeKind::code, 0);
    if (wasPlaying)
        m_playback.play();
}

bool RunEditor::setUp(const EditLabel &label, const sim::Script &script, Maker maker)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    m_playback.pause();
    m_input.releaseAll();
    endGesture();
    if (!sameScript(script, m_run.timeline().script()) && !replaceBy(label, script))
        return false;
    m_run.setEdited(maker == Maker::learner);
    // The step's first run is no answer to anything, so looking into its frames may tick a thing to try.
    if (maker == Maker::program && !sameScript(script, m_run.step().script()))
        m_run.addGiven(script);
    m_playback.goToPaused({});
    return true;
}

bool RunEditor::replaceBy(const EditLabel &label, const sim::Script &script)
{
    if (m_run.isSandbox())
        return replaceScene(label, script, m_run.draft());
    try {
        if (needsNewStart(script)) {
            startAnew(label, script);
        } else {
            const sim::Timeline trial(script, 0); // throws before anything has changed
            m_run.timeline().seek({});
            edit(label, [&](sim::Timeline &run) { return run.replaceScript(script); });
        }
    } catch (const sim::Error &error) {
        m_run.showMessage(sentenceFor(error));
        return false;
    }
    m_comparisons.show(0);
    return true;
}

void RunEditor::restart()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    m_playback.pause();
    m_input.releaseAll();
    if (hasInput()) {
        sim::Timeline &timeline = m_run.timeline();
        sim::Script script = timeline.script();
        script.values = timeline.values();
        script.input = openingInput(m_run.step(), script);
        timeline.seek({});
        edit({tr("Restart"), tr("the restart")},
             [&](sim::Timeline &run) { return run.replaceScript(std::move(script)); });
        m_comparisons.show(0); // a ghost would repeat the input that the user wants to get rid of
        m_run.showMessage(tr("A new run. The old one is in “Runs”; Undo brings it back."));
    }
    m_playback.goTo({});
}

bool RunEditor::hasInput() const
{
    return m_run.timeline().script().input != openingInput(m_run.step(), m_run.timeline().script());
}

std::shared_ptr<const sim::Blueprint> RunEditor::blueprint() const
{
    return m_run.timeline().script().values.blueprint;
}

bool RunEditor::build(const EditLabel &label, sim::Blueprint blueprint)
{
    sim::Script script = m_run.timeline().script();
    script.values.blueprint = std::make_shared<const sim::Blueprint>(std::move(blueprint));
    keepListedOff(script);
    return replaceScene(label, script, m_run.draft());
}

bool RunEditor::replaceScene(const EditLabel &label, const sim::Script &script, std::optional<QString> draft)
{
    return replaceSandbox(label, script, std::move(draft), {}); // branches have other bodies
}

bool RunEditor::rewriteScene(const EditLabel &label,
                             const std::function<sim::Script(const sim::Script &)> &rewrite)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    const Branch *shown = m_comparisons.shown();
    const int ghost = shown ? shown->id : 0;
    const int selected = m_run.timeline().track().interval().scene.find(m_run.selected().toStdString());
    Branches branches = m_comparisons.branches().withScripts(rewrite);
    OwnRun own = branches.own();
    own.end = 0; // the run has no frames yet, so that Undo makes no branch of it
    branches.setOwn(std::move(own));
    if (!replaceSandbox(label, rewrite(m_run.timeline().script()), m_run.draft(), std::move(branches)))
        return false;
    const std::vector<std::string> &names = m_run.timeline().track().interval().scene.names;
    if (selected >= 0 && std::size_t(selected) < names.size())
        m_run.select(QString::fromStdString(names[std::size_t(selected)]));
    m_comparisons.show(ghost);
    return true;
}

bool RunEditor::replaceSandbox(const EditLabel &label, const sim::Script &script,
                               std::optional<QString> draft, Branches branches)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    m_playback.pause();
    m_input.releaseAll();
    sim::Timeline &timeline = m_run.timeline();
    RunSnapshot before = m_comparisons.snapshot();
    const sim::Cursor was = timeline.cursor();
    try {
        timeline.seek({});
        timeline.replaceScript(script);
    } catch (const sim::Error &error) {
        timeline.seek(was);
        m_run.showMessage(sentenceFor(error));
        return false;
    }
    timeline.dropComparison();
    m_comparisons.reset(std::move(branches));
    m_run.setEdited(true);
    m_run.setDraft(std::move(draft));
    m_run.changes().announce(kindsOf(*before.script, script), 0);
    m_history.add(label, std::move(before), m_comparisons.snapshot());
    const sim::Scene &scene = timeline.track().interval().scene;
    if (scene.find(m_run.selected().toStdString()) < 0)
        m_run.select(QString::fromStdString(scene.names.front()));
    return true;
}

void RunEditor::goBackTo(int id)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    m_input.releaseAll();
    endGesture();
    const Branch *branch = m_comparisons.branches().find(id);
    if (!branch)
        return;
    const QString name = branch->name;
    RunSnapshot before = m_comparisons.snapshot();
    RunSnapshot to{branch->script, m_comparisons.branches(), before.draft};
    to.branches.settle(*to.script);
    to.draft = programOf(to.script->method) ? std::nullopt : draftBeside(*to.script, before);
    const QString made = before.branches.own().made;
    restore(to, made.isEmpty() ? tr("the first run") : made, KeepRun::always);
    m_comparisons.limit();
    m_history.add({tr("Go back to “%1”").arg(name), {}}, std::move(before), m_comparisons.snapshot());
    m_run.changes().announce(ChangeKind::run);
    m_run.showMessage(tr("“%1” is the current run again. The run that you left is now in “Runs”.").arg(name));
}

void RunEditor::undo()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    m_input.releaseAll();
    endGesture();
    if (!m_history.stack().canUndo())
        return;
    const QString what = m_history.stack().undoText();
    m_history.stack().undo();
    m_run.showMessage(tr("Undone: %1.").arg(what));
}

void RunEditor::redo()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    endGesture();
    if (!m_history.stack().canRedo())
        return;
    const QString what = m_history.stack().redoText();
    m_history.stack().redo();
    m_run.showMessage(tr("Redone: %1.").arg(what));
}

bool RunEditor::needsNewStart(const sim::Script &script) const
{
    const std::vector<lessons::Parameter> &all = m_run.step().parameters;
    return std::any_of(all.begin(), all.end(), [&](const lessons::Parameter &one) {
        const std::string id = one.id.toStdString();
        const sim::Values &now = m_run.timeline().script().values;
        return one.restartsRun && script.values.has(id) && now.has(id) && script.values[id] != now[id];
    });
}

bool RunEditor::replaceRun(const sim::Script &script)
{
    sim::Timeline &timeline = m_run.timeline();
    const sim::Track *comparison = timeline.comparison();
    const std::int64_t shared = lastShared(script, timeline.script());
    const bool isComparison = comparison && sameScript(comparison->script(), script);
    if (isComparison)
        timeline.swapWithComparison();
    timeline.seek({std::min(timeline.cursor().frame, shared), 0});
    if (isComparison)
        return true;
    return sameRun(script, timeline.script()) ? timeline.replaceInput(script.input)
                                              : timeline.replaceScript(script);
}

void RunEditor::restore(const RunSnapshot &to, const QString &replacedName, KeepRun keepReplaced)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    const RunSnapshot before = m_comparisons.snapshot();
    if (sameScript(*to.script, *before.script)) {
        m_run.setDraft(to.draft);
        m_comparisons.restoreBranches(to.branches);
        return;
    }
    const std::int64_t shared = lastShared(*to.script, *before.script);
    Branch replaced = m_comparisons.branchOf(before, m_run.timeline().computed(), replacedName);
    Branches branches = to.branches;
    if (keepReplaced == KeepRun::always || (keepReplaced == KeepRun::ifItWentOn && replaced.end > shared))
        branches.add(std::move(replaced));
    if (needsNewStart(*to.script)) {
        m_playback.pause();
        begin(*to.script, {}, std::move(branches), to.draft);
        return;
    }
    m_input.forget();
    m_playback.stopSeeking();
    const sim::Cursor at = m_run.timeline().cursor();
    bool isComparison = false;
    try {
        isComparison = replaceRun(*to.script);
    } catch (const sim::Error &error) {
        m_run.showMessage(sentenceFor(error));
        return;
    }
    m_comparisons.restore(std::move(branches), isComparison ? before.script.get() : nullptr);
    m_run.setEdited(false);
    m_run.setDraft(to.draft);
    m_run.changes().announce(kindsOf(*before.script, *to.script), firstDifferent(*before.script, *to.script));
    m_playback.goToPaused(at);
    if (const Branch *branch = m_comparisons.branches().find(*before.script))
        m_comparisons.show(branch->id);
}

}
