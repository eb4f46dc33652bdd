#pragma once

#include "app/model/code/code_values.h"

#include <QString>

#include <optional>
#include <vector>

namespace app {

/// The state of a section while time is stopped inside a frame.
enum class When { plain, done, now, next, later };

struct SectionMark
{
    When when = When::plain;
    int phase = -1;                    ///< the phase of the section that this mark describes
    bool selected = false;             ///< whether that phase works on the point whose values are shown
    QString note;                      ///< "done · 10 pulls"
    QString shortNote;                 ///< "done"
    std::optional<std::size_t> result; ///< with `now`: the line that shows the result of the phase
    friend bool operator==(const SectionMark &, const SectionMark &) = default;
};

/// Returns one mark per section. At the end of a frame the frame's last phase is `now`, until the next step begins. All
/// sections are plain before the first frame. `chips` are the values of `point`, from chipsOf().
std::vector<SectionMark> marksOf(const CodeListing &listing, const sim::Timeline &timeline,
                                 const std::vector<CodeChip> &chips, int point);

}
