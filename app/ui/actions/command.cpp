#include "app/ui/actions/command.h"

namespace app {

namespace {

QString keyName(QKeyCombination key)
{
    switch (key.key()) {
    case Qt::Key_Left:
        return QStringLiteral("←");
    case Qt::Key_Right:
        return QStringLiteral("→");
    case Qt::Key_Minus:
        return QStringLiteral("−");
    default:
        return QKeySequence(key.key()).toString(QKeySequence::NativeText);
    }
}

}

QString keyText(const QKeySequence &keys)
{
    if (keys.isEmpty())
        return {};
    // Qt names the modifiers in the language of the window, but writes "Left" for an arrow.
    const QString native = QKeySequence(keys[0]).toString(QKeySequence::NativeText);
    const QString name = QKeySequence(keys[0].key()).toString(QKeySequence::NativeText);
    return native.chopped(name.size()) + keyName(keys[0]);
}

QString withKeys(const QString &text, const QKeySequence &keys)
{
    return keys.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, keyText(keys));
}

Command::Command(const QString &text, const QList<QKeySequence> &keys, QObject *parent)
    : QAction(text, parent)
{
    setShortcuts(keys);
    connect(this, &QAction::changed, this, &Command::updateToolTip);
    updateToolTip();
}

void Command::setHelp(const QString &help)
{
    m_help = help;
    updateToolTip();
}

void Command::setDetails(const QString &details)
{
    m_details = details;
    updateToolTip();
}

void Command::setOtherKeys(const QKeySequence &keys)
{
    m_otherKeys = keys;
    updateToolTip();
}

void Command::setObstacle(const QString &reason)
{
    m_obstacle = reason;
    setEnabled(reason.isEmpty());
    updateToolTip();
}

void Command::setIconName(const QString &name)
{
    if (name == m_iconName)
        return;
    m_iconName = name;
    emit iconNameChanged();
}

void Command::updateToolTip()
{
    if (!m_obstacle.isEmpty()) {
        setToolTip(m_obstacle);
        return;
    }
    const QString first =
        withKeys(m_help.isEmpty() ? iconText() : m_help, m_otherKeys.isEmpty() ? shortcut() : m_otherKeys);
    setToolTip(m_details.isEmpty() ? first : first + '\n' + m_details);
}

}
