#pragma once

#include "app/model/session/open_run.h"
#include "app/model/session/run_editor.h"
#include "app/ui/dock/card_gallery.h"

namespace app {

/// Paints a preview of a step with a preset's values.
using PresetPainter = std::function<QPixmap(const lessons::Step &, const lessons::Preset &, QSize)>;

/// A gallery with a picture of each preset of the open step. A click restarts the step with that preset.
class PresetGallery : public CardGallery
{
    Q_OBJECT

public:
    PresetGallery(const OpenRun &run, RunEditor &editor, const Theme &theme, PresetPainter painter,
                  QWidget *parent = nullptr);

protected:
    std::vector<GalleryCard> entries() override;

private:
    const OpenRun &m_run;
    RunEditor &m_editor;
    PresetPainter m_painter;
};

}
