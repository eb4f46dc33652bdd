#pragma once

#include "app/model/difference_course.h"

#include <QByteArray>

namespace app {

/// How far two runs are apart, as comma-separated text: a row each frame that was looked at, with the distance and the body
/// that it is of. Empty where nothing is compared.
QByteArray differenceTable(const DifferenceCourse &course);

}
