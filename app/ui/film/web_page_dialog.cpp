#include "app/ui/film/web_page_dialog.h"

#include "app/ui/dialogs/ask_file.h"
#include "app/ui/dialogs/caption.h"
#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/film/frame_range.h"
#include "app/ui/film/page_colors.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace app {

namespace {

constexpr int usualFrames = 300; ///< of a run that has not been played yet

}

WebPageDialog::WebPageDialog(const Session &session, QWidget *parent)
    : ExportDialog({tr("Web page of the run"), tr("The first frame of the page"),
                    tr("The last frame of the page; the run is computed up to there"),
                    tr("Progress of the web page"), tr("Cancel the page (Esc)")},
                   parent),
      m_session(session)
{
    column().insertWidget(
        0,
        makeCaption(tr("One file that plays the run in any browser, also without a network: the scene, the "
                       "listing with its values, the plots that are open, and the text of the step."),
                    this));
    complete();
    makeButton().setText(tr("&Save as…"));
    makeButton().setToolTip(tr("Choose a file, and make the page; you can use the window meanwhile"));
    connect(&makeButton(), &QPushButton::clicked, this, &WebPageDialog::askPath);
}

void WebPageDialog::offer(std::vector<PlotSpec> plots, const PageSwitches &switches)
{
    if (!isMaking()) {
        m_plots = std::move(plots);
        m_switches = switches;
        const auto played = static_cast<int>(m_session.experiment().frames);
        range().set(0, played > 1 ? played : usualFrames);
        clearMessage();
    }
    showInFront(*this);
}

void WebPageDialog::askPath()
{
    const QString path = askWhereToSave(this, tr("Web page of the run"), m_session.step().id + pageEnding,
                                        tr("Web pages (*.html)"));
    if (!path.isEmpty())
        makePage(path);
}

void WebPageDialog::makePage(const QString &path)
{
    make(path, [&] { return std::make_unique<WebPage>(plan(path), m_session.library()); });
}

WebPagePlan WebPageDialog::plan(const QString &path) const
{
    WebPagePlan plan;
    plan.experiment = m_session.experiment();
    plan.out = path;
    plan.from = range().first();
    plan.to = range().last();
    plan.plots = m_plots;
    plan.switches = m_switches;
    if (const Branch *ghost = m_session.comparisons().shown())
        plan.ghost = PageGhost{ghost->name, ghost->script};
    plan.light = pageColors(Scheme::light);
    plan.dark = pageColors(Scheme::dark);
    return plan;
}

}
