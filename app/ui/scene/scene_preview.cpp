// What the scene view shows during a preview, and the preview of a moment of the trail under the mouse.

#include "app/ui/scene/drawing/caption.h"
#include "app/ui/scene/hud/past_moments.h"
#include "app/ui/scene/scene_view.h"

#include <QScrollBar>

namespace app {

void SceneView::takeCaption()
{
    m_shown.caption = frameCaption(m_session.preview().run());
    if (m_session.preview().isActive())
        m_shown.caption = m_shown.caption.isEmpty()
                              ? tr("Preview of frame %1.").arg(m_session.preview().run().cursor().frame)
                              : tr("Preview. %1").arg(m_shown.caption);
    else if (m_shown.caption.isEmpty())
        m_shown.caption = m_session.presentation().note();
}

void SceneView::followPreview(const Change &change)
{
    const bool isPreview = m_session.preview().isActive();
    const bool wasElsewhere = m_place || m_shown.past || change.kinds != ChangeKind::preview;
    if (!m_session.preview().marked())
        m_ownsPreview = false;
    m_shown.past.reset();
    if (!isPreview && !wasElsewhere)
        return;
    if (isPreview && m_ownsPreview) {
        m_shown.past = m_session.presentation().picture();
        takeCaption();
        describe();
        viewport()->update();
        return;
    }
    if (isPreview && !m_place)
        m_place = QPoint(horizontalScrollBar()->value(), verticalScrollBar()->value());
    refresh();
    if (isPreview || !m_place)
        return;
    horizontalScrollBar()->setValue(m_place->x());
    verticalScrollBar()->setValue(m_place->y());
    m_place.reset();
}

void SceneView::previewPointed()
{
    const int point = BodyDrag::bodyAt(m_shown, camera(), m_pointer);
    pointAt(point < 0 ? QString() : nameOf(point));
    const std::optional<std::int64_t> frame = point < 0 && !m_session.playback().isPlaying()
                                                  ? pastFrameAt(m_shown, camera(), m_pointer)
                                                  : std::nullopt;
    if (frame) {
        m_ownsPreview = true;
        m_session.preview().show({*frame, 0});
    } else if (m_ownsPreview) {
        m_session.preview().end();
    }
}

void SceneView::pointAt(const QString &body)
{
    if (body == m_pointed)
        return;
    m_pointed = body;
    emit bodyPointedAt(body);
}

}
