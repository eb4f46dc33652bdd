#pragma once

#include "app/model/files/document.h"
#include "app/ui/dock/window_mode.h"

#include <QObject>

#include <cstdint>
#include <map>
#include <optional>

class QWidget;

namespace app {

class Command;
class ModeChoice;
class Notice;
class SceneExport;

/// What a window that restarts hands over to the next one, besides the settings and the session, which stays.
struct Handover
{
    std::map<StepName, Document::Saved> saved; ///< the saved state of its files
    WindowMode mode = WindowMode::learn;
    std::optional<std::int64_t> goal; ///< the frame that the session is going to
    bool isPlaying = false;
    bool isSceneOnly = false; ///< without panels
};

/// The parts of a window whose state the next window takes over.
struct RestartParts
{
    Session &session;
    Document &document;
    ModeChoice &mode;
    Command &sceneOnly; ///< shows the window without panels
};

/// Closes a window so that the next one continues from it. Another language and another size need this, because they need
/// a new application.
class Restart : public QObject
{
    Q_OBJECT

public:
    /// All parts, and the other arguments, must outlive it.
    Restart(const RestartParts &parts, const SceneExport &exports, Notice &notice, QWidget &window);

    /// Restarts, unless a film or a web page is being made: then it asks, beginning with `reason`, a sentence.
    void offer(const QString &reason);
    /// Closes the window. Nothing is lost, so nothing is asked.
    void start();
    /// Returns what the next window needs; empty if this one is simply closed.
    const std::optional<Handover> &handover() const { return m_handover; }
    /// Continues from an earlier window on the same session. Call it before the window saves by itself, so that the open
    /// run is not offered for recovery.
    void continueFrom(const Handover &from);

private:
    RestartParts m_parts;
    const SceneExport &m_exports;
    Notice &m_notice;
    QWidget &m_window;
    std::optional<Handover> m_handover;
};

}
