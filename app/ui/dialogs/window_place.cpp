#include "app/ui/dialogs/window_place.h"

#include <QGuiApplication>
#include <QScreen>
#include <QSettings>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace app {

namespace {

// Rectangles in physical screen pixels, relative to the screen's upper left corner.
constexpr const char *placeKey = "window/place"; ///< of the window without its frame
constexpr const char *frameKey = "window/frame"; ///< of the frame round the window
constexpr const char *screenKey = "window/screen";
constexpr const char *stateKey = "window/state";
enum State { usual, maximized, fullScreen };

QRect scaled(const QRect &rect, double by)
{
    const auto scale = [by](int px) { return static_cast<int>(std::lround(px * by)); };
    return {scale(rect.x()), scale(rect.y()), scale(rect.width()), scale(rect.height())};
}

const QScreen &screenCalled(const QString &name)
{
    const QList<QScreen *> all = QGuiApplication::screens();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](QScreen *one) { return one->name() == name; });
    return found == all.end() ? *QGuiApplication::primaryScreen() : **found;
}

QMargins marginsOf(const QRect &inner, const QRect &outer)
{
    return {inner.left() - outer.left(), inner.top() - outer.top(), outer.right() - inner.right(),
            outer.bottom() - inner.bottom()};
}

}

QRect insideScreen(QRect wanted, const QMargins &frame, const QRect &room)
{
    const QRect inner = room.marginsRemoved(frame);
    wanted.setSize(wanted.size().boundedTo(inner.size()));
    wanted.moveLeft(std::clamp(wanted.left(), inner.left(), inner.right() + 1 - wanted.width()));
    wanted.moveTop(std::clamp(wanted.top(), inner.top(), inner.bottom() + 1 - wanted.height()));
    return wanted;
}

bool WindowPlace::restore()
{
    const QSettings settings;
    const QRect kept = settings.value(placeKey).toRect();
    if (kept.isEmpty())
        return false;
    const QScreen &screen = screenCalled(settings.value(screenKey).toString());
    const double ratio = screen.devicePixelRatio();
    const QRect place = scaled(kept, 1.0 / ratio).translated(screen.geometry().topLeft());
    const QRect frame = scaled(settings.value(frameKey, kept).toRect(), 1.0 / ratio);
    m_put = insideScreen(place, marginsOf(scaled(kept, 1.0 / ratio), frame), screen.availableGeometry());
    m_window.setGeometry(m_put);
    const int state = settings.value(stateKey).toInt();
    if (state != usual)
        m_window.setWindowState(state == maximized ? Qt::WindowMaximized : Qt::WindowFullScreen);
    return true;
}

bool WindowPlace::isWherePut() const
{
    // Physical pixels are rounded on the way to window coordinates and back.
    const auto isNear = [](int a, int b) { return std::abs(a - b) <= 1; };
    const QRect now = m_window.geometry();
    const QSize size = m_put.size().expandedTo(m_window.minimumSize());
    const QPoint moved = now.topLeft() - m_put.topLeft();
    // Some window managers move a window by its frame when they show it.
    const QPoint frame = now.topLeft() - m_window.frameGeometry().topLeft();
    return isNear(now.width(), size.width()) && isNear(now.height(), size.height()) &&
           ((isNear(moved.x(), 0) && isNear(moved.y(), 0)) ||
            (isNear(moved.x(), frame.x()) && isNear(moved.y(), frame.y())));
}

void WindowPlace::keep()
{
    QSettings settings;
    settings.setValue(stateKey, m_window.isFullScreen()  ? fullScreen
                                : m_window.isMaximized() ? maximized
                                                         : usual);
    const bool isUsual = !m_window.isFullScreen() && !m_window.isMaximized();
    if (isUsual ? isWherePut() : !m_put.isNull())
        return;
    const QScreen &screen = *m_window.screen();
    const QPoint corner = screen.geometry().topLeft();
    const double ratio = screen.devicePixelRatio();
    const QRect place = isUsual ? m_window.geometry() : m_window.normalGeometry();
    const QMargins frame = isUsual ? marginsOf(place, m_window.frameGeometry()) : QMargins();
    settings.setValue(screenKey, screen.name());
    settings.setValue(placeKey, scaled(place.translated(-corner), ratio));
    settings.setValue(frameKey, scaled(place.translated(-corner).marginsAdded(frame), ratio));
}

}
