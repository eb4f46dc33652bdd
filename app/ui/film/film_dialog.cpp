#include "app/ui/film/film_dialog.h"

#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "app/ui/dialogs/caption.h"
#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/film/export_progress.h"
#include "app/ui/film/film_name.h"
#include "app/ui/film/film_size.h"
#include "app/ui/film/frame_range.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>

namespace app {

namespace {

constexpr int margin = 20;
constexpr int pageWidth = 460;
constexpr int usualRate = 30;

QString folder()
{
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QDir(pictures).exists() ? pictures : QDir::homePath();
}

}

FilmDialog::FilmDialog(const Session &session, const SceneView &view, const Theme &theme, QWidget *parent)
    : QDialog(parent), m_session(session), m_view(view), m_theme(theme)
{
    setWindowTitle(tr("Film of the run"));
    setModal(false);
    m_fields = fields();
    m_progress = new ExportProgress(tr("Progress of the film"), this);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(12);
    column->addWidget(m_fields);
    column->addWidget(m_progress);
    column->addStretch(1);
    column->addWidget(buttons());
    resize(pageWidth, column->totalHeightForWidth(pageWidth));
    connect(&m_next, &QTimer::timeout, this, &FilmDialog::goOn);
    connect(m_name, &FilmName::changed, this, &FilmDialog::clearMessage);
    connect(m_range, &FrameRange::changed, this, [this] {
        m_name->forbidReplacing();
        clearMessage();
    });
    showState();
}

QWidget *FilmDialog::fields()
{
    auto *fields = new QWidget(this);
    auto *grid = new QGridLayout(fields);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(10);
    grid->setHorizontalSpacing(12);
    m_range = new FrameRange(*grid, tr("The first frame of the film"),
                             tr("The last frame of the film; the run is computed up to there"));
    m_rate = makeFrameBox(tr("Frames a second"), tr("The speed of the film: 30 is as fast as in the window"),
                          fields);
    m_rate->setRange(1, static_cast<int>(mostGifRate));
    m_rate->setValue(usualRate);
    m_size = new FilmSize(*m_view.viewport(), fields);
    addRow(*grid, tr("Frames a &second"), m_rate, m_rate);
    addRow(*grid, tr("&Width"), m_size, &m_size->width());
    m_name = new FilmName(fields);
    addRow(*grid, tr("F&ile"), m_name, &m_name->field());
    grid->setColumnStretch(1, 1);
    grid->addWidget(
        makeCaption(tr("A name that ends in .webm or .gif makes one file. A name such as walk_%04d.png makes "
                       "a picture of each frame, with its number instead of %04d."),
                    fields),
        grid->rowCount(), 1);
    return fields;
}

QWidget *FilmDialog::buttons()
{
    auto *buttons = new QWidget(this);
    auto *row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    m_make = new QPushButton(buttons);
    m_make->setDefault(true);
    m_stop = new QPushButton(buttons);
    m_stop->setAutoDefault(false);
    row->addStretch(1);
    row->addWidget(m_stop);
    row->addWidget(m_make);
    connect(m_make, &QPushButton::clicked, this, &FilmDialog::start);
    connect(m_stop, &QPushButton::clicked, this, [this] { isMaking() ? stop() : reject(); });
    return buttons;
}

QString FilmDialog::message() const
{
    return m_progress->message();
}

void FilmDialog::offer()
{
    if (!isMaking()) {
        m_range->set(0, static_cast<int>(m_session.experiment().frames));
        m_name->suggest(folder(), m_session.step().id);
        m_name->forbidReplacing();
        clearMessage();
    }
    placeOverParent(*this);
    show();
    raise();
    activateWindow();
}

/// Clears the message: it was about the previous settings.
void FilmDialog::clearMessage()
{
    if (isMaking())
        return;
    m_progress->setMessage({});
    showState();
}

FilmPlan FilmDialog::plan() const
{
    FilmPlan plan;
    plan.experiment = m_session.experiment();
    plan.out = m_name->name();
    plan.size = m_size->size();
    plan.scheme = m_theme.scheme();
    plan.extras = m_view.extras();
    plan.from = m_range->first();
    plan.to = m_range->last();
    plan.rate = m_rate->value();
    return plan;
}

void FilmDialog::start()
{
    m_making = m_name->name();
    try {
        const QString objection = m_name->objection(m_range->first(), m_range->last());
        if (!objection.isEmpty()) {
            m_name->allowReplacing();
            showState();
            m_progress->setMessage(objection);
            return;
        }
        m_film = std::make_unique<Film>(plan(), m_session.library());
        m_next.start(0);
        m_progress->setMessage(tr("Choosing its colours…"));
    } catch (const UserError &error) {
        m_progress->setMessage(error.sentence());
    } catch (const sim::Error &error) {
        m_progress->setMessage(sentenceFor(error));
    }
    showState();
}

void FilmDialog::goOn()
{
    try {
        if (m_film->goOn()) {
            m_progress->setMessage(tr("Frame %1 of %2").arg(m_film->frame()).arg(m_range->last()));
            showState();
            return;
        }
        const QString why = m_film->endsEarly();
        const QString name = shownPath(QFileInfo(m_making).fileName());
        const auto all = static_cast<int>(m_film->total());
        end(why.isEmpty() ? tr("%1 is saved.").arg(name)
                          : tr("%1 is saved, up to the frame where the run stops. %2").arg(name, why));
        m_progress->showDone(all, all);
    } catch (const UserError &error) {
        end(error.sentence());
    }
}

void FilmDialog::stop()
{
    const bool isOne = filmKind(m_making) != FilmKind::pictures;
    end(isOne ? tr("Cancelled. No file was written.")
              : tr("Cancelled. The pictures up to frame %1 are saved.").arg(m_film->frame()));
}

void FilmDialog::end(const QString &sentence)
{
    m_next.stop();
    m_film.reset();
    m_name->forbidReplacing();
    m_progress->setMessage(sentence);
    showState();
}

void FilmDialog::showState()
{
    m_fields->setEnabled(!isMaking());
    m_make->setEnabled(!isMaking());
    const bool replaces = m_name->mayReplace() && !isMaking();
    m_make->setText(replaces ? tr("&Replace") : tr("&Make the film"));
    m_make->setToolTip(replaces ? tr("Make the film, and overwrite the existing file")
                                : tr("Make the film; you can use the window meanwhile"));
    m_stop->setText(isMaking() ? tr("Ca&ncel") : tr("Close"));
    m_stop->setToolTip(isMaking() ? tr("Cancel the film (Esc)") : tr("Close this page (Esc)"));
    if (m_film)
        m_progress->showDone(static_cast<int>(m_film->done()), static_cast<int>(m_film->total()));
    else
        m_progress->hideBar();
}

void FilmDialog::done(int result)
{
    if (isMaking())
        stop();
    QDialog::done(result);
}

}
