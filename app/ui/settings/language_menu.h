#pragma once

#include <QMenu>

namespace app {

/// A menu of the languages of the window.
class LanguageMenu : public QMenu
{
    Q_OBJECT

public:
    explicit LanguageMenu(QWidget *parent);

signals:
    /// The choice takes effect once the window opens again. `sentence` says so.
    void restartWanted(const QString &sentence);
    /// The learner chose the language that the window has.
    void unchanged();

private:
    void add(const QString &text, const QString &code);
    void choose(const QString &code);

    QString m_chosen;  ///< code, or empty for the language of the system
    QString m_current; ///< code
    QActionGroup *m_group;
};

}
