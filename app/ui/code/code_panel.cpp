#include "app/ui/code/code_panel.h"

#include "app/model/sentences.h"
#include "app/ui/code/code_card.h"
#include "app/ui/code/code_view.h"
#include "app/ui/code/stop_list.h"
#include "app/ui/theme/theme.h"
#include "sim/run/script/composed_interval.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include <utility>

namespace app {

namespace {

constexpr int besideGone = 14;              ///< px: the number of lines that are gone, and its button
constexpr qint64 playingMilliseconds = 100; ///< between two sets of values while playing: no dancing numbers

}

CodePanel::CodePanel(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_theme(theme), m_view(new CodeView(theme, this)),
      m_stops(new StopList(session, theme, this)), m_card(new CodeCard(theme, this))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_stops);
    setFocusProxy(m_view);
    makeActions();
    connectView();
    connectNumbers();
    applyTheme();
    connect(&theme, &Theme::changed, this, &CodePanel::applyTheme);
    connect(&session, &Session::stepOpened, this, &CodePanel::follow);
    connect(&session, &Session::runChanged, this, &CodePanel::follow);
    connect(&session, &Session::moved, this, &CodePanel::follow);
    connect(&session, &Session::playingChanged, this, [this] {
        m_refreshed.invalidate(); // marks come and go at once
        follow();
    });
    connect(&session, &Session::selectionChanged, this, [this] {
        if (m_looks)
            m_session.endGlance(); // the values under the mouse are another body's now
        follow();
    });
    connect(&session, &Session::glanceChanged, this, &CodePanel::followGlance);
    rebuild();
}

CodePanel::~CodePanel()
{
    // Never placed in a title, it has no parent.
    if (m_actions && !m_actions->parent())
        delete m_actions;
}

void CodePanel::makeActions()
{
    m_actions = new QWidget;
    auto *row = new QHBoxLayout(m_actions);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    m_newLines = new QToolButton;
    m_newLines->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_newLines->setToolTip(tr("Lines that the step before does not have. Click to go through them."));
    m_goneLines = new QToolButton;
    m_goneLines->setToolTip(
        tr("Lines that only the step before has. Click to see them struck through where they "
           "were, or no longer (F8 in the code)."));
    m_goneLines->setCheckable(true);
    m_copy = new QToolButton;
    m_copy->setToolTip(tr("Copy the shown code, with its files' names"));
    m_copy->setAccessibleName(tr("Copy the code"));
    for (QToolButton *button : {m_newLines, m_goneLines, m_copy}) {
        button->setIconSize({16, 16});
        button->setFixedHeight(28);
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
    }
    connect(m_newLines, &QToolButton::clicked, m_view, &CodeView::showNextNew);
    connect(m_goneLines, &QToolButton::toggled, this, &CodePanel::showGoneLines);
    connect(m_goneLines, &QToolButton::clicked, m_view, &CodeView::showFirstGone);
    connect(m_copy, &QToolButton::clicked, this, &CodePanel::copyAll);
}

void CodePanel::applyTheme()
{
    m_newLines->setIcon(m_theme.icon(QStringLiteral("difference")));
    m_copy->setIcon(m_theme.icon(QStringLiteral("copy")));
}

void CodePanel::copyAll()
{
    QApplication::clipboard()->setText(m_view->shownText());
    emit said(tr("Copied the code."));
}

void CodePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    follow();
}

void CodePanel::followGlance()
{
    if (!m_session.marked())
        m_looks = false;
    // What is under the mouse, or typed over, stays as it is.
    if (m_looks || m_editor || (!m_session.isGlancing() && !m_top))
        return;
    if (!m_top)
        m_top = m_view->firstVisibleLine();
    follow();
    if (m_session.isGlancing())
        return;
    m_view->setFirstVisibleLine(*m_top);
    m_top.reset();
}

void CodePanel::follow()
{
    if (m_looks && m_session.isGlancing())
        return;
    const bool same = m_session.shown().track().intervalPtr() == m_interval &&
                      m_session.timeline().script().method == m_method && &m_session.step() == m_step;
    if (!same)
        rebuild();
    showCaption();
    if (!isVisible())
        return;
    if (m_session.isPlaying() && m_refreshed.isValid() && m_refreshed.elapsed() < playingMilliseconds)
        return;
    refresh();
}

void CodePanel::rebuild()
{
    m_interval = m_session.shown().track().intervalPtr();
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
    m_asked.reset();
    m_ranTo.reset();
    m_card->hide();
    closeEditor();
    m_refreshed.invalidate();
    m_begun = false;
    showNewLines();
}

std::optional<CodeListing> CodePanel::listingBefore() const
{
    const lessons::Step *before = m_session.preceding();
    return before ? listingAtStart(*before, m_method) : std::nullopt;
}

void CodePanel::refresh()
{
    m_refreshed.start();
    const sim::Timeline &timeline = m_session.shown();
    std::vector<CodeChip> values = chipsOf(m_listing, m_session.moments(), *m_interval, point());
    if (m_session.stoppedBy() && !m_session.isGlancing())
        dropNext(values, m_listing, timeline.cursor().phase % m_interval->pipeline.phasesPerStep());
    std::vector<SectionMark> marks = marksNow(timeline, values);
    const std::vector<CodeChip> parameters = parameterChips(m_listing, *m_step, timeline.values());
    values.insert(values.end(), parameters.begin(), parameters.end());
    m_view->setValues(std::move(values), std::move(marks));
    const std::optional<sim::Cursor> &marked = m_session.marked();
    if (!m_session.isGlancing())
        showStand();
    else if (marked && marked->phase > 0)
        m_view->scrollToNow();
    showCard();
}

/// While playing nothing is marked: it would be another line at each frame.
std::vector<SectionMark> CodePanel::marksNow(const sim::Timeline &timeline,
                                             const std::vector<CodeChip> &values) const
{
    if (m_session.isPlaying())
        return std::vector<SectionMark>(m_listing.sections.size());
    std::vector<SectionMark> marks = marksOf(m_listing, timeline, values, point());
    const bool isThere = m_ranTo && timeline.cursor() == m_ranTo->at && m_ranTo->section < marks.size();
    if (isThere && marks[m_ranTo->section].when == When::now)
        marks[m_ranTo->section].result = m_ranTo->line;
    return marks;
}

void CodePanel::showStand()
{
    const sim::Timeline &timeline = m_session.timeline();
    const sim::Cursor at = timeline.cursor();
    if (!m_begun && at != sim::Cursor{})
        m_view->showPhases();
    m_begun = m_begun || at != sim::Cursor{};
    // The end of a frame comes into view where the step before it was one inside the frame.
    const bool hasEnded = std::exchange(m_wasInside, at.phase > 0) && at.phase == 0;
    const bool isRanTo = m_ranTo && m_ranTo->at == at;
    if ((at.phase > 0 || hasEnded || isRanTo) && !m_session.isPlaying())
        m_view->showNow();
    if (const std::optional<BreakHit> &hit = m_session.stoppedBy()) {
        const Breakpoint *stop = m_session.breakpoints().find(hit->id);
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
    m_newLines->setText(text);
    m_newLines->setAccessibleName(text);
    m_newLines->setVisible(count > 0);
    const int gone = m_listing.goneLines();
    const QString less = QStringLiteral("−%1").arg(gone); // the title has little room
    m_goneLines->setText(less);
    m_goneLines->setFixedWidth(m_goneLines->fontMetrics().horizontalAdvance(less) + besideGone);
    m_goneLines->setAccessibleName(gone == 1 ? tr("1 line gone") : tr("%1 lines gone").arg(gone));
    m_goneLines->setVisible(gone > 0);
}

void CodePanel::showGoneLines(bool shown)
{
    m_view->setGone(shown ? Gone::shown : Gone::hidden);
    closeEditor();
    m_card->hide();
}

}
