#pragma once

#include "app/ui/theme/theme.h"

#include <QFrame>

class QLineEdit;

namespace app {

/// A small field to type a name into, over the window: Return takes it, Escape or a click elsewhere leaves all as it is.
class NameField : public QFrame
{
    Q_OBJECT

public:
    NameField(const QString &name, const Theme &theme, QWidget *parent);

    /// Shows it there on the screen, or as near as it fits, with the whole name chosen.
    void popupAt(const QPoint &place);

signals:
    void named(const QString &name);

private:
    QLineEdit *m_edit;
};

}
