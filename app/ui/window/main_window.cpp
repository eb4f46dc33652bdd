#include "app/ui/window/main_window.h"

#include "app/model/course.h"
#include "app/model/sentences.h"
#include "app/ui/code/code_panel.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/measure/accuracy_panel.h"
#include "app/ui/panels/dock_title.h"
#include "app/ui/panels/help_page.h"
#include "app/ui/panels/learn_panel.h"
#include "app/ui/panels/measure_panel.h"
#include "app/ui/panels/parameter_panel.h"
#include "app/ui/scene/scene_bar.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/scene/thumbnail.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/time/footfall_strip.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/notice.h"
#include "app/ui/window/status_figures.h"
#include "app/ui/window/stop_notice.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int wide = 1600; ///< px, from here on the docks are broader

QFrame *divider(QWidget *parent)
{
    auto *line = new QFrame(parent);
    line->setObjectName("divider");
    line->setFixedHeight(1);
    return line;
}

}

MainWindow::MainWindow(Session &session, Theme &theme, StudyFunction study, QWidget *parent)
    : QMainWindow(parent), m_session(session), m_theme(theme), m_course(new Course(session, this)),
      m_study(new AccuracyStudy(session, std::move(study), this)),
      m_stability(new StabilityWatch(session, this))
{
    setWindowIcon(QIcon(":/app/springstep.svg"));
    setDockOptions(QMainWindow::AnimatedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setCentralWidget(centre());
    makeDocks();
    makeStability();
    makeActions();
    setMenuWidget(header());
    makeStatus();
    connect(&theme, &Theme::changed, this, [this] { m_theme.apply(*qApp); });
    connect(&session, &Session::stepOpened, this, &MainWindow::nameWindow);
    nameWindow();
    restore();
    qApp->installEventFilter(this);
    m_scene->setFocus();
}

MainWindow::~MainWindow()
{
    qApp->removeEventFilter(this);
}

QWidget *MainWindow::centre()
{
    auto *centre = new QWidget(this);
    centre->setObjectName("panel");
    centre->setAttribute(Qt::WA_StyledBackground);
    m_notice = new Notice(m_theme, centre);
    m_sceneBar = new SceneBar(m_session, m_theme, centre);
    m_scene = new SceneView(m_session, m_theme, centre);
    m_scene->setMinimumSize(480, 240);
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

QDockWidget *MainWindow::dock(const QString &name, QWidget *title, QWidget *content, Qt::DockWidgetArea area)
{
    auto *dock = new QDockWidget(name, this);
    dock->setObjectName(name);
    dock->setFeatures(QDockWidget::DockWidgetClosable);
    dock->setTitleBarWidget(title);
    dock->setWidget(content);
    addDockWidget(area, dock);
    return dock;
}

void MainWindow::makeDocks()
{
    m_learn = new LearnPanel(m_session, m_theme, this);
    m_left = dock("lessons", new QWidget(this), m_learn, Qt::LeftDockWidgetArea);

    m_accuracy = new AccuracyPanel(*m_study, m_theme, this);
    m_accuracyDock = dock("accuracy", new QWidget(this), m_accuracy, Qt::RightDockWidgetArea);
    m_accuracyDock->hide();
    m_energy = new EnergyPanel(m_session, m_theme, this);
    m_energyDock = dock("energy", new QWidget(this), m_energy, Qt::BottomDockWidgetArea);
    m_energyDock->hide();

    m_code = new CodePanel(m_session, m_theme, this);
    auto *codeTitle = new DockTitle(tr("Code"), m_theme, this);
    codeTitle->setCaption(m_code->caption());
    connect(m_code, &CodePanel::captionChanged, codeTitle, &DockTitle::setCaption);
    codeTitle->addAction(m_code->titleActions());
    connect(m_code, &CodePanel::said, &m_session, &Session::said);
    m_codeDock = dock("code", codeTitle, m_code, Qt::RightDockWidgetArea);

    auto *numbers = new QWidget(this);
    m_measures = new MeasurePanel(m_session, *m_course, m_theme, numbers);
    m_parameters = new ParameterPanel(m_session, m_theme, numbers);
    m_parameters->setPresetPainter(
        [this](const lessons::Step &step, const lessons::Preset &preset, QSize size) {
            sim::Values values = step.presets();
            for (const auto &[id, value] : preset.values)
                values.set(id.toStdString(), value);
            return thumbnail(step, values, m_theme, size);
        });
    auto *column = new QVBoxLayout(numbers);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_measures);
    m_measureLine = divider(numbers);
    column->addWidget(m_measureLine);
    column->addWidget(m_parameters, 1);
    m_parameterDock = dock("parameters", new QWidget(this), numbers, Qt::RightDockWidgetArea);
    connect(m_parameters, &ParameterPanel::wantedHeightChanged, this, &MainWindow::fitParameters);
    connect(m_measures, &MeasurePanel::contentChanged, this, &MainWindow::showMeasures);
    showMeasures();
}

void MainWindow::showMeasures()
{
    m_measures->setVisible(!m_measures->isEmpty());
    m_measureLine->setVisible(!m_measures->isEmpty());
    fitParameters();
}

void MainWindow::fitParameters()
{
    // What is above them gets all the height that the parameters do not need.
    const int wanted = m_parameterDock->sizeHint().height();
    QDockWidget *above = m_codeDock->isHidden() ? m_accuracyDock : m_codeDock;
    if (m_stabilityDock && !m_stabilityDock->isHidden())
        above = m_stabilityDock;
    resizeDocks({above, m_parameterDock}, {std::max(1, height() - wanted), wanted}, Qt::Vertical);
}

void MainWindow::makeStatus()
{
    m_status = new QLabel(this);
    m_status->setTextFormat(Qt::RichText);
    m_status->setContentsMargins(8, 0, 8, 0);
    m_status->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    statusBar()->addWidget(m_status, 1);
    statusBar()->addPermanentWidget(new StatusFigures(m_session, *m_study, this));
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setFixedHeight(28);
    statusBar()->addPermanentWidget(m_gauge);
    connect(&m_session, &Session::moved, this, &MainWindow::showStatus);
    connect(&m_session, &Session::playingChanged, this, &MainWindow::showStatus);
    connect(&m_session, &Session::said, this, [this](const QString &sentence) {
        m_said = sentence;
        showStatus();
    });
    connect(&m_session, &Session::stepOpened, this, [this] { m_said.clear(); });
    showStatus();
}

void MainWindow::showStatus()
{
    const sim::Track &track = m_session.timeline().track();
    const sim::Cursor at = track.at();
    QString text;
    if (!m_said.isEmpty()) {
        text = m_said.toHtmlEscaped();
        m_said.clear();
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
}

void MainWindow::nameWindow()
{
    const QString name = m_path.isEmpty() ? m_session.step().title : QFileInfo(m_path).fileName();
    setWindowTitle(tr("%1 – Springstep").arg(name));
}

void MainWindow::openFile(const QString &path)
{
    try {
        m_session.open(readExperiment(path, m_session.library()));
        m_path = path;
        m_notice->say({});
        nameWindow();
    } catch (const Refusal &refusal) {
        m_notice->say(tr("Experiment not opened: %1 Your scene is unchanged.").arg(refusal.sentence()));
    } catch (const sim::Error &error) {
        m_notice->say(tr("Experiment not opened: %1 Your scene is unchanged.").arg(sentenceFor(error)));
    }
}

bool MainWindow::saveFile(const QString &path)
{
    try {
        writeExperiment(path, m_session.experiment(), m_session.library());
    } catch (const Refusal &refusal) {
        m_notice->say(tr("Experiment not saved: %1").arg(refusal.sentence()));
        return false;
    }
    m_path = path;
    nameWindow();
    emit m_session.said(tr("Saved as %1.").arg(QFileInfo(path).fileName()));
    return true;
}

void MainWindow::askOpen()
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open an experiment"), m_path, tr("Experiments (*.json)"));
    if (!path.isEmpty())
        openFile(path);
}

void MainWindow::askSave()
{
    const QString suggestion = m_path.isEmpty() ? m_session.step().id + ".json" : m_path;
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save the experiment"), suggestion, tr("Experiments (*.json)"));
    if (!path.isEmpty())
        saveFile(path);
}

void MainWindow::restore()
{
    const QSettings settings;
    if (!restoreGeometry(settings.value("window/geometry").toByteArray()))
        resize(1280, 800);
    m_docksKnown = restoreState(settings.value("window/docks").toByteArray());
    m_accuracyDock->hide(); // the window opens for learning
    m_energyDock->hide();
    showStability(false);
}

void MainWindow::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    if (!m_docksKnown)
        resizeDocks({m_left, m_codeDock}, width() < wide ? QList{280, 400} : QList{320, 480}, Qt::Horizontal);
    m_docksKnown = true;
    fitParameters();
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    QSettings settings;
    settings.setValue("window/geometry", saveGeometry());
    showStability(false);
    settings.setValue("window/docks", m_mode == Mode::learn ? saveState() : m_learnDocks);
    QMainWindow::closeEvent(event);
}

}
