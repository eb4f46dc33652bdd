#include "app/model/web/number_columns.h"

#include <QtEndian>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace app {

namespace {

constexpr char exactKind = 0;
constexpr char shortKind = 1;
/// The largest multiple. Distances of four times as much still fit into the 53 bits of JavaScript's numbers.
constexpr double mostMultiple = 1e15;

void appendWhole(QByteArray &bytes, std::int64_t number)
{
    auto code = static_cast<std::uint64_t>(number < 0 ? -2 * number - 1 : 2 * number);
    for (; code >= 128; code >>= 7)
        bytes.append(static_cast<char>(code % 128 + 128));
    bytes.append(static_cast<char>(code));
}

}

qsizetype NumberColumns::addRounded(std::span<const double> values, int bits)
{
    const auto multiple = [bits](double value) { return std::ldexp(value, bits); };
    const bool fits = std::all_of(values.begin(), values.end(),
                                  [&](double value) { return std::abs(multiple(value)) <= mostMultiple; });
    if (!fits)
        return addExact(values);
    const qsizetype at = m_bytes.size();
    m_bytes.append(static_cast<char>(bits));
    std::int64_t last = 0, step = 0;
    for (const double value : values) {
        const std::int64_t now = std::llround(multiple(value));
        appendWhole(m_bytes, now - (last + step));
        step = now - last;
        last = now;
    }
    return at;
}

qsizetype NumberColumns::addExact(std::span<const double> values)
{
    const qsizetype at = m_bytes.size();
    m_bytes.append(exactKind);
    for (const double value : values) {
        char bytes[sizeof value];
        qToLittleEndian(value, bytes);
        m_bytes.append(bytes, sizeof bytes);
    }
    return at;
}

qsizetype NumberColumns::addShort(std::span<const double> values)
{
    const qsizetype at = m_bytes.size();
    m_bytes.append(shortKind);
    for (const double value : values) {
        char bytes[sizeof(float)];
        const bool fits = std::abs(value) <= std::numeric_limits<float>::max();
        qToLittleEndian(fits ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN(), bytes);
        m_bytes.append(bytes, sizeof bytes);
    }
    return at;
}

}
