#pragma once

#include "app/model/analysis/effect_ledger.h"
#include "app/ui/actions/command.h"
#include "app/ui/dock/live_panel.h"
#include "app/ui/theme/theme.h"

class QLabel;

namespace app {

class EffectList;
class PanelTitle;

/// The effects of the scene, the cost of each, and a switch for each.
class EffectsPanel : public LivePanel
{
    Q_OBJECT

public:
    /// Measures costs on `thread`.
    EffectsPanel(const OpenRun &run, RunEditor &editor, const Playback &playback, const Theme &theme,
                 CostFunction function = measureCost, std::shared_ptr<QThreadPool> thread = makeJobThread(),
                 QWidget *parent = nullptr);

    const EffectLedger &ledger() const { return m_ledger; }
    EffectList &list() const { return *m_list; }
    QString caption() const;
    /// Returns the text below the list: the cost of a frame without the effect under the pointer.
    QString remark() const;
    /// Returns whether no measurement is under way that will change the contents.
    bool isSettled() const;
    /// Returns the command that measures the effects again, at the cursor of the run.
    Command *measureAgain() const { return m_again; }

    QSize sizeHint() const override { return {560, 290}; }
    QSize minimumSizeHint() const override { return {420, 190}; }

protected:
    void setActive(bool isActive) override;
    bool isChanging() const override;
    void showContents() override;

private:
    void refreshRemark();
    const EffectLine *costliest() const;

    const OpenRun &m_run;
    const Playback &m_playback;
    EffectLedger m_ledger;
    PanelTitle *m_title;
    EffectList *m_list;
    QLabel *m_remark;
    QLabel *m_rest; ///< the cost of the scene at rest
    Command *m_again;
};

}
