#include "app/ui/window/header.h"

#include "app/ui/actions/command_button.h"
#include "app/ui/actions/commands.h"
#include "app/ui/theme/icon_button.h"
#include "app/ui/theme/icons.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QToolButton>

namespace app {

namespace {

constexpr int leastMenus = 16; ///< px, of the button for the menus that do not fit

}

Header::Header(QMenuBar *menus, const Commands &commands, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_theme(theme)
{
    setObjectName("header");
    setAttribute(Qt::WA_StyledBackground);
    setFixedHeight(40);
    auto *logo = new QLabel(this);
    drawLogo(*logo);
    connect(&theme, &Theme::changed, logo, [this, logo] { drawLogo(*logo); });
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(12, 0, 8, 0);
    row->setSpacing(4);
    row->addWidget(logo);
    row->addWidget(menus, 1, Qt::AlignVCenter);
    letGiveWay(*menus);
    addButton(*row, *commands.edit.undo);
    addButton(*row, *commands.edit.redo);
    const auto addGap = [row](int width) { // goes first in a narrow window
        row->addItem(new QSpacerItem(width, 0, QSizePolicy::Maximum, QSizePolicy::Minimum));
    };
    addGap(4);
    row->addWidget(modeSwitch(commands), 0, Qt::AlignVCenter);
    addGap(8);
    addButton(*row, *commands.view.lessons);
    addButton(*row, *commands.view.codeAndParameters);
    addButton(*row, *commands.help.keys);
}

void Header::drawLogo(QLabel &logo)
{
    const QIcon sign = signOf(m_theme.tokens().button, m_theme.tokens().buttonText);
    logo.setPixmap(sign.pixmap(QSize(20, 20), devicePixelRatioF()));
}

void Header::letGiveWay(QMenuBar &menus)
{
    menus.setMinimumWidth(leastMenus);
    if (auto *more = menus.findChild<QToolButton *>("qt_menubar_ext_button")) {
        more->setIconSize({12, 12});
        more->setToolTip(tr("More menus"));
        more->setAccessibleName(more->toolTip());
        showIcon(*more, "more", m_theme);
    }
}

void Header::addButton(QHBoxLayout &row, Command &command)
{
    QToolButton *button = makeIconButton({}, {}, m_theme, this);
    showCommand(*button, command, m_theme);
    row.addWidget(button);
}

QWidget *Header::modeSwitch(const Commands &commands)
{
    auto *frame = new QFrame;
    frame->setObjectName("modes");
    auto *row = new QHBoxLayout(frame);
    row->setContentsMargins(2, 2, 2, 2);
    row->setSpacing(2);
    for (Command *mode : commands.view.modes()) {
        auto *button = new QToolButton(frame);
        button->setObjectName("mode");
        button->setDefaultAction(mode);
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
    }
    return frame;
}

}
