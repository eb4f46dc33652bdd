#include "app/cli/plot_axis.h"

#include <algorithm>

namespace app {

LogAxis::LogAxis(const std::vector<double> &values, double from, double to) : m_from(from), m_to(to)
{
    bool isFirst = true;
    for (const double value : values) {
        if (!(value > 0.0) || !std::isfinite(value))
            continue;
        const int low = static_cast<int>(std::floor(std::log10(value)));
        const int high = static_cast<int>(std::ceil(std::log10(value)));
        m_first = isFirst ? low : std::min(m_first, low);
        m_last = isFirst ? high : std::max(m_last, high);
        isFirst = false;
    }
    m_last = std::max(m_last, m_first + 1);
}

void spreadOut(std::vector<double> &places, double gap, double from, double to)
{
    double least = from;
    for (double &place : places) {
        place = std::max(place, least);
        least = place + gap;
    }
    double most = to;
    for (auto place = places.rbegin(); place != places.rend(); ++place) {
        *place = std::min(*place, most);
        most = *place - gap;
    }
}

}
