#include "app/ui/effects/effects_panel.h"

#include "app/model/rest_words.h"
#include "app/ui/effects/effect_list.h"
#include "app/ui/panels/panel_title.h"

#include <QAction>
#include <QFrame>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int refreshMilliseconds = 100; ///< while playing: words that change faster cannot be read

}

EffectsPanel::EffectsPanel(Session &session, const Theme &theme, CostFunction function, QWidget *parent)
    : QWidget(parent), m_session(session), m_ledger(session, std::move(function)),
      m_title(new PanelTitle(tr("Effects"), PanelTitle::CaptionPlace::besideTitle, theme, this)),
      m_list(new EffectList(theme, this)), m_remark(new QLabel(this)), m_rest(new QLabel(this)),
      m_again(new QAction(tr("&Measure the effects again"), this))
{
    setObjectName("panel");
    setAttribute(Qt::WA_StyledBackground);
    m_again->setShortcut(QKeySequence("Ctrl+M"));
    m_again->setToolTip(tr("Measure what a frame costs where the run is now (%1)").arg("Ctrl+M"));
    auto *again = new QToolButton(m_title);
    again->setObjectName("tab");
    again->setText(tr("Measure again"));
    again->setToolTip(m_again->toolTip());
    again->setFocusPolicy(Qt::TabFocus);
    m_title->addAction(again);
    // The margins are the layout's: a label loses its own when the style sheet changes.
    auto *foot = new QVBoxLayout;
    foot->setContentsMargins(16, 5, 16, 5);
    foot->setSpacing(3);
    for (QLabel *label : {m_remark, m_rest}) {
        label->setObjectName("caption");
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        foot->addWidget(label);
    }
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 4);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(new EffectHeads(theme, *m_list, this));
    column->addWidget(m_list, 1);
    auto *line = new QFrame(this);
    line->setObjectName("divider");
    line->setFixedHeight(1);
    column->addWidget(line);
    column->addLayout(foot);
    m_later.setSingleShot(true);
    connect(&m_later, &QTimer::timeout, this, &EffectsPanel::refreshNow);
    connect(again, &QToolButton::clicked, m_again, &QAction::trigger);
    connect(m_again, &QAction::triggered, this, [this] { m_ledger.costs().measureAgain(); });
    connect(m_list, &EffectList::currentChangedTo, this, &EffectsPanel::refreshRemark);
    // A list that is being read is not changed under the reader.
    connect(&m_list->lines(), &EffectListModel::switched, &m_ledger, &EffectLedger::switchEffect,
            Qt::QueuedConnection);
    connect(&m_ledger, &EffectLedger::changed, this, &EffectsPanel::refreshNow);
    connect(&session, &Session::moved, this, &EffectsPanel::refresh);
    connect(&session, &Session::playingChanged, this, &EffectsPanel::refresh);
}

QString EffectsPanel::caption() const
{
    return m_title->caption();
}

QString EffectsPanel::remark() const
{
    return m_remark->text();
}

void EffectsPanel::refresh()
{
    if (!isSeen())
        return;
    if (!m_session.isPlaying() || !m_sinceRefresh.isValid() || m_sinceRefresh.hasExpired(refreshMilliseconds))
        refreshNow();
    else if (!m_later.isActive())
        m_later.start(refreshMilliseconds);
}

void EffectsPanel::refreshNow()
{
    if (!isSeen())
        return;
    m_later.stop();
    m_sinceRefresh.start();
    m_title->setCaption(m_ledger.caption());
    m_list->lines().setLines(m_ledger.lines());
    refreshRemark();
}

const EffectLine *EffectsPanel::costliest() const
{
    const std::vector<EffectLine> &lines = m_list->lines().lines();
    const auto found =
        std::max_element(lines.begin(), lines.end(), [](const EffectLine &a, const EffectLine &b) {
            return (a.saving.isEmpty() ? -1.0 : a.ns) < (b.saving.isEmpty() ? -1.0 : b.ns);
        });
    return found == lines.end() ? nullptr : &*found;
}

void EffectsPanel::refreshRemark()
{
    const EffectLine *line = m_list->current();
    if (!line || line->saving.isEmpty())
        line = costliest();
    m_remark->setText(line ? line->saving : QString());
    m_rest->setText(restSentence(m_session.timeline().track()));
    m_rest->setToolTip(m_rest->text());
}

bool EffectsPanel::isSettled() const
{
    return !isSeen() || (m_ledger.costs().isAtRest() && m_ledger.knowsAll() && !m_later.isActive());
}

void EffectsPanel::watch()
{
    m_ledger.setWatched(isSeen());
    m_again->setEnabled(isSeen());
    if (isSeen())
        refreshNow();
    else
        m_later.stop();
}

void EffectsPanel::setCovered(bool covered)
{
    m_isCovered = covered;
    watch();
}

void EffectsPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    watch();
}

void EffectsPanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    watch();
}

}
