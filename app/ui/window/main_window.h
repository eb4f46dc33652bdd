#pragma once

#include "app/model/analysis/accuracy_study.h"
#include "app/model/analysis/cost_monitor.h"
#include "app/model/analysis/stability_monitor.h"
#include "app/model/files/autosave.h"
#include "app/model/session/session.h"
#include "app/ui/actions/commands.h"
#include "app/ui/dialogs/window_place.h"
#include "app/ui/dock/panel_layout.h"
#include "app/ui/dock/panel_sizes.h"
#include "app/ui/dock/plots_dock.h"
#include "app/ui/theme/theme.h"

#include <QMainWindow>

#include <memory>

namespace app {

class AccuracyPanel;
class BranchesPanel;
class CodePages;
class DockFitter;
class EffectsPanel;
class EnergyPanel;
class ExperimentFiles;
class FailureNotice;
class GalleryDesk;
class HelpPages;
class Introduction;
class LearnPanel;
class LeftPages;
class LessonDesk;
class MeasureSeries;
class ModeChoice;
class NotebookDesk;
class NumbersPanel;
class PlotsPanel;
class RailChoice;
class RecoveryPrompt;
class Restart;
class SandboxCommands;
class SceneColumn;
class SceneExport;
class SettlingMonitor;
class StabilityDock;
class StabilityGauge;
class StabilityPanel;
class WindowKeys;
class WindowLayouts;
class YourLessons;

/// The window: lessons on the left, the scene with its time in the middle, code and parameters on the right. It
/// makes its parts and connects them.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    MainWindow(Session &session, Theme &theme, StudyFunction study = sim::studyAccuracy,
               CostFunction cost = measureCost, QWidget *parent = nullptr);
    ~MainWindow() override;

    using Mode = WindowMode;
    /// Arranges the window for a mode. In the build mode a sandbox is open; the learn mode leaves it.
    void setMode(Mode mode);
    Mode mode() const { return m_layout.id.mode; }

    const AccuracyStudy &study() const { return *m_study; }
    const StabilityMonitor &stability() const { return *m_stability; }
    const SettlingMonitor &settling() const { return *m_settling; }
    /// Returns the docks, which show and hide the panels.
    const Docks &docks() const { return m_layout.docks; }
    PlotsPanel &plots() const { return *m_plots; }
    const EffectsPanel &effects() const { return *m_effects; }
    StabilityPanel &stabilityPanel() const { return *m_stabilityPanel; }
    const FailureNotice &stopNotice() const;
    /// Shows a mistake in a document of a lesson, until it is mended. Empty: there is none.
    void showDocumentMistake(const QString &sentence);

    /// Makes the window no larger than `room`, px. Panels hide until the others fit, and come back when there is
    /// room again or when the learner asks for them.
    void fitInto(QSize room);
    /// Returns what shows the tour and the map of concepts.
    Introduction &introduction() const { return *m_introduction; }

    /// Opens an experiment file. If it is invalid, the reason is shown and nothing changes.
    void openFile(const QString &path);
    /// Writes the run so far. Returns whether it was written; a failure is shown.
    bool saveFile(const QString &path);
    /// Writes the scene as it is shown, as PNG or SVG. Returns whether it was written; a failure is shown.
    bool savePictureAs(const QString &path);
    /// Saves what is not saved yet to `folder` within `within` ms of each change from now on, and offers what
    /// earlier starts have left there.
    void autosaveIn(const QString &folder, int within = Autosave::saveWithin);
    /// Keeps the gallery in `folder` from now on. Before, there is none.
    void keepGalleryIn(const QString &folder);
    /// Offers to open and to begin lessons without C++, which are kept in `lessons`. `lessons` must outlive the window.
    void offerYourLessons(YourLessons &lessons);

    /// Returns what closes this window for another one that continues from it.
    Restart &restart() const { return *m_restart; }

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;

private:
    void makeDocks();
    void makePanels(CostFunction cost);
    void makeCode();
    void makeLayouts();
    void makeSandbox();
    void makeMenus();
    void makeFiles();
    void connectPanels();
    void connectCommands();
    void connectHelp();
    void setSceneOnly(bool isOn);

    Session &m_session;
    Theme &m_theme;
    Commands m_commands;
    PanelLayout m_layout;
    PanelSizes m_sizes{m_layout};
    PlotsDock m_plotsDock{m_layout};
    WindowPlace m_place{*this};
    std::unique_ptr<RailChoice> m_rail;
    std::unique_ptr<DockFitter> m_fitter;
    std::unique_ptr<StabilityDock> m_stabilityDock;
    std::unique_ptr<WindowLayouts> m_layouts;
    std::unique_ptr<ModeChoice> m_mode;
    std::unique_ptr<SandboxCommands> m_sandbox;
    std::unique_ptr<ExperimentFiles> m_files;
    std::unique_ptr<RecoveryPrompt> m_recovery;
    std::unique_ptr<GalleryDesk> m_gallery;
    std::unique_ptr<NotebookDesk> m_notebook;
    std::unique_ptr<HelpPages> m_help;
    std::unique_ptr<Introduction> m_introduction;
    std::unique_ptr<SceneExport> m_export;
    std::unique_ptr<Restart> m_restart;
    std::unique_ptr<WindowKeys> m_keys;

    MeasureSeries *m_measures; ///< what the steps measure
    /// Shared by all measurements of time, so that they do not disturb each other.
    std::shared_ptr<QThreadPool> m_measuringThread = makeJobThread();
    AccuracyStudy *m_study;
    StabilityMonitor *m_stability;
    SettlingMonitor *m_settling;
    SceneColumn *m_centre;
    LeftPages *m_left = nullptr;
    LearnPanel *m_learn = nullptr;
    LessonDesk *m_lessons = nullptr;
    AccuracyPanel *m_accuracy = nullptr;
    EnergyPanel *m_energy = nullptr;
    EffectsPanel *m_effects = nullptr;
    BranchesPanel *m_branches = nullptr;
    CodePages *m_code = nullptr;
    PlotsPanel *m_plots = nullptr;
    NumbersPanel *m_numbers = nullptr;
    StabilityPanel *m_stabilityPanel = nullptr;
    StabilityGauge *m_gauge = nullptr;
};

}
