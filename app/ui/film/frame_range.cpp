#include "app/ui/film/frame_range.h"

#include "app/model/experiment/experiment.h"

#include <QGridLayout>
#include <QLabel>
#include <QSpinBox>

namespace app {

QSpinBox *makeFrameBox(const QString &name, const QString &help, QWidget *parent)
{
    auto *box = new QSpinBox(parent);
    box->setRange(0, static_cast<int>(mostFrames));
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setAlignment(Qt::AlignRight);
    box->setAccessibleName(name);
    box->setToolTip(help);
    box->setFixedWidth(96);
    return box;
}

void addRow(QGridLayout &form, const QString &caption, QWidget *field, QWidget *buddy)
{
    const int row = form.rowCount();
    auto *label = new QLabel(caption, form.parentWidget());
    label->setBuddy(buddy);
    form.addWidget(label, row, 0);
    form.addWidget(field, row, 1, field == buddy ? Qt::AlignLeft : Qt::Alignment());
}

FrameRange::FrameRange(QGridLayout &form, const QString &firstHelp, const QString &lastHelp)
    : QObject(form.parentWidget()), m_first(makeFrameBox(tr("First frame"), firstHelp, form.parentWidget())),
      m_last(makeFrameBox(tr("Last frame"), lastHelp, form.parentWidget()))
{
    addRow(form, tr("&First frame"), m_first, m_first);
    addRow(form, tr("&Last frame"), m_last, m_last);
    for (const QSpinBox *box : {m_first, m_last})
        connect(box, &QSpinBox::valueChanged, this, &FrameRange::changed);
}

int FrameRange::first() const
{
    return m_first->value();
}

int FrameRange::last() const
{
    return m_last->value();
}

void FrameRange::set(int first, int last)
{
    m_first->setValue(first);
    m_last->setValue(last);
}

}
