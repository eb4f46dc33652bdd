#pragma once

#include "app/model/code/source_files.h"
#include "lessons/api/step.h"
#include "sim/run/timeline.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace app {

/// A line of code in the code panel.
struct CodeLine
{
    SourceLine source;
    QString file;       ///< relative to the project's top folder
    bool isNew = false; ///< the previous step does not have this line
    bool isPlumbing =
        false;            ///< method code that sums up the results of the effects: the same for all effects
    bool isQuiet = false; ///< the line computes nothing itself: plumbing, signatures, braces, plain returns
    friend bool operator==(const CodeLine &, const CodeLine &) = default;

    /// Returns the line without its comment and surrounding spaces. Empty for blank lines and comment lines.
    QString code() const;
};

/// A line that only the previous step has, with its former position.
struct GoneLine
{
    std::size_t before =
        0; ///< index of the section's line that followed it; the number of lines if it was the last
    QString text;
    QString file;
    friend bool operator==(const GoneLine &, const GoneLine &) = default;
};

/// The code of one part of the step: its set-up, the order of phases, or a phase.
struct CodeSection
{
    enum class Role {
        scene, ///< set-up of the step
        order, ///< order in which the method runs the phases
        phase, ///< one phase, or the same phase of several groups
    };
    Role role = Role::phase;
    QString title;
    sim::EffectKind kind = sim::EffectKind::motion;
    std::vector<int> phases; ///< indices into the pipeline's phases; empty for scene and order
    std::vector<CodeLine> lines;
    std::vector<GoneLine> gone = {}; ///< in order
    friend bool operator==(const CodeSection &, const CodeSection &) = default;

    /// Returns the files that the lines come from, each once, in order.
    QStringList files() const;
    bool has(int phase) const;
};

/// All code that runs for a step, in the order in which it runs.
struct CodeListing
{
    std::vector<CodeSection> sections;
    friend bool operator==(const CodeListing &, const CodeListing &) = default;

    /// Returns the number of new lines. A line that runs in several places counts once.
    int newLines() const;
    /// Returns the number of removed lines.
    int goneLines() const;
};

/// Returns the set-up of `step`, then the order of phases of `method`, then the phases of `interval`. Phases of
/// different groups with the same source share a section.
CodeListing listingOf(const lessons::Step &step, const sim::ComposedInterval &interval,
                      const sim::Method &method);

/// Returns the listing of `step` with its default settings, computed by `method`. If `method` does not fit, the step's
/// own method is used. Empty if neither fits.
std::optional<CodeListing> listingAtStart(const lessons::Step &step, const sim::MethodPtr &method);

/// Marks the lines of `listing` that `before` does not have. Blank lines and lone braces never count as new.
void markNew(CodeListing &listing, const CodeListing &before);

/// Adds the lines that only `before` has, at their former positions. A section of `before` corresponds to the section
/// that has most of its lines. Blank lines and lone braces never count as removed. A line that ran in several places is
/// removed once.
void markGone(CodeListing &listing, const CodeListing &before);

/// Returns the name of the file without its folder.
QString fileName(const QString &file);

}
