#include "app/ui/scene/drawing/line_clip.h"

#include <algorithm>

namespace app {

std::optional<std::pair<double, double>> partWithin(const QRectF &box, QPointF from, QPointF to)
{
    double start = 0.0, end = 1.0;
    const auto cut = [&](double at, double way, double low, double high) {
        if (way == 0.0)
            return at >= low && at <= high;
        const auto [in, out] = std::minmax({(low - at) / way, (high - at) / way});
        start = std::max(start, in);
        end = std::min(end, out);
        return start < end;
    };
    const bool isInside = cut(from.x(), to.x() - from.x(), box.left(), box.right()) &&
                          cut(from.y(), to.y() - from.y(), box.top(), box.bottom());
    return isInside ? std::optional(std::pair(start, end)) : std::nullopt;
}

}
