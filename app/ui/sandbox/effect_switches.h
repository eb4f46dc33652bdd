#pragma once

#include "app/model/workbench.h"

#include <QWidget>

#include <map>

class QCheckBox;

namespace app {

/// A switch for each effect that can act on the whole of a scene that is built.
class EffectSwitches : public QWidget
{
    Q_OBJECT

public:
    /// Both must outlive this.
    EffectSwitches(Session &session, Workbench &bench, QWidget *parent = nullptr);

    /// Returns the switch of an effect; null where there is none.
    QCheckBox *box(const QString &effect) const;

private:
    void make();
    void refresh();

    Session &m_session;
    Workbench &m_bench;
    std::map<QString, QCheckBox *> m_switches; ///< by effect
};

}
