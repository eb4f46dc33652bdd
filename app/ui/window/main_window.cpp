#include "app/ui/window/main_window.h"

#include "app/model/course.h"
#include "app/model/words.h"
#include "app/ui/panels/help_page.h"
#include "app/ui/scene/scene_bar.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/time/footfall_strip.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/commands.h"
#include "app/ui/window/divider.h"
#include "app/ui/window/experiment_files.h"
#include "app/ui/window/kept_offer.h"
#include "app/ui/window/notice.h"
#include "app/ui/window/room.h"
#include "app/ui/window/status_line.h"
#include "app/ui/window/stop_notice.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QSettings>
#include <QVBoxLayout>

namespace app {

MainWindow::MainWindow(Session &session, Theme &theme, StudyFunction study, CostFunction cost,
                       QWidget *parent)
    : QMainWindow(parent), m_session(session), m_theme(theme), m_course(new Course(session, this)),
      m_study(new AccuracyStudy(session, std::move(study), this)),
      m_stability(new StabilityWatch(session, this)), m_trip(session)
{
    setWindowIcon(QIcon(":/app/springstep.svg"));
    setDockOptions(QMainWindow::AnimatedDocks);
    setDocumentMode(true);
    setMinimumSize(leastWindow); // panels step aside before it is as small as that
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCentralWidget(centre());
    m_commands = std::make_unique<Commands>(*this);
    makeDocks(std::move(cost));
    makeStability();
    makeActions();
    makeBuilding();
    setMenuWidget(header());
    setStatusBar(new StatusLine(m_session, *m_study, *m_stability, m_gauge, this));
    connect(&theme, &Theme::changed, this, [this] { m_theme.apply(*qApp); });
    makeFiles();
    restore();
    qApp->installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, &MainWindow::catchFocus);
    m_scene->setFocus();
}

MainWindow::~MainWindow()
{
    qApp->removeEventFilter(this);
    qApp->disconnect(this);
}

void MainWindow::catchFocus(const QWidget *before, const QWidget *now)
{
    const bool isHere = before && now && before->window() == this && now->window() == this;
    if (isHere && !before->isVisible())
        m_scene->setFocus();
}

QWidget *MainWindow::centre()
{
    auto *centre = new QWidget(this);
    centre->setObjectName("panel");
    centre->setAttribute(Qt::WA_StyledBackground);
    m_notice = new Notice(m_theme, centre);
    m_sceneBar = new SceneBar(m_session, m_theme, centre);
    m_scene = new SceneView(m_session, m_theme, centre);
    m_scene->setMinimumSize(leastScene);
    m_stopNotice = new StopNotice(m_session, m_theme, m_scene);
    m_transport = new TransportBar(m_session, m_theme, centre);
    m_timeline = new TimelineStrip(m_session, m_theme, centre);
    m_footfall = new FootfallStrip(m_session, *m_course, *m_timeline, m_theme, centre);
    m_sceneBar->attach(*m_scene);
    m_scene->attach(*m_study);
    auto *column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_notice);
    column->addWidget(m_sceneBar);
    column->addWidget(divider(centre));
    column->addWidget(m_scene, 1);
    column->addWidget(divider(centre));
    column->addWidget(m_transport);
    column->addWidget(m_timeline);
    column->addWidget(m_footfall);
    return centre;
}

void MainWindow::makeFiles()
{
    m_files = std::make_unique<ExperimentFiles>(m_session, *m_notice, *this);
    m_kept = std::make_unique<KeptOffer>(m_session, *m_files, *m_notice, m_theme);
    connect(m_files.get(), &ExperimentFiles::said, &m_session, &Session::said);
    connect(&m_files->document(), &Document::stateChanged, this, &MainWindow::nameWindow);
    connect(&m_session, &Session::stepOpened, this, &MainWindow::nameWindow);
    connect(&m_session, &Session::stepOpened, this, &MainWindow::rememberStep);
    setAcceptDrops(true);
    nameWindow();
}

void MainWindow::nameWindow()
{
    const QString path = m_files->document().path();
    const QString name = path.isEmpty() ? m_session.step().title : shownPath(QFileInfo(path).fileName());
    setWindowTitle(tr("%1[*] – Springstep").arg(name));
    setWindowModified(m_files->document().isChanged());
}

void MainWindow::openFile(const QString &path)
{
    m_files->open(path);
}

bool MainWindow::saveFile(const QString &path)
{
    return m_files->save(path);
}

void MainWindow::keepScenesIn(const QString &folder, int within)
{
    m_kept->keepIn(folder, within);
}

void MainWindow::restore()
{
    const QSettings settings;
    if (!m_place.restore())
        resize(1280, 800);
    m_firstDocks = saveState();
    m_layoutKey = layoutKey(m_mode);
    useKeptForm();
    restorePanels(m_layouts.kept(m_layoutKey));
    m_accuracyDock->hide(); // the window opens for learning
    m_energyDock->hide();
    m_branchesDock->hide();
    m_effectsDock->hide();
    showStability(false);
    showPlots(settings.value("plots/shown", true).toBool());
}

bool MainWindow::event(QEvent *event)
{
    if (event->type() == QEvent::MouseButtonPress)
        noteSeparator(*static_cast<QMouseEvent *>(event));
    const bool isDone = QMainWindow::event(event);
    if (event->type() == QEvent::LayoutRequest && isVisible())
        m_room->share(); // a panel may want more than before
    else if (event->type() == QEvent::MouseButtonRelease)
        keepSides();
    return isDone;
}

void MainWindow::fitInto(QSize room)
{
    resize(size().boundedTo(room));
    m_room->share();
}

void MainWindow::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    placeSides();
    fitParameters();
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!m_leaves && !m_files->mayClose()) {
        event->ignore();
        return;
    }
    m_place.keep();
    showStability(false);
    saveLayouts();
    QMainWindow::closeEvent(event);
}

}
