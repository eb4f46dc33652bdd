#include "app/ui/dialogs/dialog_place.h"

#include <QScreen>
#include <QWidget>

#include <algorithm>

namespace app {

void placeOverParent(QWidget &dialog)
{
    if (!dialog.parentWidget() || dialog.isVisible())
        return;
    const QWidget &window = *dialog.parentWidget()->window();
    const QRect inner = window.geometry(), outer = window.frameGeometry();
    // The dialog will have the same frame as the window.
    const QRect room = window.screen()->availableGeometry().adjusted(
        inner.left() - outer.left(), inner.top() - outer.top(), inner.right() - outer.right(),
        inner.bottom() - outer.bottom());
    QRect place(QPoint(), dialog.size().boundedTo(room.size()));
    place.moveCenter(inner.center());
    place.moveLeft(std::clamp(place.left(), room.left(), room.right() + 1 - place.width()));
    place.moveTop(std::clamp(place.top(), room.top(), room.bottom() + 1 - place.height()));
    dialog.setGeometry(place);
}

}
