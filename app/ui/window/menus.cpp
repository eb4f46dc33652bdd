#include "app/ui/window/menus.h"

#include "app/ui/actions/commands.h"
#include "app/ui/actions/sandbox_commands.h"
#include "app/ui/learn/lessons/lesson_desk.h"

#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>

namespace app {

namespace {

/// Fills the menus of a menu bar.
class Menus
{
    Q_DECLARE_TR_FUNCTIONS(Menus)

public:
    explicit Menus(QMenuBar &bar) : m_bar(bar) {}

    void addFile(const FileCommands &file, const LessonDesk &lessons, QMenu *recent) const
    {
        QMenu *menu = m_bar.addMenu(tr("&File"));
        menu->addActions({file.startNew, file.open});
        menu->addMenu(recent);
        menu->addAction(file.recover);
        menu->addSeparator();
        menu->addActions({file.save, file.saveAs});
        menu->addActions({file.keep, file.gallery});
        menu->addSeparator();
        menu->addActions({&lessons.begin(), &lessons.forget(), file.handIn});
        menu->addSeparator();
        menu->addMenu(tr("&Export"))
            ->addActions({file.exportPicture, file.exportFilm, file.exportWebPage, file.exportHandout});
        menu->addSeparator();
        menu->addAction(file.quit);
    }

    void addEdit(const EditCommands &edit, const SandboxCommands &sandbox) const
    {
        QMenu *menu = m_bar.addMenu(tr("&Edit"));
        menu->addActions({edit.undo, edit.redo});
        menu->addSeparator();
        menu->addActions({edit.copyText, edit.pasteText, edit.copyPicture});
        menu->addSeparator();
        menu->addAction(sandbox.take);
        menu->addSeparator();
        menu->addActions({sandbox.deleteChosen, sandbox.duplicateChosen, sandbox.chooseAll});
        menu->addActions({sandbox.rule, sandbox.linkChosen});
    }

    void addRun(const RunCommands &run, QMenu *otherRuns) const
    {
        QMenu *menu = m_bar.addMenu(tr("&Run"));
        menu->addActions({run.play, run.frameForward, run.frameBack, run.phaseForward, run.phaseBack,
                          run.stepOver, run.stepOut, run.restart, run.repeat, run.end, run.goToFrame,
                          run.slower, run.faster});
        menu->addSeparator();
        menu->addActions({run.startAfresh, run.forgetOldRun});
        menu->addMenu(otherRuns);
        menu->addActions({run.chooseRun, run.compare});
        menu->addSeparator();
        menu->addActions({run.nextStep, run.previousStep});
    }

    void addView(const ViewCommands &view, const Submenus &submenus) const
    {
        QMenu *menu = m_bar.addMenu(tr("&View"));
        menu->addActions({view.learn, view.measure, view.build});
        menu->addSeparator();
        menu->addActions({view.zoomIn, view.zoomOut, view.fit, view.nextOutside, view.unitCircle});
        menu->addSeparator();
        menu->addActions({view.lessons, view.lessonRail, view.codeAndParameters, view.energy, view.effects,
                          view.plots, view.stability, view.settling});
        menu->addMenu(submenus.arrangePanels);
        menu->addMenu(submenus.language);
        menu->addSeparator();
        menu->addActions({view.dark, view.highContrast});
        menu->addMenu(submenus.size);
        menu->addActions({view.lessMotion, view.sceneOnly, view.fullScreen});
    }

    void addHelp(const HelpCommands &help) const
    {
        QMenu *menu = m_bar.addMenu(tr("&Help"));
        menu->addActions({help.keys, help.hint, help.map, help.glossary, help.tour});
        menu->addSeparator();
        menu->addAction(help.about);
    }

private:
    QMenuBar &m_bar;
};

}

QMenuBar *makeMenuBar(const Commands &commands, const SandboxCommands &sandbox, const LessonDesk &lessons,
                      const Submenus &submenus, QWidget *parent)
{
    auto *bar = new QMenuBar(parent);
    bar->setNativeMenuBar(false);
    const Menus menus(*bar);
    menus.addFile(commands.file, lessons, submenus.recentFiles);
    menus.addEdit(commands.edit, sandbox);
    menus.addRun(commands.run, submenus.otherRuns);
    menus.addView(commands.view, submenus);
    menus.addHelp(commands.help);
    return bar;
}

}
