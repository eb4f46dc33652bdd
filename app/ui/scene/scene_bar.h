#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

namespace app {

class FlatButton;
class SceneView;
class StepMenu;

/// The bar above the scene: method, step, what is shown, zoom. 36 px high.
class SceneBar : public QWidget
{
    Q_OBJECT

public:
    SceneBar(Session &session, const Theme &theme, QWidget *parent = nullptr);

    /// The view that "Show" and the zoom are about.
    void attach(SceneView &view);
    /// Shows an entry of "Show" or not, as the learner left it; ids as in chosen(). An unknown one changes nothing.
    void choose(const QString &id, bool on);
    /// The ids of the entries of "Show".
    QStringList choices() const;
    /// A button with an icon of the theme, before "Show", that does what `action` does.
    void addTool(QAction &action, const QString &icon);
    /// Something between step and "Show", which the bar owns then and which may be given less room than it wants; null:
    /// nothing, and what was there is deleted.
    void setMiddle(QWidget *middle);
    /// Without the captions of method and step.
    QSize minimumSizeHint() const override;

signals:
    /// The learner switched an entry of "Show".
    void chosen(const QString &id, bool on);

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    FlatButton *button(const QString &tip);
    void fillMethods();
    void fillShow();
    void showValues();
    void showZoom(double percent);
    /// Drops captions when not all of the bar finds room.
    void arrange();
    int widthWith(int method, int step) const;

    Session &m_session;
    const Theme &m_theme;
    SceneView *m_view = nullptr;
    FlatButton *m_method;
    FlatButton *m_step;
    FlatButton *m_show;
    FlatButton *m_zoom;
    FlatButton *m_fit;
    int m_toolsWidth = 0; ///< px, of all buttons that were added
    QWidget *m_middle = nullptr;
    StepMenu *m_steps = nullptr;
};

}
