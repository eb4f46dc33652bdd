#include "app/ui/dialogs/dialog_place.h"

#include "app/ui/dialogs/window_place.h"

#include <QScreen>
#include <QWidget>

namespace app {

void placeOverParent(QWidget &dialog)
{
    if (!dialog.parentWidget() || dialog.isVisible())
        return;
    const QWidget &window = *dialog.parentWidget()->window();
    const QRect inner = window.geometry(), outer = window.frameGeometry();
    const QMargins frame(inner.left() - outer.left(), inner.top() - outer.top(),
                         outer.right() - inner.right(), outer.bottom() - inner.bottom());
    QRect place(QPoint(), dialog.size());
    place.moveCenter(inner.center());
    // The dialog will have the same frame as the window.
    dialog.setGeometry(insideScreen(place, frame, window.screen()->availableGeometry()));
}

void showInFront(QWidget &dialog)
{
    placeOverParent(dialog);
    dialog.show();
    dialog.raise();
    dialog.activateWindow();
}

}
