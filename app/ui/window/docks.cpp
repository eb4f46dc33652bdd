// The docks of the window: what stands in them, and how high they are.

#include "app/ui/code/code_panel.h"
#include "app/ui/effects/effects_panel.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/measure/accuracy_panel.h"
#include "app/ui/panels/dock_title.h"
#include "app/ui/panels/learn_panel.h"
#include "app/ui/panels/measure_panel.h"
#include "app/ui/panels/parameter_panel.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/scene/thumbnail.h"
#include "app/ui/window/divider.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/room.h"

#include <QDockWidget>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int besideColumn = 68;      ///< px of the window's height: header and status bar
constexpr int readableAccuracy = 490; ///< px, its tab included

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

void MainWindow::showDock(QDockWidget &dock, bool shown)
{
    dock.setVisible(shown);
    if (shown)
        dock.raise(); // it may be one of several tabs
}

void MainWindow::makeDocks(CostFunction cost)
{
    m_learn = new LearnPanel(m_session, m_theme, this);
    m_left = dock("lessons", new QWidget(this), m_learn, Qt::LeftDockWidgetArea);
    m_left->setWindowTitle(tr("Lessons"));

    m_accuracy = new AccuracyPanel(*m_study, m_theme, this);
    m_accuracyDock = dock("accuracy", new QWidget(this), m_accuracy, Qt::RightDockWidgetArea);
    m_accuracyDock->setWindowTitle(tr("Accuracy")); // its tab, where docks are tabs
    m_accuracyDock->hide();
    m_energy = new EnergyPanel(m_session, m_theme, this);
    m_energyDock = dock("energy", new QWidget(this), m_energy, Qt::BottomDockWidgetArea);
    m_energyDock->setWindowTitle(tr("Energy"));
    m_energyDock->hide();
    connect(m_energyDock, &QDockWidget::visibilityChanged, m_energy,
            [energy = m_energy](bool seen) { energy->setCovered(!seen); });
    m_effects = new EffectsPanel(m_session, m_theme, std::move(cost), this);
    m_effectsDock = dock("effects", new QWidget(this), m_effects, Qt::BottomDockWidgetArea);
    m_effectsDock->setWindowTitle(tr("Effects"));
    m_effectsDock->hide();
    tabifyDockWidget(m_energyDock, m_effectsDock); // beside each other they would not fit below the picture
    connect(m_effectsDock, &QDockWidget::visibilityChanged, m_effects,
            [effects = m_effects](bool seen) { effects->setCovered(!seen); });

    makeBranchesDock();
    makeCodeDock();
    makePlots();
    makeParameterDock();
    connect(m_parameters, &ParameterPanel::wantedHeightChanged, this, &MainWindow::fitParameters);
    connect(m_measures, &MeasurePanel::contentChanged, this, &MainWindow::showMeasures);
    showMeasures();
    m_room = std::make_unique<Room>(*this, *m_learn, *m_scene, *m_left, *m_parameterDock);
    connect(m_room.get(), &Room::sidesChanged, this, [this] {
        placeSides();
        fitParameters();
    });
}

void MainWindow::makeCodeDock()
{
    m_code = new CodePanel(m_session, m_theme, this);
    auto *codeTitle = new DockTitle(tr("Code"), m_theme, this);
    codeTitle->setCaption(m_code->caption());
    connect(m_code, &CodePanel::captionChanged, codeTitle, &DockTitle::setCaption);
    codeTitle->addAction(m_code->titleActions());
    connect(m_code, &CodePanel::said, &m_session, &Session::said);
    m_codeDock = dock("code", codeTitle, m_code, Qt::RightDockWidgetArea);
}

void MainWindow::makeParameterDock()
{
    auto *numbers = new QWidget(this);
    m_measures = new MeasurePanel(m_session, *m_course, m_theme, numbers);
    m_parameters = new ParameterPanel(m_session, m_theme, numbers);
    m_parameters->setPresetPainter(
        [this](const lessons::Step &step, const lessons::Preset &preset, QSize size) {
            sim::Values values = step.defaultValues();
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
    m_parameterDock->setWindowTitle(tr("Parameters"));
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
    const int separator = style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, this);
    const int all = height() - besideColumn - separator;
    m_parameterDock->widget()
        ->updateGeometry(); // else the dock knows what it holds only after the next events
    int wanted = m_parameterDock->sizeHint().height();
    if (m_mode == Mode::measure) { // a plot is read as a whole; parameters can be scrolled
        const int least = m_parameterDock->minimumSizeHint().height();
        wanted = std::clamp(all - readableAccuracy, least, std::max(least, wanted));
    }
    wanted = m_layouts.length(m_layoutKey, heightOfParameters, wanted);
    QDockWidget *above = m_codeDock->isHidden() ? m_accuracyDock : m_codeDock;
    if (m_stabilityDock && !m_stabilityDock->isHidden())
        above = m_stabilityDock;
    if (m_plotsDock->isHidden() || !hasRoomForPlots()) {
        resizeDocks({above, m_parameterDock}, {std::max(1, all - wanted), wanted}, Qt::Vertical);
        return;
    }
    const int plots = m_plots->sizeHint().height();
    resizeDocks({above, m_plotsDock, m_parameterDock},
                {std::max(1, all - separator - wanted - plots), plots, wanted}, Qt::Vertical);
}

}
