// A window that is too small for all that is open: what can be done without steps aside, and comes back.

#include "app/ui/window/room.h"

#include "app/ui/panels/learn_panel.h"
#include "app/ui/scene/scene_view.h"

#include <QDockWidget>
#include <QEvent>
#include <QLayout>
#include <QTimer>

#include <algorithm>

namespace app {

namespace {

constexpr QSize smallScene{320, 160}; ///< px, where nothing else helps

bool contains(const std::vector<QDockWidget *> &panels, const QDockWidget *one)
{
    return std::find(panels.begin(), panels.end(), one) != panels.end();
}

}

bool MainWindow::event(QEvent *event)
{
    const bool isDone = QMainWindow::event(event);
    if (event->type() == QEvent::LayoutRequest && isVisible())
        giveWay(); // a panel may want more than before
    return isDone;
}

void MainWindow::fitInto(QSize room)
{
    resize(size().boundedTo(room));
    giveWay();
}

QSize MainWindow::leastSize()
{
    // From within: what has changed there is told to the window only later.
    centralWidget()->layout()->activate();
    for (QDockWidget *panel : findChildren<QDockWidget *>())
        panel->layout()->activate();
    layout()->activate();
    return layout()->totalMinimumSize();
}

bool MainWindow::isShortOfRoom()
{
    const QSize least = leastSize();
    return least.width() > width() || least.height() > height();
}

void MainWindow::giveWay()
{
    const std::vector<QDockWidget *> asked = takeAsked();
    const auto areSidesAside = [this] {
        return std::any_of(m_aside.begin(), m_aside.end(), [](const Aside &aside) {
            return aside.way == Way::numbers || aside.way == Way::right || aside.way == Way::left;
        });
    };
    const bool wereSidesAside = areSidesAside();
    while (!m_aside.empty() && m_aside.back().least.width() <= width() &&
           m_aside.back().least.height() <= height()) {
        const Aside last = m_aside.back();
        m_aside.pop_back();
        bringBack(last);
        // Later, as others that are arranged meanwhile come to the front, too.
        QTimer::singleShot(0, this, [panels = last.panels] {
            for (QDockWidget *panel : panels)
                panel->raise();
        });
    }
    // They were as narrow as they can be before they went. Later: what has just come back has no size yet.
    if (wereSidesAside && !areSidesAside())
        QTimer::singleShot(0, this, [this] {
            if (m_mode != Mode::measure)
                placeSides();
            fitParameters();
        });
    // What the learner has just asked for stays, if others can make room for it.
    for (const std::vector<QDockWidget *> &spared : {asked, std::vector<QDockWidget *>()}) {
        for (const Way way : {Way::rail, Way::below, Way::smallScene, Way::numbers, Way::right, Way::left}) {
            if (!isShortOfRoom())
                return;
            stepAside(way, spared);
        }
    }
}

bool MainWindow::stepAside(Way way, const std::vector<QDockWidget *> &asked)
{
    Aside aside{way, {}, leastSize()};
    if (way == Way::rail) {
        if (m_learn->form() == LearnPanel::Form::rail || m_left->isHidden() || contains(asked, m_left))
            return false;
        m_learn->setForm(LearnPanel::Form::rail);
    } else if (way == Way::smallScene) {
        if (m_scene->minimumSize() == smallScene)
            return false;
        m_scene->setMinimumSize(smallScene);
    } else {
        const Qt::DockWidgetArea area = way == Way::below  ? Qt::BottomDockWidgetArea
                                        : way == Way::left ? Qt::LeftDockWidgetArea
                                                           : Qt::RightDockWidgetArea;
        for (QDockWidget *panel : shownIn(area)) {
            if (!contains(asked, panel) && (way != Way::numbers || panel == m_parameterDock))
                aside.panels.push_back(panel);
        }
        // Of tabs the last one comes back in front: that is to be the one that is now.
        std::stable_partition(aside.panels.begin(), aside.panels.end(),
                              [](const QDockWidget *one) { return one->visibleRegion().isEmpty(); });
        for (QDockWidget *panel : aside.panels)
            panel->hide();
    }
    const QSize least = leastSize();
    const bool helps = (aside.least.width() > width() && least.width() < aside.least.width()) ||
                       (aside.least.height() > height() && least.height() < aside.least.height());
    if (helps)
        m_aside.push_back(aside);
    else
        bringBack(aside);
    return helps;
}

std::vector<QDockWidget *> MainWindow::takeAsked()
{
    std::vector<QDockWidget *> asked;
    for (Aside &aside : m_aside) {
        if (aside.way == Way::rail && m_learn->form() == LearnPanel::Form::whole)
            asked.push_back(m_left);
        const auto shown = std::partition(aside.panels.begin(), aside.panels.end(),
                                          [](const QDockWidget *one) { return one->isHidden(); });
        asked.insert(asked.end(), shown, aside.panels.end());
        aside.panels.erase(shown, aside.panels.end());
    }
    const auto isOver = [this](const Aside &aside) {
        return aside.way == Way::rail ? m_learn->form() == LearnPanel::Form::whole
                                      : aside.way != Way::smallScene && aside.panels.empty();
    };
    m_aside.erase(std::remove_if(m_aside.begin(), m_aside.end(), isOver), m_aside.end());
    return asked;
}

void MainWindow::bringBack(const Aside &aside)
{
    if (aside.way == Way::rail)
        m_learn->setForm(LearnPanel::Form::whole);
    else if (aside.way == Way::smallScene)
        m_scene->setMinimumSize(leastScene);
    for (QDockWidget *panel : aside.panels)
        panel->show();
}

void MainWindow::bringAllBack()
{
    takeAsked();
    while (!m_aside.empty()) {
        const Aside last = m_aside.back();
        m_aside.pop_back();
        bringBack(last);
    }
}

std::vector<QDockWidget *> MainWindow::shownIn(Qt::DockWidgetArea area) const
{
    std::vector<QDockWidget *> shown;
    for (QDockWidget *panel : findChildren<QDockWidget *>()) {
        if (!panel->isHidden() && !panel->isFloating() && dockWidgetArea(panel) == area)
            shown.push_back(panel);
    }
    return shown;
}

}
