#include "app/ui/dock/card_gallery.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QScreen>
#include <QToolButton>

#include <algorithm>

namespace app {

namespace {

constexpr int cardMargin = 12;
constexpr int cardGap = 4; ///< px between the gallery and its anchor

}

CardGallery::CardGallery(QSize picture, int columns, const Theme &theme, QWidget *parent)
    : QFrame(parent, Qt::Popup), m_picture(picture), m_columns(columns), m_theme(theme),
      m_grid(new QGridLayout(this))
{
    setObjectName("gallery");
    setAttribute(Qt::WA_StyledBackground);
    m_grid->setContentsMargins(cardMargin, cardMargin, cardMargin, cardMargin);
    m_grid->setSpacing(8);
    connect(&m_timer, &QTimer::timeout, this, &CardGallery::paintNext);
}

void CardGallery::popUp(QWidget &anchor)
{
    m_anchor = &anchor;
    fill();
    adjustSize();
    const QRect room = anchor.screen()->availableGeometry();
    const QRect from(anchor.mapToGlobal(QPoint()), anchor.size());
    const int below = from.bottom() + 1 + cardGap;
    const bool fits = below + height() <= room.bottom();
    const bool isRight = from.center().x() > anchor.window()->geometry().center().x();
    const int x = isRight ? from.right() + 1 - width() : from.left();
    move(std::clamp(x, room.left(), std::max(room.left(), room.right() - width())),
         fits ? below : std::max(room.top(), from.top() - cardGap - height()));
    show();
    if (!m_buttons.empty())
        m_buttons.front()->setFocus(Qt::PopupFocusReason);
}

void CardGallery::hideEvent(QHideEvent *event)
{
    QFrame::hideEvent(event);
    if (!m_anchor)
        return;
    // The anchor got no leave event, because this pop-up had grabbed the mouse.
    m_anchor->setAttribute(Qt::WA_UnderMouse,
                           m_anchor->rect().contains(m_anchor->mapFromGlobal(QCursor::pos())));
    m_anchor->update();
}

void CardGallery::fill()
{
    qDeleteAll(m_buttons);
    m_buttons.clear();
    m_cards = entries();
    for (std::size_t i = 0; i < m_cards.size(); ++i) {
        m_buttons.push_back(buttonOf(i));
        const int place = static_cast<int>(i);
        m_grid->addWidget(m_buttons.back(), place / m_columns, place % m_columns);
    }
    m_painted = 0;
    m_timer.start(0);
}

void CardGallery::paintNext()
{
    // Pictures are painted one at a time, so that the gallery opens at once and can be used meanwhile.
    if (!isVisible() || m_painted >= m_cards.size()) {
        m_timer.stop();
        return;
    }
    const GalleryCard &card = m_cards[m_painted];
    const QString key = card.key + '/' + QString::number(int(m_theme.scheme()));
    auto found = m_pictures.find(key);
    if (found == m_pictures.end())
        found = m_pictures.emplace(key, card.picture(m_picture)).first;
    m_buttons[m_painted++]->setIcon(found->second);
}

QToolButton *CardGallery::buttonOf(std::size_t number)
{
    const GalleryCard &card = m_cards[number];
    auto *button = new QToolButton(this);
    button->setObjectName("card");
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(m_picture);
    QPixmap blank(m_picture);
    blank.fill(m_theme.tokens().sunk);
    button->setIcon(blank);
    button->setText(card.title);
    button->setFont(m_theme.ui());
    button->setToolTip(card.tip);
    button->setAccessibleName(card.title);
    button->setAccessibleDescription(card.help);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setFixedSize(m_picture + QSize(12, 34));
    button->installEventFilter(this);
    connect(button, &QToolButton::clicked, this, [this, take = card.take] {
        close();
        take();
    });
    return button;
}

bool CardGallery::eventFilter(QObject *watched, QEvent *event)
{
    // By default a button uses any arrow key to go to the next or the previous button, and ignores the grid.
    if (event->type() == QEvent::KeyPress)
        return goFrom(watched, static_cast<QKeyEvent *>(event)->key());
    return QFrame::eventFilter(watched, event);
}

bool CardGallery::goFrom(const QObject *button, int key)
{
    if (key == Qt::Key_Return || key == Qt::Key_Enter) { // a tool button handles only Space
        const auto chosen = std::find(m_buttons.begin(), m_buttons.end(), button);
        if (chosen != m_buttons.end())
            (*chosen)->click();
        return chosen != m_buttons.end();
    }
    int step = 0;
    if (key == Qt::Key_Right)
        step = 1;
    else if (key == Qt::Key_Left)
        step = -1;
    else if (key == Qt::Key_Down)
        step = m_columns;
    else if (key == Qt::Key_Up)
        step = -m_columns;
    const auto to = std::find(m_buttons.begin(), m_buttons.end(), button) - m_buttons.begin() + step;
    if (to >= 0 && to < static_cast<std::ptrdiff_t>(m_buttons.size()))
        m_buttons[static_cast<std::size_t>(to)]->setFocus(Qt::TabFocusReason);
    return step != 0;
}

}
