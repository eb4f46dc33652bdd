// The header of the window with its menus and buttons, and what can be undone.

#include "app/ui/theme/icons.h"
#include "app/ui/window/commands.h"
#include "app/ui/window/experiment_files.h"
#include "app/ui/window/main_window.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QToolButton>

namespace app {

namespace {

QToolButton *headerButton(QAction *action, const QIcon &icon)
{
    auto *button = new QToolButton;
    button->setFocusPolicy(Qt::TabFocus);
    button->setIcon(icon);
    button->setIconSize({16, 16});
    button->setFixedSize(28, 28);
    const auto follow = [action, button] {
        button->setEnabled(action->isEnabled());
        button->setToolTip(action->toolTip());
        button->setAccessibleName(action->text().remove('&'));
    };
    follow();
    QObject::connect(action, &QAction::changed, button, follow);
    QObject::connect(button, &QToolButton::clicked, action, &QAction::trigger);
    return button;
}

}

QWidget *MainWindow::header()
{
    auto *header = new QWidget(this);
    header->setObjectName("header");
    header->setAttribute(Qt::WA_StyledBackground);
    header->setFixedHeight(40);
    auto *logo = new QLabel(header);
    const auto dressLogo = [this, logo] {
        const QIcon sign = signOf(m_theme.tokens().button, m_theme.tokens().buttonText);
        logo->setPixmap(sign.pixmap(QSize(20, 20), devicePixelRatioF()));
    };
    dressLogo();
    connect(&m_theme, &Theme::changed, logo, dressLogo);
    auto *menus = new QMenuBar(header);
    menus->setNativeMenuBar(false);
    for (QMenu *menu : {m_file, m_edit, m_run, m_view, m_help})
        menus->addMenu(menu);
    auto *row = new QHBoxLayout(header);
    row->setContentsMargins(12, 0, 8, 0);
    row->setSpacing(4);
    row->addWidget(logo);
    row->addWidget(menus, 1, Qt::AlignVCenter);
    const auto add = [&](QAction *action, const QString &icon) {
        QToolButton *button = headerButton(action, m_theme.icon(icon));
        row->addWidget(button);
        connect(&m_theme, &Theme::changed, button,
                [this, button, icon] { button->setIcon(m_theme.icon(icon)); });
    };
    add(m_undo, "undo");
    add(m_redo, "redo");
    row->addSpacing(4);
    row->addWidget(modeSwitch(), 0, Qt::AlignVCenter);
    row->addSpacing(8);
    add(findChild<QAction *>("showLessons"), "panel-left");
    add(findChild<QAction *>("showCode"), "panel-right");
    add(m_helpAction, "help");
    return header;
}

void MainWindow::makeEditActions()
{
    const KeyGroup group = KeyGroup::changes;
    const QList<QKeySequence> redoKeys = {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")};
    m_undo = m_commands->add(tr("&Undo"), {QKeySequence("Ctrl+Z")}, group);
    m_redo = m_commands->add(tr("&Redo"), redoKeys, group);
    m_undo->setObjectName("undo");
    m_redo->setObjectName("redo");
    m_edit->addActions({m_undo, m_redo});
    connect(m_undo, &QAction::triggered, &m_session, &Session::undo);
    connect(m_redo, &QAction::triggered, &m_session, &Session::redo);
    connect(&m_session.deeds(), &QUndoStack::indexChanged, this, &MainWindow::nameDeeds);
    nameDeeds();
    m_edit->addSeparator();
    const auto add = [&](const QString &text, const char *key, auto slot) {
        QAction *made = m_commands->add(text, {QKeySequence(key)}, KeyGroup::experiments);
        connect(made, &QAction::triggered, this, slot);
        m_edit->addAction(made);
    };
    add(tr("&Copy the experiment as text"), "Ctrl+Shift+C", [this] { m_files->copyAsText(); });
    add(tr("&Paste an experiment"), "Ctrl+Shift+V", [this] { m_files->pasteText(); });
    add(tr("Copy the p&icture of the scene"), "Ctrl+Shift+P", &MainWindow::copyPicture);
}

void MainWindow::nameDeeds()
{
    const QUndoStack &deeds = m_session.deeds();
    const QString undone = deeds.undoText();
    const QString redone = deeds.redoText();
    m_undo->setEnabled(deeds.canUndo());
    m_redo->setEnabled(deeds.canRedo());
    m_undo->setText(undone.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(undone));
    m_redo->setText(redone.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(redone));
    m_undo->setToolTip(undone.isEmpty() ? tr("Nothing was changed in this step that could be undone (Ctrl+Z)")
                                        : tr("Undo: %1 (Ctrl+Z)").arg(undone));
    m_redo->setToolTip(redone.isEmpty() ? tr("Nothing was undone (Ctrl+Shift+Z)")
                                        : tr("Redo: %1 (Ctrl+Shift+Z)").arg(redone));
}

}
