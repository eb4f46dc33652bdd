#pragma once

#include "app/model/difference_course.h"

namespace app {

/// The largest difference and where it is: "Largest: 12 px apart, foot 3, at frame 97." Or why there is none.
QString differenceSentence(const DifferenceCourse &course);

/// A branch on one line of a menu: its name, where it parts from the run, and whether it is kept.
QString branchLine(const Branch &branch, const sim::Script &run);

}
