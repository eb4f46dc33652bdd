#include "app/ui/parameters/preset_gallery.h"

namespace app {

namespace {

constexpr QSize pictureSize{156, 104};
constexpr int columns = 3;

}

PresetGallery::PresetGallery(const OpenRun &run, RunEditor &editor, const Theme &theme, PresetPainter painter,
                             QWidget *parent)
    : CardGallery(pictureSize, columns, theme, parent), m_run(run), m_editor(editor),
      m_painter(std::move(painter))
{
    setAccessibleName(tr("Presets"));
}

std::vector<GalleryCard> PresetGallery::entries()
{
    const lessons::Step &step = m_run.step();
    std::vector<GalleryCard> cards;
    for (const lessons::Preset &preset : step.presets) {
        GalleryCard card;
        card.title = preset.title;
        card.help = preset.help;
        card.tip = tr("%1 Restarts this step.").arg(preset.help);
        card.key = m_run.lesson().id + '/' + step.id + '/' + preset.title;
        card.picture = [this, &step, &preset](QSize size) { return m_painter(step, preset, size); };
        card.take = [this, preset] { m_editor.startWith(preset); };
        cards.push_back(std::move(card));
    }
    return cards;
}

}
