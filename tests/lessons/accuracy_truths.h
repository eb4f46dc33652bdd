#pragma once

#include <cmath>

/// What the scenes of the lesson `accuracy` come to, in closed form.
namespace support {

/// Where a spring without damping, let go `amplitude` px away, has its foot after `frames`.
inline double cosine(double amplitude, double k, double frames)
{
    return amplitude * std::cos(std::sqrt(k) * frames);
}

/// How high above the floor a ball is that falls from `height` and keeps the share `bounce` of its speed.
inline double bouncingHeight(double height, double gravity, double bounce, double frames)
{
    double left = frames - std::sqrt(2 * height / gravity);
    if (left < 0.0)
        return height - 0.5 * gravity * frames * frames;
    double speed = std::sqrt(2 * height * gravity);
    for (int i = 0; i < 200; ++i) {
        speed *= bounce;
        const double flight = 2 * speed / gravity;
        if (left < flight)
            return speed * left - 0.5 * gravity * left * left;
        left -= flight;
    }
    return 0.0;
}

}
