#include "app/ui/window/handover.h"

namespace app {

Handover handOver(Session &session, const Document &document, WindowMode mode, bool isSceneOnly)
{
    const bool isPlaying = session.playback().isPlaying();
    const std::optional<std::int64_t> goal = session.playback().goal();
    session.input().releaseAll();
    session.preview().end();
    session.cancelComputing();
    return {document.saved(), mode, goal, isPlaying, isSceneOnly};
}

void takeOver(const Handover &from, Session &session, Document &document)
{
    document.setSaved(from.saved);
    if (from.goal)
        session.playback().goTo({*from.goal, 0});
    if (from.isPlaying)
        session.playback().play();
}

}
