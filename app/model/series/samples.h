#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace app {

/// Numbers of consecutive output steps of a run, with several columns. If there are too many output steps to store,
/// several of them share a bucket. A bucket stores the first, lowest and highest number, which is enough to plot them
/// all.
class Samples
{
public:
    /// The numbers of one column in one bucket; NaN if no output step has a number.
    struct Bucket
    {
        double first = 0.0;
        double low = 0.0;
        double high = 0.0;
    };

    Samples() = default;
    /// Starts at the output step at frame `first`. `stride` output steps share a bucket.
    Samples(std::size_t columns, std::int64_t first, int framesPerOutput, std::int64_t stride);

    std::size_t columns() const { return m_columns; }
    std::int64_t stride() const { return m_stride; }
    std::int64_t firstFrame() const { return m_first; }
    /// Returns the frame of the next output step to add.
    std::int64_t nextFrame() const { return m_first + m_outputSteps * m_framesPerOutput; }
    /// Returns the number of buckets.
    std::size_t size() const { return m_columns == 0 ? 0 : m_buckets.size() / m_columns; }
    bool isEmpty() const { return m_outputSteps == 0; }
    const Bucket &at(std::size_t bucket, std::size_t column) const
    {
        return m_buckets[bucket * m_columns + column];
    }
    /// Returns the frame of the first output step in a bucket.
    std::int64_t frameOf(std::size_t bucket) const
    {
        return m_first + static_cast<std::int64_t>(bucket) * m_stride * m_framesPerOutput;
    }
    /// Returns the bucket of the output step at `frame`, or the nearest one. There must be at least one.
    std::size_t bucketNear(std::int64_t frame) const;

    /// Adds the next output step, with one number per column.
    void add(std::span<const double> values);
    /// Drops the output steps after `frame`, and the others that share a bucket with them.
    void forgetAfter(std::int64_t frame);
    /// Drops the buckets before the one that starts at `frame`.
    void forgetBefore(std::int64_t frame);
    /// Merges each pair of neighbouring buckets.
    void thin();

private:
    std::size_t m_columns = 0;
    std::int64_t m_first = 0;
    std::int64_t m_outputSteps = 0;
    std::int64_t m_stride = 1;
    int m_framesPerOutput = 1;
    std::vector<Bucket> m_buckets; ///< by bucket, then by column
};

}
