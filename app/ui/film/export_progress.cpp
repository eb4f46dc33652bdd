#include "app/ui/film/export_progress.h"

#include "app/ui/dialogs/caption.h"

#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

ExportProgress::ExportProgress(const QString &name, QWidget *parent)
    : QWidget(parent), m_bar(new QProgressBar(this)), m_message(makeCaption({}, this))
{
    m_bar->setTextVisible(false);
    m_bar->setFixedHeight(6);
    m_bar->setAccessibleName(name);
    QSizePolicy keepsRoom = m_bar->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    m_bar->setSizePolicy(keepsRoom);
    m_bar->hide(); // until there is progress to show
    m_message->setMinimumHeight(2 * m_message->fontMetrics().lineSpacing());
    m_message->setAlignment(Qt::AlignTop);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    column->addWidget(m_bar);
    column->addWidget(m_message);
}

QString ExportProgress::message() const
{
    return m_message->text();
}

void ExportProgress::setMessage(const QString &sentence)
{
    m_message->setText(sentence);
}

void ExportProgress::showDone(int done, int total)
{
    m_bar->setRange(0, std::max(1, total));
    m_bar->setValue(done);
    m_bar->show();
}

void ExportProgress::hideBar()
{
    m_bar->hide();
}

}
