#include "app/ui/dock/progress_line.h"

namespace app {

namespace {

constexpr int thickness = 6;   ///< px
constexpr int fullRange = 100; ///< percent

}

ProgressLine::ProgressLine(const QString &name, QWidget *parent) : QProgressBar(parent)
{
    setRange(0, fullRange);
    setTextVisible(false);
    setFixedHeight(thickness);
    setAccessibleName(name);
}

void ProgressLine::setShare(double share)
{
    const int next = qRound(fullRange * share);
    if (next == value())
        return;
    // setValue() calls repaint(), which does nothing while updates are disabled. Enabling them again calls
    // update().
    setUpdatesEnabled(false);
    setValue(next);
    setUpdatesEnabled(true);
}

}
