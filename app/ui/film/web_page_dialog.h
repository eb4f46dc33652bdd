#pragma once

#include "app/model/session/session.h"
#include "app/model/web/web_page.h"
#include "app/ui/film/export_dialog.h"

namespace app {

/// A dialog that asks for the frames of a web page and makes it.
class WebPageDialog : public ExportDialog
{
    Q_OBJECT

public:
    /// `session` must outlive it.
    explicit WebPageDialog(const Session &session, QWidget *parent = nullptr);

    /// Shows the dialog with the frames of the open run. The page gets `plots`, which must name their bodies, and its scene
    /// shows what `switches` say, with the ghost that the window shows when the page is made.
    void offer(std::vector<PlotSpec> plots, const PageSwitches &switches);
    /// Makes the page with the frames of the dialog.
    void makePage(const QString &path);

private:
    void askPath();
    WebPagePlan plan(const QString &path) const;

    const Session &m_session;
    std::vector<PlotSpec> m_plots;
    PageSwitches m_switches;
};

}
