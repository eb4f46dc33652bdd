#pragma once

#include "app/model/session.h"
#include "app/ui/panels/card_gallery.h"

namespace app {

/// Paints what a step looks like with a preset's values.
using PresetPainter = std::function<QPixmap(const lessons::Step &, const lessons::Preset &, QSize)>;

/// The presets of the open step as pictures: a click starts the step anew with one of them.
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
