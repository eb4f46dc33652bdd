#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace app {

/// Numbers of neighbouring rows of a run, several to a row. Where there are too many rows to keep each, some of them
/// share a bucket, which keeps the first number, the lowest and the highest: what a plot needs to draw them all.
class Samples
{
public:
    /// What one bucket keeps of one column; NaN where no row has a number.
    struct Bucket
    {
        double first = 0.0;
        double low = 0.0;
        double high = 0.0;
    };

    Samples() = default;
    /// From the row at frame `first` on. `stride`: rows that share a bucket.
    Samples(std::size_t columns, std::int64_t first, int framesPerOutput, std::int64_t stride);

    std::size_t columns() const { return m_columns; }
    std::int64_t stride() const { return m_stride; }
    std::int64_t firstFrame() const { return m_first; }
    /// The frame of the row that comes next.
    std::int64_t nextFrame() const { return m_first + m_rows * m_framesPerOutput; }
    /// How many buckets there are.
    std::size_t size() const { return m_columns == 0 ? 0 : m_buckets.size() / m_columns; }
    bool isEmpty() const { return m_rows == 0; }
    const Bucket &at(std::size_t bucket, std::size_t column) const
    {
        return m_buckets[bucket * m_columns + column];
    }
    /// The frame of the first row of a bucket.
    std::int64_t frameOf(std::size_t bucket) const
    {
        return m_first + static_cast<std::int64_t>(bucket) * m_stride * m_framesPerOutput;
    }
    /// The bucket of the row at `frame`, or the nearest there is. There must be one.
    std::size_t bucketNear(std::int64_t frame) const;

    /// Adds the next row: one number a column.
    void add(std::span<const double> row);
    /// Forgets the rows after `frame`, with others that share a bucket with them.
    void forgetAfter(std::int64_t frame);
    /// Forgets the buckets before the one that begins at `frame`.
    void forgetBefore(std::int64_t frame);
    /// Each two neighbouring buckets become one.
    void thin();

private:
    std::size_t m_columns = 0;
    std::int64_t m_first = 0;
    std::int64_t m_rows = 0;
    std::int64_t m_stride = 1;
    int m_framesPerOutput = 1;
    std::vector<Bucket> m_buckets; ///< by bucket, then by column
};

}
