#pragma once

#include "app/ui/theme/theme.h"

#include <QObject>

namespace app {

class HelpPages;
class LearnPanel;
class ModeChoice;
class ParameterPanel;
class SceneColumn;
class Session;
class Tour;
struct Commands;
struct PanelLayout;

/// The parts of a window that the tour opens, or points at.
struct TourParts
{
    const PanelLayout &layout;
    ModeChoice &mode;
    const SceneColumn &centre;
    LearnPanel &learn;
    const QWidget &code;
    const ParameterPanel &parameters;
    const Commands &commands;
};

/// Introduces the window with the tour and the map of concepts.
class Introduction : public QObject
{
    Q_OBJECT

public:
    /// All parts, and the other arguments, must outlive it.
    Introduction(const TourParts &parts, Session &session, HelpPages &help, const Theme &theme);

    /// Starts the tour: cards that point at the parts of the window, one after the other.
    void startTour();
    /// Shows the map of concepts, if the lessons have any.
    void showMap();
    /// Greets a new learner: starts the tour, and shows the map of concepts when it has ended.
    void welcome();

private:
    TourParts m_parts;
    HelpPages &m_help;
    const Theme &m_theme;
    Tour *m_tour = nullptr; ///< made when it is started first
};

}
