#pragma once

#include "app/model/session/session.h"
#include "app/ui/learn/card_gallery.h"

namespace app {

/// Paints a preview of a step with a preset's values.
using PresetPainter = std::function<QPixmap(const lessons::Step &, const lessons::Preset &, QSize)>;

/// A gallery with a picture of each preset of the open step. A click restarts the step with that preset.
class PresetGallery : public CardGallery
{
    Q_OBJECT

public:
    PresetGallery(Session &session, const Theme &theme, PresetPainter painter, QWidget *parent = nullptr);

protected:
    std::vector<GalleryCard> entries() override;

private:
    Session &m_session;
    PresetPainter m_painter;
};

}
