#pragma once

#include "app/listing/rule_program.h"
#include "app/model/listing/code_text.h"
#include "app/model/session/edit_label.h"
#include "app/model/session/open_run.h"

#include <QCoreApplication>

#include <optional>
#include <vector>

namespace app {

class RunEditor;

/// Returns whether the draft of `run` is that of a rule, not of a listing: in the sandbox, unless a listing computes the
/// run, because the effects of the scene do not act then.
bool hasRuleDraft(const OpenRun &run);

/// The rule of a sandbox scene, as the learner has written it. It acts like any effect, under every method. While the
/// text does not compile, it is kept as a draft and the last rule that compiled still acts.
///
/// ChangeKind::code announces each change of the text, also together with other kinds.
class RuleCode
{
    Q_DECLARE_TR_FUNCTIONS(RuleCode)

public:
    RuleCode(OpenRun &run, RunEditor &editor) : m_run(run), m_editor(editor) {}

    /// Returns whether the open scene can have a rule.
    bool isOffered() const { return hasRuleDraft(m_run) && m_run.timeline().script().values.blueprint; }
    /// Returns what text() is as long as the learner has not written anything. It computes no force.
    static QString startingText();
    /// Returns the text as the learner has left it.
    QString text() const;
    /// Returns whether text() is the rule that acts, not a draft or the starting text.
    bool isActing() const;
    /// Returns whether a rule acts: text(), or the last one that compiled.
    bool hasRule() const;
    /// Returns the mistakes of text(), in its order. Empty if it compiles.
    std::vector<CodeMistake> mistakes() const;
    /// Returns the mistake that ended the run, if the rule did. Its line is one of text() if isActing().
    std::optional<listing::RuleError> runError() const;

    /// Replaces the text. If it compiles, the run is computed again up to the cursor, and the previous run becomes the
    /// ghost. Edits without a TypingPause between them are one undo entry, unless RunEditor::endGesture() was called
    /// between them.
    void write(const QString &text);
    /// Deletes the rule, so that text() is the starting text again. It can be undone.
    void remove();

private:
    const sim::BlueprintRule &rule() const;
    void set(const QString &text, const EditLabel &label);
    const listing::CompiledRule &compiled(const QString &text) const;

    OpenRun &m_run;
    RunEditor &m_editor;
    TypingPause m_pause;
    mutable RecentResults<QString, listing::CompiledRule> m_compiled;
};

}
