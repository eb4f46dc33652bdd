#pragma once

#include "app/model/accuracy_study.h"
#include "app/model/cost_watch.h"
#include "app/model/scene_keeper.h"
#include "app/model/session.h"
#include "app/model/stability_watch.h"
#include "app/model/workshop_trip.h"
#include "app/ui/theme/theme.h"
#include "app/ui/window/layout_store.h"
#include "app/ui/window/left.h"
#include "app/ui/window/place_keeper.h"

#include <QMainWindow>

#include <memory>
#include <optional>
#include <vector>

class QActionGroup;
class QDockWidget;
class QMouseEvent;

namespace app {

class AboutPage;
class AccuracyPanel;
class BranchesPanel;
class BuildPanel;
class CodePanel;
class Commands;
class Course;
class EffectsPanel;
class EnergyPanel;
class ExperimentFiles;
class FilmDialog;
class FootfallStrip;
class GlossaryPage;
class HelpPage;
class KeptOffer;
class LearnPanel;
class Notice;
class MeasurePanel;
class ParameterPanel;
class PlotsPanel;
class Room;
class SceneBar;
class SceneCard;
class SceneView;
class StabilityGauge;
class StabilityPanel;
class StopNotice;
class TimelineStrip;
class Tour;
class TransportBar;
struct TourStop;
class Workbench;

/// The window: lessons on the left, the scene with its time in the middle, code and parameters on the right.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    MainWindow(Session &session, Theme &theme, StudyFunction study = sim::studyAccuracy,
               CostFunction cost = measureCost, QWidget *parent = nullptr);
    ~MainWindow() override;

    /// What the window is arranged for.
    using Mode = WindowMode;
    void setMode(Mode mode);
    Mode mode() const { return m_mode; }
    const AccuracyStudy &study() const { return *m_study; }
    /// Whether the ledger of energy is seen, below the picture.
    void showEnergy(bool shown);
    /// Whether the ledger of effects is seen: below the picture, or with accuracy where that is measured.
    void showEffects(bool shown);
    /// Whether two runs are compared, below the picture.
    void showBranches(bool shown);
    /// Whether the plots are seen: between code and parameters where there is room, else as a tab beside the code, or
    /// beside accuracy where that is measured.
    void showPlots(bool shown);
    PlotsPanel &plots() const { return *m_plots; }
    const EffectsPanel &effects() const { return *m_effects; }
    const StabilityWatch &stability() const { return *m_stability; }
    const StopNotice &stopNotice() const { return *m_stopNotice; }
    /// Shows what bounds the step in place of code or accuracy, or those again.
    void showStability(bool shown);
    /// The map of growth, where the step has one.
    void showGrowthMap(MapPlane plane);

    /// Makes the window no larger than `room`, px. Panels step aside until it goes into that, and come back when there is
    /// room again, or when they are asked for.
    void fitInto(QSize room);
    /// Whether the tour was never started on this machine.
    static bool wantsTour();
    /// Cards that point at the parts of the window, one after the other.
    void startTour();

    /// Opens an experiment file. A file that is refused is named with the reason, and nothing changes.
    void openFile(const QString &path);
    /// Writes the run so far. Returns whether it was written; a failure is shown.
    bool saveFile(const QString &path);
    /// Writes the scene as it is shown, as PNG or SVG. Returns whether it was written; a failure is shown.
    bool savePictureAs(const QString &path);
    /// Keeps what is not saved in `folder` from now on, `within` ms, and offers what programs before have left there.
    void keepScenesIn(const QString &folder, int within = SceneKeeper::keepWithin);

    /// Opens the step that was open last, in this program or one before; nothing where there is none.
    void openLast();
    /// Closes the window so that another one can go on with what is in it: see left(). Nothing is lost, so nothing is asked.
    void startAgain();
    /// What another window is to go on with; empty where this one is simply closed.
    const std::optional<Left> &left() const { return m_leaves; }
    /// Goes on with what a window before left on the same session. keepScenesIn() is to be called after it, and does not offer
    /// what is open.
    void goOn(const Left &from);

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    static constexpr const char *heightOfParameters = "parameters"; ///< where the learner chose it

    void makeActions();
    void makeFileActions();
    void makeEditActions();
    void nameDeeds();
    void makeTimeActions();
    void makeViewActions();
    void makeModeActions();
    void makeAppearanceActions();
    void makeSchemeActions();
    void makeSizeActions();
    void makeFocusActions();
    void rememberChoices();
    /// Whether nothing moves that only decorates.
    void setStill(bool still);
    void setFocusMode(bool on);
    void enterFocus();
    void leaveFocus();
    /// Where the arrangement for `mode` is kept in the settings.
    QString layoutKey(Mode mode) const;
    static QString layoutKey(Mode mode, bool isWide);
    void keepLayout();
    /// As restoreState(), also while the window is still to be laid out.
    bool restorePanels(const QByteArray &state);
    void saveLayouts();
    /// Arranges the panels as they were kept for the preset in use, or as it has them at first.
    void useLayout(Mode before);
    void resetLayout();
    void makeRailAction();
    void chooseForm(bool isRail);
    void useKeptForm();
    void placeRail();
    /// A column of panels beside the scene.
    struct Side
    {
        QDockWidget *dock; ///< one of its panels
        const char *name;  ///< for the settings
        int width;         ///< px that it is to have
        int least;         ///< px, where the scene needs the room
    };
    bool isBeside(const QDockWidget &dock, Qt::DockWidgetArea area) const;
    std::vector<Side> sides() const;
    /// Gives the panels beside the scene their widths: those that the learner chose, else those that suit the window.
    void placeSides();
    /// The mouse is pressed: remembers what is beside the separator there, if one is there.
    void noteSeparator(const QMouseEvent &event);
    /// Keeps the lengths that a separator was dragged to.
    void keepSides();
    /// Changes to a preset, without what belongs to it besides its panels.
    void arrangeFor(Mode mode);
    void makeLanguageMenu();
    void chooseLanguage(const QString &code, const QString &spoken);
    void makeBuilding();
    QList<QAction *> makeToolActions();
    void makeBuildActions();
    void followWorkshop();
    QWidget *modeSwitch();
    void arrangeForMeasuring();
    QWidget *header();
    QWidget *centre();
    void makeDocks(CostFunction cost);
    void makeCodeDock();
    void makeParameterDock();
    QDockWidget *dock(const QString &name, QWidget *title, QWidget *content, Qt::DockWidgetArea area);
    static void showDock(QDockWidget &dock, bool shown);
    void fitParameters();
    void showMeasures();
    void makeStability();
    void makeBranchesDock();
    void makeBranchActions();
    void makePlots();
    void makePlotsAction();
    /// Where the mouse is in a plot, or on the timeline, is the moment that all show, as long as it is there.
    void joinCursors();
    void arrangePlots();
    bool hasRoomForPlots() const;
    void showHelp();
    void makeLearning();
    void showGlossary(const QString &typed);
    std::vector<TourStop> tourStops();
    /// Gives the keys to the scene where the widget that had them has gone out of sight: the next in the row, to which
    /// they went, would be pressed by whoever means to play.
    void catchFocus(const QWidget *before, const QWidget *now);
    void rememberStep();
    /// Starts again, unless that would stop a film: then it says what comes with the next start, and offers that.
    void startAgainFor(const QString &sentence);
    void makeExportActions();
    void copyPicture();
    void askPicture();
    void showFilm();
    void restore();
    void makeFiles();
    void nameWindow();

    Session &m_session;
    Theme &m_theme;
    std::unique_ptr<ExperimentFiles> m_files;
    std::unique_ptr<KeptOffer> m_kept;
    std::unique_ptr<Commands> m_commands;
    std::unique_ptr<Room> m_room;
    std::optional<Left> m_leaves;
    PlaceKeeper m_place{*this};
    Course *m_course; ///< what the steps measure
    AccuracyStudy *m_study;
    StabilityWatch *m_stability;
    Mode m_mode = Mode::learn;
    LayoutStore m_layouts;
    QString m_layoutKey;     ///< of the arrangement in use
    QByteArray m_firstDocks; ///< the arrangement of a new window
    WorkshopTrip m_trip;
    QMenu *m_file = nullptr;
    QMenu *m_edit = nullptr;
    QMenu *m_run = nullptr;
    QMenu *m_view = nullptr;
    QMenu *m_help = nullptr;
    QAction *m_play = nullptr;
    QAction *m_undo = nullptr;
    QAction *m_redo = nullptr;
    QAction *m_helpAction = nullptr;
    QAction *m_focusAction = nullptr;
    QByteArray m_docksBeforeFocus; ///< the arrangement that comes back when focus mode ends
    QActionGroup *m_modes = nullptr;
    QAction *m_take = nullptr;             ///< takes the scene to the workshop
    std::vector<QAction *> m_buildActions; ///< that do something only while a scene is built
    Workbench *m_bench = nullptr;
    BuildPanel *m_build = nullptr;

    LearnPanel *m_learn = nullptr;
    SceneBar *m_sceneBar = nullptr;
    SceneView *m_scene = nullptr;
    SceneCard *m_card = nullptr; ///< over the scene, while it is alone
    StopNotice *m_stopNotice = nullptr;
    TransportBar *m_transport = nullptr;
    TimelineStrip *m_timeline = nullptr;
    FootfallStrip *m_footfall = nullptr;
    CodePanel *m_code = nullptr;
    ParameterPanel *m_parameters = nullptr;
    MeasurePanel *m_measures = nullptr;
    QWidget *m_measureLine = nullptr; ///< between measures and parameters
    Notice *m_notice = nullptr;
    HelpPage *m_helpPage = nullptr;
    FilmDialog *m_film = nullptr;
    GlossaryPage *m_glossaryPage = nullptr;
    AboutPage *m_about = nullptr;
    Tour *m_tour = nullptr;
    AccuracyPanel *m_accuracy = nullptr;
    BranchesPanel *m_branches = nullptr;
    EnergyPanel *m_energy = nullptr;
    EffectsPanel *m_effects = nullptr;
    PlotsPanel *m_plots = nullptr;
    StabilityGauge *m_gauge = nullptr;
    StabilityPanel *m_stabilityPanel = nullptr;
    QAction *m_stabilityAction = nullptr;
    QDockWidget *m_left = nullptr;
    QAction *m_railAction = nullptr;
    QDockWidget *m_accuracyDock = nullptr;
    QDockWidget *m_branchesDock = nullptr;
    QDockWidget *m_energyDock = nullptr;
    QDockWidget *m_effectsDock = nullptr;
    QDockWidget *m_codeDock = nullptr;
    QDockWidget *m_plotsDock = nullptr;
    QDockWidget *m_parameterDock = nullptr;
    QDockWidget *m_stabilityDock = nullptr;
    QDockWidget *m_replaced = nullptr;   ///< what stands aside while stability is shown
    std::vector<Side> m_besideSeparator; ///< that is dragged
    int m_heightBefore = 0;              ///< of the parameters
};

}
