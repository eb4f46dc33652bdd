#include "sim/finite.h"

#include "sim/wide.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace sim {

namespace {

/// A part that one thread looks at: about 20 us, far more than handing it out takes.
constexpr int pointsInPart = 16'384;

/// The columns of what points have, one number a point. Those that a state lacks are not among them.
class Columns
{
public:
    explicit Columns(const State &state)
    {
        add(state.position);
        add(state.velocity);
        add(state.acceleration);
        add(state.angle);
        add(state.spin);
        add(state.turning);
    }
    const double *const *begin() const { return m_columns.data(); }
    const double *const *end() const { return m_columns.data() + m_count; }

private:
    template <class Array>
    void add(const Array &array)
    {
        for (Eigen::Index column = 0; array.rows() > 0 && column < array.cols(); ++column)
            m_columns[m_count++] = array.data() + column * array.rows();
    }

    std::array<const double *, 9> m_columns{};
    std::size_t m_count = 0;
};

}

bool areFinite(const State &state, Points points)
{
    const Columns columns(state);
    std::int64_t others = 0;
    runFast([&] {
        std::int64_t found = 0;
        for (const double *const column : columns) {
            // x - x is 0 for every finite x, and NaN for the others
            for (int i = points.first; i < points.end(); ++i)
                found |= column[i] - column[i] == 0.0 ? std::int64_t{0} : std::int64_t{1};
        }
        others = found;
    });
    return others == 0;
}

bool isFinite(const State &state, Crew &crew)
{
    if (!state.gait.isFinite().all() || !state.gaitSpeed.isFinite().all())
        return false;
    const int points = state.points();
    const int parts = points / pointsInPart;
    if (parts < 2)
        return areFinite(state, {0, points});
    std::atomic<bool> all = true;
    crew.share(parts, [&](int part) {
        const auto from = [&](int number) { return static_cast<int>(std::int64_t{points} * number / parts); };
        if (!areFinite(state, {from(part), from(part + 1) - from(part)}))
            all = false;
    });
    return all;
}

}
