#pragma once

#include "app/model/catalog/lesson_library.h"

namespace tests {

/// Returns two small lessons. "one" has the steps "first", with a thing to try (wait five frames), and "second". "two" has
/// the step "many", with seven parameters, among them a choice ("formula") and a count ("feet").
app::LessonLibrary twoLessons();

/// Returns the step as "puppet": the same scene, whose points store no velocities.
lessons::Step puppetOf(lessons::Step step);

}
