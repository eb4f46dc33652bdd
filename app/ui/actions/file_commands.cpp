#include "app/ui/actions/file_commands.h"

#include "app/ui/actions/command_list.h"

namespace app {

FileCommands::FileCommands(CommandList &list)
    : startNew(list.add(tr("&New: the step as published"), {QKeySequence(QKeySequence::New)},
                        KeyGroup::experiments)),
      open(list.add(tr("&Open an experiment or a lesson…"), {QKeySequence(QKeySequence::Open)},
                    KeyGroup::experiments)),
      recover(list.add(tr("Reco&ver scenes…"), {}, KeyGroup::experiments)),
      save(list.add(tr("&Save the experiment"), {QKeySequence(QKeySequence::Save)}, KeyGroup::experiments)),
      saveAs(list.add(tr("Save &as…"), {QKeySequence("Ctrl+Shift+S")}, KeyGroup::experiments)),
      keep(list.add(tr("&Keep in gallery"), {QKeySequence("Ctrl+Shift+K")}, KeyGroup::experiments)),
      gallery(list.add(tr("&Gallery…"), {QKeySequence("Ctrl+Shift+O")}, KeyGroup::experiments)),
      handIn(list.add(tr("&Hand in a notebook…"), {QKeySequence("Ctrl+Shift+N")}, KeyGroup::experiments)),
      exportPicture(
          list.add(tr("&Picture of the scene…"), {QKeySequence("Ctrl+Shift+E")}, KeyGroup::pictures)),
      exportFilm(list.add(tr("&Film of the run…"), {QKeySequence("Ctrl+Shift+F")}, KeyGroup::pictures)),
      exportWebPage(
          list.add(tr("&Web page of the run…"), {QKeySequence("Ctrl+Shift+W")}, KeyGroup::pictures)),
      exportHandout(
          list.add(tr("&Handout of the lesson…"), {QKeySequence("Ctrl+Shift+A")}, KeyGroup::pictures)),
      quit(list.add(tr("&Quit"), {QKeySequence("Ctrl+Q")}, KeyGroup::experiments))
{
    open->setHelp(tr("An experiment, or a lesson: its lesson.json or its .springstep-lesson file"));
    keep->setHelp(tr("Keep the experiment with a picture, without choosing a file"));
    gallery->setHelp(tr("What you keep: open, rename or remove it"));
    handIn->setHelp(tr("Write what you did into a file for your teacher, or onto a page"));
    exportPicture->setHelp(tr("The scene as it is shown, as PNG or SVG"));
    exportFilm->setHelp(tr("The run as a video, an animated GIF or a PNG for each frame"));
    exportHandout->setHelp(
        tr("The lesson on paper, as a PDF: with lines to write on, and the answers at the end"));
    exportWebPage->setHelp(tr("One file that plays the run in any browser, with the listing and the plots"));
}

}
