#pragma once

#include "app/model/sandbox/sandbox_editor.h"

#include <QWidget>

#include <map>

class QCheckBox;

namespace app {

/// A check box for each effect that can act on a whole sandbox scene.
class EffectSwitches : public QWidget
{
    Q_OBJECT

public:
    /// The run and the editor must outlive this.
    EffectSwitches(const OpenRun &run, SandboxEditor &editor, QWidget *parent = nullptr);

    /// Returns the check box of an effect, or null if there is none.
    QCheckBox *box(const QString &effect) const;

private:
    void make();
    void refresh();

    const OpenRun &m_run;
    SandboxEditor &m_editor;
    std::map<QString, QCheckBox *> m_switches; ///< by effect id
};

}
