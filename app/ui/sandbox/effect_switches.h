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
    /// The session and the editor must outlive this.
    EffectSwitches(Session &session, SandboxEditor &editor, QWidget *parent = nullptr);

    /// Returns the check box of an effect, or null if there is none.
    QCheckBox *box(const QString &effect) const;

private:
    void make();
    void refresh();

    Session &m_session;
    SandboxEditor &m_editor;
    std::map<QString, QCheckBox *> m_switches; ///< by effect id
};

}
