#pragma once

#include <QString>

#include <cstdint>

namespace app {

/// What the window is arranged for.
enum class WindowMode { learn, measure, build };

/// What a window that closes to open again leaves to the one that comes, besides the settings and what is kept.
struct Left
{
    QString lesson; ///< ids of the open step
    QString step;
    QString file;              ///< of its experiment; empty: it has none
    std::int64_t frame = 0;    ///< where its cursor stands
    std::int64_t computed = 0; ///< the last frame that the run came to
    WindowMode mode = WindowMode::learn;
};

}
