#include "app/ui/actions/command_button.h"

#include "app/ui/actions/command.h"

#include <QToolButton>

namespace app {

void showCommand(QToolButton &button, Command &command, const Theme &theme, QColor Tokens::*ink)
{
    const auto follow = [&button, &command] {
        button.setEnabled(command.isEnabled());
        button.setToolTip(command.toolTip());
        button.setAccessibleName(command.iconText());
    };
    const auto draw = [&button, &command, &theme, ink] {
        button.setIcon(theme.icon(command.iconName(), theme.tokens().*ink));
    };
    follow();
    draw();
    QObject::connect(&command, &QAction::changed, &button, follow);
    QObject::connect(&command, &Command::iconNameChanged, &button, draw);
    QObject::connect(&theme, &Theme::changed, &button, draw);
    QObject::connect(&button, &QToolButton::clicked, &command, &QAction::trigger);
}

}
