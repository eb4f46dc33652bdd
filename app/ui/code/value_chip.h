#pragma once

#include <QRect>
#include <QString>
#include <QStringList>

class QColor;
class QPainter;

namespace app {

class Theme;

/// The space for a value at the right end of a line of code.
struct ChipRoom
{
    QRect row;                 ///< of the line, over the full width of the viewport
    int endOfCode = 0;         ///< x of the end of the code, without a trailing comment
    bool hasScrollBar = false; ///< whether there is a scroll bar on the right
};

/// A value on a rounded background, at the right end of a line of code.
struct ValueChip
{
    enum class Look {
        plain,
        changed, ///< the value has just changed
        now,     ///< the line is the current one
        earlier, ///< the value belongs to an earlier moment
    };

    QRect rect;   ///< empty without a value
    QRect cover;  ///< the part of the line that the chip needs for itself
    QString text; ///< the longest form that fits, or "…"

    /// Paints the chip, and before it `behind` over the end of a long line or comment.
    void paint(QPainter &painter, Look look, const QColor &behind, const Theme &theme) const;
};

/// Places a value. `forms` are its texts, longest first. A value is never cut: a part of a number would look like
/// another number.
ValueChip fitChip(const QStringList &forms, const ChipRoom &room, const Theme &theme);

}
