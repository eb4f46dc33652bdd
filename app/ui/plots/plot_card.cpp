#include "app/ui/plots/plot_card.h"

#include "app/model/text/quantity_text.h"
#include "app/model/text/sentences.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/plots/plot_value.h"
#include "app/ui/scene/flat_button.h"
#include "app/ui/theme/icon_button.h"

#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int headerHeight = 30; ///< px
constexpr int gap = 4;           ///< px

}

PlotCard::PlotCard(const OpenRun &run, Playback &playback, const ComparisonRuns &comparisons,
                   const PlotSeries &series, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_run(run), m_playback(playback), m_comparisons(comparisons), m_series(series),
      m_theme(theme), m_plot(new QuantityPlot(run, playback, series, theme, this)),
      m_export(new PlotExport([this] { return m_plot->picture(); }, theme, this))
{
    styleAsPanel(*this);
    m_export->setNumbers([this] { return numbers(); });
    QVBoxLayout *column = makeColumn(this);
    column->addWidget(header());
    column->addWidget(m_plot, 1);
    connect(m_plot, &QuantityPlot::pointedAt, this, &PlotCard::pointedAt);
    connect(m_plot, &QuantityPlot::zoomWanted, this, &PlotCard::zoomWanted);
    connect(m_plot, &QuantityPlot::removalWanted, this, &PlotCard::removalWanted);
}

FlatButton *PlotCard::chooser(QuantityMenu::Axis axis, Quantity PlotSpec::*quantity, const QString &tip)
{
    auto *menu = new QuantityMenu(
        m_run, axis, [this, quantity] { return spec().*quantity; }, this);
    connect(menu, &QuantityMenu::chosen, this, [this, quantity](const Quantity &chosen) {
        PlotSpec wanted = spec();
        wanted.*quantity = chosen;
        emit changeWanted(wanted);
    });
    auto *button = new FlatButton(m_theme, this);
    button->setMenu(menu);
    button->setToolTip(tip);
    return button;
}

QWidget *PlotCard::header()
{
    auto *row = new QWidget(this);
    row->setFixedHeight(headerHeight);
    m_up = chooser(QuantityMenu::Axis::up, &PlotSpec::up, tr("Plotted quantity"));
    m_across = chooser(QuantityMenu::Axis::across, &PlotSpec::across,
                       tr("The other axis: time, or another quantity"));
    m_value = new PlotValue(m_theme, row);
    m_more = makeIconButton("plotMenu", "more", m_theme, row);
    m_more->setToolTip(tr("Save, copy, keep or remove this plot"));
    m_more->setAccessibleName(tr("Actions for this plot"));
    connect(m_more, &QToolButton::clicked, this,
            [this] { openMenu(m_more->mapToGlobal(QPoint(0, m_more->height()))); });
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(8, 0, 8, 0);
    layout->setSpacing(0);
    layout->setSizeConstraint(QLayout::SetNoConstraint); // fitHeader() shortens what does not fit
    layout->addWidget(m_up);
    layout->addWidget(m_across);
    layout->addWidget(m_value, 1);
    layout->addSpacing(gap);
    layout->addWidget(m_more);
    return row;
}

void PlotCard::setSpec(const PlotSpec &spec)
{
    m_plot->setSpec(spec);
}

void PlotCard::refresh(const std::vector<double> &begun, const std::optional<PlotSeries::Inside> &inside)
{
    m_plot->refresh(begun, inside);
    writeHeader();
    if (!m_pace.isDue())
        return;
    m_pace.restart();
    // The two numbers of a plot without time take too much room here; the axes show them.
    const bool isShown = spec().isAgainstTime() && m_plot->emptyText().isEmpty();
    m_value->setText(isShown ? m_plot->valueText() : QString(), m_plot->exactText());
}

/// Does nothing unless the title has changed, because each change lays out the whole window.
void PlotCard::writeHeader()
{
    if (m_plot->title() == m_plot->accessibleName())
        return;
    m_up->setTexts({}, quantityTitle(m_series.bound(spec().up)));
    m_across->setTexts(tr("against"), quantityTitle(m_series.bound(spec().across)));
    m_plot->setAccessibleName(m_plot->title());
    fitHeader();
}

void PlotCard::fitHeader()
{
    const int room = width() - 16 - m_more->width() - gap;
    m_across->setShort(m_up->fullWidth() + m_across->fullWidth() > room);
}

void PlotCard::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitHeader();
}

QMenu *PlotCard::menu()
{
    auto *menu = new QMenu(this);
    menu->setToolTipsVisible(true);
    const bool isOfABody = pinned(spec(), m_run.selected()).isPinned();
    if (isOfABody) {
        const QString body = spec().up.body.isEmpty() ? m_run.selected() : spec().up.body;
        QAction *keep = menu->addAction(tr("&Pin to %1").arg(bodyTitle(body)));
        keep->setCheckable(true);
        keep->setChecked(spec().isPinned());
        keep->setToolTip(tr("If off, the plot follows the body that is selected in the picture"));
        connect(keep, &QAction::triggered, this, [this](bool on) {
            emit changeWanted(on ? pinned(spec(), m_run.selected()) : unpinned(spec()));
        });
        menu->addSeparator();
    }
    m_export->addTo(*menu);
    menu->addSeparator();
    const auto add = [&](const QString &text, auto slot) {
        connect(menu->addAction(text), &QAction::triggered, this, slot);
    };
    add(tr("&Fewer frames\t+"), [this] { emit zoomWanted(1); });
    add(tr("&More frames\t−"), [this] { emit zoomWanted(-1); });
    menu->addSeparator();
    add(tr("&Remove this plot\tDel"), [this] { emit removalWanted(); });
    return menu;
}

void PlotCard::openMenu(const QPoint &place)
{
    QMenu *opened = menu();
    opened->setAttribute(Qt::WA_DeleteOnClose);
    opened->popup(place);
}

void PlotCard::contextMenuEvent(QContextMenuEvent *event)
{
    openMenu(event->globalPos());
}

std::optional<NumberSheet> PlotCard::numbers() const
{
    if (!m_plot->emptyText().isEmpty())
        return std::nullopt;
    const sim::Timeline &timeline = m_run.timeline();
    NumberSheet sheet;
    const bool turns = timeline.state().spin.rows() > 0;
    for (const Quantity &one : {spec().across, spec().up}) {
        if (one.what == QuantityKind::time)
            continue;
        sheet.quantities.push_back(m_series.bound(one));
        sheet.titles << QStringLiteral("%1 [%2]").arg(quantityName(sheet.quantities.back()),
                                                      unitOf(one.what, turns));
    }
    sheet.run = timeline.script();
    sheet.frames = timeline.computed();
    if (const sim::Track *comparison = timeline.comparison()) {
        sheet.comparison = comparison->script();
        sheet.comparisonFrames = comparison->computed();
        sheet.comparisonName = m_comparisons.comparisonName();
    }
    return sheet;
}

}
