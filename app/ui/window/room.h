#pragma once

#include <QObject>
#include <QSize>

#include <vector>

class QDockWidget;
class QMainWindow;

namespace app {

class LearnPanel;
class SceneView;

/// px that the scene has at least; less only when nothing else is left to give.
constexpr QSize leastScene{480, 220};
/// px that the window has at least.
constexpr QSize leastWindow{480, 420};
/// px of its width, from here on there is room for lessons, accuracy and code beside each other.
constexpr int wideWindow = 1600;

/// The room that a window has for its panels. Where it is too small for all that is open, what can be done without steps
/// aside, and comes back.
class Room : public QObject
{
    Q_OBJECT

public:
    /// `lessons` is the dock of `learn`; `numbers`, the one of measures and parameters, goes before the others beside the
    /// scene. All must outlive it.
    Room(QMainWindow &window, LearnPanel &learn, SceneView &scene, QDockWidget &lessons,
         QDockWidget &numbers);

    /// Lets panels step aside until the window is large enough for those that stay, and brings back those that have room
    /// again, or that the learner has asked for meanwhile.
    void share();
    /// Brings all of them back, whether there is room or not.
    void bringAllBack();

signals:
    /// Panels stepped aside or came back: the others have other lengths to share.
    void sidesChanged();

private:
    /// What steps aside while the window is too small for all of it, in this order.
    enum class Way { rail, below, smallScene, numbers, right, left };

    /// What stepped aside.
    struct Aside
    {
        Way way;
        std::vector<QDockWidget *> panels; ///< that were hidden
        QSize least;                       ///< px that the window needs to have it back
    };

    QSize leastSize();
    bool isShort();
    void bringBackWhatFits();
    void letStepAside(const std::vector<QDockWidget *> &asked);
    /// Lets what is `way` step aside, but for what was `asked` for. Returns whether that helps.
    bool stepAside(Way way, const std::vector<QDockWidget *> &asked);
    /// The panels that go with `way`, but for those that were `asked` for; the one in front comes last.
    std::vector<QDockWidget *> panelsFor(Way way, const std::vector<QDockWidget *> &asked) const;
    /// Panels that stepped aside and were shown again by others than bringBack(): the learner asked for them.
    std::vector<QDockWidget *> takeAsked();
    void bringBack(const Aside &aside);

    QMainWindow &m_window;
    LearnPanel &m_learn;
    SceneView &m_scene;
    QDockWidget &m_lessons;
    QDockWidget &m_numbers;
    std::vector<Aside> m_aside; ///< the last one last
};

}
