#include "app/ui/parameters/measure_panel.h"

#include "app/ui/dock/panel_parts.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/parameters/measure_row.h"

#include <QVBoxLayout>

namespace app {

namespace {

constexpr int panelBottomMargin = 6;

}

MeasurePanel::MeasurePanel(const OpenRun &run, const Playback &playback, const Preview &preview,
                           const MeasureSeries &series, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_run(run), m_preview(preview), m_series(series), m_theme(theme), m_pace(playback)
{
    styleAsPanel(*this);
    auto *title = new PanelTitle(tr("Measured"), theme, this);
    title->setCaption(tr("at the cursor"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, panelBottomMargin);
    column->setSpacing(0);
    column->setAlignment(Qt::AlignTop);
    column->addWidget(title);
    m_run.onChange(everyChange, this, &MeasurePanel::follow);
    connect(&series, &MeasureSeries::changed, this, &MeasurePanel::refresh);
    open();
}

QSize MeasurePanel::sizeHint() const
{
    return {400,
            PanelTitle::height + static_cast<int>(m_rows.size()) * MeasureRow::height + panelBottomMargin};
}

void MeasurePanel::open()
{
    for (MeasureRow *row : m_rows)
        delete row;
    m_rows.clear();
    m_step = &m_run.step();
    for (std::size_t i = 0; i < m_run.step().measures.size(); ++i) {
        m_rows.push_back(new MeasureRow(m_run, m_preview, m_series, i, m_theme, this));
        layout()->addWidget(m_rows.back());
        m_rows.back()->show();
    }
    updateGeometry();
    emit contentChanged();
}

void MeasurePanel::follow(const Change &change)
{
    if (change.isAny(ChangeKind::step))
        open();
    if (change.isAny(ChangeKind::playing | ChangeKind::preview))
        refreshNow();
    else if (change.isAny(ChangeKind::cursor))
        refresh();
}

void MeasurePanel::refresh()
{
    if (m_pace.isDue())
        refreshNow();
}

void MeasurePanel::refreshNow()
{
    if (m_step != &m_run.step())
        return; // the series has heard of another step before this panel
    m_pace.restart();
    for (MeasureRow *row : m_rows)
        row->refresh();
}

}
