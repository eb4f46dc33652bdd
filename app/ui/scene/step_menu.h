#pragma once

#include "app/model/session/open_run.h"
#include "app/model/session/run_editor.h"

#include <QMenu>

class QLabel;
class QLineEdit;
class QWidgetAction;

namespace app {

/// A menu of steps, or of tolerances for an adaptive method, with a field for any other value.
class StepMenu : public QMenu
{
    Q_OBJECT

public:
    explicit StepMenu(const OpenRun &run, RunEditor &editor, QWidget *parent = nullptr);

    /// Lists steps or tolerances, whichever the method takes, and checks the one in use.
    void follow();

signals:
    /// The learner has chosen a value. If the method rejects it, nothing has changed.
    void chosen();

private:
    void addOther();
    void takeOther();
    /// Says below the field why the typed value is invalid.
    void explain(const QString &why);
    bool isAdaptive() const;

    const OpenRun &m_run;
    RunEditor &m_editor;
    QLineEdit *m_other = nullptr;
    QLabel *m_unit = nullptr; ///< of the field
    QLabel *m_why = nullptr;  ///< why the typed value is invalid
    QWidgetAction *m_whyEntry = nullptr;
};

}
