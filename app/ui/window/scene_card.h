#pragma once

#include "app/ui/theme/theme.h"

#include <QFrame>
#include <QKeySequence>

class QLabel;

namespace app {

class Command;
class OpenRun;
class Progress;
class SceneView;

/// A card over the scene, for a window without panels: the step and the next thing to try. The mouse goes through it.
class SceneCard : public QFrame
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    SceneCard(const OpenRun &run, const Progress &progress, const Command &nextStep, const Theme &theme,
              SceneView &scene);

    /// Returns the next thing to try, or that all are done and how to go on.
    QString sentence() const;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void refresh();
    void place();

    const OpenRun &m_run;
    const Progress &m_progress;
    const QKeySequence m_nextKeys; ///< that open the next step
    const Theme &m_theme;
    SceneView &m_scene;
    QLabel *m_title;
    QLabel *m_text;
};

}
