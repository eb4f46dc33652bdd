#pragma once

#include "app/model/code/code_listing.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace app {

/// A row of the code view.
struct CodeRow
{
    enum class Kind {
        heading, ///< heading of a section
        file,    ///< the file of the lines below, where the file changes within a section
        code,
        gone, ///< a removed line of the previous step, at its old place
        gap,  ///< empty row below a section
    };
    Kind kind = Kind::gap;
    std::size_t section = 0;
    std::size_t line = 0; ///< index in the section, for code
    QString text;
    QByteArray inks;         ///< the style of each byte of the text
    bool isPlumbing = false; ///< see CodeLine; for a file name: whether such lines follow
    friend bool operator==(const CodeRow &, const CodeRow &) = default;
};

/// Whether lines that the step removed are shown.
enum class Gone { hidden, shown };

/// Returns the rows that show `listing`, from top to bottom.
std::vector<CodeRow> rowsOf(const CodeListing &listing, Gone gone);

/// Returns the key that identifies a section across steps, for example to remember that it is folded.
QString keyOf(const CodeSection &section);
/// Returns the key for the lines that add up an effect's results. All of these lines fold together.
QString keyOfPlumbing();

/// Returns a section as text, with the file and first line number of each part of its code.
QString plainText(const CodeSection &section);

}
