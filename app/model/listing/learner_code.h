#pragma once

#include "app/listing/program.h"
#include "app/model/listing/code_text.h"
#include "app/model/session/edit_label.h"
#include "app/model/session/open_run.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace app {

class RunEditor;

/// The listing of the open step, as the learner has written it. The text becomes the method of the run, *Your code*. A text
/// that does not compile is kept as a draft, while the run goes on with the last one that did.
///
/// ChangeKind::code announces each change of the text, also together with other kinds.
class LearnerCode : public QObject
{
    Q_OBJECT

public:
    LearnerCode(OpenRun &run, RunEditor &editor) : m_run(run), m_editor(editor) {}

    /// Returns whether there is a listing to show: the step's, or one that the learner wrote.
    bool isOffered() const;
    /// Returns the step's listing. Empty if it has none.
    QString original() const;
    /// Returns the text as the learner has left it.
    QString text() const;
    /// Returns the text if the run does not use it; see OpenRun::draft().
    const std::optional<QString> &draft() const;
    /// Returns whether the text differs from the step's listing.
    bool isChanged() const { return text() != original(); }
    /// Returns whether the listing computes the run, or did before its latest text stopped compiling. The step's own
    /// method at its own step size computes the step's listing. Otherwise the panel shows the page of the method and
    /// offers use().
    bool isInUse() const;
    /// Returns whether the run is computed by text() itself, so that lines and values belong to it.
    bool isRunning() const { return isInUse() && !draft(); }
    /// Returns the mistakes of text(), in its order. Empty if it compiles.
    std::vector<CodeMistake> mistakes() const;
    /// Returns the program of text(), or null if it does not compile.
    std::shared_ptr<const listing::Program> program() const;
    /// Returns the mistake that ended the run, if its own code did.
    std::optional<listing::RunError> runError() const;

    /// Replaces the text. If the listing is in use and the text compiles, the run is computed again up to the cursor, and
    /// the previous run becomes the ghost. Edits without a TypingPause between them are one undo entry, unless
    /// RunEditor::endGesture() was called between them. A text of more than listing::maxTextBytes is a mistake.
    void write(const QString &text);
    /// Replaces the text by the step's listing. If the text was in use, the step's own method computes the run then. It can
    /// be undone.
    void reset();
    /// Replaces the text by the step's listing without the lines that `task` asks for. None of them names the previous run.
    void removeLines(const lessons::CodeTask &task);
    /// Makes the text compute the run: as *Your code*, or by the step's own method if it is the step's listing. If the
    /// text does not compile, says so, and changes nothing.
    void use();

    /// Compiles `text` for the names of the open step's scene. The last results are cached.
    const listing::Compiled &compiled(const QString &text) const;

    /// Returns the names of the open step's scene.
    const listing::Vocabulary &vocabulary() const;

signals:
    /// reset() is about to replace the text.
    void wasReset();

private:
    bool isOwnMethod() const;
    void set(const QString &text, const EditLabel &label);
    /// Returns the method that computes `text`, which `program` was compiled from.
    std::pair<sim::MethodPtr, sim::StepSize>
    methodOf(const QString &text, const std::shared_ptr<const listing::Program> &program) const;

    OpenRun &m_run;
    RunEditor &m_editor;
    TypingPause m_pause;
    mutable RecentResults<std::pair<QString, listing::Vocabulary>, listing::Compiled> m_compiled;
    mutable listing::Vocabulary m_names;
    mutable std::pair<const lessons::Step *, sim::Values> m_namesOf; ///< what m_names was found in
};

}
