#pragma once

#include "app/ui/theme/theme.h"

#include <QFrame>

class QLineEdit;

namespace app {

/// A popup field for a name. Return accepts the name; Escape or a click elsewhere cancels.
class NameField : public QFrame
{
    Q_OBJECT

public:
    NameField(const QString &name, const Theme &theme, QWidget *parent);

    /// Shows the field at a place on the screen, or as near as it fits, with the whole name selected.
    void popupAt(const QPoint &place);

signals:
    void named(const QString &name);

private:
    QLineEdit *m_edit;
};

}
