#pragma once

#include <Qt>

namespace app {

/// The keys of the code. They work on its current line or word.
namespace codeKeys {

inline constexpr Qt::Key toggleBreakpoint = Qt::Key_F9;
inline constexpr Qt::Key changeNumber = Qt::Key_F2;
inline constexpr Qt::Key showRemovedLines = Qt::Key_F8;
inline constexpr QKeyCombination showValue = Qt::CTRL | Qt::Key_I;
inline constexpr QKeyCombination completeName = Qt::CTRL | Qt::Key_Space;

}

}
