#pragma once

#include "app/model/analysis/remedy_search.h"
#include "app/ui/theme/theme.h"

#include <QFrame>

class QLabel;

namespace app {

/// A card over the scene of a run that has failed: the reason, and a button for each remedy. Hidden otherwise.
class FailureNotice : public QFrame
{
    Q_OBJECT

public:
    /// The card lies at the top of `picture` and follows its size. All arguments must outlive it.
    FailureNotice(const OpenRun &run, RunEditor &editor, const Theme &theme, QWidget *picture);

    QString sentence() const;
    const RemedySearch &search() const { return m_search; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    void refresh();
    void showRemedies();
    void use(const sim::Remedy &remedy);
    void place();

    const OpenRun &m_run;
    RunEditor &m_editor;
    const Theme &m_theme;
    RemedySearch m_search;
    QLabel *m_text;
    QLabel *m_hint;     ///< shown instead of buttons
    QWidget *m_buttons; ///< one for each remedy
};

}
