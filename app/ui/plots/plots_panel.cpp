#include "app/ui/plots/plots_panel.h"

#include "app/ui/panels/panel_title.h"
#include "app/ui/panels/progress_line.h"
#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/scene/flat_button.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr int patienceMilliseconds = 300;
constexpr int heightOfOne = 250; ///< px, with the panel's title
constexpr int heightOfTwo = 420;

}

PlotsPanel::PlotsPanel(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_theme(theme), m_course(session),
      m_title(new PanelTitle(tr("Plots"), PanelTitle::CaptionPlace::besideTitle, theme, this)),
      m_add(new FlatButton(theme, this)), m_pages(new QStackedWidget(this))
{
    setObjectName("panel");
    setAttribute(Qt::WA_StyledBackground);
    m_add->setTexts({}, tr("Add"));
    m_add->setMenu(addMenu());
    m_add->setToolTip(tr("Another plot"));
    m_add->setAccessibleName(tr("Add a plot"));
    m_title->addAction(m_add);
    m_scroll = new QScrollArea(m_pages);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    auto *inside = new QWidget(m_scroll);
    inside->setObjectName("panel");
    inside->setAttribute(Qt::WA_StyledBackground);
    m_column = new QVBoxLayout(inside);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(0);
    m_scroll->setWidget(inside);
    m_pages->addWidget(m_scroll);
    m_pages->addWidget(emptyPage());
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 4);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_pages, 1);
    column->addWidget(saving());
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, m_saving, &QWidget::show);
    connect(&session, &Session::stepOpened, this, &PlotsPanel::open);
    connect(&m_list, &PlotList::changed, this, &PlotsPanel::rebuild);
    connect(&m_course, &PlotCourse::changed, this, &PlotsPanel::refreshSoon);
    connect(&session, &Session::moved, this, &PlotsPanel::refreshSoon);
    connect(&session, &Session::runChanged, this, &PlotsPanel::refreshSoon);
    connect(&session, &Session::selectionChanged, this, &PlotsPanel::refreshSoon);
    connect(&session, &Session::playingChanged, this, &PlotsPanel::refreshSoon);
    connect(&session, &Session::glanceChanged, this, &PlotsPanel::followGlance);
    connect(&theme, &Theme::changed, this, &PlotsPanel::refreshSoon);
    open();
    rebuild();
}

QWidget *PlotsPanel::saving()
{
    m_saving = new QWidget(this);
    m_progress = new ProgressLine(tr("How much of the numbers is written"), m_saving);
    auto *stop = new QPushButton(tr("Cancel"), m_saving);
    stop->setObjectName("measure");
    stop->setAutoDefault(false);
    stop->setToolTip(tr("Leave off; nothing is saved then"));
    connect(stop, &QPushButton::clicked, this, [this] {
        if (NumberTable *writing = table())
            writing->cancel();
    });
    auto *row = new QHBoxLayout(m_saving);
    row->setContentsMargins(16, 4, 16, 4);
    row->addWidget(new QLabel(tr("Saving numbers…"), m_saving));
    row->addWidget(m_progress, 1);
    row->addWidget(stop);
    m_saving->hide();
    return m_saving;
}

void PlotsPanel::open()
{
    m_list.open(m_session.timeline().script());
}

std::size_t PlotsPanel::indexOf(const PlotCard &card) const
{
    return static_cast<std::size_t>(std::find(m_cards.begin(), m_cards.end(), &card) - m_cards.begin());
}

PlotCard *PlotsPanel::makeCard()
{
    auto *card = new PlotCard(m_session, m_course, m_theme, m_scroll->widget());
    connect(card, &PlotCard::changeWanted, this,
            [this, card](const PlotSpec &spec) { m_list.change(indexOf(*card), spec); });
    connect(
        card, &PlotCard::removalWanted, this, [this, card] { removeCard(*card); },
        Qt::QueuedConnection); // it asks from its own menu or key
    connect(card, &PlotCard::pointedAt, this, &PlotsPanel::setHovered);
    connect(card, &PlotCard::pointedAt, this, &PlotsPanel::pointedAt);
    connect(card, &PlotCard::zoomWanted, this, &PlotsPanel::zoom);
    connect(&card->exports(), &PlotExport::said, this, &PlotsPanel::said);
    connect(&card->exports(), &PlotExport::failed, this, &PlotsPanel::failed);
    connect(&card->exports(), &PlotExport::tableChanged, this, &PlotsPanel::showSaving);
    m_column->addWidget(card, 1);
    return card;
}

void PlotsPanel::removeCard(PlotCard &card)
{
    const std::size_t index = indexOf(card);
    if (index >= m_cards.size())
        return;
    // Its own card goes, so that the others keep what they show and the focus.
    const bool hadFocus = card.isAncestorOf(focusWidget()) || card.plot().hasFocus();
    m_cards.erase(m_cards.begin() + static_cast<std::ptrdiff_t>(index));
    letGo(card);
    m_list.remove(index);
    if (!hadFocus)
        return;
    if (m_cards.empty())
        m_add->setFocus(Qt::OtherFocusReason);
    else
        m_cards[std::min(index, m_cards.size() - 1)]->plot().setFocus(Qt::OtherFocusReason);
}

void PlotsPanel::letGo(PlotCard &card)
{
    if (NumberTable *writing = card.exports().table())
        writing->cancel(); // it would go with the card, and nobody would hear of it
    m_column->removeWidget(&card);
    card.hide();
    card.deleteLater();
}

QSize PlotsPanel::sizeHint() const
{
    return {400, m_cards.size() > 1 ? heightOfTwo : heightOfOne};
}

void PlotsPanel::rebuild()
{
    const int wanted = m_wantedHeight;
    while (m_cards.size() < m_list.plots().size())
        m_cards.push_back(makeCard());
    while (m_cards.size() > m_list.plots().size()) {
        PlotCard *last = m_cards.back();
        m_cards.pop_back();
        letGo(*last);
    }
    for (std::size_t i = 0; i < m_cards.size(); ++i)
        m_cards[i]->setSpec(m_list.plots()[i]);
    m_pages->setCurrentIndex(m_cards.empty() ? 1 : 0);
    m_course.setQuantities(m_list.quantities());
    refreshSoon();
    m_wantedHeight = sizeHint().height();
    if (m_wantedHeight != wanted)
        emit wantedHeightChanged();
}

void PlotsPanel::refreshSoon()
{
    if (!isVisible() || m_isCovered || std::exchange(m_isDue, true))
        return;
    // Not by a timer: those come after the window is painted, which would be painted again.
    QMetaObject::invokeMethod(this, &PlotsPanel::refresh, Qt::QueuedConnection);
}

void PlotsPanel::followGlance()
{
    const bool isInside = m_session.isGlancing() && m_session.shown().cursor().phase > 0;
    if (std::exchange(m_looksInside, isInside) || isInside)
        refreshSoon();
}

void PlotsPanel::refresh()
{
    m_isDue = false;
    if (!isVisible() || m_isCovered)
        return;
    const std::vector<double> begun = m_course.begun();
    const std::optional<PlotCourse::Inside> inside = m_course.inside();
    for (PlotCard *card : m_cards)
        card->refresh(begun, inside);
    writeCaption();
}

void PlotsPanel::writeCaption()
{
    const std::int64_t last = m_course.window().last, first = m_course.window().first;
    const bool isAll = first == 0 && last >= m_session.timeline().computed();
    const QString text = m_cards.empty() ? QString()
                         : isAll         ? tr("the whole run")
                                         : tr("frame %1 to %2").arg(first).arg(last);
    if (text != m_title->caption())
        m_title->setCaption(text);
}

void PlotsPanel::setHovered(std::optional<std::int64_t> frame)
{
    for (PlotCard *card : m_cards)
        card->plot().setHovered(frame);
}

void PlotsPanel::setPointedBody(const QString &body)
{
    for (PlotCard *card : m_cards)
        card->plot().setPointedBody(body);
}

void PlotsPanel::zoom(int steps)
{
    std::int64_t rows = m_course.mostRows();
    const std::int64_t shown =
        (m_course.window().last - m_course.window().first) / std::max(1, m_course.rowFrames());
    if (steps > 0)
        rows = std::min(rows, shown) >> steps; // from what is seen: a young run fills less than it may
    else
        rows = std::min(rows << -steps, PlotCourse::allRows);
    m_course.setMostRows(rows);
}

NumberTable *PlotsPanel::table() const
{
    for (const PlotCard *card : m_cards) {
        if (card->exports().table())
            return card->exports().table();
    }
    return nullptr;
}

void PlotsPanel::showSaving()
{
    NumberTable *writing = table();
    if (!writing) {
        m_patience.stop();
        m_saving->hide();
        return;
    }
    m_progress->setShare(0.0);
    m_patience.start(patienceMilliseconds);
    connect(writing, &NumberTable::progressed, m_progress,
            [this, writing] { m_progress->setShare(writing->done()); });
}

void PlotsPanel::setCovered(bool covered)
{
    m_isCovered = covered;
    watch();
}

void PlotsPanel::watch()
{
    m_course.setWatched(isVisible() && !m_isCovered);
    refresh();
}

void PlotsPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    watch();
}

void PlotsPanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    watch();
}

}
