#pragma once

#include <QByteArray>

#include <span>

namespace app {

/// Columns of numbers as bytes, which page/numbers.js reads. A column begins with a byte for its kind:
///
/// - 0: numbers of 8 bytes, little-endian,
/// - 1: numbers of 4 bytes, little-endian,
/// - B, from 2 on: multiples of 2^-B. Each is stored as its distance from the line through the two before, because
///   bodies move smoothly. The distances d are whole numbers, written as 2d or −2d − 1, with 7 bits in a byte, the lowest
///   first. A byte of 128 or more is followed by another one.
class NumberColumns
{
public:
    /// Appends `values`, rounded to multiples of 2^-`bits`. If a number is too large for that, all are stored exactly.
    /// Returns the position of the column.
    qsizetype addRounded(std::span<const double> values, int bits);
    /// Appends `values` with seven digits each. Those over 3e38 become NaN, as missing ones are. Returns the position of the
    /// column.
    qsizetype addShort(std::span<const double> values);

    const QByteArray &bytes() const { return m_bytes; }

private:
    qsizetype addExact(std::span<const double> values);

    QByteArray m_bytes;
};

}
