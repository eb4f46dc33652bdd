#include "app/ui/actions/gestures.h"

#include "app/ui/actions/command_list.h"
#include "app/ui/code/code_keys.h"
#include "app/ui/help/help_page.h"

#include <QCoreApplication>

namespace app {

namespace {

class Gestures
{
    Q_DECLARE_TR_FUNCTIONS(Gestures)

public:
    explicit Gestures(HelpPage &page) : m_page(page) {}

    void ofScene() const
    {
        add(KeyGroup::picture, tr("Drag a body"), tr("grab it; let go while moving to throw it"));
        add(KeyGroup::picture, tr("Drag the background"), tr("move the picture"));
        add(KeyGroup::picture, tr("Click an arrow at the edge"), tr("go to the body that it points to"));
        add(KeyGroup::picture, tr("Wheel"), tr("zoom where the pointer is"));
        add(KeyGroup::picture, tr("[ and ]"), tr("select the previous or the next body"));
        add(KeyGroup::picture, tr("Alt and an arrow key"), tr("move the selected body 10 px"));
        add(KeyGroup::picture, tr("Press the background"), tr("blow, steer or aim, in steps that have this"));
        add(KeyGroup::picture, tr("Drag with the middle button"), tr("move the picture"));
        add(KeyGroup::picture, tr("Arrow keys"), tr("steer, in steps that have this"));
        add(KeyGroup::picture, tr("Alt, Shift and an arrow key"), tr("move the pointer or the target 20 px"));
        add(KeyGroup::picture, tr("Alt and Enter"), tr("press or release the pointer's button"));
        add(KeyGroup::picture, tr("Drag an end of the ruler"),
            tr("measure a length and an angle (switch it on under Show)"));
        add(KeyGroup::picture, tr("Ctrl, Alt and an arrow key"),
            tr("move the ruler's far end 5 px; with Shift the near one"));
        add(KeyGroup::picture, tr("Esc"), tr("let go"));
        add(KeyGroup::otherRuns, tr("Click the dots below a ring"),
            tr("compare with the run that branches off there; right-click: more"));
        add(KeyGroup::build, tr("Shift and a click"), tr("add a part to the selection, or remove it"));
        add(KeyGroup::build, tr("Drag the background"), tr("select all parts in the box"));
        add(KeyGroup::build, tr("Drag from point to point"),
            tr("connect them, with the Spring or the Stick tool"));
        add(KeyGroup::build, tr("Arrow keys and Enter"), tr("move the tool 10 px, with Shift 1 px; use it"));
        add(KeyGroup::build, tr("Alt and an arrow key"),
            tr("move the selected parts 10 px, with Shift 1 px"));
        add(KeyGroup::build, tr("{ and }"), tr("select the previous or the next spring or stick"));
        add(KeyGroup::build, tr("Escape"), tr("end a row of links, put the tool away, clear the selection"));
    }
    void ofTime() const
    {
        add(KeyGroup::time, tr("Drag the timeline"), tr("go anywhere in time"));
        add(KeyGroup::time, tr("Click a phase"), tr("run to it"));
        add(KeyGroup::time, tr("Point at timeline, phase, plot or trail"),
            tr("preview that moment; the run stays at its frame"));
        add(KeyGroup::time, tr("Alt and the underlined letter"), tr("use a remedy, when a run has failed"));
        add(KeyGroup::experiments, tr("Drop a file on the window"), tr("open it"));
        add(KeyGroup::plots, tr("Press or drag"), tr("go to a frame"));
        add(KeyGroup::plots, tr("+ and −, or Ctrl and the wheel"), tr("fewer or more frames"));
        add(KeyGroup::plots, tr("The names above a plot"), tr("choose what it shows"));
        add(KeyGroup::plots, tr("Menu key, or right-click"), tr("save, copy, keep or remove it"));
        add(KeyGroup::plots, tr("Delete"), tr("remove it"));
    }
    void ofCode() const
    {
        add(KeyGroup::code, tr("Click a line, or Enter"), tr("run to its phase"));
        add(KeyGroup::code, tr("Click left of a line, or %1").arg(keyText(codeKeys::toggleBreakpoint)),
            tr("set or remove a breakpoint before its phase"));
        add(KeyGroup::code, tr("Drag a dotted word"), tr("change that parameter; with Shift in small steps"));
        add(KeyGroup::code, tr("Double-click it, or %1").arg(keyText(codeKeys::changeNumber)),
            tr("type the parameter's value"));
        add(KeyGroup::code, tr("Point at a word, or %1").arg(keyText(codeKeys::showValue)),
            tr("its value, and its last 120 frames"));
        add(KeyGroup::code, tr("Up and Down"), tr("from line to line; with Ctrl from heading to heading"));
        add(KeyGroup::code, tr("Ctrl and Left or Right"), tr("from word to word"));
        add(KeyGroup::code, tr("Enter, on a heading"), tr("fold or unfold"));
        add(KeyGroup::code, keyText(codeKeys::showRemovedLines), tr("show the lines that this step removed"));
        add(KeyGroup::code, keyText(QKeySequence::Copy), tr("copy the selection, or the whole region"));
        add(KeyGroup::code, tr("Stop when…"),
            tr("the field below the code: stop when a condition becomes true"));
    }
    void ofListing() const
    {
        add(KeyGroup::code, tr("Click left of a line, in the listing"), tr("run to it"));
        add(KeyGroup::code,
            tr("Ctrl and a click left of a line, or %1, in the listing")
                .arg(keyText(codeKeys::toggleBreakpoint)),
            tr("set or remove a breakpoint before it"));
        add(KeyGroup::code, tr("Point at a place or a velocity, in the listing"),
            tr("see it in the picture"));
        add(KeyGroup::code, tr("Drag a number, in the listing"), tr("change it; with Shift in small steps"));
        add(KeyGroup::code, tr("%1, in the listing").arg(keyText(codeKeys::completeName)),
            tr("complete a name"));
        add(KeyGroup::code, tr("Esc, in the listing"), tr("leave it, so that keys move the run again"));
    }
    void ofAccuracy() const
    {
        add(KeyGroup::accuracy, tr("Arrow keys"), tr("walk through the points of a plot"));
        add(KeyGroup::accuracy, tr("Enter or a click"), tr("use the method and step of a point"));
        add(KeyGroup::accuracy, tr("+ and −, or drag the line"), tr("set the largest error that you accept"));
    }

private:
    void add(KeyGroup group, const QString &gesture, const QString &effect) const
    {
        m_page.addGesture(titleOf(group), gesture, effect);
    }

    HelpPage &m_page;
};

}

void addGestures(HelpPage &page)
{
    const Gestures gestures(page);
    gestures.ofScene();
    gestures.ofTime();
    gestures.ofCode();
    gestures.ofListing();
    gestures.ofAccuracy();
}

}
