#include "app/ui/panels/preset_gallery.h"

namespace app {

PresetGallery::PresetGallery(Session &session, const Theme &theme, PresetPainter painter, QWidget *parent)
    : CardGallery({3, {156, 104}, Edge::right}, theme, parent), m_session(session),
      m_painter(std::move(painter))
{
    setAccessibleName(tr("Presets"));
}

std::vector<CardGallery::Card> PresetGallery::contents() const
{
    std::vector<Card> cards;
    for (const lessons::Preset &preset : m_session.step().presetGallery)
        cards.push_back({preset.title, preset.help, tr("%1 Starts this step anew.").arg(preset.help)});
    return cards;
}

QPixmap PresetGallery::picture(std::size_t index)
{
    const lessons::Step &step = m_session.step();
    const lessons::Preset &preset = step.presetGallery[index];
    const QString key = m_session.lesson().id + '/' + step.id + '/' + preset.title + '/' +
                        QString::number(static_cast<int>(theme().scheme()));
    auto found = m_pictures.find(key);
    if (found == m_pictures.end())
        found = m_pictures.emplace(key, m_painter(step, preset, pictureSize())).first;
    return found->second;
}

void PresetGallery::take(std::size_t index)
{
    m_session.startWith(m_session.step().presetGallery[index]);
}

}
