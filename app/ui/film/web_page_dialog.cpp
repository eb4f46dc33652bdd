#include "app/ui/film/web_page_dialog.h"

#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "app/ui/dialogs/ask_file.h"
#include "app/ui/dialogs/caption.h"
#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/film/export_progress.h"
#include "app/ui/film/frame_range.h"
#include "app/ui/film/page_colors.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <utility>

namespace app {

namespace {

constexpr int dialogMargin = 20;
constexpr int dialogWidth = 440;
constexpr int usualFrames = 300; ///< of a run that has not been played yet

}

WebPageDialog::WebPageDialog(const Session &session, QWidget *parent) : QDialog(parent), m_session(session)
{
    setWindowTitle(tr("Web page of the run"));
    setModal(false);
    m_fields = fields();
    m_progress = new ExportProgress(tr("Progress of the web page"), this);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(dialogMargin, dialogMargin, dialogMargin, dialogMargin);
    column->setSpacing(12);
    column->addWidget(makeCaption(
        tr("One file that plays the run in any browser, also without a network: the scene, the listing with "
           "its values, the plots that are open, and the text of the step."),
        this));
    column->addWidget(m_fields);
    column->addWidget(m_progress);
    column->addStretch(1);
    column->addWidget(buttons());
    resize(dialogWidth, column->totalHeightForWidth(dialogWidth));
    connect(&m_next, &QTimer::timeout, this, &WebPageDialog::goOn);
    showState();
}

QWidget *WebPageDialog::fields()
{
    auto *fields = new QWidget(this);
    auto *grid = new QGridLayout(fields);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(10);
    grid->setHorizontalSpacing(12);
    m_range = new FrameRange(*grid, tr("The first frame of the page"),
                             tr("The last frame of the page; the run is computed up to there"));
    grid->setColumnStretch(1, 1);
    return fields;
}

QWidget *WebPageDialog::buttons()
{
    auto *buttons = new QWidget(this);
    auto *row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    m_save = new QPushButton(tr("&Save as…"), buttons);
    m_save->setToolTip(tr("Choose a file, and make the page; you can use the window meanwhile"));
    m_save->setDefault(true);
    m_stop = new QPushButton(buttons);
    m_stop->setAutoDefault(false);
    row->addStretch(1);
    row->addWidget(m_stop);
    row->addWidget(m_save);
    connect(m_save, &QPushButton::clicked, this, &WebPageDialog::askPath);
    connect(m_stop, &QPushButton::clicked, this,
            [this] { isMaking() ? end(tr("Cancelled. No file was written.")) : reject(); });
    return buttons;
}

QString WebPageDialog::message() const
{
    return m_progress->message();
}

void WebPageDialog::offer(std::vector<PlotSpec> plots, const PageSwitches &switches)
{
    if (!isMaking()) {
        m_plots = std::move(plots);
        m_switches = switches;
        const auto played = static_cast<int>(m_session.experiment().frames);
        m_range->set(0, played > 1 ? played : usualFrames);
        m_progress->setMessage({});
        showState();
    }
    placeOverParent(*this);
    show();
    raise();
    activateWindow();
}

void WebPageDialog::askPath()
{
    const QString path = askWhereToSave(this, tr("Web page of the run"), m_session.step().id + pageEnding,
                                        tr("Web pages (*.html)"));
    if (!path.isEmpty())
        make(path);
}

void WebPageDialog::make(const QString &path)
{
    WebPagePlan plan;
    plan.experiment = m_session.experiment();
    plan.out = path;
    plan.from = m_range->first();
    plan.to = m_range->last();
    plan.plots = m_plots;
    plan.switches = m_switches;
    if (const Branch *ghost = m_session.comparisons().shown())
        plan.ghost = PageGhost{ghost->name, ghost->script};
    plan.light = pageColors(Scheme::light);
    plan.dark = pageColors(Scheme::dark);
    m_path = path;
    try {
        m_page = std::make_unique<WebPage>(plan, m_session.library());
        m_next.start(0);
        m_progress->setMessage({});
    } catch (const UserError &error) {
        m_progress->setMessage(error.sentence());
    } catch (const sim::Error &error) {
        m_progress->setMessage(sentenceFor(error));
    }
    showState();
}

void WebPageDialog::goOn()
{
    try {
        if (m_page->goOn()) {
            m_progress->setMessage(tr("Frame %1 of %2").arg(m_page->frame()).arg(m_range->last()));
            showState();
            return;
        }
        const QString why = m_page->endsEarly();
        const QString name = shownPath(QFileInfo(m_path).fileName());
        end(why.isEmpty() ? tr("%1 is saved.").arg(name)
                          : tr("%1 is saved, up to the frame where the run stops. %2").arg(name, why));
    } catch (const UserError &error) {
        end(error.sentence());
    }
}

void WebPageDialog::end(const QString &sentence)
{
    m_next.stop();
    m_page.reset();
    m_progress->setMessage(sentence);
    showState();
}

void WebPageDialog::showState()
{
    m_fields->setEnabled(!isMaking());
    m_save->setEnabled(!isMaking());
    m_stop->setText(isMaking() ? tr("Ca&ncel") : tr("Close"));
    m_stop->setToolTip(isMaking() ? tr("Cancel the page (Esc)") : tr("Close this dialog (Esc)"));
    if (m_page)
        m_progress->showDone(static_cast<int>(m_page->frame()) - m_range->first(),
                             m_range->last() - m_range->first());
    else
        m_progress->hideBar();
}

void WebPageDialog::done(int result)
{
    if (isMaking())
        end(tr("Cancelled. No file was written."));
    QDialog::done(result);
}

}
