#include "app/ui/actions/command.h"

#include <QCoreApplication>

namespace app {

namespace {

struct KeyNames
{
    Q_DECLARE_TR_FUNCTIONS(KeyNames)
};

/// Keys whose names in menus are translated here: in some languages, Qt's own are not those on keyboards ("Control",
/// "Retorno").
[[maybe_unused]] constexpr const char *namesInMenus[] = {
    QT_TRANSLATE_NOOP("QShortcut", "Ctrl"),   QT_TRANSLATE_NOOP("QShortcut", "Shift"),
    QT_TRANSLATE_NOOP("QShortcut", "Esc"),    QT_TRANSLATE_NOOP("QShortcut", "Tab"),
    QT_TRANSLATE_NOOP("QShortcut", "Return"), QT_TRANSLATE_NOOP("QShortcut", "Backspace"),
    QT_TRANSLATE_NOOP("QShortcut", "Ins"),    QT_TRANSLATE_NOOP("QShortcut", "Del"),
};

QString nameOf(Qt::Key key)
{
    switch (key) {
    case Qt::Key_Left:
        return QStringLiteral("←");
    case Qt::Key_Right:
        return QStringLiteral("→");
    case Qt::Key_Up:
        return QStringLiteral("↑");
    case Qt::Key_Down:
        return QStringLiteral("↓");
    case Qt::Key_Minus:
        return QStringLiteral("−");
    case Qt::Key_PageUp:
        return KeyNames::tr("Page Up");
    case Qt::Key_PageDown:
        return KeyNames::tr("Page Down");
    default:
        return QKeySequence(key).toString(QKeySequence::NativeText);
    }
}

}

QStringList keyNames(QKeyCombination keys)
{
    QStringList names;
    const Qt::KeyboardModifiers modifiers = keys.keyboardModifiers();
    if (modifiers & Qt::ControlModifier)
        names << KeyNames::tr("Ctrl");
    if (modifiers & Qt::AltModifier)
        names << KeyNames::tr("Alt");
    if (modifiers & Qt::ShiftModifier)
        names << KeyNames::tr("Shift");
    return names << nameOf(keys.key());
}

QString keyText(const QKeySequence &keys)
{
    return keys.isEmpty() ? QString() : keyNames(keys[0]).join('+');
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
