#include "app/ui/window/main_window.h"

#include "app/model/course.h"
#include "app/model/document.h"
#include "app/model/scene_keeper.h"
#include "app/model/sentences.h"
#include "app/ui/panels/help_page.h"
#include "app/ui/scene/scene_bar.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/time/footfall_strip.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/divider.h"
#include "app/ui/window/notice.h"
#include "app/ui/window/room.h"
#include "app/ui/window/status_figures.h"
#include "app/ui/window/status_sentence.h"
#include "app/ui/window/stop_notice.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int wide = 1600;             ///< px, from here on the docks are broader
constexpr int readMilliseconds = 4000; ///< that a sentence takes to be read

}

MainWindow::MainWindow(Session &session, Theme &theme, StudyFunction study, CostFunction cost,
                       QWidget *parent)
    : QMainWindow(parent), m_session(session), m_theme(theme), m_course(new Course(session, this)),
      m_study(new AccuracyStudy(session, std::move(study), this)),
      m_stability(new StabilityWatch(session, this))
{
    setWindowIcon(QIcon(":/app/springstep.svg"));
    setDockOptions(QMainWindow::AnimatedDocks);
    setDocumentMode(true);
    setMinimumSize(leastWindow); // panels step aside before it is as small as that
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCentralWidget(centre());
    makeDocks(std::move(cost));
    makeStability();
    makeActions();
    makeBuilding();
    setMenuWidget(header());
    makeStatus();
    connect(&theme, &Theme::changed, this, [this] { m_theme.apply(*qApp); });
    makeDocument();
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

void MainWindow::makeStatus()
{
    m_status = new StatusSentence(this);
    statusBar()->addWidget(m_status, 1);
    m_figures = new StatusFigures(m_session, *m_study, this);
    statusBar()->addPermanentWidget(m_figures);
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setFixedHeight(28);
    statusBar()->addPermanentWidget(m_gauge);
    connect(m_stability, &StabilityWatch::changed, this, &MainWindow::shareStatusBar);
    m_saidLong.setSingleShot(true);
    m_saidLong.setInterval(readMilliseconds);
    connect(&m_saidLong, &QTimer::timeout, this, &MainWindow::followRun);
    connect(&m_session, &Session::moved, this, &MainWindow::followRun);
    connect(&m_session, &Session::playingChanged, this, &MainWindow::followRun);
    connect(&m_session, &Session::runChanged, this, [this] {
        if (!m_session.isPlaying())
            m_said.clear(); // it was about what was done before
    });
    connect(&m_session, &Session::said, this, &MainWindow::say);
    connect(&m_session, &Session::stepOpened, this, [this] { m_said.clear(); });
    showStatus();
}

void MainWindow::say(const QString &sentence)
{
    m_said = sentence;
    m_saidAt = m_session.timeline().at();
    m_saidLong.start();
    showStatus();
}

/// A sentence stays until the learner goes on, and while the run plays until there was time to read it.
void MainWindow::followRun()
{
    const bool isElsewhere = m_session.timeline().at() != m_saidAt;
    if (m_session.isPlaying() ? !m_saidLong.isActive() : isElsewhere)
        m_said.clear();
    showStatus();
}

void MainWindow::showStatus()
{
    const sim::Track &track = m_session.timeline().track();
    const sim::Cursor at = track.at();
    QString text;
    if (m_session.isGlancing()) {
        text = m_session.shown().at().phase > 0
                   ? tr("A look inside frame %1. The run stays where it is.").arg(at.frame)
                   : tr("A look at frame %1. The run stays at frame %2.")
                         .arg(m_session.shown().at().frame)
                         .arg(at.frame);
    } else if (!m_said.isEmpty()) {
        text = m_said.toHtmlEscaped();
    } else if (m_session.stoppedBy() && !m_session.isPlaying()) {
        text = m_session.stoppedBy()->sentence.toHtmlEscaped();
    } else if (m_session.isResting()) {
        text = tr("Everything rests. Touch something, or press <b>Space</b> to stop.");
    } else if (m_session.isPlaying()) {
        text = tr("Playing. Press <b>Space</b> to stop anywhere.");
    } else if (at.phase > 0) {
        const QString phase = phrase(track.shown().pipeline.phaseAt(at.phase - 1).title).toHtmlEscaped();
        text = tr("Inside frame %1, after %2. <b>Shift+→</b> next phase, <b>→</b> next frame.")
                   .arg(at.frame)
                   .arg(phase);
    } else {
        text = tr("<b>Space</b> plays, <b>→</b> next frame, <b>Shift+→</b> into the frame. Drag anything.");
    }
    if (text != m_status->text())
        m_status->setText(text);
    shareStatusBar();
}

void MainWindow::shareStatusBar()
{
    constexpr int between = 24; // px that the bar itself takes
    const int taken = m_status->sizeHint().width() + m_gauge->sizeHint().width() + between;
    m_figures->setMost(width() - taken);
}

void MainWindow::restore()
{
    const QSettings settings;
    if (!restoreGeometry(settings.value("window/geometry").toByteArray()))
        resize(1280, 800);
    m_firstDocks = saveState();
    m_layoutKey = layoutKey(m_mode);
    useKeptForm();
    m_docksKnown = restoreState(settings.value(m_layoutKey).toByteArray());
    m_accuracyDock->hide(); // the window opens for learning
    m_energyDock->hide();
    m_branchesDock->hide();
    m_effectsDock->hide();
    showStability(false);
    showPlots(settings.value("plots/shown", true).toBool());
}

void MainWindow::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    if (!m_docksKnown)
        placeSides();
    m_docksKnown = true;
    fitParameters();
}

void MainWindow::placeSides()
{
    resizeDocks({m_left, m_codeDock}, width() < wide ? QList{280, 400} : QList{320, 480}, Qt::Horizontal);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (!mayClose()) {
        event->ignore();
        return;
    }
    QSettings().setValue("window/geometry", saveGeometry());
    showStability(false);
    saveLayouts();
    QMainWindow::closeEvent(event);
}

}
