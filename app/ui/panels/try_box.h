#pragma once

#include "app/ui/theme/theme.h"
#include "lessons/api/step.h"

#include <QWidget>

class QToolButton;

namespace app {

class NarrationText;
class TryRow;

/// A thing to try with its hint, which is shown when the learner asks for it.
class TryBox : public QWidget
{
    Q_OBJECT

public:
    static constexpr int left = 4; ///< px before the row, so that the button stands right under its box

    TryBox(const lessons::Try &what, const Theme &theme, QWidget *parent = nullptr);

    /// What is done needs no hint any more.
    void setDone(bool done);
    bool hasHint() const;
    bool showsHint() const;
    void showHint(bool shown);

signals:
    /// The learner has asked for the hint, or put it away.
    void hintAsked(bool shown);

private:
    void dress();

    const Theme &m_theme;
    TryRow *m_row;
    QToolButton *m_button = nullptr; ///< null where there is no hint
    NarrationText *m_hint = nullptr; ///< likewise
};

}
