#pragma once

#include "app/model/session/session.h"
#include "app/model/web/web_page.h"

#include <QDialog>
#include <QTimer>

class QPushButton;

namespace app {

class ExportProgress;
class FrameRange;

/// A dialog that asks for the frames of a web page and makes it while the window stays usable.
class WebPageDialog : public QDialog
{
    Q_OBJECT

public:
    /// `session` must outlive it.
    explicit WebPageDialog(const Session &session, QWidget *parent = nullptr);

    /// Shows the dialog with the frames of the open run. The page gets `plots`, which must name their bodies, and its scene
    /// shows what `switches` say, with the ghost that the window shows when the page is made.
    void offer(std::vector<PlotSpec> plots, const PageSwitches &switches);
    /// Makes the page with the frames of the dialog.
    void make(const QString &path);
    bool isMaking() const { return m_page != nullptr; }
    /// Returns the message at the bottom: the progress, or how it ended.
    QString message() const;
    void done(int result) override;

private:
    QWidget *fields();
    QWidget *buttons();
    void askPath();
    void goOn();
    void end(const QString &sentence);
    void showState();

    const Session &m_session;
    std::vector<PlotSpec> m_plots;
    PageSwitches m_switches;
    FrameRange *m_range;
    QWidget *m_fields; ///< all settings
    ExportProgress *m_progress;
    QPushButton *m_save;
    QPushButton *m_stop;
    std::unique_ptr<WebPage> m_page;
    QString m_path;
    QTimer m_next; ///< for the next piece; active while a page is made
};

}
