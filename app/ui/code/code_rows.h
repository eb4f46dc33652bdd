#pragma once

#include "app/model/code_listing.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace app {

/// A line of the code view.
struct CodeRow
{
    enum class Kind {
        heading, ///< of a section
        file,    ///< where the lines below are from, when that changes within a section
        code,
        gone, ///< a line of the step before, where it was
        gap,  ///< below a section
    };
    Kind kind = Kind::gap;
    std::size_t section = 0;
    std::size_t line = 0; ///< in the section, for code
    QString text;
    QByteArray inks;         ///< the style of each byte of the text
    bool isPlumbing = false; ///< see CodeLine; of a file's name: whether such lines follow
    friend bool operator==(const CodeRow &, const CodeRow &) = default;
};

/// What is shown of lines that are gone.
enum class Gone { hidden, shown };

/// The lines that show `listing`, from top to bottom.
std::vector<CodeRow> rowsOf(const CodeListing &listing, Gone gone);

/// What is remembered of a section across steps, for example that it is folded.
QString keyOf(const CodeSection &section);
/// The same for the lines that add up what an effect has computed: they fold together.
QString keyOfPlumbing();

/// A section as text, with the files and first lines that its code is from.
QString plainText(const CodeSection &section);

}
