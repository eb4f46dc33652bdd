// The window's commands: menus and keys.

#include "app/ui/code/code_panel.h"
#include "app/ui/effects/effects_panel.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/panels/help_page.h"
#include "app/ui/panels/learn_panel.h"
#include "app/ui/panels/number_box.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/arrange_menu.h"
#include "app/ui/window/commands.h"
#include "app/ui/window/experiment_files.h"
#include "app/ui/window/gestures.h"
#include "app/ui/window/kept_offer.h"
#include "app/ui/window/main_window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>

namespace app {

namespace {

/// Whether the widget with the focus needs this key for itself, so that the window's command must not take it.
bool needsKey(const QWidget *widget, const QKeyEvent &key)
{
    const bool arrows = key.key() >= Qt::Key_Left && key.key() <= Qt::Key_Down;
    const bool plain = (key.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == Qt::NoModifier;
    if (!plain)
        return false;
    if (qobject_cast<const NumberBox *>(widget) && key.key() == Qt::Key_Space)
        return false; // a number has none
    if (qobject_cast<const QLineEdit *>(widget) || qobject_cast<const QAbstractSpinBox *>(widget))
        return arrows || key.key() == Qt::Key_Home || key.key() == Qt::Key_End || !key.text().isEmpty();
    if (qobject_cast<const QAbstractSlider *>(widget))
        return arrows || key.key() == Qt::Key_Home || key.key() == Qt::Key_End;
    if (qobject_cast<const QAbstractItemView *>(widget))
        return arrows || key.key() == Qt::Key_Home || key.key() == Qt::Key_End || key.key() == Qt::Key_Space;
    if (qobject_cast<const QComboBox *>(widget))
        return arrows || key.key() == Qt::Key_Space;
    if (qobject_cast<const QAbstractButton *>(widget))
        return key.key() == Qt::Key_Space;
    return false;
}

/// After a click Space plays, and arrows go from frame to frame, wherever the click was: buttons and lists take keys only
/// from whoever goes there by Tab.
void leaveKeysToTime(QWidget *widget, const QWidget *window)
{
    const bool takesKeys = qobject_cast<QAbstractButton *>(widget) || qobject_cast<QComboBox *>(widget) ||
                           qobject_cast<QAbstractItemView *>(widget);
    if (takesKeys && widget->window() == window && (widget->focusPolicy() & Qt::ClickFocus) == Qt::ClickFocus)
        widget->setFocusPolicy(Qt::TabFocus);
}

/// A click elsewhere takes the number that was typed, also where it leaves the keyboard with the number.
void takeTypedNumber(const QObject *clicked)
{
    auto *box = qobject_cast<NumberBox *>(QApplication::focusWidget());
    const auto *widget = qobject_cast<const QWidget *>(clicked);
    if (box && widget && widget != box && !box->isAncestorOf(widget))
        box->takeTyped();
}

}

void MainWindow::makeActions()
{
    m_file = new QMenu(tr("&File"), this);
    m_edit = new QMenu(tr("&Edit"), this);
    m_run = new QMenu(tr("&Run"), this);
    m_view = new QMenu(tr("&View"), this);
    m_help = new QMenu(tr("&Help"), this);
    makeFileActions();
    makeEditActions();
    makeTimeActions();
    makeViewActions();
    m_helpAction = m_commands->add(tr("&Keys and mouse"), {QKeySequence(Qt::Key_F1), QKeySequence("?")},
                                   KeyGroup::window);
    connect(m_helpAction, &QAction::triggered, this, &MainWindow::showHelp);
    m_help->addAction(m_helpAction);
    makeLearning();
}

void MainWindow::makeFileActions()
{
    const KeyGroup group = KeyGroup::experiments;
    const auto add = [&](const QString &text, const QKeySequence &key, auto slot) {
        QAction *made = m_commands->add(text, {key}, group);
        connect(made, &QAction::triggered, this, slot);
        m_file->addAction(made);
    };
    add(tr("&New: the step as published"), QKeySequence::New, [this] { m_files->startNew(); });
    add(tr("&Open an experiment…"), QKeySequence::Open, [this] { m_files->askOpen(); });
    QMenu *recent = m_file->addMenu(tr("Open &recent"));
    recent->setToolTipsVisible(true);
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { m_files->fillRecent(*recent); });
    connect(m_file->addAction(tr("Reco&ver scenes…")), &QAction::triggered, this,
            [this] { m_kept->showList(); });
    m_file->addSeparator();
    add(tr("&Save the experiment"), QKeySequence::Save, [this] { m_files->saveOrAsk(); });
    add(tr("Save &as…"), QKeySequence("Ctrl+Shift+S"), [this] { m_files->askSave(); });
    makeExportActions();
    m_file->addSeparator();
    add(tr("&Quit"), QKeySequence("Ctrl+Q"), [this] { close(); });
}

void MainWindow::makeTimeActions()
{
    const KeyGroup group = KeyGroup::time;
    const auto add = [&](const QString &text, const QList<QKeySequence> &keys, KeyGroup where, auto slot) {
        QAction *made = m_commands->add(text, keys, where);
        connect(made, &QAction::triggered, this, slot);
        m_run->addAction(made);
        return made;
    };
    const auto end = [this] { m_session.goTo({m_session.timeline().computed(), 0}); };
    m_play = add(tr("&Play or pause"), {QKeySequence(Qt::Key_Space)}, group,
                 [this] { m_transport->playOrPause(); });
    add(tr("Next &frame"), {QKeySequence(Qt::Key_Right)}, group, [this] { m_session.frameForward(); });
    add(tr("Frame &back"), {QKeySequence(Qt::Key_Left)}, group, [this] { m_session.frameBack(); });
    add(tr("&Next phase"), {QKeySequence("Shift+Right")}, group, [this] { m_session.phaseForward(); });
    add(tr("P&hase back"), {QKeySequence("Shift+Left")}, group, [this] { m_session.phaseBack(); });
    add(tr("Re&start"), {QKeySequence(Qt::Key_Home)}, group, [this] { m_session.restart(); });
    add(tr("Repea&t the run, with all that was done in it"), {QKeySequence("Shift+Home")}, group,
        [this] { m_session.repeat(); });
    add(tr("To the &end of what was computed"), {QKeySequence(Qt::Key_End)}, group, end);
    m_run->addAction(m_transport->goToFrameAction());
    m_commands->list(m_transport->goToFrameAction(), group);
    add(tr("S&lower"), {QKeySequence("-")}, group, [this] { m_transport->slower(); });
    add(tr("Faste&r"), {QKeySequence("+"), QKeySequence("=")}, group, [this] { m_transport->faster(); });
    m_run->addSeparator();
    add(tr("Start the step &afresh"), {QKeySequence("Ctrl+R")}, group, [this] { m_session.startAfresh(); });
    QAction *forget =
        add(tr("Forget the &old run"), {QKeySequence("Ctrl+D")}, group, [this] { m_session.forgetGhost(); });
    const auto follow = [this, forget] { forget->setEnabled(m_session.beside()); };
    connect(&m_session, &Session::stepOpened, forget, follow);
    connect(&m_session, &Session::runChanged, forget, follow);
    follow();
    makeBranchActions();
    m_run->addSeparator();
    const KeyGroup steps = KeyGroup::steps;
    add(tr("Ne&xt step"), {QKeySequence(Qt::Key_PageDown)}, steps, [this] { m_learn->goOn(); });
    add(tr("Pre&vious step"), {QKeySequence(Qt::Key_PageUp)}, steps, [this] { m_learn->goBack(); });
}

void MainWindow::makeViewActions()
{
    const auto add = [&](const QString &text, const QList<QKeySequence> &keys, KeyGroup where, auto slot) {
        QAction *made = m_commands->add(text, keys, where);
        connect(made, &QAction::triggered, this, slot);
        m_view->addAction(made);
        return made;
    };
    makeModeActions();
    const KeyGroup picture = KeyGroup::picture;
    add(tr("Zoom &in"), {QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")}, picture,
        [this] { m_scene->zoomIn(); });
    add(tr("Zoom &out"), {QKeySequence("Ctrl+-")}, picture, [this] { m_scene->zoomOut(); });
    add(tr("&Fit the scene"), {QKeySequence("Ctrl+0"), QKeySequence("0")}, picture, [this] {
        m_scene->fit();
    })->setToolTip(tr("Show the whole stage with all bodies, and stay with them (Ctrl+0)"));
    add(tr("Ne&xt body outside"), {QKeySequence("O")}, picture, [this] {
        m_scene->showNextOutside();
    })->setToolTip(tr("Bring a body that is outside of the picture into view (O)"));
    m_view->addSeparator();
    const KeyGroup window = KeyGroup::window;
    const auto toggle = [&](const QString &text, const char *key, std::vector<QDockWidget *> docks) {
        QAction *made = add(text, {QKeySequence(key)}, window, [docks](bool shown) {
            for (QDockWidget *dock : docks)
                dock->setVisible(shown);
        });
        made->setCheckable(true);
        made->setChecked(true);
        connect(docks.front(), &QDockWidget::visibilityChanged, made,
                [made, dock = docks.front()] { made->setChecked(!dock->isHidden()); });
        return made;
    };
    toggle(tr("&Lessons"), "Ctrl+1", {m_left})->setObjectName("showLessons");
    makeRailAction();
    toggle(tr("&Code and parameters"), "Ctrl+2", {m_codeDock, m_parameterDock})->setObjectName("showCode");
    QAction *energy = add(tr("E&nergy"), {QKeySequence("Ctrl+3")}, window, [this](bool shown) {
        showEnergy(shown || m_energy->visibleRegion().isEmpty()); // it may be a tab that is covered
    });
    energy->setCheckable(true);
    connect(m_energyDock, &QDockWidget::visibilityChanged, energy,
            [dock = m_energyDock, energy] { energy->setChecked(!dock->isHidden()); });
    energy->setToolTip(tr("Where energy and momentum went (Ctrl+3)"));
    energy->setObjectName("showEnergy");
    QAction *effects = add(tr("Effec&ts"), {QKeySequence("Ctrl+4")}, window,
                           [this](bool shown) { showEffects(shown || m_effects->isCovered()); });
    effects->setCheckable(true);
    effects->setToolTip(tr("What each effect of the scene costs, with a switch for each (Ctrl+4)"));
    effects->setObjectName("showEffects");
    connect(m_effectsDock, &QDockWidget::visibilityChanged, effects,
            [dock = m_effectsDock, effects] { effects->setChecked(!dock->isHidden()); });
    addAction(m_effects->measureAgain());
    m_commands->list(m_effects->measureAgain(), window);
    makePlotsAction();
    m_stabilityAction = add(tr("&Stability of the step"), {QKeySequence("Ctrl+L")}, window,
                            [this](bool shown) { showStability(shown); });
    m_stabilityAction->setCheckable(true);
    auto *arrange = new ArrangeMenu(*this, *m_commands, m_theme);
    connect(arrange, &ArrangeMenu::resetAsked, this, &MainWindow::resetLayout);
    connect(arrange, &ArrangeMenu::moved, this, &MainWindow::fitParameters);
    m_view->addMenu(arrange);
    makeLanguageMenu();
    makeAppearanceActions();
}

void MainWindow::showHelp()
{
    if (!m_helpPage) {
        m_helpPage = new HelpPage(m_theme, this);
        for (const KeyGroup group : allKeyGroups)
            m_helpPage->addGroup(titleOf(group));
        for (const Commands::Listed &listed : m_commands->listed())
            m_helpPage->addAction(titleOf(listed.group), listed.action);
        addGestures(*m_helpPage);
    }
    m_helpPage->show();
    m_helpPage->raise();
    m_helpPage->activateWindow();
}

bool MainWindow::eventFilter(QObject *watched, QEvent *event)
{
    if (m_files->takesDrop(watched, *event))
        return true;
    if (event->type() == QEvent::MouseButtonPress)
        takeTypedNumber(watched);
    if (event->type() == QEvent::Show)
        leaveKeysToTime(qobject_cast<QWidget *>(watched), this);
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::ShortcutOverride ||
        event->type() == QEvent::KeyPress)
        m_session.endGlance(); // whoever does something does it where the run stands
    if (event->type() == QEvent::ShortcutOverride) {
        const QWidget *focus = QApplication::focusWidget();
        if (focus && focus->window() == this && needsKey(focus, *static_cast<QKeyEvent *>(event))) {
            event->accept();
            return true;
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

}
