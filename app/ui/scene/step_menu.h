#pragma once

#include "app/model/session.h"

#include <QMenu>

class QLabel;
class QLineEdit;

namespace app {

/// The steps that a method can take, or the tolerances where it chooses its steps itself, and a field for any other one.
class StepMenu : public QMenu
{
    Q_OBJECT

public:
    explicit StepMenu(Session &session, QWidget *parent = nullptr);

    /// Offers what the method in use takes, with a mark at what the run has.
    void follow();

signals:
    /// The learner has chosen one. What the method refuses changes nothing.
    void chosen();

private:
    void addOther();
    void takeOther();
    bool isAdaptive() const;

    Session &m_session;
    QLineEdit *m_other = nullptr;
    QLabel *m_unit = nullptr; ///< of what is typed there
    QLabel *m_why = nullptr;  ///< why it was refused
};

}
