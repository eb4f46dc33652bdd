#include "app/ui/sandbox/name_row.h"

#include "app/ui/sandbox/property_row.h"

#include <QFocusEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace app {

NameRow::NameRow(SandboxEditor &editor, int point, const QString &section, QWidget *parent)
    : QWidget(parent), m_editor(editor), m_point(point), m_field(new QLineEdit(this)),
      m_whyNot(new QLabel(this))
{
    auto *label = new QLabel(tr("Name"), this);
    label->setMinimumWidth(PropertyRow::labelWidth);
    label->setBuddy(m_field);
    m_field->setObjectName("bodyName");
    setSection(section);
    m_field->setAcceptDrops(false); // the window takes files
    m_field->installEventFilter(this);
    m_whyNot->setObjectName("failure");
    m_whyNot->setWordWrap(true);
    m_whyNot->hide();
    auto *row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(label);
    row->addWidget(m_field, 1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(PropertyRow::margin, 2, PropertyRow::margin, 2);
    column->setSpacing(4);
    column->addLayout(row);
    column->addWidget(m_whyNot);
    setToolTip(tr("The name of the point in files, in “Stop when…”, and in lessons and their listings. Press "
                  "Enter to apply."));
    m_field->setAccessibleDescription(toolTip());
    connect(m_field, &QLineEdit::textEdited, this, [this] { showWhyNot({}); });
    connect(m_field, &QLineEdit::returnPressed, this, &NameRow::enter);
    connect(m_field, &QLineEdit::editingFinished, this, &NameRow::leave);
    reset();
}

void NameRow::setSection(const QString &section)
{
    m_field->setAccessibleName(section + ": " + tr("Name"));
}

QString NameRow::whyNot() const
{
    return m_whyNot->isHidden() ? QString() : m_whyNot->text();
}

void NameRow::discard()
{
    m_field->disconnect(this);
}

QString NameRow::typed() const
{
    return m_field->text().trimmed();
}

bool NameRow::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::FocusIn)
        m_byMouse = static_cast<QFocusEvent *>(event)->reason() == Qt::MouseFocusReason;
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape) {
        reset();
        m_field->selectAll();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void NameRow::enter()
{
    showWhyNot(m_editor.whyNotCalled(m_point, typed()));
    if (!whyNot().isEmpty())
        return;
    if (m_byMouse) {
        m_field->clearFocus(); // so that the next keys go to the run; it applies the name
        return;
    }
    m_editor.rename(m_point, typed());
    reset();
    m_field->selectAll();
}

void NameRow::leave()
{
    if (m_field->hasFocus()) // Enter has been pressed
        return;
    m_editor.rename(m_point, typed());
    reset();
}

void NameRow::showWhyNot(const QString &sentence)
{
    m_whyNot->setText(sentence);
    m_whyNot->setVisible(!sentence.isEmpty());
}

void NameRow::refresh()
{
    if (!m_field->hasFocus() || !m_field->isModified())
        reset();
}

void NameRow::reset()
{
    showWhyNot({});
    if (m_editor.isOpen() && std::size_t(m_point) < m_editor.plan().points.size())
        m_field->setText(QString::fromStdString(m_editor.plan().points[std::size_t(m_point)].name));
}

}
