#pragma once

#include <QString>

namespace app {

/// `springstep trace FILE`: writes the run of an experiment as CSV. Returns the exit code.
int trace(const QString &file);

}
