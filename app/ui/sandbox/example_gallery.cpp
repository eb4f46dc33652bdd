#include "app/ui/sandbox/example_gallery.h"

#include "app/model/workshop.h"
#include "app/ui/scene/thumbnail.h"

namespace app {

namespace {

constexpr int pictureFrames = 24; ///< at which an example shows what it is

}

ExampleGallery::ExampleGallery(Session &session, const Theme &theme, QWidget *parent)
    : CardGallery({4, {168, 124}, Edge::left}, theme, parent), m_session(session)
{
    setAccessibleName(tr("Examples"));
}

std::vector<CardGallery::Card> ExampleGallery::contents() const
{
    std::vector<Card> cards;
    for (const lessons::Example &example : m_session.step().examples)
        cards.push_back(
            {example.title, example.help, tr("%1 Undo brings your scene back.").arg(example.help)});
    return cards;
}

QPixmap ExampleGallery::picture(std::size_t index)
{
    try {
        const QString file = m_session.step().examples[index].file;
        const sim::Script script = readExperiment(file, m_session.library()).script;
        lessons::Step step = m_session.step();
        step.opening = [script](sim::Script &opened) { opened = script; };
        return thumbnail(step, script.values, theme(), pictureSize(), pictureFrames);
    } catch (const Refusal &) {
        return {}; // a click says why
    }
}

void ExampleGallery::take(std::size_t index)
{
    takeExample(m_session, m_session.step().examples[index]);
}

}
