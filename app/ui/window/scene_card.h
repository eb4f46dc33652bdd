#pragma once

#include "app/ui/theme/theme.h"

#include <QFrame>

class QLabel;

namespace app {

class SceneView;
class Session;

/// A card over the scene, for a window without panels: the step and the next thing to try. The mouse goes through it.
class SceneCard : public QFrame
{
    Q_OBJECT

public:
    SceneCard(Session &session, const Theme &theme, SceneView &scene);

    /// Returns the next thing to try, or that all are done and how to go on.
    QString sentence() const;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void applyTheme();
    void refresh();
    void place();

    Session &m_session;
    const Theme &m_theme;
    SceneView &m_scene;
    QLabel *m_title;
    QLabel *m_text;
};

}
