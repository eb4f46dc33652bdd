#include "app/ui/dock/dock_fitter.h"

#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/step/narration.h"
#include "app/ui/scene/scene_view.h"

#include <QDockWidget>
#include <QLayout>
#include <QMainWindow>
#include <QTimer>

#include <algorithm>

namespace app {

namespace {

constexpr QSize smallScene{320, 160}; ///< px, if nothing else helps

bool contains(const std::vector<QDockWidget *> &panels, const QDockWidget *one)
{
    return std::find(panels.begin(), panels.end(), one) != panels.end();
}

}

DockFitter::DockFitter(PanelLayout &layout, LearnPanel &learn, SceneView &scene)
    : m_window(layout.window), m_learn(learn), m_scene(scene), m_lessons(layout.docks[Panel::lessons]),
      m_numbers(layout.docks[Panel::parameters]), m_code(layout.docks[Panel::code])
{
}

QSize DockFitter::leastSize()
{
    // Activated from the inside out, because the window learns of inner changes only later.
    m_window.centralWidget()->layout()->activate();
    for (QDockWidget *panel : m_window.findChildren<QDockWidget *>()) {
        if (QLayout *title = panel->titleBarWidget()->layout())
            title->activate();
        panel->layout()->activate();
    }
    m_window.layout()->activate();
    return m_window.layout()->totalMinimumSize();
}

bool DockFitter::isShort()
{
    const QSize least = leastSize();
    return least.width() > m_window.width() || least.height() > m_window.height();
}

void DockFitter::share()
{
    const std::size_t before = m_aside.size();
    const std::vector<QDockWidget *> requested = takeRequested();
    bringBackWhatFits();
    letStepAside(requested);
    // Emitted later, because a panel that was just shown has no size yet.
    if (m_aside.size() != before)
        QTimer::singleShot(0, this, &DockFitter::sidesChanged);
}

void DockFitter::letStepAside(std::vector<QDockWidget *> requested)
{
    // A task is read and judged beside the code that the learner writes.
    if (m_learn.narration().isWriting())
        requested.insert(requested.end(), {&m_lessons, &m_code});
    // First try to keep the panels that the learner has just asked for.
    for (const std::vector<QDockWidget *> &spared : {requested, std::vector<QDockWidget *>()}) {
        for (const Way way : {Way::rail, Way::below, Way::smallScene, Way::numbers, Way::right, Way::left}) {
            if (!isShort())
                return;
            stepAside(way, spared);
        }
    }
}

void DockFitter::bringBackWhatFits()
{
    while (!m_aside.empty() && m_aside.back().least.width() <= m_window.width() &&
           m_aside.back().least.height() <= m_window.height()) {
        const Aside last = bringLastBack();
        // Raised later, because other layout changes bring their own tabs to the front meanwhile.
        QTimer::singleShot(0, this, [panels = last.panels] {
            for (QDockWidget *panel : panels)
                panel->raise();
        });
    }
}

bool DockFitter::stepAside(Way way, const std::vector<QDockWidget *> &requested)
{
    Aside aside{way, {}, leastSize()};
    if (way == Way::rail) {
        if (m_learn.form() == LearnPanel::Form::rail || m_lessons.isHidden() ||
            contains(requested, &m_lessons))
            return false;
        m_learn.setForm(LearnPanel::Form::rail);
    } else if (way == Way::smallScene) {
        if (m_scene.minimumSize() == smallScene)
            return false;
        m_scene.setMinimumSize(smallScene);
    } else {
        aside.panels = panelsFor(way, requested);
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

std::vector<QDockWidget *> DockFitter::panelsFor(Way way, const std::vector<QDockWidget *> &requested) const
{
    const Qt::DockWidgetArea area = way == Way::below  ? Qt::BottomDockWidgetArea
                                    : way == Way::left ? Qt::LeftDockWidgetArea
                                                       : Qt::RightDockWidgetArea;
    std::vector<QDockWidget *> panels;
    for (QDockWidget *panel : m_window.findChildren<QDockWidget *>()) {
        const bool isThere =
            !panel->isHidden() && !panel->isFloating() && m_window.dockWidgetArea(panel) == area;
        if (isThere && !contains(requested, panel) && (way != Way::numbers || panel == &m_numbers))
            panels.push_back(panel);
    }
    // The last tab to be shown again is in front, so the tab that is in front now goes last.
    std::stable_partition(panels.begin(), panels.end(),
                          [](const QDockWidget *one) { return one->visibleRegion().isEmpty(); });
    return panels;
}

std::vector<QDockWidget *> DockFitter::takeRequested()
{
    std::vector<QDockWidget *> requested;
    for (Aside &aside : m_aside) {
        if (aside.way == Way::rail && m_learn.form() == LearnPanel::Form::whole)
            requested.push_back(&m_lessons);
        const auto shown = std::partition(aside.panels.begin(), aside.panels.end(),
                                          [](const QDockWidget *one) { return one->isHidden(); });
        requested.insert(requested.end(), shown, aside.panels.end());
        aside.panels.erase(shown, aside.panels.end());
    }
    const auto isOver = [this](const Aside &aside) {
        return aside.way == Way::rail ? m_learn.form() == LearnPanel::Form::whole
                                      : aside.way != Way::smallScene && aside.panels.empty();
    };
    m_aside.erase(std::remove_if(m_aside.begin(), m_aside.end(), isOver), m_aside.end());
    return requested;
}

void DockFitter::bringBack(const Aside &aside)
{
    if (aside.way == Way::rail)
        m_learn.setForm(LearnPanel::Form::whole);
    else if (aside.way == Way::smallScene)
        m_scene.setMinimumSize(leastScene);
    for (QDockWidget *panel : aside.panels)
        panel->show();
}

DockFitter::Aside DockFitter::bringLastBack()
{
    const Aside last = std::move(m_aside.back());
    m_aside.pop_back();
    bringBack(last);
    return last;
}

void DockFitter::bringAllBack()
{
    takeRequested();
    while (!m_aside.empty())
        bringLastBack();
}

}
