#pragma once

#include <QByteArray>
#include <QString>

#include <map>

namespace app {

/// How the panels stand in each arrangement, by its key, as the learner has left them: in this program, and in the settings
/// from one to the next.
class LayoutStore
{
public:
    /// As QMainWindow::saveState() gave it; empty: the arrangement was never left.
    QByteArray kept(const QString &key) const;
    void keep(const QString &key, const QByteArray &state) { m_kept[key] = state; }
    /// As if the arrangement had never been left.
    void forget(const QString &key);
    /// Writes the settings.
    void save() const;

    /// Whether the lessons are a narrow strip there; `byItself` where the learner has not chosen.
    bool hasRail(const QString &key, bool byItself) const;
    void chooseRail(const QString &key, bool rail);

    /// How many px the learner has made a panel there, by a name for it; `byItself` where nobody has.
    int length(const QString &key, const QString &name, int byItself) const;
    void chooseLength(const QString &key, const QString &name, int px);

private:
    std::map<QString, QByteArray> m_kept;
};

}
