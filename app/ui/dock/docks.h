#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <utility>
#include <vector>

class QDockWidget;
class QMainWindow;

namespace app {

class Command;

/// The panels of the window.
enum class Panel { lessons, accuracy, energy, effects, branches, code, plots, parameters, stability };

/// Whether a dock is open in a new window.
enum class DockStart { open, hidden };

/// A row of the table from which the window makes its docks.
struct DockEntry
{
    Panel panel;
    const char *name;        ///< object name, by which stored layouts know the dock
    QString title;           ///< of its tab
    Qt::DockWidgetArea area; ///< at first
    DockStart start;
};

/// The docks of a window.
class Docks : public QObject
{
    Q_OBJECT

public:
    /// `window` must outlive it.
    explicit Docks(QMainWindow &window) : m_window(window) {}

    /// Adds an empty dock. Docks at the bottom become tabs, because side by side they would not fit below the scene.
    void add(const DockEntry &entry);
    /// Puts the content into a dock, and a title if the content shows none. Both should be made with the dock as parent:
    /// a widget that is given another one styles all its parts again, which takes long.
    void fill(Panel panel, QWidget &content, QWidget *title = nullptr);
    QDockWidget &operator[](Panel panel) const { return *m_docks.at(panel); }
    std::vector<QDockWidget *> all() const;

    /// Shows a panel in front of other tabs, or hides it.
    void show(Panel panel, bool isShown) const;
    /// Makes show() call `function` for a panel that has no fixed place.
    void setShowFunction(Panel panel, std::function<void(bool)> function)
    {
        m_showFunctions[panel] = std::move(function);
    }
    /// Returns whether a panel is open, but not visible behind another tab.
    bool isCovered(Panel panel) const;
    /// Returns whether a panel stands in that area beside the scene.
    bool isIn(Panel panel, Qt::DockWidgetArea area) const;

    /// Makes a command show or hide a panel. If the panel is covered by another tab, the command brings it to the front.
    void toggle(Command &command, Panel panel);
    /// Makes a command show and hide panels, and follow whether the first one is open.
    void toggleTogether(Command &command, const std::vector<Panel> &panels);

private:
    void follow(Command &command, Panel panel);

    QMainWindow &m_window;
    std::map<Panel, QDockWidget *> m_docks;
    std::map<Panel, std::function<void(bool)>> m_showFunctions;
};

}
