#pragma once

#include <QColor>

namespace app {

/// Returns the mix of two opaque colours: `from` at 0, `to` at 1.
QColor mixed(const QColor &from, const QColor &to, double share);

}
