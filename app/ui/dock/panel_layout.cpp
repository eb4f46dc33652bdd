#include "app/ui/dock/panel_layout.h"

namespace app {

QString LayoutId::key() const
{
    switch (mode) {
    case WindowMode::measure:
        return isWide ? QStringLiteral("window/docksMeasureWide") : QStringLiteral("window/docksMeasure");
    case WindowMode::build:
        return QStringLiteral("window/docksBuild");
    case WindowMode::learn:
        break;
    }
    return QStringLiteral("window/docks");
}

bool hasRoomForPlots(QSize window)
{
    constexpr int high = 900; // px
    return window.width() >= wideWindow && window.height() >= high;
}

}
