#include "app/ui/plots/plots_panel.h"

#include "app/model/session/comparison_runs.h"
#include "app/model/session/playback.h"
#include "app/model/session/preview.h"
#include "app/model/text/quantity_text.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/dock/progress_line.h"
#include "app/ui/dock/scroll_page.h"
#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/scene/flat_button.h"
#include "sim/run/script/composed_interval.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
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

PlotsPanel::PlotsPanel(const OpenRun &run, Playback &playback, const Preview &preview,
                       const ComparisonRuns &comparisons, const Theme &theme, QWidget *parent)
    : LivePanel(parent), m_run(run), m_playback(playback), m_preview(preview), m_comparisons(comparisons),
      m_theme(theme), m_series(run, playback, comparisons), m_title(new PanelTitle(tr("Plots"), theme, this)),
      m_add(new FlatButton(theme, this)), m_pages(new QStackedWidget(this))
{
    m_add->setTexts({}, tr("Add"));
    m_add->setMenu(addMenu());
    m_add->setToolTip(tr("Another plot"));
    m_add->setAccessibleName(tr("Add a plot"));
    m_title->addAction(m_add);
    m_scroll = makeScrollArea(*m_pages);
    QWidget *inside = makePage();
    m_column = makeColumn(inside);
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
    run.onChange(ChangeKind::step, this, &PlotsPanel::open);
    connect(&m_list, &PlotList::changed, this, &PlotsPanel::rebuild);
    connect(&m_series, &PlotSeries::changed, this, &PlotsPanel::refreshSoon);
    run.onChange(ChangeKind::run | ChangeKind::cursor | ChangeKind::playing | ChangeKind::selection, this,
                 &PlotsPanel::refreshSoon);
    run.onChange(ChangeKind::preview, this, &PlotsPanel::followPreview);
    connect(&theme, &Theme::changed, this, &PlotsPanel::refreshSoon);
    open();
    rebuild();
}

QWidget *PlotsPanel::emptyPage()
{
    QLabel *text = makeTextLabel({},
                                 tr("There is no plot yet. <b>Add</b>, above, has curves to start with: the "
                                    "position of a body, its speed, or one quantity against another."),
                                 m_pages);
    text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    text->setContentsMargins(16, 4, 16, 8);
    return text;
}

QMenu *PlotsPanel::addMenu()
{
    auto *menu = new QMenu(this);
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillAddMenu(*menu); });
    return menu;
}

void PlotsPanel::fillAddMenu(QMenu &menu)
{
    menu.clear();
    const auto offer = [&](const QString &text, const PlotSpec &plot) {
        QAction *made = menu.addAction(text);
        const sim::Scene &scene = m_run.timeline().track().interval().scene;
        for (const Quantity &one : {m_series.bound(plot.up), m_series.bound(plot.across)}) {
            if (const std::optional<NoValue> why = whyNot(one, scene)) {
                made->setEnabled(false);
                made->setToolTip(noValueWords(one, scene, *why));
            }
        }
        if (m_list.isFull()) {
            made->setEnabled(false);
            made->setToolTip(tr("There are %1 plots: more would be too small to read. Remove one first.")
                                 .arg(PlotList::most));
        }
        connect(made, &QAction::triggered, this, [this, plot] { add(plot); });
    };
    const auto ofTime = [&](QuantityKind what) {
        return offer(tr("%1 against time").arg(kindTitle(what)), {{what}});
    };
    ofTime(QuantityKind::placeX);
    ofTime(QuantityKind::placeY);
    ofTime(QuantityKind::speed);
    if (m_run.timeline().state().angle.rows() > 0)
        ofTime(QuantityKind::angle);
    ofTime(QuantityKind::energy);
    menu.addSeparator();
    offer(tr("the path: y against x"), {{QuantityKind::placeY}, {QuantityKind::placeX}});
    offer(tr("velocity y against y"), {{QuantityKind::velocityY}, {QuantityKind::placeY}});
    if (m_run.timeline().state().spin.rows() > 0)
        offer(tr("turning speed against angle"), {{QuantityKind::spin}, {QuantityKind::angle}});
    menu.addSeparator();
    QAction *hint = menu.addAction(tr("For anything else, add a plot and choose what it shows"));
    hint->setEnabled(false);
    hint->setToolTip(tr("The names above a plot are menus"));
}

void PlotsPanel::add(const PlotSpec &plot)
{
    if (m_list.isFull())
        return;
    m_list.add(plot);
    m_cards.back()->plot().setFocus(Qt::OtherFocusReason);
    QTimer::singleShot(0, m_cards.back(), [this] {
        if (!m_cards.empty())
            m_scroll->ensureWidgetVisible(m_cards.back());
    });
}

QWidget *PlotsPanel::saving()
{
    m_saving = new QWidget(this);
    m_progress = new ProgressLine(tr("Progress of saving"), m_saving);
    auto *stop = new QPushButton(tr("Cancel"), m_saving);
    stop->setObjectName("measure");
    stop->setFocusPolicy(Qt::TabFocus);
    stop->setToolTip(tr("Cancel; nothing is saved then"));
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
    m_list.open(m_run.timeline().script());
}

std::size_t PlotsPanel::indexOf(const PlotCard &card) const
{
    return static_cast<std::size_t>(std::find(m_cards.begin(), m_cards.end(), &card) - m_cards.begin());
}

PlotCard *PlotsPanel::makeCard()
{
    auto *card = new PlotCard(m_run, m_playback, m_comparisons, m_series, m_theme, m_scroll->widget());
    connect(card, &PlotCard::changeWanted, this,
            [this, card](const PlotSpec &spec) { m_list.change(indexOf(*card), spec); });
    connect(
        card, &PlotCard::removalWanted, this, [this, card] { removeCard(*card); },
        Qt::QueuedConnection); // the signal comes from the card's own menu or key
    connect(card, &PlotCard::pointedAt, this, &PlotsPanel::setHovered);
    connect(card, &PlotCard::pointedAt, this, &PlotsPanel::pointedAt);
    connect(card, &PlotCard::zoomWanted, this, &PlotsPanel::zoom);
    connect(&card->exports(), &PlotExport::messageRequested, this,
            [this](const QString &sentence) { m_run.showMessage(sentence); });
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
    // This very card is deleted, not the last one, so that the others keep their plots and the focus.
    const bool hadFocus = card.isAncestorOf(focusWidget()) || card.plot().hasFocus();
    m_cards.erase(m_cards.begin() + static_cast<std::ptrdiff_t>(index));
    discard(card);
    m_list.remove(index);
    if (!hadFocus)
        return;
    if (m_cards.empty())
        m_add->setFocus(Qt::OtherFocusReason);
    else
        m_cards[std::min(index, m_cards.size() - 1)]->plot().setFocus(Qt::OtherFocusReason);
}

void PlotsPanel::discard(PlotCard &card)
{
    if (NumberTable *writing = card.exports().table())
        writing->cancel(); // it is deleted with the card
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
        discard(*last);
    }
    for (std::size_t i = 0; i < m_cards.size(); ++i)
        m_cards[i]->setSpec(m_list.plots()[i]);
    m_pages->setCurrentIndex(m_cards.empty() ? 1 : 0);
    m_series.setQuantities(quantitiesOf(m_list.plots()));
    refreshSoon();
    m_wantedHeight = sizeHint().height();
    if (m_wantedHeight != wanted)
        emit wantedHeightChanged();
}

/// Draws several changes at once. A timer would fire after the window is painted, which would then be painted twice.
void PlotsPanel::refreshSoon()
{
    if (!isSeen() || std::exchange(m_isDue, true))
        return;
    const auto refreshDue = [this] {
        m_isDue = false;
        refreshNow();
    };
    QMetaObject::invokeMethod(this, refreshDue, Qt::QueuedConnection);
}

void PlotsPanel::followPreview()
{
    const bool isInside = m_preview.isActive() && m_preview.run().cursor().phase > 0;
    if (std::exchange(m_previewsInside, isInside) || isInside)
        refreshSoon();
}

void PlotsPanel::setActive(bool isActive)
{
    m_series.setActive(isActive);
}

void PlotsPanel::showContents()
{
    const std::vector<double> begun = m_series.begun();
    const std::optional<PlotSeries::Inside> inside = m_series.inside(m_preview.run());
    for (PlotCard *card : m_cards)
        card->refresh(begun, inside);
    writeCaption();
}

void PlotsPanel::writeCaption()
{
    const std::int64_t last = m_series.window().last, first = m_series.window().first;
    const bool isAll = first == 0 && last >= m_run.timeline().computed();
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
    std::int64_t most = m_series.mostSteps();
    const std::int64_t shown =
        (m_series.window().last - m_series.window().first) / std::max(1, m_series.framesPerOutput());
    if (steps > 0)
        most = std::min(most, shown) >> steps; // from the frames shown: a short run has fewer than the limit
    else
        most = std::min(most << -steps, PlotSeries::allSteps);
    m_series.setMostSteps(most);
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

}
