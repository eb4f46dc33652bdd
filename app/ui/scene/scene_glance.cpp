// What the scene view shows while somebody looks at another moment, and what the mouse on the picture looks at.

#include "app/ui/scene/caption.h"
#include "app/ui/scene/past_spot.h"
#include "app/ui/scene/scene_view.h"

#include <QScrollBar>

namespace app {

void SceneView::takeCaption()
{
    m_shown.caption = frameCaption(m_session.shown());
    if (m_session.isGlancing())
        m_shown.caption = m_shown.caption.isEmpty()
                              ? tr("Only a look: this is frame %1.").arg(m_session.shown().cursor().frame)
                              : tr("Only a look. %1").arg(m_shown.caption);
    else if (m_shown.caption.isEmpty())
        m_shown.caption = m_session.note();
}

void SceneView::followGlance()
{
    const bool glances = m_session.isGlancing();
    const bool wasElsewhere = m_place || m_shown.past;
    if (!m_session.marked())
        m_looksBack = false;
    m_shown.past.reset();
    if (!glances && !wasElsewhere)
        return;
    if (glances && m_looksBack) {
        m_shown.past = m_session.picture();
        takeCaption();
        describe();
        viewport()->update();
        return;
    }
    if (glances && !m_place)
        m_place = QPoint(horizontalScrollBar()->value(), verticalScrollBar()->value());
    refresh();
    if (glances || !m_place)
        return;
    horizontalScrollBar()->setValue(m_place->x());
    verticalScrollBar()->setValue(m_place->y());
    m_place.reset();
}

void SceneView::lookBack()
{
    const int point = Hand::bodyAt(m_shown, camera(), m_pointer);
    pointAt(point < 0 ? QString() : nameOf(point));
    const std::optional<std::int64_t> frame =
        point < 0 && !m_session.isPlaying() ? pastFrameAt(m_shown, camera(), m_pointer) : std::nullopt;
    if (frame) {
        m_looksBack = true;
        m_session.glance({*frame, 0});
    } else if (m_looksBack) {
        m_session.endGlance();
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
