#include "app/ui/actions/view_commands.h"

#include "app/ui/actions/command_list.h"

namespace app {

namespace {

constexpr KeyGroup inWindow = KeyGroup::window;

Command *named(Command *command, const char *name)
{
    command->setObjectName(name);
    return command;
}

}

ViewCommands::ViewCommands(CommandList &list)
    : learn(list.add(tr("L&earn"), {QKeySequence("F5")}, inWindow)),
      measure(list.add(tr("&Measure"), {QKeySequence("F6")}, inWindow)),
      build(list.add(tr("&Build"), {QKeySequence("F7")}, inWindow)),
      zoomIn(list.add(tr("Zoom &in"), {QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")}, KeyGroup::picture)),
      zoomOut(list.add(tr("Zoom &out"), {QKeySequence("Ctrl+-")}, KeyGroup::picture)),
      fit(list.add(tr("&Fit the scene"), {QKeySequence("Ctrl+0"), QKeySequence("0")}, KeyGroup::picture)),
      nextOutside(list.add(tr("Ne&xt body outside"), {QKeySequence("O")}, KeyGroup::picture)),
      unitCircle(named(list.add(tr("Unit circle"), {QKeySequence("U")}, KeyGroup::picture), "unitCircle")),
      lessons(named(list.add(tr("&Lessons"), {QKeySequence("Ctrl+1")}, inWindow), "showLessons")),
      lessonRail(named(list.add(tr("Lessons &as a narrow strip"), {QKeySequence("Ctrl+Shift+1")}, inWindow),
                       "lessonRail")),
      codeAndParameters(
          named(list.add(tr("&Code and parameters"), {QKeySequence("Ctrl+2")}, inWindow), "showCode")),
      energy(named(list.add(tr("E&nergy"), {QKeySequence("Ctrl+3")}, inWindow), "showEnergy")),
      effects(named(list.add(tr("Effec&ts"), {QKeySequence("Ctrl+4")}, inWindow), "showEffects")),
      plots(named(list.add(tr("&Plots"), {QKeySequence("Ctrl+5")}, inWindow), "showPlots")),
      stability(list.add(tr("&Stability of the step"), {QKeySequence("Ctrl+L")}, inWindow)),
      settling(named(list.add(tr("Map of the time to rest"), {QKeySequence("Ctrl+Shift+L")}, inWindow),
                     "showSettling")),
      unlockPanels(named(list.add(tr("&Unlock: panels can be moved"), {}, inWindow), "movable")),
      resetPanels(named(list.add(tr("&Reset"), {}, inWindow), "resetLayout")),
      dark(named(list.add(tr("&Dark"), {QKeySequence("Ctrl+Shift+D")}, inWindow), "dark")),
      highContrast(
          named(list.add(tr("&High contrast"), {QKeySequence("Ctrl+Shift+H")}, inWindow), "contrast")),
      lessMotion(named(list.add(tr("Less mo&vement"), {}, inWindow), "lessMotion")),
      sceneOnly(named(list.add(tr("Scene onl&y"), {QKeySequence("F11")}, inWindow), "sceneOnly")),
      fullScreen(list.add(tr("F&ull screen"), {QKeySequence("Shift+F11")}, inWindow))
{
    learn->setHelp(tr("Lessons, scene and code"));
    measure->setHelp(tr("The error and the cost of each method for this scene"));
    build->setHelp(tr("Build your own scene from points, springs, sticks and feet"));
    fit->setIconText(tr("Fit"));
    fit->setIconName("fit");
    fit->setHelp(tr("Show the whole scene with all bodies, and keep them in view"));
    nextOutside->setHelp(tr("Bring a body that is outside the picture into view"));
    unitCircle->setHelp(tr("Show the angle of an arrow, its cosine and its sine on a circle"));
    lessons->setIconName("panel-left");
    lessonRail->setHelp(tr("Show only the symbols of the lessons, to save space"));
    codeAndParameters->setIconName("panel-right");
    energy->setHelp(tr("Where energy and momentum went"));
    effects->setHelp(tr("The cost of each effect in the scene, with a switch for each"));
    plots->setHelp(tr("Curves of any quantity of any body"));
    settling->setHelp(tr("How many frames the run takes to come to rest, for each stiffness and damping"));
    unlockPanels->setHelp(tr("Drag a panel by its title to another place"));
    resetPanels->setHelp(tr("Moves the panels back to their original places, in this mode only"));
    lessMotion->setHelp(tr("Panels and menus open without animation, and wind is drawn as a still picture. "
                           "Only the simulation moves"));
    sceneOnly->setHelp(tr("Show only the scene and its timeline. Press again to bring the panels back"));
    for (Command *command :
         {learn, measure, build, lessons, lessonRail, codeAndParameters, energy, effects, plots, stability,
          settling, unitCircle, unlockPanels, dark, highContrast, lessMotion, sceneOnly, fullScreen})
        command->setCheckable(true);
}

}
