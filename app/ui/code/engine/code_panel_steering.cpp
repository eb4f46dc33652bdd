// Controlling the run from the code: running to a line, breakpoints and the context menu.

#include "app/model/code/code_targets.h"
#include "app/ui/code/breakpoint_list.h"
#include "app/ui/code/engine/code_card.h"
#include "app/ui/code/engine/code_panel.h"
#include "app/ui/code/engine/code_view.h"

#include <QApplication>
#include <QClipboard>

namespace app {

void CodePanel::connectView()
{
    connect(m_view, &CodeView::stopRequested, this, &CodePanel::toggleStop);
    connect(m_view, &CodeView::runRequested, this, &CodePanel::runTo);
    connect(m_view, &CodeView::removedLinesRequested, this, [this] {
        if (m_listing.goneLines() == 0)
            m_session.showMessage(tr("This step removed no lines."));
        else
            m_goneLines->click();
    });
    connect(m_view, &CodeView::menuRequested, this, [this](const QPoint &place, std::size_t row) {
        QMenu *menu = menuFor(row);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->popup(place);
    });
    connect(m_view, &CodeView::rowPointedAt, this, &CodePanel::pointAt);
    connect(m_stops, &BreakpointList::chosen, m_view, &CodeView::showPlace);
    connect(&m_session.playback().breakpoints(), &Breakpoints::changed, this, &CodePanel::showBreakpoints);
    showBreakpoints();
}

void CodePanel::showBreakpoints()
{
    m_view->setBreakpoints(m_session.playback().breakpoints().all());
}

void CodePanel::toggleStop(std::size_t row)
{
    if (row >= m_view->rows().size())
        return; // the code has changed since the menu opened
    const CodeSection &section = m_listing.sections[m_view->rows()[row].section];
    const CodePlace place = m_view->placeOf(row);
    Breakpoints &breakpoints = m_session.playback().breakpoints();
    if (section.role != CodeSection::Role::phase && !breakpoints.at(place)) {
        m_session.showMessage(
            section.role == CodeSection::Role::scene
                ? tr("This line sets the scene up, before the first frame. Choose a line of a phase to stop "
                     "at.")
                : tr("This line says in which order phases run. Choose a line of a phase to stop at."));
        return;
    }
    const bool isSet = breakpoints.toggle(place);
    const QString where = tr("%1, line %2").arg(fileName(place.file)).arg(place.line);
    m_session.showMessage(isSet ? tr("Stops before %1.").arg(where)
                                : tr("No longer stops before %1.").arg(where));
}

void CodePanel::runTo(std::size_t row)
{
    if (row >= m_view->rows().size())
        return;
    const CodeSection &section = m_listing.sections[m_view->rows()[row].section];
    const std::optional<sim::Cursor> target = runTarget(section, m_session.timeline());
    if (!target) {
        m_session.showMessage(
            section.role == CodeSection::Role::scene
                ? tr("This line sets the scene up, before the first frame. Click a line of a phase to run to "
                     "it.")
                : tr("This line says in which order phases run. Click a line of a phase to run to it."));
        return;
    }
    const CodeRow &its = m_view->rows()[row];
    m_ranTo =
        section.lines[its.line].isQuiet ? std::nullopt : std::optional(RanTo{its.section, its.line, *target});
    m_session.preview().end(); // the line under the mouse was marked or previewed
    m_session.playback().runTo(*target);
}

/// Between two frames, a line only marks its phase. Otherwise, moving the mouse across the code would jump in
/// and out of the next frame at every line. Inside a frame, it previews the state after the line's phase.
void CodePanel::pointAt(std::optional<std::size_t> row)
{
    std::optional<sim::Cursor> moment;
    if (row && *row < m_view->rows().size() && !m_session.playback().isPlaying())
        moment = momentOf(m_listing.sections[m_view->rows()[*row].section], m_session.timeline());
    if (!moment) {
        if (m_ownsPreview)
            m_session.preview().end();
        return;
    }
    m_ownsPreview = true;
    if (m_session.timeline().cursor().phase > 0)
        m_session.preview().show(*moment);
    else
        m_session.preview().mark(*moment);
}

QMenu *CodePanel::menuFor(std::size_t row)
{
    auto *menu = new QMenu(this);
    const CodeLine *line = m_view->lineAt(row);
    const CodeSection &section = m_listing.sections[m_view->rows()[row].section];
    if (line && section.role == CodeSection::Role::phase) {
        connect(menu->addAction(tr("Run to here")), &QAction::triggered, this, [this, row] { runTo(row); });
        const Breakpoint *stop = m_session.playback().breakpoints().at(m_view->placeOf(row));
        connect(menu->addAction(stop ? tr("Remove breakpoint") : tr("Set breakpoint")), &QAction::triggered,
                this, [this, row] { toggleStop(row); });
        connect(menu->addAction(tr("Set breakpoint when…")), &QAction::triggered, this, [this, row] {
            const Breakpoints &breakpoints = m_session.playback().breakpoints();
            const CodePlace place = m_view->placeOf(row);
            if (!breakpoints.at(place))
                toggleStop(row);
            if (const Breakpoint *stop = breakpoints.at(place))
                m_stops->edit(stop->id);
        });
        menu->addSeparator();
    }
    QAction *copy = menu->addAction(tr("Copy"));
    copy->setEnabled(m_view->hasSelectedText());
    connect(copy, &QAction::triggered, m_view, &CodeView::copy);
    connect(menu->addAction(tr("Copy “%1”").arg(section.title)), &QAction::triggered, this,
            [text = plainText(section)] { QApplication::clipboard()->setText(text); });
    connect(menu->addAction(tr("Copy all shown code")), &QAction::triggered, this, &CodePanel::copyAll);
    return menu;
}

}
