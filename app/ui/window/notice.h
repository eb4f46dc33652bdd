#pragma once

#include "app/ui/theme/theme.h"

#include <QFrame>

class QLabel;
class QToolButton;

namespace app {

/// A line across the window that says what was refused, and stays until it is read. Hidden while empty.
class Notice : public QFrame
{
    Q_OBJECT

public:
    explicit Notice(const Theme &theme, QWidget *parent = nullptr);

    void say(const QString &sentence);
    QString sentence() const;

private:
    void dress();

    const Theme &m_theme;
    QLabel *m_text;
    QToolButton *m_close;
};

}
