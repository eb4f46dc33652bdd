#pragma once

#include <QString>

#include <cstdint>

namespace app {

/// What `springstep cost` is asked.
struct CostRequest
{
    QString what; ///< a file, or LESSON/STEP
    bool asJson = false;
    std::int64_t frame = 0; ///< the frames after this one are measured
};

/// `springstep cost`: what each effect of a scene costs in a frame. Returns the exit code.
int cost(const CostRequest &request);

}
