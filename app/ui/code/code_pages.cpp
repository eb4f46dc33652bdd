#include "app/ui/code/code_pages.h"

#include "app/model/session/session.h"
#include "app/model/text/sentences.h"
#include "app/ui/code/code_panel.h"
#include "app/ui/code/code_view.h"
#include "app/ui/code/listing_panel.h"
#include "app/ui/dock/panel_title.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace app {

CodePages::CodePages(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_engine(new CodePanel(session, theme, this)),
      m_listing(new ListingPanel(session, theme, this)), m_pages(new QStackedWidget(this)),
      m_offer(new QWidget(this)), m_offerText(new QLabel(m_offer)), m_use(new QPushButton(m_offer)),
      m_tabs(new QWidget(this)), m_actions(new QWidget(this))
{
    if (QSettings().value(pageKey).toString() == QLatin1String("engine"))
        m_wanted = Page::engine;
    m_pages->addWidget(m_listing);
    m_pages->addWidget(m_engine);
    makeOffer();
    makeTitle();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_offer);
    layout->addWidget(m_pages, 1);
    connect(m_engine, &CodePanel::captionChanged, this, [this] { emit captionChanged(caption()); });
    connect(m_listing, &ListingPanel::placeChosen, this, [this](const CodePlace &place) {
        choose(Page::engine);
        m_engine->view().showPlace(place);
    });
    session.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::code, this, &CodePages::follow);
    m_wasInUse = session.code().isInUse();
    follow();
}

CodePages::~CodePages() = default;

void CodePages::makeOffer()
{
    m_offer->setObjectName("panel");
    m_offer->setAttribute(Qt::WA_StyledBackground);
    m_offerText->setObjectName("caption");
    m_offerText->setWordWrap(true);
    m_use->setObjectName("useListing");
    m_use->setToolTip(tr("Let the listing compute the run from here"));
    auto *row = new QHBoxLayout(m_offer);
    row->setContentsMargins(16, 2, 12, 8);
    row->setSpacing(12);
    row->addWidget(m_offerText, 1);
    row->addWidget(m_use);
    connect(m_use, &QPushButton::clicked, &m_session, [this] { m_session.code().use(); });
}

void CodePages::makeTitle()
{
    auto *row = new QHBoxLayout(m_tabs);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    m_listingTab =
        makeTab(tr("Listing"), tr("The program of a frame, to read, to step through and to change"), m_tabs);
    m_engineTab = makeTab(tr("Engine"), tr("The code of Springstep that computes the run"), m_tabs);
    auto *group = new QButtonGroup(this);
    for (const auto &[tab, page] :
         {std::pair(m_listingTab, Page::listing), std::pair(m_engineTab, Page::engine)}) {
        tab->setAccessibleName(tab->text());
        row->addWidget(tab);
        group->addButton(tab);
        connect(tab, &QToolButton::clicked, this, [this, page = page] { choose(page); });
    }
    auto *actions = new QHBoxLayout(m_actions);
    actions->setContentsMargins(0, 0, 0, 0);
    actions->addWidget(m_listing->titleActions());
    actions->addWidget(m_engine->titleActions());
}

CodePages::Page CodePages::page() const
{
    return m_pages->currentWidget() == m_listing ? Page::listing : Page::engine;
}

void CodePages::choose(Page page)
{
    m_wanted = page;
    QSettings().setValue(pageKey,
                         page == Page::engine ? QStringLiteral("engine") : QStringLiteral("listing"));
    show(page);
}

QString CodePages::caption() const
{
    return page() == Page::listing ? QString() : m_engine->caption();
}

QString CodePages::shortCaption() const
{
    return page() == Page::listing ? QString() : bodyTitle(m_session.selected());
}

StepBy CodePages::stepBy() const
{
    return page() == Page::listing && isVisible() && m_session.lines().isAvailable() ? StepBy::lines
                                                                                     : StepBy::phases;
}

void CodePages::follow()
{
    const LearnerCode &code = m_session.code();
    const bool isInUse = code.isInUse();
    const bool changed = std::exchange(m_wasInUse, isInUse) != isInUse;
    m_tabs->setVisible(code.isOffered());
    m_offer->setVisible(code.isOffered() && !isInUse);
    const QString method = phrase(m_session.timeline().script().method->title());
    m_offerText->setText(tr("%1 computes this run, not the listing.").arg(method));
    m_use->setText(code.isChanged() ? tr("Use your code") : tr("Use the listing"));
    if (!code.isOffered())
        show(Page::engine);
    else if (changed || m_step != &m_session.step())
        show(isInUse ? m_wanted : Page::engine);
    m_step = &m_session.step();
    emit stepByChanged();
}

void CodePages::show(Page page)
{
    const bool isListing = page == Page::listing;
    m_pages->setCurrentWidget(isListing ? static_cast<QWidget *>(m_listing) : m_engine);
    m_listing->titleActions()->setVisible(isListing);
    m_engine->titleActions()->setVisible(!isListing);
    m_listingTab->setChecked(isListing);
    m_engineTab->setChecked(!isListing);
    emit captionChanged(caption());
    emit stepByChanged();
}

void CodePages::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    emit stepByChanged();
}

void CodePages::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    emit stepByChanged();
}

}
