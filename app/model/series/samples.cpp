#include "app/model/series/samples.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

/// Merges a later bucket into `bucket`. NaN is ignored.
void take(Samples::Bucket &bucket, const Samples::Bucket &later)
{
    bucket.low = std::fmin(bucket.low, later.low);
    bucket.high = std::fmax(bucket.high, later.high);
}

}

Samples::Samples(std::size_t columns, std::int64_t first, int framesPerOutput, std::int64_t stride)
    : m_columns(columns), m_first(first), m_stride(stride), m_framesPerOutput(framesPerOutput)
{
}

std::size_t Samples::bucketNear(std::int64_t frame) const
{
    const std::int64_t bucket = (frame - m_first) / (m_stride * m_framesPerOutput);
    return static_cast<std::size_t>(
        std::clamp<std::int64_t>(bucket, 0, static_cast<std::int64_t>(size()) - 1));
}

void Samples::add(std::span<const double> values)
{
    const bool begins = m_outputSteps % m_stride == 0;
    for (std::size_t column = 0; column < m_columns; ++column) {
        const Bucket one{values[column], values[column], values[column]};
        if (begins)
            m_buckets.push_back(one);
        else
            take(m_buckets[m_buckets.size() - m_columns + column], one);
    }
    ++m_outputSteps;
}

void Samples::forgetAfter(std::int64_t frame)
{
    if (frame >= nextFrame() - m_framesPerOutput)
        return;
    const std::int64_t steps = frame < m_first ? 0 : (frame - m_first) / m_framesPerOutput + 1;
    const std::int64_t buckets = steps / m_stride;
    m_buckets.resize(static_cast<std::size_t>(buckets) * m_columns);
    m_outputSteps = buckets * m_stride;
}

void Samples::forgetBefore(std::int64_t frame)
{
    const std::int64_t wide = m_stride * m_framesPerOutput;
    const std::int64_t buckets =
        std::clamp<std::int64_t>((frame - m_first) / wide, 0, static_cast<std::int64_t>(size()));
    m_buckets.erase(m_buckets.begin(), m_buckets.begin() + static_cast<std::ptrdiff_t>(buckets) *
                                                               static_cast<std::ptrdiff_t>(m_columns));
    m_first += buckets * wide;
    m_outputSteps = std::max<std::int64_t>(0, m_outputSteps - buckets * m_stride);
}

void Samples::thin()
{
    const std::size_t count = size();
    for (std::size_t bucket = 0; bucket < count; ++bucket) {
        for (std::size_t column = 0; column < m_columns; ++column) {
            const Bucket one = at(bucket, column);
            Bucket &into = m_buckets[bucket / 2 * m_columns + column];
            if (bucket % 2 == 0)
                into = one;
            else
                take(into, one);
        }
    }
    m_buckets.resize((count + 1) / 2 * m_columns);
    m_stride *= 2;
}

}
