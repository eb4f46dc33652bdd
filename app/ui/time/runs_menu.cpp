#include "app/ui/time/runs_menu.h"

#include "app/model/difference_words.h"
#include "app/ui/time/name_field.h"

#include <QMetaMethod>

#include <algorithm>

namespace app {

namespace {

/// A text that may have an "&" in it, for a menu.
QString plain(QString text)
{
    return text.replace('&', "&&");
}

}

RunsMenu::RunsMenu(Session &session, const Theme &theme, QWidget *parent)
    : QMenu(tr("Other r&uns"), parent), m_session(session), m_theme(theme)
{
    setObjectName("runs");
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &RunsMenu::fill);
    fill();
}

void RunsMenu::showOnly(int branch)
{
    showOnly(std::vector{branch});
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
    // Menus of runs that are gone go later: one of them may be what is at work.
    for (QMenu *menu : findChildren<QMenu *>(QString(), Qt::FindDirectChildrenOnly))
        menu->deleteLater();
    clear();
    const std::vector<Branch> &all = m_session.branches().all();
    std::vector<const Branch *> shown;
    for (auto branch = all.rbegin(); branch != all.rend(); ++branch) {
        if (m_only.empty() || std::count(m_only.begin(), m_only.end(), branch->id) > 0)
            shown.push_back(&*branch);
    }
    if (m_only.size() == 1 && shown.size() == 1) {
        addDeeds(*this, *shown.front());
        return;
    }
    for (const Branch *branch : shown)
        addRun(*branch);
    if (shown.empty()) {
        QAction *none = addAction(tr("No other run yet"));
        none->setToolTip(tr("Go back in time and change something: the run as it was stays as another run."));
        none->setEnabled(false);
        return;
    }
    addSeparator();
    QAction *hide = addAction(tr("Show none &beside"), this, [this] { m_session.showBeside(0); });
    hide->setEnabled(m_session.beside() != nullptr);
    hide->setToolTip(tr("Only this run is seen; the others stay in this menu"));
    if (!isSignalConnected(QMetaMethod::fromSignal(&RunsMenu::compareWanted)))
        return; // where they are compared already
    QAction *compare = addAction(tr("&Compare in numbers"), this, &RunsMenu::compareWanted);
    compare->setToolTip(tr("How far the two runs are apart, frame by frame"));
}

void RunsMenu::addRun(const Branch &branch)
{
    auto *menu = new QMenu(plain(branchLine(branch, m_session.timeline().script())), this);
    menu->setToolTipsVisible(true);
    if (m_session.beside() == &branch)
        menu->setIcon(m_theme.icon("show"));
    else if (branch.isKept)
        menu->setIcon(m_theme.icon("pin"));
    addDeeds(*menu, branch);
    addMenu(menu);
}

void RunsMenu::addDeeds(QMenu &menu, const Branch &branch)
{
    const int id = branch.id;
    const bool isBeside = m_session.beside() == &branch;
    const auto add = [&](const QString &text, const QString &tip, auto deed) {
        QAction *made = menu.addAction(text, this, deed);
        made->setToolTip(tip);
        return made;
    };
    QAction *show = add(tr("&Show beside"), tr("As a ghost in the picture, and as dots in the timeline"),
                        [this, id, isBeside] { m_session.showBeside(isBeside ? 0 : id); });
    show->setCheckable(true);
    show->setChecked(isBeside);
    add(tr("&Go back to it"), tr("It is the run again, exactly as it was; this run becomes another run"),
        [this, id] { m_session.goBackTo(id); });
    menu.addSeparator();
    QAction *keep = add(tr("&Keep"),
                        tr("It stays until you delete it. Of those that are not kept, the last %1 stay.")
                            .arg(Branches::mostPassing),
                        [this, id, kept = branch.isKept] { m_session.keepBranch(id, !kept); });
    keep->setCheckable(true);
    keep->setChecked(branch.isKept);
    add(tr("&Rename…"), tr("Give this run a name of your own"), [this, id] { askName(id); });
    add(tr("&Delete"), tr("It is gone, unless you undo this"), [this, id] { m_session.deleteBranch(id); });
}

void RunsMenu::askName(int id)
{
    const Branch *branch = m_session.branches().find(id);
    if (!branch)
        return;
    QWidget *window = parentWidget() ? parentWidget()->window() : nullptr;
    auto *field = new NameField(branch->name, m_theme, window);
    connect(field, &NameField::named, &m_session,
            [session = &m_session, id](const QString &name) { session->renameBranch(id, name); });
    field->popupAt(pos());
}

}
