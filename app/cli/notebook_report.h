#pragma once

#include "app/model/notebook/notebook_check.h"

#include <QString>

#include <vector>

namespace app {

/// A notebook that was checked, or why it could not be read.
struct CheckedNotebook
{
    QString file; ///< the name as given on the command line
    Notebook notebook = {};
    std::vector<NotebookFinding> findings = {}; ///< one for each entry
    QString mistake = {};                       ///< empty: it could be read

    /// Returns whether the runs show every entry, and the seal is intact.
    bool holds() const;
};

/// Returns the result of a check as a table to read, as CSV, and as JSON. Notebooks that could not be read are only in the
/// JSON.
QString notebookTable(const std::vector<CheckedNotebook> &all);
QString notebookCsv(const std::vector<CheckedNotebook> &all);
QString notebookJson(const std::vector<CheckedNotebook> &all);

}
