#pragma once

#include <sstream>
#include <string>

namespace sim {

/// Returns `value` with three significant digits, for the values of an Error.
inline std::string numberText(double value)
{
    std::ostringstream stream;
    stream.precision(3);
    stream << value;
    return stream.str();
}

}
