#include "app/ui/film/export_dialog.h"

#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "app/ui/dialogs/caption.h"
#include "app/ui/film/frame_range.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

namespace app {

namespace {

constexpr int dialogMargin = 20;
constexpr int dialogWidth = 460;

}

ExportDialog::ExportDialog(const ExportTexts &texts, QWidget *parent)
    : QDialog(parent), m_cancelHelp(texts.cancel), m_column(new QVBoxLayout(this)),
      m_settings(new QWidget(this)), m_form(new QGridLayout(m_settings)),
      m_range(new FrameRange(*m_form, texts.first, texts.last)), m_bar(new QProgressBar(this)),
      m_message(makeCaption({}, this))
{
    setWindowTitle(texts.title);
    setModal(false);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setVerticalSpacing(10);
    m_form->setHorizontalSpacing(12);
    m_form->setColumnStretch(1, 1);
    m_bar->setTextVisible(false);
    m_bar->setFixedHeight(6);
    m_bar->setAccessibleName(texts.progress);
    QSizePolicy keepsRoom = m_bar->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    m_bar->setSizePolicy(keepsRoom);
    m_message->setMinimumHeight(2 * m_message->fontMetrics().lineSpacing());
    m_message->setAlignment(Qt::AlignTop);
    m_column->setContentsMargins(dialogMargin, dialogMargin, dialogMargin, dialogMargin);
    m_column->setSpacing(12);
    m_column->addWidget(m_settings);
    m_column->addWidget(m_bar);
    m_column->addWidget(m_message);
    m_column->addStretch(1);
    connect(&m_next, &QTimer::timeout, this, &ExportDialog::goOn);
}

ExportDialog::~ExportDialog() = default;

void ExportDialog::complete()
{
    m_make = new QPushButton(this);
    m_make->setDefault(true);
    m_stop = new QPushButton(this);
    m_stop->setAutoDefault(false);
    auto *row = new QHBoxLayout;
    row->setSpacing(8);
    row->addStretch(1);
    row->addWidget(m_stop);
    row->addWidget(m_make);
    m_column->addLayout(row);
    connect(m_stop, &QPushButton::clicked, this, [this] { isMaking() ? cancel() : reject(); });
    showState();
    resize(dialogWidth, m_column->totalHeightForWidth(dialogWidth));
}

QString ExportDialog::message() const
{
    return m_message->text();
}

void ExportDialog::setMessage(const QString &sentence)
{
    m_message->setText(sentence);
    if (const int needed = m_column->totalHeightForWidth(width()); needed > height())
        resize(width(), needed); // a long message would squeeze the texts above it
}

void ExportDialog::clearMessage()
{
    if (isMaking())
        return;
    setMessage({});
    showState();
}

void ExportDialog::make(const QString &path, const std::function<std::unique_ptr<Export>()> &begin)
{
    m_path = path;
    try {
        setMessage({});
        m_export = begin();
        if (m_export)
            m_next.start(0);
    } catch (const UserError &error) {
        setMessage(error.sentence());
    } catch (const sim::Error &error) {
        setMessage(sentenceFor(error));
    }
    showState();
}

void ExportDialog::goOn()
{
    try {
        if (m_export->goOn()) {
            setMessage(tr("Frame %1 of %2").arg(m_export->frame()).arg(m_range->last()));
            showState();
            return;
        }
        const QString why = m_export->endsEarly();
        const QString name = shownPath(QFileInfo(m_path).fileName());
        end(why.isEmpty() ? tr("%1 is saved.").arg(name)
                          : tr("%1 is saved, up to the frame where the run stops. %2").arg(name, why));
        m_bar->setValue(m_bar->maximum());
        m_bar->show();
    } catch (const UserError &error) {
        end(error.sentence());
    }
}

void ExportDialog::cancel()
{
    end(cancelled(m_export->frame()));
}

QString ExportDialog::cancelled(std::int64_t) const
{
    return tr("Cancelled. No file was written.");
}

void ExportDialog::end(const QString &sentence)
{
    m_next.stop();
    m_export.reset();
    setMessage(sentence);
    showState();
}

void ExportDialog::showState()
{
    m_settings->setEnabled(!isMaking());
    m_make->setEnabled(!isMaking());
    m_stop->setText(isMaking() ? tr("Ca&ncel") : tr("Close"));
    m_stop->setToolTip(isMaking() ? m_cancelHelp : tr("Close this dialog (Esc)"));
    m_bar->setVisible(isMaking());
    if (m_export) {
        m_bar->setRange(0, static_cast<int>(std::max<std::int64_t>(1, m_export->total())));
        m_bar->setValue(static_cast<int>(m_export->done()));
    }
}

void ExportDialog::done(int result)
{
    if (isMaking())
        cancel();
    QDialog::done(result);
}

}
