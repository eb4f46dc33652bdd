#pragma once

#include "app/model/source_book.h"
#include "lessons/api/step.h"
#include "sim/run/timeline.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace app {

/// A line of shown code.
struct CodeLine
{
    SourceLine source;
    QString file;            ///< from the project's top folder
    bool isNew = false;      ///< the step before does not have it
    bool isPlumbing = false; ///< how the method adds up what an effect has computed: the same for all effects
    bool isQuiet = false;    ///< it computes nothing of its own: plumbing, signatures, braces, plain returns
    friend bool operator==(const CodeLine &, const CodeLine &) = default;

    /// Without its comment and the spaces around it; empty for a line that is nothing else.
    QString code() const;
};

/// A line that only the step before has, at the place where it was.
struct GoneLine
{
    std::size_t before = 0; ///< it stood before this line of the section; one more than the last: at its end
    QString text;
    QString file;
    friend bool operator==(const GoneLine &, const GoneLine &) = default;
};

/// The code of one thing that runs.
struct CodeSection
{
    enum class Role {
        scene, ///< the step's set-up
        order, ///< how the method orders the phases
        phase, ///< one phase, or the same phase of several groups
    };
    Role role = Role::phase;
    QString title;
    sim::EffectKind kind = sim::EffectKind::motion;
    std::vector<int> phases; ///< indices into the pipeline's phases; empty for scene and order
    std::vector<CodeLine> lines;
    std::vector<GoneLine> gone = {}; ///< in order
    friend bool operator==(const CodeSection &, const CodeSection &) = default;

    /// The files that the lines are from, each once, in order.
    QStringList files() const;
    bool has(int phase) const;
};

/// All code that runs for a step, in the order in which it runs.
struct CodeListing
{
    std::vector<CodeSection> sections;
    friend bool operator==(const CodeListing &, const CodeListing &) = default;

    /// Lines that are new; one that runs in several places counts once.
    int newLines() const;
    /// Lines that are gone.
    int goneLines() const;
};

/// The set-up of `step`, then the method's order, then the phases of `segment`. Phases of different groups with the
/// same source share a section.
CodeListing listingOf(const lessons::Step &step, const sim::ComposedInterval &interval,
                      const sim::Method &method);

/// The listing of a step that nobody has touched, computed by `method` or, where that does not fit, by the
/// step's own; empty when neither does.
std::optional<CodeListing> listingAtStart(const lessons::Step &step, const sim::MethodPtr &method);

/// Marks the lines of `listing` that `before` does not have. Blank lines and lone braces are never new.
void markNew(CodeListing &listing, const CodeListing &before);

/// Puts the lines that only `before` has to where they were: what one section of it became is the section that has most
/// of its lines. Blank lines and lone braces are never gone, and one that ran in several places goes once.
void markGone(CodeListing &listing, const CodeListing &before);

/// The file's name without its folder.
QString fileName(const QString &file);

}
