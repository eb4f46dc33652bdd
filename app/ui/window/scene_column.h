#pragma once

#include "app/ui/theme/theme.h"

#include <QWidget>

class QVBoxLayout;

namespace app {

class FailureNotice;
class FootfallStrip;
class MeasureSeries;
class Notice;
class RunCommands;
class SceneBar;
class SceneCard;
class SceneView;
class Session;
class TimelineStrip;
class TransportBar;

/// The middle of the window: notice, scene with the bar above it, and the time of the run.
class SceneColumn : public QWidget
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    SceneColumn(Session &session, MeasureSeries &measures, const RunCommands &commands, const Theme &theme,
                QWidget *parent);

    Notice &notice() const { return *m_notice; }
    SceneBar &bar() const { return *m_bar; }
    SceneView &scene() const { return *m_scene; }
    FailureNotice &failure() const { return *m_failure; }
    TransportBar &transport() const { return *m_transport; }
    TimelineStrip &timeline() const { return *m_timeline; }

    /// Fits for a window without panels: the first parameters above the scene, what to try on a card over it,
    /// and its time in one row.
    void showAlone();
    /// Fits for a window with panels.
    void showBesidePanels();

private:
    Session &m_session;
    const RunCommands &m_commands;
    const Theme &m_theme;
    Notice *m_notice;
    SceneBar *m_bar;
    SceneView *m_scene;
    FailureNotice *m_failure;
    TransportBar *m_transport;
    TimelineStrip *m_timeline;
    FootfallStrip *m_footfall;
    SceneCard *m_card = nullptr; ///< made when it is shown first
    QVBoxLayout *m_column;
};

}
