#pragma once

#include "app/model/session/session.h"
#include "app/ui/dock/card_gallery.h"

namespace app {

/// A gallery with a picture of each example of the open sandbox. A click opens one in place of the current
/// scene.
class ExampleGallery : public CardGallery
{
    Q_OBJECT

public:
    ExampleGallery(const OpenRun &run, RunEditor &editor, const Theme &theme, QWidget *parent = nullptr);

protected:
    std::vector<GalleryCard> entries() override;

private:
    QPixmap pictureOf(const lessons::Example &example, QSize size) const;

    const OpenRun &m_run;
    RunEditor &m_editor;
    const Theme &m_theme;
};

}
