#pragma once

#include "lessons/api/text/document_scan.h"
#include "lessons/api/text/run_setup.h"

#include <QString>

#include <optional>

namespace lessons {

/// A parameter that the document of a lesson without C++ declares. The numbers are in the lesson's own document; a
/// translation has the texts, and may repeat the numbers.
struct ParameterText
{
    QString id;
    QString name;      ///< in the window
    QString help = {}; ///< one sentence: the effect of the parameter
    QString unit = {};
    std::optional<double> value = {};
    std::optional<double> minimum = {};
    std::optional<double> maximum = {};
    std::optional<double> step = {}; ///< the smallest change: 1, 0.1, 0.01... down to 0.000001
    /// The lengths and stiffnesses of the scene that it sets, as written: "k of nail-lamp". Empty: the rule reads it.
    std::optional<ListItem> sets = {};
    int line = 0; ///< of its heading, from 1
};

/// Reads the text and the list below a heading “## Parameter: NAME {#ID}”. A list may be missing. `file` is the name that
/// errors show.
/// @throws DocumentError if the text is missing, or an item of the list is unknown, there twice, or has a wrong value
ParameterText parseParameter(const DocumentPart &part, const QString &name, const QString &id,
                             const QString &file);

}
