#include "app/ui/time/name_field.h"

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>

#include <algorithm>

namespace app {

namespace {

constexpr int mostLetters = 60;
constexpr int fieldWidth = 260; ///< px

}

NameField::NameField(const QString &name, const Theme &theme, QWidget *parent)
    : QFrame(parent, Qt::Popup), m_edit(new QLineEdit(name, this))
{
    setObjectName("nameField");
    setAttribute(Qt::WA_DeleteOnClose);
    setFont(theme.ui());
    auto *label = new QLabel(tr("Name"), this);
    label->setBuddy(m_edit);
    m_edit->setMaxLength(mostLetters);
    m_edit->setMinimumWidth(fieldWidth);
    m_edit->setAccessibleName(tr("Name of the run"));
    m_edit->setToolTip(tr("Press Return to apply, Esc to cancel"));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(12, 8, 12, 8);
    row->setSpacing(8);
    row->addWidget(label);
    row->addWidget(m_edit);
    connect(m_edit, &QLineEdit::returnPressed, this, [this] {
        emit named(m_edit->text());
        close();
    });
}

void NameField::popupAt(const QPoint &place)
{
    show(); // the layout has its sizes only from here on
    adjustSize();
    const QScreen *screen = QGuiApplication::screenAt(place);
    const QRect room = (screen ? screen : QGuiApplication::primaryScreen())->availableGeometry();
    move(std::clamp(place.x(), room.left(), std::max(room.left(), room.right() - width())),
         std::clamp(place.y(), room.top(), std::max(room.top(), room.bottom() - height())));
    m_edit->selectAll();
    m_edit->setFocus(Qt::PopupFocusReason);
}

}
