#include "app/ui/parameters/parameter_panel.h"

#include "app/model/session/offered_parameters.h"
#include "app/model/text/sentences.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/dock/scroll_page.h"
#include "app/ui/parameters/parameter_row.h"

#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr std::size_t alwaysShown = 4;
constexpr std::size_t leastShown = 2; ///< if there is little height; the rest can be scrolled to
constexpr int labelWidth = 88;
constexpr int unitWidth = 53;
constexpr int disclosureHeight = 28;
constexpr int bottomMargin = 12;

}

ParameterPanel::ParameterPanel(const OpenRun &run, RunEditor &editor, const Playback &playback,
                               const Theme &theme, QWidget *parent)
    : QWidget(parent), m_run(run), m_editor(editor), m_theme(theme), m_pace(playback)
{
    styleAsPanel(*this);
    m_area = makeScrollArea(*this);
    QWidget *page = makePage();
    m_column = new QVBoxLayout(page);
    m_column->setContentsMargins(0, 0, 0, 4); // smaller than preferred: a dock may be slightly too low
    m_column->setSpacing(0);
    m_area->setWidget(page);
    makeDisclosure();
    QVBoxLayout *column = makeColumn(this);
    column->addWidget(makeTitle());
    column->addWidget(m_area, 1);
    m_run.onChange(everyChange, this, &ParameterPanel::follow);
    connect(&theme, &Theme::changed, this, &ParameterPanel::drawArrow);
    open();
}

QWidget *ParameterPanel::makeTitle()
{
    auto *title = new PanelTitle(tr("Parameters"), m_theme, this);
    const auto addButton = [&](const QString &name, const QString &text) {
        auto *button = new QToolButton(title);
        button->setObjectName(name);
        button->setText(text);
        button->setFont(m_theme.ui());
        button->setFixedSize(button->fontMetrics().horizontalAdvance(text) + 8, 28);
        button->setFocusPolicy(Qt::TabFocus); // after a click, Space still starts playback
        title->addAction(button);
        return button;
    };
    m_presets = addButton("presets", tr("Presets"));
    m_presets->setToolTip(tr("Pictures of this step with other values"));
    connect(m_presets, &QToolButton::clicked, this, [this] { m_gallery->popUp(*m_presets); });
    m_resetAll = addButton("resetAll", tr("Reset all"));
    connect(m_resetAll, &QToolButton::clicked, &m_editor, &RunEditor::resetParameters);
    return title;
}

void ParameterPanel::setPresetPainter(PresetPainter painter)
{
    delete m_gallery;
    m_gallery = new PresetGallery(m_run, m_editor, m_theme, std::move(painter), this);
    showPresets();
}

void ParameterPanel::setHighlights(const std::vector<lessons::Highlight> &highlights)
{
    QStringList ids; // and names of other things
    for (const lessons::Highlight &one : highlights) {
        if (one.kind == lessons::Highlight::Kind::thing)
            ids << one.a;
        else if (one.kind == lessons::Highlight::Kind::circle)
            ids << one.b;
    }
    if (ids == m_marked)
        return;
    m_marked = ids;
    showMarked();
}

void ParameterPanel::showMarked()
{
    bool isFolded = false;
    for (ParameterRow *row : m_rows) {
        row->setMarked(m_marked.contains(row->parameter().id));
        if (!row->isMarked())
            continue;
        isFolded = isFolded || row->isHidden();
        m_area->ensureWidgetVisible(row, 0, 0);
    }
    m_more->setDown(isFolded);
}

void ParameterPanel::showPresets()
{
    m_presets->setVisible(m_gallery && !m_run.step().presets.empty());
}

void ParameterPanel::makeDisclosure()
{
    m_more = new QToolButton(this);
    m_more->setObjectName("disclosure");
    m_more->setFont(m_theme.ui(12));
    m_more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_more->setIconSize({12, 12});
    m_more->setFixedHeight(disclosureHeight);
    m_more->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_more->setFocusPolicy(Qt::TabFocus);
    connect(m_more, &QToolButton::clicked, this, [this] {
        m_chosen = true;
        unfold(!m_unfolded);
    });
}

void ParameterPanel::open()
{
    // Deleted later, because the signal that opened another step may have come from one of these rows.
    for (ParameterRow *row : m_rows) {
        row->hide();
        row->deleteLater();
    }
    m_rows.clear();
    while (QLayoutItem *item = m_column->takeAt(0))
        delete item;
    addRows();
    showPresets();
    alignColumns();
    m_chosen = false;
    m_unfolded = false;
    nameRest();
    unfoldIfRoom();
    unfold(m_unfolded);
    showMarked();
    refreshNow();
}

QStringList ParameterPanel::offered() const
{
    QStringList ids;
    for (const lessons::Parameter *parameter : offeredParameters(m_run, m_editor))
        ids << parameter->id;
    return ids;
}

bool ParameterPanel::hasOtherTexts() const
{
    return std::any_of(m_rows.begin(), m_rows.end(), [this](const ParameterRow *row) {
        const lessons::Parameter &shown = row->parameter();
        const lessons::Parameter *now = m_run.step().parameter(shown.id);
        return now && (now->name != shown.name || now->help != shown.help || now->unit != shown.unit);
    });
}

void ParameterPanel::follow(const Change &change)
{
    const bool hasOtherParameters =
        change.isAny(ChangeKind::run) && m_run.isSandbox() && offered() != m_offered;
    if (change.isAny(ChangeKind::step) || hasOtherParameters ||
        (change.isAny(ChangeKind::texts) && hasOtherTexts()))
        open();
    if (change.isAny(ChangeKind::run | ChangeKind::playing))
        refreshNow();
    else if (change.isAny(ChangeKind::cursor))
        refresh();
}

void ParameterPanel::addRows()
{
    QStringList rest;
    m_offered = offered();
    for (const lessons::Parameter &parameter : m_run.step().parameters) {
        if (!m_offered.contains(parameter.id))
            continue;
        if (m_rows.size() == alwaysShown)
            m_column->addWidget(m_more);
        if (m_rows.size() >= alwaysShown)
            rest.push_back(rest.isEmpty() ? parameter.name : withinSentence(parameter.name));
        m_rows.push_back(new ParameterRow(m_run, m_editor, parameter, m_theme, m_area->widget()));
        m_column->addWidget(m_rows.back());
    }
    m_column->addStretch(1);
    m_rest = rest.join(", ");
    nameRest();
    m_more->setVisible(!rest.isEmpty());
}

void ParameterPanel::alignColumns()
{
    int label = labelWidth;
    int unit = unitWidth;
    for (const ParameterRow *row : m_rows) {
        label = std::max(label, row->wantedLabelWidth());
        unit = std::max(unit, row->wantedUnitWidth());
    }
    for (ParameterRow *row : m_rows)
        row->setColumns(label, unit);
}

void ParameterPanel::nameRest()
{
    constexpr int beside = 44; // px, arrow and margins
    m_more->setText(m_more->fontMetrics().elidedText(m_rest, Qt::ElideRight, std::max(40, width() - beside)));
}

void ParameterPanel::refresh()
{
    if (m_pace.isDue())
        refreshNow();
}

void ParameterPanel::refreshNow()
{
    m_pace.restart();
    bool changed = false;
    for (ParameterRow *row : m_rows) {
        row->refresh();
        changed = changed || row->isChanged();
    }
    if (changed == m_resetAll->isEnabled() && !m_resetAll->toolTip().isEmpty())
        return;
    m_resetAll->setEnabled(changed);
    m_resetAll->setToolTip(changed ? tr("Reset every parameter to its start value in this step")
                                   : tr("Nothing to reset: every parameter has its start value."));
}

void ParameterPanel::unfold(bool all)
{
    m_unfolded = all;
    for (std::size_t i = alwaysShown; i < m_rows.size(); ++i)
        m_rows[i]->setVisible(all);
    drawArrow();
    m_more->setToolTip(all ? tr("Show fewer parameters") : tr("Show all parameters"));
    m_more->setAccessibleName(all ? tr("%1, shown").arg(m_rest) : tr("%1, folded").arg(m_rest));
    updateGeometry();
    emit wantedHeightChanged();
}

void ParameterPanel::drawArrow()
{
    m_more->setIcon(m_theme.icon(m_unfolded ? "down" : "right"));
}

void ParameterPanel::unfoldIfRoom()
{
    if (m_chosen || !m_placed || m_rows.size() <= alwaysShown)
        return;
    const bool room = height() >= fullHeight() - slack;
    if (room != m_unfolded)
        unfold(room);
}

int ParameterPanel::heightOf(std::size_t rows, bool disclosure) const
{
    return PanelTitle::height + static_cast<int>(rows) * ParameterRow::height +
           (disclosure ? disclosureHeight : 0) + bottomMargin;
}

int ParameterPanel::fullHeight() const
{
    return heightOf(m_rows.size(), m_rows.size() > alwaysShown);
}

QSize ParameterPanel::sizeHint() const
{
    // Only rows that the learner unfolds may make the panel higher. Others unfold only if there is room already.
    const bool some = m_rows.size() > alwaysShown;
    return {400, heightOf(some && !(m_unfolded && m_chosen) ? alwaysShown : m_rows.size(), some)};
}

QSize ParameterPanel::minimumSizeHint() const
{
    // Without a part of the margin, in which the next row would begin.
    const bool isCut = m_rows.size() > leastShown;
    return {300, heightOf(std::min(m_rows.size(), leastShown), false) - (isCut ? slack : 0)};
}

void ParameterPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    m_placed = true;
    nameRest();
    unfoldIfRoom();
}

}
