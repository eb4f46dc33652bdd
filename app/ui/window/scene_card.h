#pragma once

#include "app/ui/theme/theme.h"

#include <QFrame>

class QLabel;

namespace app {

class SceneView;
class Session;

/// The step and what there is to do in it, in a sentence, over the picture: for whoever has put everything else away. The
/// mouse goes through it.
class SceneCard : public QFrame
{
    Q_OBJECT

public:
    SceneCard(Session &session, const Theme &theme, SceneView &scene);

    /// The next thing to try; where all are done, that, and the way on.
    QString sentence() const;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void dress();
    void refresh();
    void place();

    Session &m_session;
    const Theme &m_theme;
    SceneView &m_scene;
    QLabel *m_title;
    QLabel *m_text;
};

}
