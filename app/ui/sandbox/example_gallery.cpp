#include "app/ui/sandbox/example_gallery.h"

#include "app/model/workshop.h"
#include "app/ui/scene/thumbnail.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QScreen>
#include <QToolButton>

#include <algorithm>

namespace app {

namespace {

constexpr int columns = 4;
constexpr int margin = 12;
constexpr int gap = 4;            ///< px between the gallery and what it hangs from
constexpr int pictureFrames = 24; ///< at which an example shows what it is

/// The example as a picture; empty where its file cannot be read.
QPixmap pictureOf(const Session &session, const lessons::Example &example, const Theme &theme, QSize size)
{
    try {
        const sim::Script script = readExperiment(example.file, session.library()).script;
        lessons::Step step = session.step();
        step.opening = [script](sim::Script &opened) { opened = script; };
        return thumbnail(step, script.values, theme, size, pictureFrames);
    } catch (const Refusal &) {
        return {}; // a click says why
    }
}

}

ExampleGallery::ExampleGallery(Session &session, const Theme &theme, QWidget *parent)
    : QFrame(parent, Qt::Popup), m_session(session), m_theme(theme), m_grid(new QGridLayout(this))
{
    setObjectName("gallery");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Examples"));
    m_grid->setContentsMargins(margin, margin, margin, margin);
    m_grid->setSpacing(8);
    connect(&m_later, &QTimer::timeout, this, &ExampleGallery::paintNext);
}

void ExampleGallery::popUp(const QWidget &anchor)
{
    fill();
    adjustSize();
    const QRect room = anchor.screen()->availableGeometry();
    const QPoint corner = anchor.mapToGlobal(QPoint(0, 0));
    const int x = std::clamp(corner.x(), room.left(), std::max(room.left(), room.right() - width()));
    move(x, std::max(room.top(), corner.y() - gap - height()));
    show();
    if (!m_cards.empty())
        m_cards.front()->setFocus(Qt::PopupFocusReason);
}

void ExampleGallery::fill()
{
    qDeleteAll(m_cards);
    m_cards.clear();
    for (const lessons::Example &example : m_session.step().examples) {
        const int index = static_cast<int>(m_cards.size());
        m_cards.push_back(card(example));
        m_grid->addWidget(m_cards.back(), index / columns, index % columns);
    }
    m_painted = 0;
    m_later.start(0);
}

void ExampleGallery::paintNext()
{
    // One at a time: the gallery is there at once, and can be used before all of it is painted.
    if (!isVisible() || m_painted >= m_cards.size()) {
        m_later.stop();
        return;
    }
    const lessons::Example &example = m_session.step().examples[m_painted];
    m_cards[m_painted++]->setIcon(pictureOf(m_session, example, m_theme, pictureSize));
}

QToolButton *ExampleGallery::card(const lessons::Example &example)
{
    auto *card = new QToolButton(this);
    card->setObjectName("card");
    card->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    card->setIconSize(pictureSize);
    QPixmap blank(pictureSize);
    blank.fill(m_theme.tokens().sunk);
    card->setIcon(blank);
    card->setText(example.title);
    card->setFont(m_theme.ui());
    card->setToolTip(tr("%1 Undo brings your scene back.").arg(example.help));
    card->setAccessibleName(example.title);
    card->setAccessibleDescription(example.help);
    card->setFocusPolicy(Qt::StrongFocus);
    card->setFixedSize(pictureSize + QSize(12, 34));
    card->installEventFilter(this);
    connect(card, &QToolButton::clicked, this, [this, example] {
        close();
        takeExample(m_session, example);
    });
    return card;
}

bool ExampleGallery::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress)
        return QFrame::eventFilter(watched, event);
    // A button takes arrow keys for the next and the previous one, whatever stands above and below.
    int step = 0;
    switch (static_cast<QKeyEvent *>(event)->key()) {
    case Qt::Key_Right:
        step = 1;
        break;
    case Qt::Key_Left:
        step = -1;
        break;
    case Qt::Key_Down:
        step = columns;
        break;
    case Qt::Key_Up:
        step = -columns;
        break;
    default:
        return false;
    }
    const auto to = std::find(m_cards.begin(), m_cards.end(), watched) - m_cards.begin() + step;
    if (to >= 0 && to < static_cast<std::ptrdiff_t>(m_cards.size()))
        m_cards[static_cast<std::size_t>(to)]->setFocus(Qt::TabFocusReason);
    return true;
}

}
