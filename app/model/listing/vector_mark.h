#pragma once

#include "app/model/listing/listing_frame.h"
#include "sim/base/vec2.h"

#include <QString>

#include <optional>
#include <vector>

namespace app {

/// A part of a line of the text.
struct TextRange
{
    int line = 1;   ///< from 1
    int column = 1; ///< from 1, in characters
    int length = 0;
    friend bool operator==(const TextRange &, const TextRange &) = default;
};

/// A Vec2 of the listing, drawn in the scene.
struct VectorMark
{
    enum class Kind {
        place,      ///< a cross at `to`
        difference, ///< an arrow from `from` to `to`
    };
    Kind kind = Kind::place;
    sim::Vec2 from = {}, to = {}; ///< px
    QString name;                 ///< as in the text: "target", "foot.velocity"
    TextRange range;              ///< of the name
    friend bool operator==(const VectorMark &, const VectorMark &) = default;
};

/// Returns the Vec2 whose name is at a position of `text` (both from 1; the column in characters), after `index` lines of
/// `frame`. The difference of two places is an arrow between them, also if it is multiplied; a velocity starts at its
/// body. Empty if there is no Vec2, or if it has no value yet.
std::optional<VectorMark> vectorMarkAt(const QString &text, int line, int column, const ListingFrame &frame,
                                       int index);

/// Returns the places in `text` that use `body`, a name of the scene such as "foot2": by its own name, by that of its
/// array, or by a variable that stands for it after `index` lines of `frame`, which may be null.
std::vector<TextRange> usesOf(const QString &text, const QString &body, const listing::Vocabulary &vocabulary,
                              const ListingFrame *frame, int index);

}
