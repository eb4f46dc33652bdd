#include "app/ui/panels/preset_gallery.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QScreen>
#include <QToolButton>

#include <algorithm>

namespace app {

namespace {

constexpr int columns = 3;
constexpr int margin = 12;
constexpr int gap = 4; ///< between the gallery and what it hangs from

}

PresetGallery::PresetGallery(Session &session, const Theme &theme, PresetPainter painter, QWidget *parent)
    : QFrame(parent, Qt::Popup), m_session(session), m_theme(theme), m_painter(std::move(painter)),
      m_grid(new QGridLayout(this))
{
    setObjectName("gallery");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Presets"));
    m_grid->setContentsMargins(margin, margin, margin, margin);
    m_grid->setSpacing(8);
    connect(&m_later, &QTimer::timeout, this, &PresetGallery::paintNext);
}

void PresetGallery::popUp(const QWidget &anchor)
{
    fill();
    adjustSize();
    const QRect room = anchor.screen()->availableGeometry();
    const QPoint top = anchor.mapToGlobal(QPoint(anchor.width(), 0));
    const int below = top.y() + anchor.height() + gap;
    const bool fits = below + height() <= room.bottom();
    const int x = std::clamp(top.x() - width(), room.left(), std::max(room.left(), room.right() - width()));
    move(x, fits ? below : std::max(room.top(), top.y() - gap - height()));
    show();
    if (!m_cards.empty())
        m_cards.front()->setFocus(Qt::PopupFocusReason);
}

void PresetGallery::fill()
{
    qDeleteAll(m_cards);
    m_cards.clear();
    for (const lessons::Preset &preset : m_session.step().presetGallery) {
        const int index = static_cast<int>(m_cards.size());
        m_cards.push_back(card(preset));
        m_grid->addWidget(m_cards.back(), index / columns, index % columns);
    }
    m_painted = 0;
    m_later.start(0);
}

void PresetGallery::paintNext()
{
    // One at a time: the gallery is there at once, and can be used before all of it is painted.
    if (!isVisible() || m_painted >= m_cards.size()) {
        m_later.stop();
        return;
    }
    const lessons::Step &step = m_session.step();
    const lessons::Preset &preset = step.presetGallery[m_painted];
    const QString key = m_session.lesson().id + '/' + step.id + '/' + preset.title + '/' +
                        QString::number(int(m_theme.scheme()));
    auto found = m_pictures.find(key);
    if (found == m_pictures.end())
        found = m_pictures.emplace(key, m_painter(step, preset, pictureSize)).first;
    m_cards[m_painted++]->setIcon(found->second);
}

QToolButton *PresetGallery::card(const lessons::Preset &preset)
{
    auto *card = new QToolButton(this);
    card->setObjectName("card");
    card->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    card->setIconSize(pictureSize);
    QPixmap blank(pictureSize);
    blank.fill(m_theme.tokens().sunk);
    card->setIcon(blank);
    card->setText(preset.title);
    card->setFont(m_theme.ui());
    card->setToolTip(tr("%1 Starts this step anew.").arg(preset.help));
    card->setAccessibleName(preset.title);
    card->setAccessibleDescription(preset.help);
    card->setFocusPolicy(Qt::StrongFocus);
    card->setFixedSize(pictureSize + QSize(12, 34));
    card->installEventFilter(this);
    connect(card, &QToolButton::clicked, this, [this, preset] { choose(preset); });
    return card;
}

void PresetGallery::choose(const lessons::Preset &preset)
{
    close();
    m_session.startWith(preset);
}

bool PresetGallery::eventFilter(QObject *watched, QEvent *event)
{
    // A button takes arrow keys for the next and the previous one, whatever stands above and below.
    if (event->type() == QEvent::KeyPress)
        return goFrom(static_cast<QToolButton *>(watched), static_cast<QKeyEvent *>(event)->key());
    return QFrame::eventFilter(watched, event);
}

bool PresetGallery::goFrom(const QToolButton *card, int key)
{
    int step = 0;
    if (key == Qt::Key_Right)
        step = 1;
    else if (key == Qt::Key_Left)
        step = -1;
    else if (key == Qt::Key_Down)
        step = columns;
    else if (key == Qt::Key_Up)
        step = -columns;
    const auto from = std::find(m_cards.begin(), m_cards.end(), card) - m_cards.begin();
    const auto to = from + step;
    if (to >= 0 && to < static_cast<std::ptrdiff_t>(m_cards.size()))
        m_cards[static_cast<std::size_t>(to)]->setFocus(Qt::TabFocusReason);
    return step != 0;
}

}
