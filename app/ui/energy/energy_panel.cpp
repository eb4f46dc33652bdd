#include "app/ui/energy/energy_panel.h"

#include "app/model/series/energy_table.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/energy/energy_list.h"
#include "app/ui/energy/energy_plot.h"
#include "app/ui/plots/plot_export.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>

#include <algorithm>

namespace app {

namespace {

constexpr int listWidth = 276;
constexpr int narrowUpTo = 640;   ///< px: a panel that is narrower, and tall, has its list below the plot
constexpr int tallFrom = 400;     ///< px
constexpr int unitHeight = 22;    ///< px
constexpr double mostList = 0.42; ///< of the panel's height, for a list below the plot

}

EnergyPanel::EnergyPanel(const OpenRun &run, Playback &playback, const Preview &preview, const Theme &theme,
                         QWidget *parent)
    : LivePanel(parent), m_run(run), m_playback(playback), m_preview(preview), m_series(run, playback),
      m_title(new PanelTitle(tr("Where it went"), theme, this)), m_pages(new QStackedWidget(this))
{
    m_plot = new EnergyPlot(run, playback, m_series, theme, m_pages);
    m_list = new EnergyList(theme, m_pages);
    m_ledger = ledger();
    m_reason = new QLabel(m_pages);
    m_reason->setWordWrap(true);
    m_reason->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_reason->setContentsMargins(16, 4, 16, 8);
    m_pages->addWidget(m_ledger);
    m_pages->addWidget(m_reason);
    m_export = new PlotExport([this] { return m_plot->picture(); }, theme, this);
    m_export->setNumbersAsText(
        [this] { return view() == EnergyView::energy ? energyTable(m_series) : momentumTable(m_series); });
    m_export->addContextMenu(*m_plot);
    m_title->addAction(tabs());
    m_title->addAction(m_export->makeButton(this));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 4);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_pages, 1);
    connect(m_plot, &EnergyPlot::pointedAt, m_plot, &EnergyPlot::setHovered);
    connect(&m_series, &EnergySeries::changed, this, [this] {
        m_lines.reset();
        refresh();
    });
    run.onChange(ChangeKind::cursor | ChangeKind::playing, this, &EnergyPanel::refresh);
    run.onChange(ChangeKind::preview, this, &EnergyPanel::followPreview);
    connect(&theme, &Theme::changed, this, &EnergyPanel::refresh);
}

QWidget *EnergyPanel::ledger()
{
    auto *page = new QWidget(m_pages);
    auto *side = new QWidget(page);
    m_side = side;
    m_unit = new QLabel(side);
    m_unit->setObjectName("caption");
    m_unit->setContentsMargins(31, 2, 12, 2);
    auto *column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_list, 1);
    column->addWidget(m_unit);
    auto *row = new QHBoxLayout(page);
    row->setContentsMargins(8, 0, 4, 0);
    row->setSpacing(4);
    row->addWidget(m_plot, 1);
    row->addWidget(side);
    m_split = row;
    return page;
}

/// Puts the list below the plot in a narrow panel, where the plot beside it would be too narrow.
void EnergyPanel::placeList()
{
    const bool isBelow = width() < narrowUpTo && height() >= tallFrom;
    const int wanted = static_cast<int>(m_list->lines().size()) * EnergyDelegate::rowHeight + unitHeight;
    m_split->setDirection(isBelow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_side->setMinimumWidth(isBelow ? 0 : listWidth);
    m_side->setMaximumWidth(isBelow ? QWIDGETSIZE_MAX : listWidth);
    m_side->setMinimumHeight(0);
    m_side->setMaximumHeight(isBelow ? std::min(wanted, static_cast<int>(mostList * height()))
                                     : QWIDGETSIZE_MAX);
}

void EnergyPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    placeList();
}

QWidget *EnergyPanel::tabs()
{
    auto *row = new QWidget(this);
    m_tabs = makeTabs({{tr("Energy"), tr("Where energy is, and where it went")},
                       {tr("Momentum"), tr("Mass × velocity of everything together, and what changed it")}},
                      row);
    connect(m_tabs, &QButtonGroup::idClicked, this, [this](int id) { setView(static_cast<EnergyView>(id)); });
    return row;
}

void EnergyPanel::setView(EnergyView view)
{
    m_tabs->button(static_cast<int>(view))->setChecked(true);
    m_plot->setView(view);
    refreshNow();
}

EnergyView EnergyPanel::view() const
{
    return m_plot->view();
}

QString EnergyPanel::reason() const
{
    return m_pages->currentWidget() == m_reason ? m_reason->text() : QString();
}

const std::vector<EnergyLine> &EnergyPanel::lines() const
{
    return m_list->lines();
}

QString EnergyPanel::unit() const
{
    const bool turns = m_run.timeline().state().spin.rows() > 0;
    return view() == EnergyView::energy ? energyUnit(turns) : momentumUnit();
}

void EnergyPanel::setActive(bool isActive)
{
    m_series.setActive(isActive);
}

bool EnergyPanel::isChanging() const
{
    return m_playback.isPlaying() || (!m_series.whyNot() && m_series.last() < m_run.timeline().computed());
}

void EnergyPanel::showContents()
{
    const std::optional<sim::NoEnergy> whyNot = m_series.whyNot();
    const bool turns = m_run.timeline().state().spin.rows() > 0;
    const bool isAboutTurning = !whyNot && turns && view() == EnergyView::momentum;
    m_pages->setCurrentWidget(whyNot || isAboutTurning ? m_reason : m_ledger);
    if (whyNot || isAboutTurning) {
        m_title->setCaption({});
        m_reason->setText(whyNot ? noEnergyWords(*whyNot)
                                 : tr("Everything here turns in place, held by the ground. So there is no "
                                      "momentum to count: choose a scene with moving bodies."));
        return;
    }
    showLedger();
    m_plot->refresh(counted());
}

const EnergyLines &EnergyPanel::counted()
{
    if (!m_lines)
        m_lines.emplace(m_series);
    return *m_lines;
}

void EnergyPanel::followPreview()
{
    const bool changes = m_showsPreview || m_preview.isActive();
    if (isSeen() && changes && m_pages->currentWidget() == m_ledger)
        showLedger();
}

void EnergyPanel::showLedger()
{
    m_showsPreview = m_preview.isActive();
    const std::int64_t frame = m_preview.run().cursor().frame;
    m_title->setCaption(m_series.at(frame) ? tr("frame %1 to %2").arg(m_series.start()).arg(frame)
                                           : tr("counting…"));
    m_unit->setText(unit());
    m_list->setLines(view() == EnergyView::energy ? counted().energyAt(frame) : counted().momentumAt(frame),
                     unit());
    placeList();
}

}
