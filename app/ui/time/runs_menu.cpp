#include "app/ui/time/runs_menu.h"

#include "app/model/text/difference_text.h"
#include "app/ui/time/name_field.h"

#include <QMetaMethod>

#include <algorithm>

namespace app {

namespace {

/// Returns a text for a menu, in which "&" is no mnemonic.
QString plain(QString text)
{
    return text.replace('&', "&&");
}

}

RunsMenu::RunsMenu(const OpenRun &run, RunEditor &editor, ComparisonRuns &comparisons, const Theme &theme,
                   QWidget *parent)
    : QMenu(tr("Other r&uns"), parent), m_run(run), m_editor(editor), m_comparisons(comparisons),
      m_theme(theme)
{
    setObjectName("runs");
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &RunsMenu::fill);
    fill();
}

void RunsMenu::showOnly(std::vector<int> branches)
{
    m_only = std::move(branches);
    fill();
}

void RunsMenu::popupAbove(const QWidget &widget)
{
    fill();
    popup(widget.mapToGlobal(QPoint(0, -sizeHint().height())));
}

void RunsMenu::fill()
{
    // Deleted later, because a command of one of these menus may be running.
    for (QMenu *menu : findChildren<QMenu *>(QString(), Qt::FindDirectChildrenOnly))
        menu->deleteLater();
    clear();
    const std::vector<Branch> &all = m_comparisons.branches().all();
    std::vector<const Branch *> shown;
    for (auto branch = all.rbegin(); branch != all.rend(); ++branch) {
        if (m_only.empty() || std::count(m_only.begin(), m_only.end(), branch->id) > 0)
            shown.push_back(&*branch);
    }
    if (m_only.size() == 1 && shown.size() == 1) {
        addCommands(*this, *shown.front());
        return;
    }
    for (const Branch *branch : shown)
        addRun(*branch);
    if (shown.empty()) {
        QAction *none = addAction(tr("No other run yet"));
        none->setToolTip(tr("Go back in time and change something: the old run then stays as another run."));
        none->setEnabled(false);
        return;
    }
    addSeparator();
    QAction *hide = addAction(tr("&Hide the other run"), this, [this] { m_comparisons.show(0); });
    hide->setEnabled(m_comparisons.shown() != nullptr);
    hide->setToolTip(tr("Shows only this run; the others stay in this menu"));
    if (!isSignalConnected(QMetaMethod::fromSignal(&RunsMenu::compareWanted)))
        return; // they are already being compared
    QAction *compare = addAction(tr("&Compare in numbers"), this, &RunsMenu::compareWanted);
    compare->setToolTip(tr("The distance between the two runs, frame by frame"));
}

void RunsMenu::addRun(const Branch &branch)
{
    auto *menu = new QMenu(plain(branchLine(branch, m_run.timeline().script())), this);
    menu->setToolTipsVisible(true);
    if (m_comparisons.shown() == &branch)
        menu->setIcon(m_theme.icon("show"));
    else if (branch.isKept)
        menu->setIcon(m_theme.icon("pin"));
    addCommands(*menu, branch);
    addMenu(menu);
}

void RunsMenu::addCommands(QMenu &menu, const Branch &branch)
{
    const int id = branch.id;
    const bool isShown = m_comparisons.shown() == &branch;
    const auto add = [&](const QString &text, const QString &tip, auto command) {
        QAction *made = menu.addAction(text, this, command);
        made->setToolTip(tip);
        return made;
    };
    QAction *show = add(tr("&Show beside"), tr("As a ghost in the picture, and as dots in the timeline"),
                        [this, id, isShown] { m_comparisons.show(isShown ? 0 : id); });
    show->setCheckable(true);
    show->setChecked(isShown);
    add(tr("&Go back to it"),
        tr("Makes it the current run again, exactly as it was; this run becomes another run"),
        [this, id] { m_editor.goBackTo(id); });
    menu.addSeparator();
    QAction *keep = add(tr("&Keep"),
                        tr("Keeps this run until you delete it. Of the other runs, only the last %1 stay.")
                            .arg(Branches::mostPassing),
                        [this, id, kept = branch.isKept] { m_comparisons.keep(id, !kept); });
    keep->setCheckable(true);
    keep->setChecked(branch.isKept);
    add(tr("&Rename…"), tr("Give this run another name"), [this, id] { askName(id); });
    add(tr("&Delete"), tr("Deletes this run; Undo brings it back"), [this, id] { m_comparisons.remove(id); });
}

void RunsMenu::askName(int id)
{
    const Branch *branch = m_comparisons.branches().find(id);
    if (!branch)
        return;
    QWidget *window = parentWidget() ? parentWidget()->window() : nullptr;
    auto *field = new NameField(branch->name, m_theme, window);
    connect(field, &NameField::named, &m_comparisons,
            [runs = &m_comparisons, id](const QString &name) { runs->rename(id, name); });
    field->popupAt(pos());
}

}
