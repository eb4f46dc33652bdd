#pragma once

#include "app/ui/theme/theme.h"

#include <QFrame>

#include <functional>
#include <vector>

class QBoxLayout;
class QLabel;
class QToolButton;

namespace app {

/// A button of a notice.
struct Choice
{
    QString text;
    QString help;               ///< the button's tooltip
    std::function<void()> take; ///< called after the notice has closed
};

/// A bar across the window that shows an error or asks a question, and stays until it is closed. It does not
/// block the program; closing it chooses nothing. It is hidden while empty.
class Notice : public QFrame
{
    Q_OBJECT

public:
    explicit Notice(const Theme &theme, QWidget *parent = nullptr);

    void showMessage(const QString &sentence);
    /// Asks a question. Everything that the choices capture must outlive the notice.
    void ask(const QString &sentence, const std::vector<Choice> &choices);
    QString sentence() const;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void showChoices(const std::vector<Choice> &choices);

    QLabel *m_text;
    QWidget *m_choices;
    QBoxLayout *m_row;
    QToolButton *m_close;
};

}
