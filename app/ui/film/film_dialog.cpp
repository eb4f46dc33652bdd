#include "app/ui/film/film_dialog.h"

#include "app/ui/dialogs/ask_file.h"
#include "app/ui/dialogs/caption.h"
#include "app/ui/dialogs/dialog_place.h"
#include "app/ui/film/film_name.h"
#include "app/ui/film/film_size.h"
#include "app/ui/film/frame_range.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

namespace app {

namespace {

constexpr int usualRate = 30;

}

FilmDialog::FilmDialog(const Session &session, const SceneView &view, const Theme &theme, QWidget *parent)
    : ExportDialog({tr("Film of the run"), tr("The first frame of the film"),
                    tr("The last frame of the film; the run is computed up to there"),
                    tr("Progress of the film"), tr("Cancel the film (Esc)")},
                   parent),
      m_session(session), m_view(view), m_theme(theme),
      m_rate(makeFrameBox(tr("Frames a second"), tr("The speed of the film: 30 is as fast as in the window"),
                          form().parentWidget())),
      m_size(new FilmSize(*view.viewport(), form().parentWidget())),
      m_name(new FilmName(form().parentWidget()))
{
    m_rate->setRange(1, static_cast<int>(mostGifRate));
    m_rate->setValue(usualRate);
    addRow(form(), tr("Frames a &second"), m_rate, m_rate);
    addRow(form(), tr("&Width"), m_size, &m_size->width());
    addRow(form(), tr("F&ile"), m_name, &m_name->field());
    form().addWidget(
        makeCaption(tr("A name that ends in .webm or .gif makes one file. A name such as walk_%04d.png makes "
                       "a picture of each frame, with its number instead of %04d."),
                    this),
        form().rowCount(), 1);
    complete();
    connect(&makeButton(), &QPushButton::clicked, this, &FilmDialog::start);
    connect(m_name, &FilmName::changed, this, &FilmDialog::clearMessage);
    connect(&range(), &FrameRange::changed, this, [this] {
        m_name->forbidReplacing();
        clearMessage();
    });
}

void FilmDialog::offer()
{
    if (!isMaking()) {
        range().set(0, static_cast<int>(m_session.experiment().frames));
        m_name->suggest(standardFolder(QStandardPaths::PicturesLocation), m_session.step().id);
        m_name->forbidReplacing();
        clearMessage();
    }
    showInFront(*this);
}

FilmPlan FilmDialog::plan() const
{
    FilmPlan plan;
    plan.experiment = m_session.experiment();
    plan.out = m_name->name();
    plan.size = m_size->size();
    plan.scheme = m_theme.scheme();
    plan.extras = m_view.extras();
    plan.from = range().first();
    plan.to = range().last();
    plan.rate = m_rate->value();
    return plan;
}

void FilmDialog::start()
{
    make(m_name->name(), [this]() -> std::unique_ptr<Export> {
        const QString objection = m_name->objection(range().first(), range().last());
        if (!objection.isEmpty()) {
            m_name->allowReplacing();
            setMessage(objection);
            return nullptr;
        }
        auto film = std::make_unique<Film>(plan(), m_session.library());
        m_name->forbidReplacing();
        setMessage(tr("Choosing its colours…"));
        return film;
    });
}

QString FilmDialog::cancelled(std::int64_t frame) const
{
    return filmKind(m_name->name()) == FilmKind::pictures
               ? tr("Cancelled. The pictures up to frame %1 are saved.").arg(frame)
               : ExportDialog::cancelled(frame);
}

void FilmDialog::showState()
{
    ExportDialog::showState();
    const bool replaces = m_name->mayReplace();
    makeButton().setText(replaces ? tr("&Replace") : tr("&Make the film"));
    makeButton().setToolTip(replaces ? tr("Make the film, and overwrite the existing file")
                                     : tr("Make the film; you can use the window meanwhile"));
}

}
