#pragma once

#include <cstdint>
#include <deque>

namespace app {

/// Values at the ends of consecutive output steps of a run.
template <class Value>
class FrameSeries
{
public:
    /// Returns the value of the output step that ends at `frame`; null if there is none.
    const Value *at(std::int64_t frame) const
    {
        const std::int64_t index = (frame - m_first) / m_framesPerOutput;
        return frame >= m_first && index < count() ? &m_values[static_cast<std::size_t>(index)] : nullptr;
    }
    int framesPerOutput() const { return m_framesPerOutput; }
    /// Return the frames that have values: from first() to last(), both included. There are none if last() < first().
    std::int64_t first() const { return m_first; }
    std::int64_t last() const { return m_first + (count() - 1) * m_framesPerOutput; }
    bool isEmpty() const { return m_values.empty(); }

protected:
    /// Drops all values. The next one is that of frame `first`.
    void startAt(std::int64_t first, int framesPerOutput)
    {
        m_values.clear();
        m_first = first;
        m_framesPerOutput = framesPerOutput;
    }
    /// Adds the next value. Drops the first one if there are more than `most`.
    void append(Value value, std::size_t most)
    {
        m_values.push_back(std::move(value));
        if (m_values.size() <= most)
            return;
        m_values.pop_front();
        m_first += m_framesPerOutput;
    }
    /// Drops the values from `frame` on, which is after first(). Returns whether there were any.
    bool eraseFrom(std::int64_t frame)
    {
        if (last() < frame)
            return false;
        m_values.resize(static_cast<std::size_t>((frame - 1 - m_first) / m_framesPerOutput + 1));
        return true;
    }

private:
    std::int64_t count() const { return static_cast<std::int64_t>(m_values.size()); }

    std::deque<Value> m_values;
    std::int64_t m_first = 0;
    int m_framesPerOutput = 1;
};

}
