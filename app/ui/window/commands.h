#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QObject>

#include <array>
#include <vector>

namespace app {

/// What the page of keys lists together; what is needed first comes first.
enum class KeyGroup {
    time,
    picture,
    steps,
    changes,
    code,
    plots,
    otherRuns,
    window,
    accuracy,
    build,
    experiments,
    pictures
};

inline constexpr std::array allKeyGroups{KeyGroup::time,      KeyGroup::picture,     KeyGroup::steps,
                                         KeyGroup::changes,   KeyGroup::code,        KeyGroup::plots,
                                         KeyGroup::otherRuns, KeyGroup::window,      KeyGroup::accuracy,
                                         KeyGroup::build,     KeyGroup::experiments, KeyGroup::pictures};

/// The heading above it.
QString titleOf(KeyGroup group);

/// The commands of a window: made in one place, so that the page of keys lists all that work.
class Commands : public QObject
{
    Q_OBJECT

public:
    struct Listed
    {
        QAction *action;
        KeyGroup group;
    };

    /// Their keys work in all of `window`, which owns them.
    explicit Commands(QWidget &window) : m_window(window) {}

    /// Makes a command; its tooltip is its text with the first of its keys.
    QAction *add(const QString &text, const QList<QKeySequence> &keys, KeyGroup group);
    /// Lists one that others have made.
    void list(QAction *action, KeyGroup group) { m_listed.push_back({action, group}); }
    const std::vector<Listed> &listed() const { return m_listed; }

private:
    QWidget &m_window;
    std::vector<Listed> m_listed;
};

}
