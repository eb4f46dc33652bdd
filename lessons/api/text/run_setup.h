#pragma once

#include "lessons/api/prediction.h"
#include "lessons/api/text/document_scan.h"

#include <QString>

namespace lessons {

/// Reads the list below a heading such as “### Run”. lessons/README.md describes it. A list without `frames` is valid.
/// Names of parameters, bodies and methods are not looked up. `file` is the name that errors show.
/// @throws DocumentError if a line is no item of the list, or its value is wrong
RunSetup parseRunSetup(const DocumentPart &part, const QString &file);

/// Returns `run` with what `changes` says in addition, or in place of the same value.
RunSetup withChanges(RunSetup run, const RunSetup &changes);

/// An item “- name: value” of a list.
struct ListItem
{
    QString name;
    QString value;
    int line = 0; ///< from 1
};

/// Reads a list of items “- name: value”, one a line. Blank lines are skipped.
/// @throws DocumentError if a line is something else, or if there is none
std::vector<ListItem> parseList(const DocumentPart &part, const QString &file);

/// Returns the numbers in "300, 220"; empty if one of them is not a finite number.
std::vector<double> numbersIn(const QString &text);

}
