#include "app/ui/code/code_pages.h"

#include "app/model/session/session.h"
#include "app/model/text/sentences.h"
#include "app/ui/actions/run_commands.h"
#include "app/ui/code/breakpoint_list.h"
#include "app/ui/code/engine/code_panel.h"
#include "app/ui/code/engine/code_view.h"
#include "app/ui/code/listing/listing_editor.h"
#include "app/ui/code/listing/listing_panel.h"
#include "app/ui/code/listing/rule_panel.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/scene/scene_view.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace app {

CodePages::CodePages(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_engine(new CodePanel(session, theme, this)),
      m_listing(new ListingPanel(session, theme, this)),
      m_rule(new RulePanel(session.run(), session.editor(), session.playback(), session.rule(), theme, this)),
      m_pages(new QStackedWidget(this)), m_offer(new QWidget(this)), m_offerText(new QLabel(m_offer)),
      m_use(new QPushButton(m_offer)), m_tabs(new QWidget(this)), m_actions(new QWidget(this)),
      m_wantsEngine(QSettings().value(pageKey).toString() == QLatin1String("engine"))
{
    m_pages->addWidget(m_listing); // in the order of Page
    m_pages->addWidget(m_rule);
    m_pages->addWidget(m_engine);
    makeOffer();
    makeTitle();
    QVBoxLayout *layout = makeColumn(this);
    layout->addWidget(m_offer);
    layout->addWidget(m_pages, 1);
    connect(m_engine, &CodePanel::captionChanged, this, [this] { emit captionChanged(caption()); });
    connect(m_listing, &ListingPanel::placeChosen, this, &CodePages::showPlace);
    connect(&m_engine->stops(), &BreakpointList::chosen, this, [this](const CodePlace &place) {
        if (place.isInListing())
            showPlace(place);
    });
    session.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::code, this, &CodePages::follow);
    m_wasInUse = session.code().isInUse();
    m_hadRule = session.rule().isOffered() && session.rule().hasRule();
    follow();
}

CodePages::~CodePages() = default;

void CodePages::makeOffer()
{
    styleAsPanel(*m_offer);
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
    m_tabGroup =
        makeTabs({{tr("Listing"), tr("The program of a frame, to read, to step through and to change")},
                  {tr("My rule"), tr("A force that you write, for this scene")},
                  {tr("Engine"), tr("The code of Springstep that computes the run")}},
                 m_tabs);
    for (QAbstractButton *button : m_tabGroup->buttons())
        button->setAccessibleName(button->text());
    connect(m_tabGroup, &QButtonGroup::idClicked, this, [this](int id) { choose(static_cast<Page>(id)); });
    auto *actions = new QHBoxLayout(m_actions);
    actions->setContentsMargins(0, 0, 0, 0);
    actions->addWidget(m_listing->titleActions());
    actions->addWidget(m_rule->titleActions());
    actions->addWidget(m_engine->titleActions());
}

QAbstractButton &CodePages::tab(Page page) const
{
    return *m_tabGroup->button(static_cast<int>(page));
}

CodePages::Page CodePages::page() const
{
    return static_cast<Page>(m_pages->currentIndex());
}

void CodePages::choose(Page page)
{
    m_wantsEngine = page == Page::engine;
    QSettings().setValue(pageKey, m_wantsEngine ? QStringLiteral("engine") : QStringLiteral("listing"));
    show(page);
}

void CodePages::writeAt(int line)
{
    choose(Page::listing);
    ListingEditor &editor = m_listing->editor();
    editor.setFocus(Qt::OtherFocusReason);
    editor.writeBehind(line);
}

void CodePages::attach(SceneView &scene, RunCommands &commands)
{
    connect(m_listing, &ListingPanel::vectorPointedAt, &scene, &SceneView::setVector);
    connect(m_listing, &ListingPanel::left, &scene, qOverload<>(&QWidget::setFocus));
    connect(m_rule, &RulePanel::left, &scene, qOverload<>(&QWidget::setFocus));
    connect(&scene, &SceneView::bodyPointedAt, m_listing, &ListingPanel::setPointedBody);
    const auto followPage = [this, &commands] { commands.setStepBy(stepBy()); };
    connect(this, &CodePages::stepByChanged, &commands, followPage);
    followPage();
}

void CodePages::showPlace(const CodePlace &place)
{
    choose(place.isInListing() ? Page::listing : Page::engine);
    if (place.isInListing())
        m_listing->editor().showLine(place.line);
    else
        m_engine->view().showPlace(place);
}

QString CodePages::caption() const
{
    return page() == Page::engine ? m_engine->caption() : QString();
}

QString CodePages::shortCaption() const
{
    return page() == Page::engine ? bodyTitle(m_session.selected()) : QString();
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
    const RuleCode &rule = m_session.rule();
    m_tabs->setVisible(code.isOffered() || rule.isOffered());
    tab(Page::listing).setVisible(code.isOffered());
    tab(Page::rule).setVisible(rule.isOffered());
    m_offer->setVisible(code.isOffered() && !isInUse);
    const QString method = phrase(m_session.timeline().script().method->title());
    m_offerText->setText(tr("%1 computes this run, not the listing.").arg(method));
    m_use->setText(code.isChanged() ? tr("Use your code") : tr("Use the listing"));
    const bool isFirstRule = rule.isOffered() && rule.hasRule() && !m_hadRule; // of an example, for instance
    m_hadRule = rule.isOffered() && rule.hasRule();
    if (isFirstRule)
        show(Page::rule);
    else if (changed || m_step != &m_session.step() || !isOffered(page()))
        show(wantedPage());
    m_step = &m_session.step();
    emit stepByChanged();
}

bool CodePages::isOffered(Page page) const
{
    return page == Page::engine ||
           (page == Page::listing ? m_session.code().isOffered() : m_session.rule().isOffered());
}

CodePages::Page CodePages::wantedPage() const
{
    if (m_wantsEngine)
        return Page::engine;
    if (m_session.rule().isOffered())
        return Page::rule;
    return m_session.code().isOffered() && m_session.code().isInUse() ? Page::listing : Page::engine;
}

void CodePages::show(Page page)
{
    m_pages->setCurrentIndex(static_cast<int>(page));
    m_listing->titleActions()->setVisible(page == Page::listing);
    m_rule->titleActions()->setVisible(page == Page::rule);
    m_engine->titleActions()->setVisible(page == Page::engine);
    m_actions->layout()->activate(); // otherwise the title has room for the actions of both pages for a while
    tab(page).setChecked(true);
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
