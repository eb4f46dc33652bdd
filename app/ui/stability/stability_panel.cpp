#include "app/ui/stability/stability_panel.h"

#include "app/model/analysis/map_table.h"
#include "app/model/run/run_program.h"
#include "app/model/text/phrases.h"
#include "app/ui/actions/command.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/dock/scroll_page.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/stability/growth_plot.h"
#include "app/ui/stability/settling_plot.h"
#include "app/ui/theme/icon_button.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTextDocumentFragment>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int margin = 16;

/// Returns the text with a number and its unit kept together: rich text breaks lines at thin spaces.
QString unbroken(QString text)
{
    return text.replace(QChar(0x2009), QChar(QChar::Nbsp));
}

}

StabilityPanel::StabilityPanel(StabilityMonitor &monitor, SettlingMonitor &settling, const Command &toggle,
                               const Command &settlingToggle, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_monitor(monitor), m_settling(settling), m_theme(theme)
{
    styleAsPanel(*this);
    QWidget *content = makePage();
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(margin, 4, margin, 12);
    column->setSpacing(8);
    column->addWidget(card());
    column->addWidget(remedyRows());
    m_leftOut = makeTextLabel("caption", {}, content);
    column->addWidget(m_leftOut);
    column->addWidget(map(), 1);
    m_settlingTab->setToolTip(
        withKeys(tr("Shows how many frames the run takes to come to rest, for each stiffness "
                    "and damping. Click again to close"),
                 settlingToggle.shortcut()));
    m_area = makeScrollArea(*this);
    m_area->setWidget(content);
    QVBoxLayout *all = makeColumn(this);
    all->addWidget(title(toggle));
    all->addWidget(m_area, 1);
    connect(&monitor, &StabilityMonitor::changed, this, &StabilityPanel::refresh);
    connect(&monitor, &StabilityMonitor::mapChanged, this, &StabilityPanel::refreshMap);
    connect(&settling, &SettlingMonitor::changed, this, &StabilityPanel::refreshSettling);
    refresh();
    refreshMap();
    refreshSettling();
}

QWidget *StabilityPanel::title(const Command &toggle)
{
    m_title = new PanelTitle(tr("Stability"), m_theme, this);
    m_plotMenu = m_export->makeButton(m_title);
    m_title->addAction(m_plotMenu);
    QToolButton *close = makeIconButton("closeStability", "close", m_theme, m_title);
    close->setAccessibleName(tr("Close"));
    close->setToolTip(withKeys(tr("Close, and show the previous panel"), toggle.shortcut()));
    connect(close, &QToolButton::clicked, this, &StabilityPanel::closed);
    m_title->addAction(close);
    return m_title;
}

QWidget *StabilityPanel::card()
{
    auto *card = new QFrame(this);
    card->setObjectName("sentence");
    auto *layout = new QVBoxLayout(card);
    layout->setContentsMargins(14, 10, 12, 10);
    m_verdict = makeTextLabel("verdict", {}, card);
    m_verdict->setFont(m_theme.ui(13));
    m_verdict->setTextFormat(Qt::RichText);
    layout->addWidget(m_verdict);
    return card;
}

QWidget *StabilityPanel::remedyRows()
{
    m_remedyRows = new QWidget(this);
    m_rows = new QGridLayout(m_remedyRows);
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setHorizontalSpacing(10);
    m_rows->setVerticalSpacing(4);
    m_rows->setColumnStretch(1, 1);
    m_rows->addWidget(makeTextLabel("heading", tr("Remedies"), m_remedyRows), 0, 0, 1, 2);
    return m_remedyRows;
}

QToolButton *StabilityPanel::mapButton(const QString &text, const QString &tip, MapPlane plane)
{
    QToolButton *button = makeTab(text, tip, this);
    connect(button, &QToolButton::clicked, this,
            [this, plane](bool on) { showMap(on ? std::optional(plane) : std::nullopt); });
    m_planes.push_back(button);
    return button;
}

QWidget *StabilityPanel::mapTabs()
{
    auto *tabs = new QWidget(this);
    QHBoxLayout *row = makeRow(tabs, 2);
    row->addWidget(mapButton(
        tr("k and step"),
        tr("Shows which stiffness and step are stable, with everything else unchanged. Click again to close"),
        MapPlane::step));
    row->addWidget(mapButton(tr("k and damping"),
                             tr("Shows which stiffness and damping are stable, with everything else "
                                "unchanged. Click again to close"),
                             MapPlane::damping));
    m_settlingTab = makeTab(tr("Time to rest"), {}, tabs);
    connect(m_settlingTab, &QToolButton::clicked, this, &StabilityPanel::showSettling);
    row->addWidget(m_settlingTab);
    row->addStretch();
    return tabs;
}

QWidget *StabilityPanel::map()
{
    auto *part = new QWidget(this);
    QVBoxLayout *column = makeColumn(part, 4);
    m_plot = new GrowthPlot(m_monitor, m_theme, part);
    m_settlingPlot = new SettlingPlot(m_settling, m_theme, part);
    makeExport();
    m_noMap = makeTextLabel("caption", {}, part);
    m_counted = makeTextLabel("caption", {}, part);
    column->addWidget(makeTextLabel("heading", tr("Map"), part));
    column->addWidget(mapTabs());
    column->addWidget(m_noMap);
    column->addWidget(m_counted);
    column->addWidget(m_plot, 1);
    column->addWidget(m_settlingPlot, 1);
    column->addStretch();
    return part;
}

void StabilityPanel::makeExport()
{
    m_export = new PlotExport(
        [this] { return m_settling.isActive() ? m_settlingPlot->picture() : m_plot->picture(); }, m_theme,
        this);
    m_export->setNumbersAsText([this] {
        if (m_settling.isActive())
            return m_settling.map() ? settlingTable(*m_settling.map()) : QByteArray();
        return m_monitor.map() ? growthTable(*m_monitor.map()) : QByteArray();
    });
    m_export->addContextMenu(*m_plot);
    m_export->addContextMenu(*m_settlingPlot);
}

QString StabilityPanel::verdict() const
{
    return QTextDocumentFragment::fromHtml(m_verdict->text()).toPlainText();
}

QString StabilityPanel::leftOut() const
{
    return m_leftOut->text();
}

void StabilityPanel::refresh()
{
    const StabilityReading *reading = m_monitor.reading();
    if (!reading)
        return;
    m_title->setCaption(gaugeWords(*reading));
    QString said = stabilityVerdict(*reading);
    if (const QString sticks = stickVerdict(*reading); !sticks.isEmpty())
        said += QStringLiteral("<br>") + sticks;
    said = unbroken(said);
    if (said != m_verdict->text())
        m_verdict->setText(said);
    m_leftOut->setText(unbroken(leftOutWords(*reading)));
    refreshMap();
}

QPushButton *StabilityPanel::remedyButton(const sim::Remedy &remedy)
{
    auto *button = new QPushButton(remedyTitle(remedy), m_remedyRows);
    button->setObjectName("use");
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolTip(labelled(remedyTitle(remedy), remedyOutcome(remedy)));
    button->setAccessibleDescription(remedyOutcome(remedy));
    connect(button, &QPushButton::clicked, this, [this, remedy] { m_monitor.adopt(remedy); });
    return button;
}

void StabilityPanel::refreshRemedies(const std::vector<sim::Remedy> &remedies)
{
    if (!isVisible())
        return; // no child may be added while children are hidden
    // Beside a map of growth, outcomes are in tooltips only, and each row has as many buttons as fit. Remedies do not
    // help to read the other map.
    const bool isShort = m_monitor.mapPlane().has_value();
    QStringList offered = {isShort ? QStringLiteral("short") : QString()};
    for (const sim::Remedy &one : remedies)
        offered << remedyTitle(one) + '\n' + remedyOutcome(one);
    m_remedyRows->setVisible(!remedies.empty() && !m_settling.isActive());
    if (offered == m_offered)
        return;
    m_offered = offered;
    for (QWidget *cell : m_cells)
        cell->deleteLater(); // the click may come from one of them
    m_cells.clear();
    m_remedies.clear();
    for (const sim::Remedy &one : remedies) {
        const int count = static_cast<int>(m_remedies.size());
        m_remedies.push_back(remedyButton(one));
        m_cells.push_back(m_remedies.back());
        if (isShort)
            continue;
        auto *outcome = makeTextLabel("caption", remedyOutcome(one), m_remedyRows);
        m_cells.push_back(outcome);
        m_rows->addWidget(m_remedies.back(), 1 + count, 0, Qt::AlignLeft);
        m_rows->addWidget(outcome, 1 + count, 1);
    }
    placeRemedies();
    for (QWidget *cell : m_cells)
        cell->show();
}

void StabilityPanel::placeRemedies()
{
    for (QHBoxLayout *row : m_shortRows) {
        m_rows->removeItem(row);
        delete row;
    }
    m_shortRows.clear();
    if (m_offered.value(0).isEmpty())
        return; // each has its outcome beside it
    const int gap = m_rows->horizontalSpacing();
    int room = 0;
    for (QPushButton *button : m_remedies) {
        const int needed = button->sizeHint().width() + gap;
        if (m_shortRows.empty() || needed > room) {
            m_shortRows.push_back(new QHBoxLayout);
            m_shortRows.back()->setSpacing(gap);
            m_rows->addLayout(m_shortRows.back(), static_cast<int>(m_shortRows.size()), 0, 1, 2);
            room = width() - 2 * margin + gap;
        }
        m_shortRows.back()->addWidget(button);
        room -= needed;
    }
}

void StabilityPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    placeRemedies();
}

void StabilityPanel::showMap(std::optional<MapPlane> plane)
{
    if (plane)
        m_settling.setActive(false);
    m_monitor.requestMap(plane);
    refreshMap();
}

void StabilityPanel::showSettling(bool shown)
{
    if (shown)
        m_monitor.requestMap(std::nullopt);
    m_settling.setActive(shown);
    refreshSettling();
    if (shown) // the place of the map is known after the next layout
        QTimer::singleShot(0, this, [this] { m_area->ensureWidgetVisible(m_settlingPlot, 0, 0); });
}

void StabilityPanel::refreshMap()
{
    const std::optional<MapPlane> plane = m_monitor.mapPlane();
    for (std::size_t i = 0; i < m_planes.size(); ++i) {
        const auto its = static_cast<MapPlane>(i);
        m_planes[i]->setChecked(plane == its);
        m_planes[i]->setEnabled(m_monitor.canMap(its) || plane == its);
    }
    if (const StabilityReading *reading = m_monitor.reading()) {
        std::vector<sim::Remedy> all = reading->remedies;
        if (reading->sticks)
            all.insert(all.end(), reading->sticks->remedies.begin(), reading->sticks->remedies.end());
        refreshRemedies(all);
    }
    m_leftOut->setVisible(!m_leftOut->text().isEmpty() && !m_settling.isActive());
    const bool can = m_monitor.canMap(plane.value_or(MapPlane::step));
    m_noMap->setVisible(!can && !m_settling.isActive());
    m_noMap->setText(whyNoMap());
    m_plot->setVisible(plane && can);
    m_plotMenu->setVisible((plane && can) || (m_settling.isActive() && m_settling.canMap()));
}

void StabilityPanel::refreshSettling()
{
    const bool isShown = m_settling.isActive(), can = m_settling.canMap();
    m_settlingTab->setChecked(isShown);
    m_counted->setVisible(isShown);
    if (isShown)
        m_counted->setText(can ? m_settlingPlot->explanation()
                               : tr("There is no map of the time to rest for this step: it needs the "
                                    "stiffness k, a damping, and at most %1 points.")
                                     .arg(SettlingMonitor::mostPoints));
    m_settlingPlot->setVisible(isShown && can);
    refreshMap();
    emit settlingShown(isShown);
}

QString StabilityPanel::whyNoMap() const
{
    if (!m_monitor.run().step().parameter(QStringLiteral("k")))
        return tr("There is no map for this step: it has no stiffness k to change.");
    if (programOf(m_monitor.run().timeline().script().method))
        return tr("There is no map for your code: it may compute anything, whatever the stiffness is.");
    if (m_monitor.nothingSwings())
        return tr("There is no map here: no springs act, so every stiffness and every step is stable.");
    return tr("There is no map for this method: it is stable at every stiffness.");
}

void StabilityPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_monitor.setDetailed(true);
    refreshMap();
}

void StabilityPanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    if (event->spontaneous())
        return; // only the whole window is hidden
    m_monitor.setDetailed(false);
    m_monitor.requestMap(std::nullopt);
    m_settling.setActive(false);
}

}
