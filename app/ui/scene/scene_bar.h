#pragma once

#include "app/model/listing/learner_code.h"
#include "app/model/session/open_run.h"
#include "app/model/session/run_editor.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QAction;

namespace app {

class Command;
class FlatButton;
class SceneView;
class StepMenu;

/// The bar above the scene, 36 px high: method, step, the "Show" menu, zoom.
class SceneBar : public QWidget
{
    Q_OBJECT

public:
    SceneBar(const OpenRun &run, RunEditor &editor, LearnerCode &code, const Theme &theme,
             QWidget *parent = nullptr);

    /// Connects "Show" and the zoom to a view. `fit` fits the scene into it.
    void attach(SceneView &view, Command &fit);
    /// Switches an entry of "Show"; ids as in chosen(). An unknown id changes nothing.
    void choose(const QString &id, bool on);
    /// Lets a command switch an entry of "Show", as the entry itself does, and follow it.
    void follow(const QString &id, Command &command);
    /// Returns the ids of the entries of "Show".
    QStringList choices() const;
    /// Adds a button for a command, before "Show".
    void addTool(Command &command);
    /// Places a widget between step and "Show", and deletes the one before. Null removes it. The bar owns the
    /// widget, and may give it less room than it wants.
    void setMiddle(QWidget *middle);
    /// Returns the size without the captions of method and step.
    QSize minimumSizeHint() const override;

signals:
    /// Emitted when the learner switches an entry of "Show".
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
    /// Hides captions if the bar is too narrow for them.
    void arrange();
    int widthWith(int method, int step) const;

    const OpenRun &m_run;
    RunEditor &m_editor;
    LearnerCode &m_code;
    const Theme &m_theme;
    SceneView *m_view = nullptr;
    FlatButton *m_method;
    QAction *m_listing = nullptr; ///< the learner's code, among the methods
    FlatButton *m_step;
    FlatButton *m_show;
    FlatButton *m_zoom;
    FlatButton *m_fit;
    int m_toolsWidth = 0; ///< px, of all added buttons
    QWidget *m_middle = nullptr;
    StepMenu *m_steps = nullptr;
};

}
