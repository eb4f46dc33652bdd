#include "app/ui/panels/card_gallery.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QScreen>
#include <QToolButton>

#include <algorithm>

namespace app {

namespace {

constexpr int margin = 12;
constexpr int gap = 4;          ///< px between the gallery and what it hangs from
constexpr QSize around{12, 34}; ///< px of a card beside its picture

/// How many cards farther a key goes; 0: it is none of these.
int wayOf(int key, int columns)
{
    switch (key) {
    case Qt::Key_Right:
        return 1;
    case Qt::Key_Left:
        return -1;
    case Qt::Key_Down:
        return columns;
    case Qt::Key_Up:
        return -columns;
    default:
        return 0;
    }
}

}

CardGallery::CardGallery(const Shape &shape, const Theme &theme, QWidget *parent)
    : QFrame(parent, Qt::Popup), m_shape(shape), m_theme(theme), m_grid(new QGridLayout(this))
{
    setObjectName("gallery");
    setAttribute(Qt::WA_StyledBackground);
    m_grid->setContentsMargins(margin, margin, margin, margin);
    m_grid->setSpacing(8);
    connect(&m_later, &QTimer::timeout, this, &CardGallery::paintNext);
}

void CardGallery::popUp(const QWidget &anchor)
{
    fill();
    adjustSize();
    const QRect room = anchor.screen()->availableGeometry();
    const QPoint corner = anchor.mapToGlobal(QPoint(0, 0));
    const int below = corner.y() + anchor.height() + gap;
    const bool fits = below + height() <= room.bottom();
    const int x = m_shape.edge == Edge::left ? corner.x() : corner.x() + anchor.width() - width();
    move(std::clamp(x, room.left(), std::max(room.left(), room.right() - width())),
         fits ? below : std::max(room.top(), corner.y() - gap - height()));
    show();
    if (!m_cards.empty())
        m_cards.front()->setFocus(Qt::PopupFocusReason);
}

void CardGallery::fill()
{
    qDeleteAll(m_cards);
    m_cards.clear();
    for (const Card &card : contents()) {
        const std::size_t index = m_cards.size();
        m_cards.push_back(button(card, index));
        const int place = static_cast<int>(index);
        m_grid->addWidget(m_cards.back(), place / m_shape.columns, place % m_shape.columns);
    }
    m_painted = 0;
    m_later.start(0);
}

void CardGallery::paintNext()
{
    // One at a time: the gallery is there at once, and can be used before all of it is painted.
    if (!isVisible() || m_painted >= m_cards.size()) {
        m_later.stop();
        return;
    }
    const std::size_t index = m_painted++;
    m_cards[index]->setIcon(picture(index));
}

QToolButton *CardGallery::button(const Card &card, std::size_t index)
{
    auto *button = new QToolButton(this);
    button->setObjectName("card");
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(m_shape.picture);
    QPixmap blank(m_shape.picture);
    blank.fill(m_theme.tokens().sunk);
    button->setIcon(blank);
    button->setText(card.title);
    button->setFont(m_theme.ui());
    button->setToolTip(card.tip);
    button->setAccessibleName(card.title);
    button->setAccessibleDescription(card.help);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setFixedSize(m_shape.picture + around);
    button->installEventFilter(this);
    connect(button, &QToolButton::clicked, this, [this, index] {
        close();
        take(index);
    });
    return button;
}

bool CardGallery::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress)
        return QFrame::eventFilter(watched, event);
    // A button takes arrow keys for the next and the previous one, whatever stands above and below.
    const int way = wayOf(static_cast<QKeyEvent *>(event)->key(), m_shape.columns);
    const auto to = std::find(m_cards.begin(), m_cards.end(), watched) - m_cards.begin() + way;
    if (way != 0 && to >= 0 && to < static_cast<std::ptrdiff_t>(m_cards.size()))
        m_cards[static_cast<std::size_t>(to)]->setFocus(Qt::TabFocusReason);
    return way != 0;
}

}
