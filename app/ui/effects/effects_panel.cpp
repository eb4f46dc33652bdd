#include "app/ui/effects/effects_panel.h"

#include "app/model/text/rest_text.h"
#include "app/ui/dock/divider.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/effects/effect_list.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

EffectsPanel::EffectsPanel(const OpenRun &run, RunEditor &editor, const Playback &playback,
                           const Theme &theme, CostFunction function, std::shared_ptr<QThreadPool> thread,
                           QWidget *parent)
    : LivePanel(parent), m_run(run), m_playback(playback),
      m_ledger(run, editor, playback, std::move(function), std::move(thread)),
      m_title(new PanelTitle(tr("Effects"), theme, this)), m_list(new EffectList(theme, this)),
      m_remark(new QLabel(this)), m_rest(new QLabel(this)),
      m_again(new Command(tr("&Measure the effects again"), {QKeySequence("Ctrl+M")}, this))
{
    m_again->setHelp(tr("Measure what a frame costs where the run is now"));
    QToolButton *again = makeTab(tr("Measure again"), m_again->toolTip(), m_title);
    again->setCheckable(false);
    m_title->addAction(again);
    // The layout has the margins, because a label loses its own when the style sheet changes.
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
    column->addWidget(divider(this));
    column->addLayout(foot);
    connect(again, &QToolButton::clicked, m_again, &QAction::trigger);
    connect(m_again, &QAction::triggered, this, [this] { m_ledger.costs().measureAgain(); });
    connect(m_list, &EffectList::currentChangedTo, this, &EffectsPanel::refreshRemark);
    // Queued, so that the list does not change while it handles the click.
    connect(&m_list->lines(), &EffectListModel::switched, &m_ledger, &EffectLedger::switchEffect,
            Qt::QueuedConnection);
    connect(&m_ledger, &EffectLedger::changed, this, &EffectsPanel::refreshNow);
    run.onChange(ChangeKind::cursor | ChangeKind::playing, this, &EffectsPanel::refresh);
}

QString EffectsPanel::caption() const
{
    return m_title->caption();
}

QString EffectsPanel::remark() const
{
    return m_remark->text();
}

void EffectsPanel::setActive(bool isActive)
{
    m_ledger.setActive(isActive);
    m_again->setEnabled(isActive);
}

bool EffectsPanel::isChanging() const
{
    return m_playback.isPlaying();
}

void EffectsPanel::showContents()
{
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
    m_rest->setText(restSentence(m_run.timeline().track()));
    m_rest->setToolTip(m_rest->text());
}

bool EffectsPanel::isSettled() const
{
    return !isSeen() || (m_ledger.costs().isAtRest() && m_ledger.knowsAll() && !isRefreshDue());
}

}
