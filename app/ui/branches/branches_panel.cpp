#include "app/ui/branches/branches_panel.h"

#include "app/model/series/difference_table.h"
#include "app/model/session/comparison_runs.h"
#include "app/model/session/playback.h"
#include "app/model/text/difference_text.h"
#include "app/model/text/sentences.h"
#include "app/ui/branches/difference_plot.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/theme/icon_button.h"
#include "app/ui/time/runs_menu.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace app {

BranchesPanel::BranchesPanel(const OpenRun &run, RunEditor &editor, Playback &playback,
                             ComparisonRuns &comparisons, const Theme &theme, QWidget *parent)
    : LivePanel(parent), m_run(run), m_playback(playback), m_comparisons(comparisons), m_theme(theme),
      m_series(run, comparisons), m_title(new PanelTitle(tr("Two runs"), theme, this)),
      m_plot(new DifferencePlot(run, playback, m_series, theme, this)),
      m_export(new PlotExport([this] { return m_plot->picture(); }, theme, this)),
      m_runs(new RunsMenu(run, editor, comparisons, theme, this))
{
    m_export->setNumbersAsText([this] { return differenceTable(m_series); });
    m_export->addContextMenu(*m_plot);
    m_title->addAction(tabs());
    m_title->addAction(m_export->makeButton(this));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 4);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_plot, 1);
    column->addWidget(foot());
    column->addStretch(0); // while there is no plot
    connect(m_plot, &DifferencePlot::pointedAt, m_plot, &DifferencePlot::setHovered);
    connect(&m_series, &DifferenceSeries::changed, this, &BranchesPanel::refresh);
    run.onChange(ChangeKind::run | ChangeKind::cursor | ChangeKind::playing, this, &BranchesPanel::refresh);
    run.onChange(ChangeKind::step | ChangeKind::selection, this, &BranchesPanel::nameBodies);
    connect(&theme, &Theme::changed, this, &BranchesPanel::refreshNow);
    nameBodies();
}

QWidget *BranchesPanel::tabs()
{
    auto *row = new QWidget(this);
    m_tabs = makeTabs({{tr("Largest distance"),
                        tr("In each frame, the body that is farthest from its place in the other run")},
                       {{}, tr("Only the body that is selected in the picture")}},
                      row);
    connect(m_tabs, &QButtonGroup::idClicked, this,
            [this](int id) { setOf(static_cast<DifferenceSeries::Of>(id)); });
    QToolButton *runs =
        makeTab(tr("Runs"), tr("Choose the run to compare with, keep, name and delete runs"), row);
    runs->setCheckable(false);
    runs->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    showIcon(*runs, "runs", m_theme);
    auto *layout = static_cast<QHBoxLayout *>(row->layout());
    layout->addSpacing(8);
    layout->addWidget(runs);
    connect(runs, &QToolButton::clicked, this, [this, runs] { m_runs->popupAbove(*runs); });
    return row;
}

QWidget *BranchesPanel::foot()
{
    auto *row = new QWidget(this);
    m_sentence = new QLabel(row);
    m_sentence->setTextFormat(Qt::PlainText);
    m_sentence->setWordWrap(true);
    m_go = makeTab(tr("Go there"), tr("Go to the frame with the largest difference"), row);
    m_go->setCheckable(false);
    connect(m_go, &QToolButton::clicked, this, &BranchesPanel::goToLargest);
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(16, 4, 12, 4);
    layout->setSpacing(8);
    layout->addWidget(m_sentence, 1);
    layout->addWidget(m_go);
    return row;
}

QString BranchesPanel::sentence() const
{
    return m_sentence->text();
}

void BranchesPanel::setOf(DifferenceSeries::Of of)
{
    m_tabs->button(static_cast<int>(of))->setChecked(true);
    m_series.setOf(of);
    refreshNow();
}

void BranchesPanel::nameBodies()
{
    m_tabs->button(static_cast<int>(DifferenceSeries::Of::selected))->setText(bodyTitle(m_run.selected()));
}

void BranchesPanel::goToLargest()
{
    if (!m_series.largest())
        return;
    m_playback.pause();
    m_playback.goTo({m_series.largest()->frame, 0});
}

void BranchesPanel::setActive(bool isActive)
{
    m_series.setActive(isActive);
}

bool BranchesPanel::isChanging() const
{
    return m_playback.isPlaying() || (m_series.isComparing() && m_series.next() <= m_series.end());
}

void BranchesPanel::showContents()
{
    const Branch *branch = m_comparisons.shown();
    m_title->setCaption(branch ? tr("this one and “%1”").arg(branch->name) : QString());
    m_sentence->setText(differenceSentence(m_series));
    m_plot->setVisible(branch);
    m_plot->setAccessibleDescription(m_sentence->text());
    const Difference *largest = m_series.largest();
    m_go->setVisible(largest && largest->distance > 0.0);
    m_plot->refresh();
}

}
