#include "app/ui/window/main_window.h"

#include "app/model/sandbox/build_guide.h"
#include "app/model/sandbox/sandbox_editor.h"
#include "app/model/series/measure_series.h"
#include "app/ui/accuracy/accuracy_panel.h"
#include "app/ui/actions/sandbox_commands.h"
#include "app/ui/branches/branches_panel.h"
#include "app/ui/code/code_pages.h"
#include "app/ui/code/listing/rule_panel.h"
#include "app/ui/dialogs/notice.h"
#include "app/ui/dialogs/recovery_prompt.h"
#include "app/ui/dock/arrange_menu.h"
#include "app/ui/dock/dock_fitter.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/dock/rail_choice.h"
#include "app/ui/dock/stability_dock.h"
#include "app/ui/dock/window_layouts.h"
#include "app/ui/effects/effects_panel.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/lessons/lesson_desk.h"
#include "app/ui/learn/step/narration.h"
#include "app/ui/notebook/notebook_desk.h"
#include "app/ui/parameters/parameter_panel.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/sandbox/build_panel.h"
#include "app/ui/sandbox/scene_builder.h"
#include "app/ui/scene/scene_bar.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/settings/appearance.h"
#include "app/ui/settings/language_menu.h"
#include "app/ui/settings/size_menu.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/stability/stability_panel.h"
#include "app/ui/status/status_line.h"
#include "app/ui/time/runs_menu.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/experiment_files.h"
#include "app/ui/window/gallery_desk.h"
#include "app/ui/window/header.h"
#include "app/ui/window/help_pages.h"
#include "app/ui/window/introduction.h"
#include "app/ui/window/last_step.h"
#include "app/ui/window/left_pages.h"
#include "app/ui/window/menus.h"
#include "app/ui/window/mode_choice.h"
#include "app/ui/window/numbers_panel.h"
#include "app/ui/window/preview_links.h"
#include "app/ui/window/restart.h"
#include "app/ui/window/scene_column.h"
#include "app/ui/window/scene_export.h"
#include "app/ui/window/window_keys.h"

#include <QActionGroup>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMenu>

namespace app {

namespace {

/// Tells a panel whether another tab covers its dock, so that it computes only what is seen.
template <typename Content>
void followCover(const QDockWidget &dock, Content *content)
{
    QObject::connect(&dock, &QDockWidget::visibilityChanged, content,
                     [content](bool isSeen) { content->setCovered(!isSeen); });
}

}

MainWindow::MainWindow(Session &session, Theme &theme, StudyFunction study, CostFunction cost,
                       QWidget *parent)
    : QMainWindow(parent), m_session(session), m_theme(theme), m_commands(*this, session), m_layout(*this),
      m_measures(new MeasureSeries(session.run(), this)),
      m_study(new AccuracyStudy(session.run(), session.editor(), std::move(study), m_measuringThread, this)),
      m_stability(new StabilityMonitor(session.run(), session.editor(), session.preview(), this)),
      m_settling(new SettlingMonitor(session.run(), session.editor(), session.playback(), this)),
      m_centre(new SceneColumn(session, *m_measures, m_commands.run, theme, this))
{
    setWindowIcon(QIcon(":/app/springstep.svg"));
    setDockOptions(QMainWindow::AnimatedDocks);
    setDocumentMode(true);
    setMinimumSize(leastWindow); // panels hide before it is as small as that
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCentralWidget(m_centre);
    m_centre->bar().attach(m_centre->scene(), *m_commands.view.fit);
    m_centre->scene().attach(*m_study);
    makeDocks();
    makePanels(std::move(cost));
    connectPanels();
    makeLayouts();
    makeSandbox();
    makeFiles();
    connectCommands();
    makeMenus();
    setStatusBar(new StatusLine(m_session.run(), m_session.playback(), m_session.preview(), m_commands.run,
                                *m_study, *m_stability, m_gauge, this));
    if (!m_place.restore())
        resize(1280, 800);
    m_layouts->restoreAtStart();
    m_stabilityDock->hide();
    m_layout.docks.show(Panel::plots, PlotsDock::isWanted());
    m_centre->scene().setFocus();
}

MainWindow::~MainWindow() = default;

void MainWindow::makeDocks()
{
    const auto left = Qt::LeftDockWidgetArea, right = Qt::RightDockWidgetArea,
               below = Qt::BottomDockWidgetArea;
    Docks &docks = m_layout.docks;
    for (const DockEntry &entry : {
             DockEntry{Panel::lessons, "lessons", tr("Lessons"), left, DockStart::open},
             DockEntry{Panel::accuracy, "accuracy", tr("Accuracy"), right, DockStart::hidden},
             DockEntry{Panel::energy, "energy", tr("Energy"), below, DockStart::hidden},
             DockEntry{Panel::effects, "effects", tr("Effects"), below, DockStart::hidden},
             DockEntry{Panel::branches, "branches", tr("Two runs"), below, DockStart::hidden},
             DockEntry{Panel::code, "code", tr("Code"), right, DockStart::open},
             DockEntry{Panel::plots, "plots", tr("Plots"), right, DockStart::open},
             DockEntry{Panel::parameters, "parameters", tr("Parameters"), right, DockStart::open},
             DockEntry{Panel::stability, "stability", tr("Stability"), right, DockStart::hidden},
         })
        docks.add(entry);
    // Qt computes the least sizes of all docks for this, which takes long when they have contents.
    m_layout.first = saveState();
}

void MainWindow::makePanels(CostFunction cost)
{
    Docks &docks = m_layout.docks;
    m_left = new LeftPages(&docks[Panel::lessons]);
    m_learn = new LearnPanel(m_session, m_theme, m_left);
    m_learn->setKeys(m_commands.view.lessonRail->shortcut(), m_commands.run.previousStep->shortcut(),
                     m_commands.run.nextStep->shortcut());
    m_left->setLessons(*m_learn);
    docks.fill(Panel::lessons, *m_left);
    m_accuracy = new AccuracyPanel(*m_study, m_session.preview(), m_theme, &docks[Panel::accuracy]);
    docks.fill(Panel::accuracy, *m_accuracy);
    m_energy = new EnergyPanel(m_session.run(), m_session.playback(), m_session.preview(), m_theme,
                               &docks[Panel::energy]);
    docks.fill(Panel::energy, *m_energy);
    m_effects = new EffectsPanel(m_session.run(), m_session.editor(), m_session.playback(), m_theme,
                                 std::move(cost), m_measuringThread, &docks[Panel::effects]);
    docks.fill(Panel::effects, *m_effects);
    m_branches = new BranchesPanel(m_session.run(), m_session.editor(), m_session.playback(),
                                   m_session.comparisons(), m_theme, &docks[Panel::branches]);
    docks.fill(Panel::branches, *m_branches);
    makeCode();
    m_plots = new PlotsPanel(m_session.run(), m_session.playback(), m_session.preview(),
                             m_session.comparisons(), m_theme, &docks[Panel::plots]);
    docks.fill(Panel::plots, *m_plots);
    m_numbers = new NumbersPanel(m_session.run(), m_session.editor(), m_session.playback(),
                                 m_session.preview(), *m_measures, m_theme, &docks[Panel::parameters]);
    docks.fill(Panel::parameters, *m_numbers);
    m_gauge = new StabilityGauge(*m_stability, *m_commands.view.stability, m_theme, this);
    m_stabilityPanel = new StabilityPanel(*m_stability, *m_settling, *m_commands.view.stability,
                                          *m_commands.view.settling, m_theme, &docks[Panel::stability]);
    docks.fill(Panel::stability, *m_stabilityPanel);
}

void MainWindow::makeCode()
{
    QDockWidget &dock = m_layout.docks[Panel::code];
    m_code = new CodePages(m_session, m_theme, &dock);
    auto *title = new PanelTitle(tr("Code"), m_theme, &dock);
    title->setCaption(m_code->caption());
    title->addTabs(m_code->titleTabs());
    title->addAction(m_code->titleActions());
    title->setShortCaption(m_code->shortCaption());
    connect(m_code, &CodePages::captionChanged, title, [this, title](const QString &caption) {
        title->setShortCaption(m_code->shortCaption());
        title->setCaption(caption);
    });
    m_layout.docks.fill(Panel::code, *m_code, title);
}

void MainWindow::connectPanels()
{
    const Docks &docks = m_layout.docks;
    followCover(docks[Panel::energy], m_energy);
    followCover(docks[Panel::effects], m_effects);
    followCover(docks[Panel::branches], m_branches);
    followCover(docks[Panel::plots], m_plots);
    Notice *notice = &m_centre->notice();
    m_centre->scene().attach(m_learn->narration().predictions());
    m_centre->scene().attach(m_learn->projects());
    m_code->attach(m_centre->scene(), m_commands.run);
    connect(&m_learn->narration(), &Narration::listingRequested, this, [this](int line) {
        m_layout.docks.show(Panel::code, true);
        m_code->writeAt(line);
    });
    // The receivers are alive when the focus leaves a formula because the window is destroyed.
    connect(&m_learn->narration(), &Narration::highlightsChanged, &m_centre->scene(),
            &SceneView::setHighlights);
    connect(&m_learn->narration(), &Narration::highlightsChanged, &m_numbers->parameters(),
            &ParameterPanel::setHighlights);
    connect(m_plots, &PlotsPanel::failed, notice, &Notice::showMessage);
    for (const PlotExport *exports : {&m_energy->exports(), &m_accuracy->exports(), &m_branches->exports(),
                                      &m_stabilityPanel->exports()}) {
        connect(exports, &PlotExport::messageRequested, &m_session, &Session::showMessage);
        connect(exports, &PlotExport::failed, notice, &Notice::showMessage);
    }
    const auto compare = [&docks] { docks.show(Panel::branches, true); };
    connect(&m_centre->transport().runs(), &RunsMenu::compareWanted, this, compare);
    connect(&m_centre->timeline(), &TimelineStrip::compareWanted, this, compare);
    connectPreviews(m_session.run(), m_session.preview(),
                    {*m_centre, *m_plots, *m_energy, *m_branches, *m_accuracy});
    m_keys = std::make_unique<WindowKeys>(*this, m_centre->scene(), m_commands.list, m_session);
}

void MainWindow::makeLayouts()
{
    m_rail = std::make_unique<RailChoice>(m_layout, *m_learn, m_session.run(), m_sizes,
                                          *m_commands.view.lessonRail);
    m_fitter = std::make_unique<DockFitter>(m_layout, *m_learn, m_centre->scene());
    m_stabilityDock = std::make_unique<StabilityDock>(m_layout, m_sizes);
    m_layouts = std::make_unique<WindowLayouts>(m_layout, *m_fitter, m_sizes, m_plotsDock, *m_rail);
    connect(m_plots, &PlotsPanel::wantedHeightChanged, &m_sizes, &PanelSizes::fitHeights);
    connect(m_numbers, &NumbersPanel::wantedHeightChanged, &m_sizes, &PanelSizes::fitHeights);
    connect(m_fitter.get(), &DockFitter::sidesChanged, &m_sizes, &PanelSizes::fit);
    Docks &docks = m_layout.docks;
    docks.setShowFunction(Panel::plots, [this](bool isShown) {
        m_plotsDock.show(isShown);
        m_sizes.fitHeights();
    });
    docks.setShowFunction(Panel::stability, [this](bool isShown) {
        isShown ? m_stabilityDock->show() : m_stabilityDock->hide();
    });
    connect(m_gauge, &StabilityGauge::clicked, this,
            [&docks](bool isShown) { docks.show(Panel::stability, isShown); });
    connect(m_stabilityPanel, &StabilityPanel::closed, m_stabilityDock.get(), &StabilityDock::hide);
    connect(m_stabilityDock.get(), &StabilityDock::shownChanged, m_gauge, &StabilityGauge::setChecked);
    connect(m_stabilityDock.get(), &StabilityDock::shownChanged, m_commands.view.stability,
            &QAction::setChecked);
    connect(m_stabilityPanel, &StabilityPanel::settlingShown, m_commands.view.settling, &QAction::setChecked);
    connect(m_stabilityDock.get(), &StabilityDock::closed, &m_centre->scene(),
            qOverload<>(&QWidget::setFocus));
    connect(m_layouts.get(), &WindowLayouts::aboutToArrange, this, [this] {
        m_commands.view.sceneOnly->setChecked(false);
        m_stabilityDock->hide();
    });
    connect(m_layouts.get(), &WindowLayouts::modeChanged, this, [this](Mode mode) {
        m_commands.view.modes().at(static_cast<std::size_t>(mode))->setChecked(true);
    });
}

void MainWindow::makeSandbox()
{
    auto *editor = new SandboxEditor(m_session, this);
    auto *guide = new BuildGuide(m_session.run(), m_session.editor(), m_session.playback(), *editor, this);
    auto *builder = new SceneBuilder(m_session.run(), m_session.editor(), m_session.preview(), *editor,
                                     *guide, m_centre->scene(), m_theme); // owned by the scene
    m_sandbox = std::make_unique<SandboxCommands>(m_session, *editor, m_commands.list);
    m_centre->bar().addTool(*m_sandbox->take);
    auto *build = new BuildPanel(m_session.run(), m_session.editor(), m_session.playback(), *editor, *guide,
                                 *m_sandbox, m_commands, m_theme, m_left);
    build->showProject(m_learn->projects());
    m_left->setTools(*build);
    connect(builder, &SceneBuilder::partChosen, build, &BuildPanel::showProperties);
    connect(build, &BuildPanel::leaving, this, [this] { setMode(Mode::learn); });
    m_code->rule().addCommand(*m_sandbox->tools().back());
    m_code->rule().addCommand(*m_sandbox->linkChosen);
    connect(m_sandbox->rule, &QAction::triggered, this, [this] {
        m_layout.docks.show(Panel::code, true);
        m_code->choose(CodePages::Page::rule);
        m_code->rule().setFocus(Qt::ShortcutFocusReason);
    });
    m_mode = std::make_unique<ModeChoice>(m_session, *m_layouts, *m_rail, m_sizes, *m_left,
                                          *m_commands.view.build);
    connect(editor, &SandboxEditor::changed, m_mode.get(), &ModeChoice::followStep);
    connect(editor, &SandboxEditor::renamed, m_plots,
            [this](const QString &from, const QString &to) { m_plots->list().renameBody(from, to); });
}

void MainWindow::makeFiles()
{
    m_files = std::make_unique<ExperimentFiles>(m_session, m_centre->notice(), *this);
    m_recovery =
        std::make_unique<RecoveryPrompt>(m_session.run(), m_session.playback(), m_session.comparisons(),
                                         *m_files, m_centre->notice(), m_theme);
    m_help = std::make_unique<HelpPages>(m_session, m_commands.list, m_learn->glossary(), m_theme, *this);
    m_learn->setMapCommand(*m_commands.help.map);
    m_introduction = std::make_unique<Introduction>(
        TourParts{m_layout, *m_mode, *m_centre, *m_learn, *m_code, m_numbers->parameters(), m_commands},
        m_session, *m_help, m_theme);
    m_export = std::make_unique<SceneExport>(m_session, m_centre->scene(), *m_plots, m_centre->notice(),
                                             m_theme, *this);
    m_gallery = std::make_unique<GalleryDesk>(m_session, m_centre->scene(), m_learn->projects(), *m_files,
                                              m_centre->notice(), m_theme, *this);
    m_notebook = std::make_unique<NotebookDesk>(m_session.library(), m_session.progress(), m_session.notes(),
                                                m_session.proofs(), *this);
    for (Command *command : {m_commands.file.keep, m_commands.file.gallery})
        command->setObstacle(tr("There is no folder for the gallery"));
    m_restart = std::make_unique<Restart>(
        RestartParts{m_session, m_files->document(), *m_mode, *m_commands.view.sceneOnly}, *m_export,
        m_centre->notice(), *this);
    m_session.onChange(ChangeKind::step, this, [this] { LastStep::store(m_session.run()); });
}

void MainWindow::connectCommands()
{
    const FileCommands &file = m_commands.file;
    const EditCommands &edit = m_commands.edit;
    const RunCommands &run = m_commands.run;
    const ViewCommands &view = m_commands.view;
    const auto on = [this](const Command *command, auto slot) {
        connect(command, &QAction::triggered, this, slot);
    };
    on(file.startNew, [this] { m_files->startNew(); });
    on(file.open, [this] { m_files->askOpen(); });
    on(file.recover, [this] { m_recovery->showList(); });
    on(file.save, [this] { m_files->saveOrAsk(); });
    on(file.saveAs, [this] { m_files->askSave(); });
    on(file.keep, [this] { m_gallery->keep(); });
    on(file.gallery, [this] { m_gallery->showPage(); });
    on(file.handIn, [this] { m_notebook->show(); });
    on(file.exportPicture, [this] { m_export->askPicture(); });
    on(file.exportFilm, [this] { m_export->showFilm(); });
    on(file.exportWebPage, [this] { m_export->showWebPage(); });
    on(file.exportHandout, [this] { m_export->askHandout(); });
    on(file.quit, [this] { close(); });
    on(edit.copyText, [this] { m_files->copyAsText(); });
    on(edit.pasteText, [this] { m_files->pasteText(); });
    on(edit.copyPicture, [this] { m_export->copyPicture(); });
    on(run.nextStep, [this] { m_learn->goOn(); });
    on(run.previousStep, [this] { m_learn->goBack(); });

    auto *modes = new QActionGroup(this);
    for (const Mode mode : {Mode::learn, Mode::measure, Mode::build}) {
        Command *command = view.modes().at(static_cast<std::size_t>(mode));
        modes->addAction(command);
        command->setChecked(mode == this->mode());
        on(command, [this, mode] { setMode(mode); });
    }
    on(view.zoomIn, [this] { m_centre->scene().zoomIn(); });
    on(view.zoomOut, [this] { m_centre->scene().zoomOut(); });
    on(view.fit, [this] { m_centre->scene().fit(); });
    on(view.nextOutside, [this] { m_centre->scene().showNextOutside(); });
    Docks &docks = m_layout.docks;
    docks.toggleTogether(*view.lessons, {Panel::lessons});
    docks.toggleTogether(*view.codeAndParameters, {Panel::code, Panel::parameters});
    docks.toggle(*view.energy, Panel::energy);
    docks.toggle(*view.effects, Panel::effects);
    docks.toggle(*run.compare, Panel::branches);
    docks.toggle(*view.plots, Panel::plots);
    on(view.stability, [&docks](bool isShown) { docks.show(Panel::stability, isShown); });
    on(view.settling, [this, &docks](bool isShown) {
        if (isShown)
            docks.show(Panel::stability, true);
        m_stabilityPanel->showSettling(isShown);
    });
    m_commands.list.add(*m_effects->measureAgain(), KeyGroup::window);
    on(view.resetPanels, [this] {
        m_layouts->reset();
        m_session.showMessage(tr("The panels are back in their original places."));
    });
    connect(view.sceneOnly, &QAction::toggled, this, &MainWindow::setSceneOnly);
    on(view.fullScreen, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    connectHelp();
}

void MainWindow::connectHelp()
{
    const HelpCommands &help = m_commands.help;
    const auto on = [this](const Command *command, auto slot) {
        connect(command, &QAction::triggered, this, slot);
    };
    on(help.keys, [this] { m_help->showKeys(); });
    on(help.hint, [this] {
        m_layout.docks[Panel::lessons].show();
        m_learn->setForm(LearnPanel::Form::whole);
        m_learn->showSummary(false);
        m_learn->narration().showNextHint();
    });
    on(help.glossary, [this] { m_help->showGlossary({}); });
    on(help.tour, [this] { m_introduction->startTour(); });
    on(help.map, [this] { m_introduction->showMap(); });
    on(help.about, [this] { m_help->showAbout(); });
    connect(m_learn, &LearnPanel::glossaryRequested, this,
            [this](const QString &typed) { m_help->showGlossary(typed); });
}

void MainWindow::makeMenus()
{
    auto *recent = new QMenu(tr("Open &recent"), this);
    recent->setToolTipsVisible(true);
    connect(recent, &QMenu::aboutToShow, this, [this, recent] { m_files->fillRecent(*recent); });
    const ViewCommands &view = m_commands.view;
    auto *arrange = new ArrangeMenu(*this, *view.unlockPanels, *view.resetPanels, m_theme);
    connect(arrange, &ArrangeMenu::moved, &m_sizes, &PanelSizes::fitHeights);
    auto *language = new LanguageMenu(this);
    auto *size = new SizeMenu(this);
    const auto dismiss = [this] { m_centre->notice().showMessage({}); };
    connect(language, &LanguageMenu::unchanged, this, dismiss);
    connect(language, &LanguageMenu::restartWanted, m_restart.get(), &Restart::offer);
    connect(size, &SizeMenu::unchanged, this, dismiss);
    connect(size, &SizeMenu::restartWanted, m_restart.get(), &Restart::offer);
    new Appearance(*this, m_centre->bar(), m_centre->scene(), view, m_theme);
    const Submenus submenus{recent, &m_centre->transport().runs(), arrange, language, size};
    m_lessons = new LessonDesk(m_session, m_files->document(), m_commands.list, m_centre->notice(), *this);
    connect(m_files.get(), &ExperimentFiles::lessonChosen, m_lessons, &LessonDesk::open);
    setMenuWidget(new Header(makeMenuBar(m_commands, *m_sandbox, *m_lessons, submenus, this), m_commands,
                             m_theme, this));
}

void MainWindow::setMode(Mode mode)
{
    m_mode->choose(mode);
}

void MainWindow::showDocumentMistake(const QString &sentence)
{
    m_centre->notice().showMessage(sentence);
}

const FailureNotice &MainWindow::stopNotice() const
{
    return m_centre->failure();
}

void MainWindow::setSceneOnly(bool isOn)
{
    if (isOn) {
        m_stabilityDock->hide();
        m_layouts->hideAll();
        m_centre->showAlone();
    } else {
        m_centre->showBesidePanels();
        m_layouts->showAll();
    }
}

void MainWindow::fitInto(QSize room)
{
    resize(size().boundedTo(room));
    m_fitter->share();
}

void MainWindow::openFile(const QString &path)
{
    m_files->open(path);
}

bool MainWindow::saveFile(const QString &path)
{
    return m_files->save(path);
}

bool MainWindow::savePictureAs(const QString &path)
{
    return m_export->savePicture(path);
}

void MainWindow::autosaveIn(const QString &folder, int within)
{
    m_recovery->autosaveIn(folder, within);
}

void MainWindow::keepGalleryIn(const QString &folder)
{
    m_gallery->setFolder(folder);
    m_notebook->setGallery(folder);
    for (Command *command : {m_commands.file.keep, m_commands.file.gallery})
        command->setObstacle({});
}

void MainWindow::offerYourLessons(YourLessons &lessons)
{
    m_lessons->setLessons(lessons);
}

void MainWindow::changeEvent(QEvent *event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::WindowStateChange)
        m_commands.view.fullScreen->setChecked(isFullScreen());
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!m_restart->handover() && !m_files->mayClose()) {
        event->ignore();
        return;
    }
    m_place.keep();
    m_stabilityDock->hide();
    m_layouts->save();
    QMainWindow::closeEvent(event);
}

}
