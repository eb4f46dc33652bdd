#pragma once

#include <QString>

namespace app {

/// Returns "first, second".
QString listed(const QString &first, const QString &second);
/// Returns "name: text".
QString labelled(const QString &name, const QString &text);
/// Returns "part of whole", as in "2 of 5".
QString partOf(const QString &part, const QString &whole);
/// Returns "name (remark)".
QString withRemark(const QString &name, const QString &remark);
/// Returns "number px".
QString pixels(const QString &number);
/// Returns the heading of a column or an axis of frames.
QString frameHeading();
/// Returns "frame 12".
QString frameName(std::int64_t frame);
/// Returns "1 point" or "12 points".
QString pointCount(std::int64_t count);

}
