#include "app/ui/actions/file_commands.h"

#include "app/ui/actions/command_list.h"

namespace app {

FileCommands::FileCommands(CommandList &list)
    : startNew(list.add(tr("&New: the step as published"), {QKeySequence(QKeySequence::New)},
                        KeyGroup::experiments)),
      open(list.add(tr("&Open an experiment…"), {QKeySequence(QKeySequence::Open)}, KeyGroup::experiments)),
      recover(list.add(tr("Reco&ver scenes…"), {}, KeyGroup::experiments)),
      save(list.add(tr("&Save the experiment"), {QKeySequence(QKeySequence::Save)}, KeyGroup::experiments)),
      saveAs(list.add(tr("Save &as…"), {QKeySequence("Ctrl+Shift+S")}, KeyGroup::experiments)),
      keep(list.add(tr("&Keep in gallery"), {QKeySequence("Ctrl+Shift+K")}, KeyGroup::experiments)),
      gallery(list.add(tr("&Gallery…"), {QKeySequence("Ctrl+Shift+O")}, KeyGroup::experiments)),
      exportPicture(
          list.add(tr("&Picture of the scene…"), {QKeySequence("Ctrl+Shift+E")}, KeyGroup::pictures)),
      exportFilm(list.add(tr("&Film of the run…"), {QKeySequence("Ctrl+Shift+F")}, KeyGroup::pictures)),
      quit(list.add(tr("&Quit"), {QKeySequence("Ctrl+Q")}, KeyGroup::experiments))
{
    keep->setHelp(tr("Keep the experiment with a picture, without choosing a file"));
    gallery->setHelp(tr("What you keep: open, rename or remove it"));
    exportPicture->setHelp(tr("The scene as it is shown, as PNG or SVG"));
    exportFilm->setHelp(tr("The run as a video, an animated GIF or a PNG for each frame"));
}

}
