#pragma once

#include <QByteArray>
#include <QString>

#include <map>

namespace app {

/// Stores the layout of the panels for each arrangement, by the arrangement's key, in memory and in the
/// settings.
class LayoutStore
{
public:
    /// Returns the state from QMainWindow::saveState(), or an empty array if none was stored.
    QByteArray layout(const QString &key) const;
    void store(const QString &key, const QByteArray &state) { m_stored[key] = state; }
    /// Discards the stored layout of an arrangement.
    void forget(const QString &key);
    /// Writes the layouts to the settings.
    void save() const;

    /// Returns whether the lessons are a narrow rail in that arrangement, or `byItself` if the learner has
    /// not chosen.
    bool hasRail(const QString &key, bool byItself) const;
    void chooseRail(const QString &key, bool rail);

    /// Returns the length that the learner gave the panel `name` in that arrangement, px, or `byItself` if
    /// there is none.
    int length(const QString &key, const QString &name, int byItself) const;
    void chooseLength(const QString &key, const QString &name, int px);

private:
    std::map<QString, QByteArray> m_stored;
};

}
