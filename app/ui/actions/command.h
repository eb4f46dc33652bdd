#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>

namespace app {

/// Returns the names of the keys that are pressed together: "Shift", "→".
QStringList keyNames(QKeyCombination keys);

/// Returns the keys as the window shows them: "Shift+→".
QString keyText(const QKeySequence &keys);

/// Returns a text with the keys behind it: "Undo (Ctrl+Z)". Without keys it is the text alone.
QString withKeys(const QString &text, const QKeySequence &keys);

/// An action of the window. Menus and buttons show it, and own no text, key, icon or state themselves. The
/// tooltip is derived: help and shortcut, or the reason why the command is disabled.
class Command : public QAction
{
    Q_OBJECT

public:
    Command(const QString &text, const QList<QKeySequence> &keys, QObject *parent);

    /// Sets the tooltip's sentence. Without one, the tooltip is the icon text.
    void setHelp(const QString &help);
    /// Sets further lines of the tooltip.
    void setDetails(const QString &details);
    /// Shows other keys in the tooltip than the shortcut, as long as `keys` is not empty.
    void setOtherKeys(const QKeySequence &keys);
    /// Disables the command for a reason. An empty reason enables it.
    void setObstacle(const QString &reason);
    QString obstacle() const { return m_obstacle; }

    /// Sets an icon of the theme. Buttons draw it in their own colours.
    void setIconName(const QString &name);
    const QString &iconName() const { return m_iconName; }

signals:
    void iconNameChanged();

private:
    void updateToolTip();

    QString m_help;
    QString m_details;
    QString m_obstacle;
    QKeySequence m_otherKeys;
    QString m_iconName;
};

}
