#pragma once

#include "app/model/remedy_search.h"
#include "app/ui/theme/theme.h"

#include <QFrame>

class QLabel;

namespace app {

/// A card over the picture where a run has stopped by itself: why, and what mends it, a button each. Hidden
/// everywhere else.
class StopNotice : public QFrame
{
    Q_OBJECT

public:
    /// Lies at the top of `picture` and follows its size.
    StopNotice(Session &session, const Theme &theme, QWidget *picture);

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

    Session &m_session;
    const Theme &m_theme;
    RemedySearch m_search;
    QLabel *m_text;
    QLabel *m_hint; ///< in place of buttons
    QWidget *m_buttons;
};

}
