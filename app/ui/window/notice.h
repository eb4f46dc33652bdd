#pragma once

#include "app/ui/theme/theme.h"

#include <QFrame>

#include <functional>
#include <vector>

class QBoxLayout;
class QLabel;
class QToolButton;

namespace app {

/// An answer to a notice, as a button.
struct Choice
{
    QString text;
    QString help;               ///< what it does, for the tooltip
    std::function<void()> take; ///< called when the notice is gone
};

/// A line across the window that says what was refused, or asks what to do, and stays until it is read. Nothing waits
/// for the answer; closing it answers nothing. Hidden while empty.
class Notice : public QFrame
{
    Q_OBJECT

public:
    explicit Notice(const Theme &theme, QWidget *parent = nullptr);

    void say(const QString &sentence);
    /// Whatever the choices capture must outlive the notice.
    void ask(const QString &sentence, const std::vector<Choice> &choices);
    QString sentence() const;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void dress();
    void showChoices(const std::vector<Choice> &choices);

    const Theme &m_theme;
    QLabel *m_text;
    QWidget *m_choices;
    QBoxLayout *m_row;
    QToolButton *m_close;
};

}
