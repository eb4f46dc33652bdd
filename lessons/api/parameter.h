#pragma once

#include "sim/scene/parameter_spec.h"

#include <QString>
#include <QStringList>

namespace lessons {

/// The meaning of a parameter for the whole run.
using ParameterRole = sim::ParameterRole;

/// The scale of a slider.
enum class Scale {
    linear,      ///< equal differences have equal lengths
    logarithmic, ///< equal ratios have equal lengths; sliderMin is a power of ten
};

/// A number or choice that a learner sets. The panel, tooltips, files and the command line all read this
/// declaration.
struct Parameter
{
    QString id = {};     ///< name in files and in the shown code
    QString name = {};   ///< name in the window
    QString symbol = {}; ///< in formulas; may be empty
    QString unit = {};   ///< may be empty
    QString help = {};   ///< one sentence: the effect of the parameter
    double defaultValue = 0.0;
    double min = 0.0;         ///< smallest value accepted
    double max = 1.0;         ///< largest value accepted
    double sliderMin = 0.0;   ///< value at the left end of the slider
    double sliderMax = 1.0;   ///< value at the right end
    int decimals = 2;         ///< digits shown after the decimal point
    QStringList choices = {}; ///< ids; if not empty, the value is an index of this list
    bool isInteger = false;   ///< whether only whole numbers are valid
    ParameterRole role = ParameterRole::none;
    QStringList choiceTitles = {}; ///< shown in place of the ids; may be empty
    QStringList choiceHelps = {};  ///< one sentence per choice; may be empty
    /// Whether a change of the value starts a new run, in which all other parameters have their default
    /// values.
    bool restartsRun = false;
    Scale scale = Scale::linear;
    /// Ids of the effects that read the parameter. Where a learner chooses effects, the panel shows the
    /// parameter while one of these is in the scene. Empty: always shown.
    QStringList effects = {};
};

// Long lists of choices have titles with a group in front, for example "Stiff springs › at the limit". The
// titles of a group are neighbours, and the panel shows a submenu for each group.

/// Returns the separator between a group and a title.
inline QString groupEnd()
{
    return QStringLiteral(" › ");
}

/// Returns `title` with its group in front.
inline QString grouped(const QString &group, const QString &title)
{
    return group + groupEnd() + title;
}

/// Returns the group of a title. Empty if the title has none.
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
