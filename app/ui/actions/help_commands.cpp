#include "app/ui/actions/help_commands.h"

#include "app/ui/actions/command_list.h"

namespace app {

HelpCommands::HelpCommands(CommandList &list)
    : keys(list.add(tr("&Keys and mouse"), {QKeySequence("F1"), QKeySequence("?")}, KeyGroup::window)),
      hint(list.add(tr("Show a &hint"), {QKeySequence("H")}, KeyGroup::steps)),
      glossary(list.add(tr("&Glossary"), {QKeySequence("Shift+F1"), QKeySequence("Ctrl+Shift+G")},
                        KeyGroup::window)),
      map(list.add(tr("&Map of concepts"), {QKeySequence("F2")}, KeyGroup::steps)),
      tour(list.add(tr("Take the &tour"), {}, KeyGroup::window)),
      about(list.add(tr("&About Springstep"), {}, KeyGroup::window))
{
    keys->setIconName("help");
    hint->setHelp(tr("A hint for the next thing to try"));
    glossary->setHelp(tr("The words that the lessons teach"));
    map->setIconName("map");
    map->setHelp(tr("The concepts of all lessons: what rests on what, and what you know"));
    tour->setHelp(tr("A one-minute tour of this window"));
    about->setHelp(tr("Version, licence and libraries"));
    about->setMenuRole(QAction::AboutRole);
}

}
