#include "app/ui/code/engine/code_panel.h"

#include "app/model/text/sentences.h"
#include "app/ui/actions/command.h"
#include "app/ui/code/breakpoint_list.h"
#include "app/ui/code/code_keys.h"
#include "app/ui/code/engine/code_card.h"
#include "app/ui/code/engine/code_view.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/theme/icon_button.h"
#include "sim/run/script/composed_interval.h"

#include <QApplication>
#include <QClipboard>
#include <QVBoxLayout>

#include <utility>

namespace app {

namespace {

constexpr int besideGone = 14; ///< px, between a number of lines and the edges of its button

}

CodePanel::CodePanel(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_theme(theme), m_view(new CodeView(theme, this)),
      m_stops(new BreakpointList(session.run(), session.playback(), theme, this)),
      m_card(new CodeCard(theme, this))
{
    QVBoxLayout *layout = makeColumn(this);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_stops);
    setFocusProxy(m_view);
    makeActions();
    connectView();
    connectNumbers();
    session.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::cursor, this, &CodePanel::follow);
    session.onChange(ChangeKind::playing, this, [this] {
        m_pace.reset(); // marks are updated without delay
        follow();
    });
    session.onChange(ChangeKind::selection, this, [this] {
        if (m_ownsPreview)
            m_session.preview().end(); // the values under the mouse are now another body's
        follow();
    });
    session.onChange(ChangeKind::preview, this, &CodePanel::followPreview);
    rebuild();
}

void CodePanel::makeActions()
{
    m_newLines = m_actions.addButton();
    m_newLines->setToolTip(tr("Lines that are new in this step. Click to go through them."));
    m_goneLines = m_actions.addButton();
    m_goneLines->setToolTip(tr("Lines that this step removed. Click to show or hide them, struck through at "
                               "their old places (%1 in the code).")
                                .arg(keyText(codeKeys::showRemovedLines)));
    m_goneLines->setCheckable(true);
    QToolButton *copy = m_actions.addButton();
    showIcon(*copy, "copy", m_theme);
    copy->setToolTip(tr("Copy the shown code, with its files' names"));
    copy->setAccessibleName(tr("Copy the code"));
    connect(m_newLines, &QToolButton::clicked, m_view, &CodeView::showNextNew);
    connect(m_goneLines, &QToolButton::toggled, this, &CodePanel::showGoneLines);
    connect(m_goneLines, &QToolButton::clicked, m_view, &CodeView::showFirstGone);
    connect(copy, &QToolButton::clicked, this, &CodePanel::copyAll);
}

void CodePanel::copyAll()
{
    QApplication::clipboard()->setText(m_view->shownText());
    m_session.showMessage(tr("Copied the code."));
}

void CodePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    follow();
}

void CodePanel::followPreview()
{
    if (!m_session.preview().marked())
        m_ownsPreview = false;
    // While the mouse previews a line, or a number is being edited, the code must not scroll.
    if (m_ownsPreview || m_editor || (!m_session.preview().isActive() && !m_top))
        return;
    if (!m_top)
        m_top = m_view->firstVisibleLine();
    follow();
    if (m_session.preview().isActive())
        return;
    m_view->setFirstVisibleLine(*m_top);
    m_top.reset();
}

void CodePanel::follow()
{
    if (m_ownsPreview && m_session.preview().isActive())
        return;
    const bool same = m_session.preview().run().track().intervalPtr() == m_interval &&
                      m_session.timeline().script().method == m_method && &m_session.step() == m_step;
    if (!same)
        rebuild();
    showCaption();
    if (isVisible() && m_pace.isDue())
        refresh();
}

void CodePanel::rebuild()
{
    m_interval = m_session.preview().run().track().intervalPtr();
    m_method = m_session.timeline().script().method;
    m_step = &m_session.step();
    CodeListing listing = listingOf(*m_step, *m_interval, *m_method);
    if (const auto before = listingBefore()) {
        markNew(listing, *before);
        markGone(listing, *before);
    }
    if (listing == m_listing)
        return;
    m_listing = std::move(listing);
    m_view->setListing(m_listing);
    m_view->setSpots(parameterSpots(m_listing, *m_step, *m_interval));
    m_ranTo.reset();
    hideCard();
    closeEditor();
    m_pace.reset();
    m_begun = false;
    showNewLines();
}

std::optional<CodeListing> CodePanel::listingBefore() const
{
    const lessons::Step *before = m_session.run().preceding();
    return before ? listingAtStart(*before, m_method) : std::nullopt;
}

void CodePanel::refresh()
{
    m_pace.restart();
    const sim::Timeline &timeline = m_session.preview().run();
    std::vector<CodeChip> values =
        chipsOf(m_listing, m_session.presentation().explanations(), *m_interval, point());
    if (m_session.playback().breakHit() && !m_session.preview().isActive())
        dropNext(values, m_listing, timeline.cursor().phase % m_interval->pipeline.phasesPerStep());
    std::vector<SectionMark> marks = marksNow(timeline, values);
    const std::vector<CodeChip> parameters = parameterChips(m_listing, *m_step, timeline.values());
    values.insert(values.end(), parameters.begin(), parameters.end());
    m_view->setValues(std::move(values), std::move(marks));
    const std::optional<sim::Cursor> &marked = m_session.preview().marked();
    if (!m_session.preview().isActive())
        showCurrent();
    else if (marked && marked->phase > 0)
        m_view->scrollToNow();
    showCard();
}

/// Returns no marks during playback, because the marked line would change every frame.
std::vector<SectionMark> CodePanel::marksNow(const sim::Timeline &timeline,
                                             const std::vector<CodeChip> &values) const
{
    if (m_session.playback().isPlaying())
        return std::vector<SectionMark>(m_listing.sections.size());
    std::vector<SectionMark> marks = marksOf(m_listing, timeline, values, point());
    const bool isThere = m_ranTo && timeline.cursor() == m_ranTo->at && m_ranTo->section < marks.size();
    if (isThere && marks[m_ranTo->section].when == When::now)
        marks[m_ranTo->section].result = m_ranTo->line;
    return marks;
}

void CodePanel::showCurrent()
{
    const sim::Timeline &timeline = m_session.timeline();
    const sim::Cursor at = timeline.cursor();
    if (!m_begun && at != sim::Cursor{})
        m_view->showPhases();
    m_begun = m_begun || at != sim::Cursor{};
    // Scrolls to the end of a frame only if the previous position was inside that frame.
    const bool hasEnded = std::exchange(m_wasInside, at.phase > 0) && at.phase == 0;
    const bool isRanTo = m_ranTo && m_ranTo->at == at;
    if ((at.phase > 0 || hasEnded || isRanTo) && !m_session.playback().isPlaying())
        m_view->showNow();
    if (const std::optional<BreakHit> &hit = m_session.playback().breakHit()) {
        const Breakpoint *stop = m_session.playback().breakpoints().find(hit->id);
        if (stop && stop->place)
            m_view->showPlace(*stop->place);
    }
}

int CodePanel::point() const
{
    return m_interval->scene.find(m_session.selected().toStdString());
}

void CodePanel::showCaption()
{
    const QString title = bodyTitle(m_session.selected());
    const bool isNumbered = title.back().isDigit();
    const QString caption = isNumbered ? tr("values of %1").arg(title) : tr("values of the %1").arg(title);
    if (caption == m_caption)
        return;
    m_caption = caption;
    emit captionChanged(caption);
}

void CodePanel::showNewLines()
{
    const int count = m_listing.newLines();
    const QString text = count == 1 ? tr("1 line new") : tr("%1 lines new").arg(count);
    const QString more = QStringLiteral("+%1").arg(count); // short, because the title has little space
    m_newLines->setText(more);
    m_newLines->setFixedWidth(m_newLines->fontMetrics().horizontalAdvance(more) + besideGone);
    m_newLines->setAccessibleName(text);
    m_newLines->setVisible(count > 0);
    const int gone = m_listing.goneLines();
    const QString less = QStringLiteral("−%1").arg(gone);
    m_goneLines->setText(less);
    m_goneLines->setFixedWidth(m_goneLines->fontMetrics().horizontalAdvance(less) + besideGone);
    m_goneLines->setAccessibleName(gone == 1 ? tr("1 line removed") : tr("%1 lines removed").arg(gone));
    m_goneLines->setVisible(gone > 0);
}

void CodePanel::showGoneLines(bool shown)
{
    m_view->setGone(shown ? Gone::shown : Gone::hidden);
    closeEditor();
    hideCard();
}

}
