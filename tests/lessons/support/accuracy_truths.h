#pragma once

#include <cmath>

/// Closed-form solutions of the scenes of the lesson `accuracy`.
namespace support {

/// Returns the displacement of an undamped spring after `frames`, in px. It starts at rest, `amplitude` px
/// from its centre. Mass 1, `k` in mass/frame^2.
inline double springDisplacement(double amplitude, double k, double frames)
{
    return amplitude * std::cos(std::sqrt(k) * frames);
}

/// Returns the height of a bouncing ball above the floor after `frames`, in px. The ball falls from rest at
/// `height`. `gravity` is in px/frame^2. Each contact multiplies its speed by `bounce`.
inline double bouncingHeight(double height, double gravity, double bounce, double frames)
{
    double remaining = frames - std::sqrt(2 * height / gravity);
    if (remaining < 0.0)
        return height - 0.5 * gravity * frames * frames;
    double speed = std::sqrt(2 * height * gravity);
    for (int i = 0; i < 200; ++i) {
        speed *= bounce;
        const double flight = 2 * speed / gravity;
        if (remaining < flight)
            return speed * remaining - 0.5 * gravity * remaining * remaining;
        remaining -= flight;
    }
    return 0.0;
}

}
