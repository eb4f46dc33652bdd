// The window's commands: menus and keys.

#include "app/ui/code/code_panel.h"
#include "app/ui/effects/effects_panel.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/panels/help_page.h"
#include "app/ui/panels/learn_panel.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/experiment_files.h"
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

}

QAction *MainWindow::action(const QString &text, const QList<QKeySequence> &keys, const QString &group)
{
    auto *action = new QAction(text, this);
    action->setShortcuts(keys);
    QString plain = text;
    plain.remove('&');
    if (!keys.isEmpty())
        action->setToolTip(tr("%1 (%2)").arg(plain, keys.front().toString(QKeySequence::NativeText)));
    addAction(action);
    m_actions.push_back({action, group});
    return action;
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
    m_helpAction = action(tr("&Keys and mouse"), {QKeySequence(Qt::Key_F1), QKeySequence("?")}, tr("Window"));
    connect(m_helpAction, &QAction::triggered, this, &MainWindow::showHelp);
    m_help->addAction(m_helpAction);
    makeLearning();
}

void MainWindow::makeFileActions()
{
    const QString group = tr("Experiments");
    const auto add = [&](const QString &text, const QKeySequence &key, auto slot) {
        QAction *made = action(text, {key}, group);
        connect(made, &QAction::triggered, this, slot);
        m_file->addAction(made);
    };
    add(tr("&New: the step as published"), QKeySequence::New, [this] { m_files->startNew(); });
    add(tr("&Open an experiment…"), QKeySequence::Open, [this] { m_files->askOpen(); });
    QMenu *recent = m_file->addMenu(tr("Open &recent"));
    recent->setToolTipsVisible(true);
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { m_files->fillRecent(*recent); });
    m_file->addSeparator();
    add(tr("&Save the experiment"), QKeySequence::Save, [this] { m_files->saveOrAsk(); });
    add(tr("Save &as…"), QKeySequence("Ctrl+Shift+S"), [this] { m_files->askSave(); });
    makeExportActions();
    m_file->addSeparator();
    add(tr("&Quit"), QKeySequence("Ctrl+Q"), [this] { close(); });
}

void MainWindow::makeTimeActions()
{
    const QString group = tr("Time");
    const auto add = [&](const QString &text, const QList<QKeySequence> &keys, const QString &where,
                         auto slot) {
        QAction *made = action(text, keys, where);
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
    add(tr("To the &start"), {QKeySequence(Qt::Key_Home)}, group, [this] { m_session.rewind(); });
    add(tr("To the &end of what was computed"), {QKeySequence(Qt::Key_End)}, group, end);
    m_run->addAction(m_transport->goToFrameAction());
    m_actions.push_back({m_transport->goToFrameAction(), group});
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
    const QString steps = tr("Steps");
    add(tr("Ne&xt step"), {QKeySequence(Qt::Key_PageDown)}, steps, [this] { m_learn->goOn(); });
    add(tr("Pre&vious step"), {QKeySequence(Qt::Key_PageUp)}, steps, [this] { m_learn->goBack(); });
}

void MainWindow::makeViewActions()
{
    const auto add = [&](const QString &text, const QList<QKeySequence> &keys, const QString &where,
                         auto slot) {
        QAction *made = action(text, keys, where);
        connect(made, &QAction::triggered, this, slot);
        m_view->addAction(made);
        return made;
    };
    makeModeActions();
    const QString picture = tr("Picture");
    add(tr("Zoom &in"), {QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")}, picture,
        [this] { m_scene->zoomIn(); });
    add(tr("Zoom &out"), {QKeySequence("Ctrl+-")}, picture, [this] { m_scene->zoomOut(); });
    add(tr("&Fit the scene"), {QKeySequence("Ctrl+0")}, picture, [this] { m_scene->fit(); });
    m_view->addSeparator();
    const QString window = tr("Window");
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
    m_actions.push_back({m_effects->measureAgain(), window});
    makePlotsAction();
    m_stabilityAction = add(tr("&Stability of the step"), {QKeySequence("Ctrl+L")}, window,
                            [this](bool shown) { showStability(shown); });
    m_stabilityAction->setCheckable(true);
    makeLayoutMenu();
    makeLanguageMenu();
    makeAppearanceActions();
}

void MainWindow::showHelp()
{
    if (!m_helpPage) {
        m_helpPage = new HelpPage(m_theme, this);
        for (const Listed &listed : m_actions)
            m_helpPage->addAction(listed.group, listed.action);
        m_helpPage->addGesture(tr("Picture"), tr("Drag a body"),
                               tr("grab it; let go while moving to throw it"));
        m_helpPage->addGesture(tr("Picture"), tr("Drag the background"), tr("move the picture"));
        m_helpPage->addGesture(tr("Picture"), tr("Wheel"), tr("zoom where the pointer is"));
        m_helpPage->addGesture(tr("Picture"), tr("[ and ]"), tr("choose the body before or after"));
        m_helpPage->addGesture(tr("Picture"), tr("Alt and an arrow key"), tr("carry the chosen body 10 px"));
        m_helpPage->addGesture(tr("Picture"), tr("Press the background"),
                               tr("blow, steer or aim, where a step has that"));
        m_helpPage->addGesture(tr("Picture"), tr("Drag with the middle button"), tr("move the picture"));
        m_helpPage->addGesture(tr("Other runs"), tr("Click the dots below a ring"),
                               tr("show the run that parts there beside this one; right-click: more"));
        m_helpPage->addGesture(tr("Picture"), tr("Arrow keys"), tr("steer, where a step has that"));
        m_helpPage->addGesture(tr("Picture"), tr("Alt, Shift and an arrow key"),
                               tr("move the pointer or the target 20 px"));
        m_helpPage->addGesture(tr("Picture"), tr("Alt and Enter"), tr("pointer button down or up"));
        m_helpPage->addGesture(tr("Picture"), tr("Drag an end of the ruler"),
                               tr("measure a length and an angle (switch it on under Show)"));
        m_helpPage->addGesture(tr("Picture"), tr("Ctrl, Alt and an arrow key"),
                               tr("move the ruler's far end 5 px; with Shift the near one"));
        m_helpPage->addGesture(tr("Picture"), tr("Esc"), tr("let go"));
        m_helpPage->addGesture(tr("Time"), tr("Drag the timeline"), tr("go anywhere in time"));
        m_helpPage->addGesture(tr("Time"), tr("Click a phase"), tr("run to it"));
        m_helpPage->addGesture(tr("Time"), tr("Point at timeline, phase, plot or trail"),
                               tr("look at that moment; the run stays where it stands"));
        m_helpPage->addGesture(tr("Time"), tr("Alt and the underlined letter"),
                               tr("where a run has stopped by itself: use what mends it"));
        m_helpPage->addGesture(tr("Experiments"), tr("Drop a file on the window"), tr("open it"));
        const QString plots = tr("Plots");
        m_helpPage->addGesture(plots, tr("Press or drag"), tr("go to a frame"));
        m_helpPage->addGesture(plots, tr("+ and −, or Ctrl and the wheel"), tr("fewer or more frames"));
        m_helpPage->addGesture(plots, tr("The names above a plot"), tr("menus of what it shows"));
        m_helpPage->addGesture(plots, tr("Menu key, or right-click"), tr("save, copy, keep or remove it"));
        m_helpPage->addGesture(plots, tr("Delete"), tr("remove it"));
        const QString code = tr("Code");
        m_helpPage->addGesture(code, tr("Click a line, or Enter"), tr("run to its phase"));
        m_helpPage->addGesture(code, tr("Click left of a line, or F9"),
                               tr("stop before its phase, or no longer"));
        m_helpPage->addGesture(code, tr("Drag a dotted word"),
                               tr("change that parameter; with Shift finely"));
        m_helpPage->addGesture(code, tr("Double-click it, or F2"), tr("type the parameter's value"));
        m_helpPage->addGesture(code, tr("Point at a word, or Ctrl+I"),
                               tr("its value, and its last 120 frames"));
        m_helpPage->addGesture(code, tr("Up and Down"),
                               tr("from line to line; with Ctrl from heading to heading"));
        m_helpPage->addGesture(code, tr("Ctrl and Left or Right"), tr("from word to word"));
        m_helpPage->addGesture(code, tr("Enter, on a heading"), tr("fold or unfold"));
        m_helpPage->addGesture(code, tr("F8"), tr("show the lines of the step before that are gone"));
        m_helpPage->addGesture(code, tr("Ctrl+C"), tr("copy what is selected, or the whole region"));
        m_helpPage->addGesture(code, tr("Stop when…"),
                               tr("the field below the code: stop when that comes true"));
        const QString accuracy = tr("Accuracy");
        m_helpPage->addGesture(accuracy, tr("Arrow keys"), tr("walk through the points of a plot"));
        m_helpPage->addGesture(accuracy, tr("Enter or a click"), tr("use the method and step of a point"));
        m_helpPage->addGesture(accuracy, tr("+ and −, or drag the line"), tr("how far off is near enough"));
        explainBuilding();
    }
    m_helpPage->show();
    m_helpPage->raise();
    m_helpPage->activateWindow();
}

bool MainWindow::eventFilter(QObject *watched, QEvent *event)
{
    if (m_files->takesDrop(watched, *event))
        return true;
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
