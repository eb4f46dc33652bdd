#pragma once

#include "app/model/effect_ledger.h"
#include "app/ui/theme/theme.h"

#include <QElapsedTimer>
#include <QWidget>

class QLabel;
class QToolButton;

namespace app {

class EffectList;
class PanelTitle;

/// What acts in the scene, what each effect costs, and a switch for each. Measures only while it is seen.
class EffectsPanel : public QWidget
{
    Q_OBJECT

public:
    EffectsPanel(Session &session, const Theme &theme, CostFunction function = measureCost,
                 QWidget *parent = nullptr);

    const EffectLedger &ledger() const { return m_ledger; }
    EffectList &list() const { return *m_list; }
    QString caption() const;
    /// What is said below the list: what a frame would cost without the line that is looked at.
    QString remark() const;
    /// Whether another panel lies over this one.
    void setCovered(bool covered);
    bool isCovered() const { return isVisible() && m_isCovered; }
    /// Whether nothing is under way that will change what is shown.
    bool isSettled() const;
    /// Measures the state at the cursor anew.
    QAction *measureAgain() const { return m_again; }

    QSize sizeHint() const override { return {560, 290}; }
    QSize minimumSizeHint() const override { return {420, 190}; }

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void watch();
    bool isSeen() const { return isVisible() && !m_isCovered; }
    void refresh();
    void refreshNow();
    void refreshRemark();
    const EffectLine *costliest() const;

    Session &m_session;
    EffectLedger m_ledger;
    PanelTitle *m_title;
    EffectList *m_list;
    QLabel *m_remark;
    QLabel *m_rest; ///< what the scene costs once it rests
    QAction *m_again;
    QElapsedTimer m_sinceRefresh;
    QTimer m_later;
    bool m_isCovered = false;
};

}
