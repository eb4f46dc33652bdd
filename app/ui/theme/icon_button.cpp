#include "app/ui/theme/icon_button.h"

#include <QToolButton>

namespace app {

void showIcon(QAbstractButton &button, const QString &name, const Theme &theme, QColor Tokens::*ink)
{
    const auto draw = [&button, name, &theme, ink] { button.setIcon(theme.icon(name, theme.tokens().*ink)); };
    draw();
    QObject::connect(&theme, &Theme::changed, &button, draw);
}

QToolButton *makeIconButton(const QString &objectName, const QString &icon, const Theme &theme,
                            QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setObjectName(objectName);
    button->setFixedSize(28, 28);
    button->setIconSize({16, 16});
    button->setFocusPolicy(Qt::TabFocus);
    if (!icon.isEmpty())
        showIcon(*button, icon, theme);
    return button;
}

}
