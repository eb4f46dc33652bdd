#include "app/ui/window/room.h"

#include "app/ui/panels/learn_panel.h"
#include "app/ui/scene/scene_view.h"

#include <QDockWidget>
#include <QLayout>
#include <QMainWindow>
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

Room::Room(QMainWindow &window, LearnPanel &learn, SceneView &scene, QDockWidget &lessons,
           QDockWidget &numbers)
    : m_window(window), m_learn(learn), m_scene(scene), m_lessons(lessons), m_numbers(numbers)
{
}

QSize Room::leastSize()
{
    // From within: what has changed there is told to the window only later.
    m_window.centralWidget()->layout()->activate();
    for (QDockWidget *panel : m_window.findChildren<QDockWidget *>())
        panel->layout()->activate();
    m_window.layout()->activate();
    return m_window.layout()->totalMinimumSize();
}

bool Room::isShort()
{
    const QSize least = leastSize();
    return least.width() > m_window.width() || least.height() > m_window.height();
}

void Room::share()
{
    const std::size_t before = m_aside.size();
    const std::vector<QDockWidget *> asked = takeAsked();
    bringBackWhatFits();
    letStepAside(asked);
    // Later: what has just come back has no size yet.
    if (m_aside.size() != before)
        QTimer::singleShot(0, this, &Room::sidesChanged);
}

void Room::letStepAside(const std::vector<QDockWidget *> &asked)
{
    // What the learner has just asked for stays, if others can make room for it.
    for (const std::vector<QDockWidget *> &spared : {asked, std::vector<QDockWidget *>()}) {
        for (const Way way : {Way::rail, Way::below, Way::smallScene, Way::numbers, Way::right, Way::left}) {
            if (!isShort())
                return;
            stepAside(way, spared);
        }
    }
}

void Room::bringBackWhatFits()
{
    while (!m_aside.empty() && m_aside.back().least.width() <= m_window.width() &&
           m_aside.back().least.height() <= m_window.height()) {
        const Aside last = m_aside.back();
        m_aside.pop_back();
        bringBack(last);
        // Later, as others that are arranged meanwhile come to the front, too.
        QTimer::singleShot(0, this, [panels = last.panels] {
            for (QDockWidget *panel : panels)
                panel->raise();
        });
    }
}

bool Room::stepAside(Way way, const std::vector<QDockWidget *> &asked)
{
    Aside aside{way, {}, leastSize()};
    if (way == Way::rail) {
        if (m_learn.form() == LearnPanel::Form::rail || m_lessons.isHidden() || contains(asked, &m_lessons))
            return false;
        m_learn.setForm(LearnPanel::Form::rail);
    } else if (way == Way::smallScene) {
        if (m_scene.minimumSize() == smallScene)
            return false;
        m_scene.setMinimumSize(smallScene);
    } else {
        aside.panels = panelsFor(way, asked);
        for (QDockWidget *panel : aside.panels)
            panel->hide();
    }
    const QSize least = leastSize();
    const bool helps = (aside.least.width() > m_window.width() && least.width() < aside.least.width()) ||
                       (aside.least.height() > m_window.height() && least.height() < aside.least.height());
    if (helps)
        m_aside.push_back(aside);
    else
        bringBack(aside);
    return helps;
}

std::vector<QDockWidget *> Room::panelsFor(Way way, const std::vector<QDockWidget *> &asked) const
{
    const Qt::DockWidgetArea area = way == Way::below  ? Qt::BottomDockWidgetArea
                                    : way == Way::left ? Qt::LeftDockWidgetArea
                                                       : Qt::RightDockWidgetArea;
    std::vector<QDockWidget *> panels;
    for (QDockWidget *panel : m_window.findChildren<QDockWidget *>()) {
        const bool isThere =
            !panel->isHidden() && !panel->isFloating() && m_window.dockWidgetArea(panel) == area;
        if (isThere && !contains(asked, panel) && (way != Way::numbers || panel == &m_numbers))
            panels.push_back(panel);
    }
    // Of tabs the last one comes back in front: that is to be the one that is now.
    std::stable_partition(panels.begin(), panels.end(),
                          [](const QDockWidget *one) { return one->visibleRegion().isEmpty(); });
    return panels;
}

std::vector<QDockWidget *> Room::takeAsked()
{
    std::vector<QDockWidget *> asked;
    for (Aside &aside : m_aside) {
        if (aside.way == Way::rail && m_learn.form() == LearnPanel::Form::whole)
            asked.push_back(&m_lessons);
        const auto shown = std::partition(aside.panels.begin(), aside.panels.end(),
                                          [](const QDockWidget *one) { return one->isHidden(); });
        asked.insert(asked.end(), shown, aside.panels.end());
        aside.panels.erase(shown, aside.panels.end());
    }
    const auto isOver = [this](const Aside &aside) {
        return aside.way == Way::rail ? m_learn.form() == LearnPanel::Form::whole
                                      : aside.way != Way::smallScene && aside.panels.empty();
    };
    m_aside.erase(std::remove_if(m_aside.begin(), m_aside.end(), isOver), m_aside.end());
    return asked;
}

void Room::bringBack(const Aside &aside)
{
    if (aside.way == Way::rail)
        m_learn.setForm(LearnPanel::Form::whole);
    else if (aside.way == Way::smallScene)
        m_scene.setMinimumSize(leastScene);
    for (QDockWidget *panel : aside.panels)
        panel->show();
}

void Room::bringAllBack()
{
    takeAsked();
    while (!m_aside.empty()) {
        const Aside last = m_aside.back();
        m_aside.pop_back();
        bringBack(last);
    }
}

}
