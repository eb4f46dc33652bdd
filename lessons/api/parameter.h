#pragma once

#include "sim/scene/parameter_spec.h"

#include <QString>
#include <QStringList>

namespace lessons {

/// What a parameter is for the run as a whole.
using ParameterRole = sim::ParameterRole;

/// How the slider's way is divided.
enum class Scale {
    linear,      ///< the same way for the same difference
    logarithmic, ///< the same way from 1 to 10 as from 10 to 100; sliderMin is a power of ten
};

/// A number (or a choice) that a learner sets. Declared once: panel, range, tooltip, file and command line all
/// read this.
struct Parameter
{
    QString id = {};     ///< in files and in the shown code
    QString name = {};   ///< what a learner calls it
    QString symbol = {}; ///< as formulas write it; may be empty
    QString unit = {};   ///< may be empty
    QString help = {};   ///< one sentence: what it does
    double defaultValue = 0.0;
    double min = 0.0; ///< the least and the most that files may give
    double max = 1.0;
    double sliderMin = 0.0; ///< the stretch that the slider covers
    double sliderMax = 1.0;
    int decimals = 2;         ///< shown after the point
    QStringList choices = {}; ///< ids; when not empty the value is a position in this list
    bool isInteger = false;   ///< a count: nothing between two whole numbers
    ParameterRole role = ParameterRole::none;
    QStringList choiceTitles = {}; ///< what a learner reads in place of the ids; empty: the ids
    QStringList choiceHelps = {};  ///< one sentence each; may be empty
    /// Another value is another experiment: the run begins anew with it, as Step::opening has it.
    bool restartsRun = false;
    Scale scale = Scale::linear;
    /// Ids of the effects that read it, where a learner chooses effects: it is offered while one of them is in the scene.
    /// Empty: always.
    QStringList effects = {};

    bool hasWholeValues() const { return isInteger; }
};

// A choice among many has titles with a group before them: "Stiff springs › at the limit". Those of a group stand in a
// row, and the panel offers a submenu for each group.

/// Returns what stands between a group and a title.
inline QString groupEnd()
{
    return QStringLiteral(" › ");
}

/// Returns the title of a choice with the group that it belongs to.
inline QString grouped(const QString &group, const QString &title)
{
    return group + groupEnd() + title;
}

/// Returns the group of a title; empty where it names none.
inline QString groupOf(const QString &title)
{
    const qsizetype end = title.indexOf(groupEnd());
    return end < 0 ? QString() : title.left(end);
}

/// Returns a title without its group.
inline QString withoutGroup(const QString &title)
{
    const qsizetype end = title.indexOf(groupEnd());
    return end < 0 ? title : title.mid(end + groupEnd().size());
}

}
