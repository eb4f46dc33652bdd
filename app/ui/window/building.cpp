// Building a scene of one's own: the way there and back, its tools and commands.

#include "app/model/build_guide.h"
#include "app/model/workshop.h"
#include "app/ui/panels/learn_panel.h"
#include "app/ui/sandbox/build_panel.h"
#include "app/ui/sandbox/scene_builder.h"
#include "app/ui/scene/scene_bar.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/window/commands.h"
#include "app/ui/window/main_window.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QStackedWidget>

namespace app {

void MainWindow::makeBuilding()
{
    m_bench = new Workbench(m_session, this);
    auto *guide = new BuildGuide(m_session, *m_bench, this);
    new SceneBuilder(m_session, *m_bench, *guide, *m_scene, m_theme); // the scene's own
    makeBuildActions();
    m_build = new BuildPanel(m_session, *m_bench, *guide, makeToolActions(), m_theme, this);
    connect(m_build, &BuildPanel::leaving, this, [this] { setMode(Mode::learn); });
    auto *pages = new QStackedWidget(this);
    pages->setObjectName("leftPages");
    pages->addWidget(m_learn);
    pages->addWidget(m_build);
    m_left->setWidget(pages);
    connect(m_bench, &Workbench::changed, this, &MainWindow::followWorkshop);
    connect(&m_session, &Session::stepOpened, this, &MainWindow::followWorkshop);
    followWorkshop();
}

QList<QAction *> MainWindow::makeToolActions()
{
    auto *group = new QActionGroup(this);
    QList<QAction *> tools;
    const auto add = [&](BuildTool tool, const QString &text, const QString &name, const char *key,
                         const QString &tip, const char *icon) {
        QAction *made = m_commands->add(text, {QKeySequence(key)}, KeyGroup::build);
        made->setIconText(name);
        made->setToolTip(tr("%1 (%2)").arg(tip, key));
        made->setProperty("iconName", icon);
        made->setCheckable(true);
        group->addAction(made);
        m_buildActions.push_back(made);
        tools << made;
        connect(made, &QAction::triggered, this, [this, tool] { m_bench->setTool(tool); });
        connect(m_bench, &Workbench::changed, made,
                [bench = m_bench, made, tool] { made->setChecked(bench->tool() == tool); });
        made->setChecked(m_bench->tool() == tool);
    };
    add(BuildTool::select, tr("Choose and move parts"), tr("Choose"), "V",
        tr("Choose parts, and drag them to where they shall be"), "tool-select");
    add(BuildTool::point, tr("Add points"), tr("Point"), "P", tr("Add a body with a mass and a size"),
        "tool-point");
    add(BuildTool::nail, tr("Nail points down"), tr("Nail"), "N", tr("Fix a point where it is, or free it"),
        "tool-nail");
    add(BuildTool::spring, tr("Add springs"), tr("Spring"), "S",
        tr("Tie two points: a spring pulls and pushes them to its length"), "tool-spring");
    add(BuildTool::stick, tr("Add sticks"), tr("Stick"), "T", tr("Tie two points: a stick keeps its length"),
        "tool-stick");
    add(BuildTool::foot, tr("Add feet"), tr("Foot"), "F",
        tr("Give a body a foot, which belongs at an angle from it"), "tool-foot");
    return tools;
}

void MainWindow::makeBuildActions()
{
    const auto add = [this](const QString &text, const char *key, auto slot) {
        QAction *made = m_commands->add(text, {QKeySequence(key)}, KeyGroup::build);
        connect(made, &QAction::triggered, this, slot);
        m_edit->addAction(made);
        return made;
    };
    m_edit->addSeparator();
    m_take = add(tr("&Take this scene to the sandbox"), "Ctrl+B", [this] { takeToWorkshop(m_session); });
    m_sceneBar->addTool(*m_take, "take");
    m_edit->addSeparator();
    m_buildActions = {add(tr("&Delete what is chosen"), "Del", [this] { m_bench->eraseChosen(); }),
                      add(tr("Dup&licate what is chosen"), "Ctrl+J", [this] { m_bench->duplicateChosen(); }),
                      add(tr("Choose &all"), "Ctrl+A", [this] { m_bench->chooseAll(); })};
}

void MainWindow::followWorkshop()
{
    const bool builds = m_session.isWorkshop();
    const bool hasWorkshop = workshopOf(m_session.library());
    auto *pages = findChild<QStackedWidget *>("leftPages");
    const auto measure = [](QWidget *page, bool shown) { // only what is seen needs room
        const auto policy = shown ? QSizePolicy::Preferred : QSizePolicy::Ignored;
        page->setSizePolicy(policy, policy);
    };
    measure(m_learn, !builds);
    measure(m_build, builds);
    pages->setCurrentIndex(builds ? 1 : 0);
    placeRail();
    for (QAction *one : m_buildActions)
        one->setEnabled(builds);
    m_take->setEnabled(hasWorkshop && !builds);
    m_take->setToolTip(!hasWorkshop ? tr("No sandbox is installed")
                       : builds     ? tr("This scene is in the sandbox")
                                    : tr("Take this scene to the sandbox, to build on (Ctrl+B)"));
    m_modes->actions().at(static_cast<int>(Mode::build))->setEnabled(hasWorkshop);
    m_trip.note();
    if (m_mode == Mode::measure)
        return;
    arrangeFor(builds ? Mode::build : Mode::learn);
}

}
