#include "app/ui/sandbox/example_gallery.h"

#include "app/model/sandbox/sandbox.h"
#include "app/ui/scene/drawing/thumbnail.h"

namespace app {

namespace {

constexpr QSize pictureSize{132, 96};
constexpr int columns = 6;        ///< so that four rows fit on a screen of 800 px
constexpr int pictureFrames = 24; ///< the frame at which an example is drawn

}

ExampleGallery::ExampleGallery(const OpenRun &run, RunEditor &editor, const Theme &theme, QWidget *parent)
    : CardGallery(pictureSize, columns, theme, parent), m_run(run), m_editor(editor), m_theme(theme)
{
    setAccessibleName(tr("Examples"));
}

/// Returns a picture of the example, or an empty one if its file cannot be read.
QPixmap ExampleGallery::pictureOf(const lessons::Example &example, QSize size) const
{
    try {
        const sim::Script script = readExperiment(example.file, m_run.library()).script;
        lessons::Step step = m_run.step();
        step.prepareScript = [script](sim::Script &opened) { opened = script; };
        return thumbnail(step, script.values, m_theme, size, pictureFrames);
    } catch (const UserError &) {
        return {}; // a click shows the error
    }
}

std::vector<GalleryCard> ExampleGallery::entries()
{
    std::vector<GalleryCard> cards;
    for (const lessons::Example &example : m_run.step().examples) {
        GalleryCard card;
        card.title = example.title;
        card.help = example.help;
        card.tip = tr("%1 Undo brings your scene back.").arg(example.help);
        card.key = example.file;
        card.picture = [this, example](QSize size) { return pictureOf(example, size); };
        card.take = [this, example] { takeExample(m_run, m_editor, example); };
        cards.push_back(std::move(card));
    }
    return cards;
}

}
