#include "app/ui/help/tour.h"

#include "app/model/text/phrases.h"
#include "app/ui/learn/prose.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QSettings>
#include <QShortcut>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr const char *tourSeenKey = "tour/seen";
constexpr int tourCardWidth = 360;  ///< px, its tip included, where its buttons need no more
constexpr int tipLength = 10;       ///< px round the card, in which the tip lies
constexpr int tipHalf = 9;          ///< px
constexpr int cardPadding = 16;     ///< px inside the card
constexpr double tourRadius = 10.0; ///< px
constexpr int edge = 8;             ///< px that the card keeps from the window's edges

/// A ring round the part that a card explains.
class Ring : public QWidget
{
public:
    Ring(const Theme &theme, QWidget *window) : QWidget(window), m_theme(theme)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        hide();
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(m_theme.tokens().ink, 2));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8, 8);
    }

private:
    const Theme &m_theme;
};

}

Tour::Tour(std::vector<TourStop> stops, const Theme &theme, QWidget *window)
    : QFrame(window), m_stops(std::move(stops)), m_theme(theme), m_ring(new Ring(theme, window)),
      m_title(new QLabel(this)), m_text(new QLabel(this)), m_count(new QLabel(this)),
      m_skip(new QPushButton(tr("Skip"), this)), m_back(new QPushButton(tr("Back"), this)),
      m_next(new QPushButton(this)), m_escape(new QShortcut(Qt::Key_Escape, window))
{
    setObjectName("tour");
    hide();
    m_title->setObjectName("heading");
    m_text->setFont(theme.ui(13));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::MarkdownText);
    m_count->setObjectName("caption");
    auto *column = new QVBoxLayout(this);
    const int margin = cardPadding + tipLength;
    column->setContentsMargins(margin, margin - 4, margin, margin - 4);
    column->setSpacing(6);
    column->addWidget(m_title);
    column->addWidget(m_text);
    column->addSpacing(6);
    makeButtons();
    m_escape->setEnabled(false);
    connect(m_escape, &QShortcut::activated, this, &Tour::end);
    connect(m_escape, &QShortcut::activatedAmbiguously, this, &Tour::end);
    window->installEventFilter(this);
}

void Tour::makeButtons()
{
    auto *row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_count);
    row->addStretch(1);
    for (QPushButton *button : {m_skip, m_back, m_next}) {
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
    }
    m_skip->setToolTip(tr("Ends the tour (Esc). It is in the Help menu."));
    m_back->setToolTip(tr("The previous card"));
    m_next->setProperty("primary", true);
    static_cast<QVBoxLayout *>(layout())->addLayout(row);
    connect(m_skip, &QPushButton::clicked, this, &Tour::end);
    connect(m_back, &QPushButton::clicked, this, &Tour::back);
    connect(m_next, &QPushButton::clicked, this, &Tour::forward);
}

bool Tour::isWanted()
{
    return !QSettings().value(tourSeenKey).toBool();
}

void Tour::start()
{
    QSettings().setValue(tourSeenKey, true);
    m_escape->setEnabled(true);
    show();
    m_ring->show();
    goTo(0);
}

void Tour::end()
{
    if (!isRunning())
        return;
    m_escape->setEnabled(false);
    m_ring->hide();
    hide();
    emit ended();
}

void Tour::goTo(std::size_t stop)
{
    m_stop = stop;
    const TourStop &now = m_stops[stop];
    const bool isLast = stop + 1 == m_stops.size();
    m_title->setText(now.title);
    m_text->setText(now.text);
    m_count->setText(partOf(QString::number(stop + 1), QString::number(m_stops.size())));
    m_skip->setVisible(!isLast);
    m_back->setVisible(stop > 0);
    m_next->setText(isLast ? tr("Done") : tr("Next"));
    m_next->setToolTip(isLast ? tr("Ends the tour (Enter)") : tr("The next card (Enter)"));
    setAccessibleName(QStringLiteral("%1. %2").arg(now.title, plainText(now.text)));
    place();
    m_next->setFocus(Qt::OtherFocusReason);
}

void Tour::forward()
{
    if (m_stop + 1 < m_stops.size())
        goTo(m_stop + 1);
    else
        end();
}

void Tour::back()
{
    if (m_stop > 0)
        goTo(m_stop - 1);
}

void Tour::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        forward();
    else
        QFrame::keyPressEvent(event);
}

bool Tour::eventFilter(QObject *watched, QEvent *event)
{
    const bool mayMove = event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest;
    if (watched == parentWidget() && mayMove && isRunning())
        place();
    return QFrame::eventFilter(watched, event);
}

Tour::Place Tour::placeBeside(const QRect &part) const
{
    const QRect room = parentWidget()->rect().adjusted(edge, edge, -edge, -edge);
    const int width = std::max(tourCardWidth, layout()->totalMinimumSize().width());
    const QSize size(width, layout()->totalHeightForWidth(width));
    const int y = std::clamp(part.center().y() - size.height() / 2, room.top(),
                             std::max(room.top(), room.bottom() - size.height()));
    const int x = std::clamp(part.center().x() - size.width() / 2, room.left(),
                             std::max(room.left(), room.right() - size.width()));
    const Place places[] = {
        {QRect(QPoint(part.right() + 1, y), size), Side::right},
        {QRect(QPoint(part.left() - size.width(), y), size), Side::left},
        {QRect(QPoint(x, part.top() - size.height()), size), Side::above},
        {QRect(QPoint(x, part.bottom() + 1), size), Side::below},
    };
    for (const Place &one : places) {
        if (room.contains(one.card))
            return one;
    }
    return {QRect(QPoint(x, y), size), Side::inside};
}

void Tour::place()
{
    const QRect part = m_stops[m_stop].part().intersected(parentWidget()->rect());
    const Place found = placeBeside(part);
    m_side = found.side;
    const bool isBeside = m_side == Side::right || m_side == Side::left;
    const int to = isBeside ? part.center().y() - found.card.top() : part.center().x() - found.card.left();
    const int least = tipLength + tipHalf + static_cast<int>(tourRadius);
    const int most = (isBeside ? found.card.height() : found.card.width()) - least;
    m_tip = std::clamp(to, least, most);
    m_ring->setGeometry(part);
    setGeometry(found.card);
    m_ring->raise();
    raise();
    update();
}

void Tour::paintEvent(QPaintEvent *)
{
    const QRectF body = QRectF(rect()).adjusted(tipLength, tipLength, -tipLength, -tipLength);
    QPainterPath card;
    card.addRoundedRect(body.adjusted(0.5, 0.5, -0.5, -0.5), tourRadius, tourRadius);
    // The tip is drawn to the left and turned to the side of the part.
    QPolygonF tip;
    const double at = m_tip;
    if (m_side == Side::right)
        tip << QPointF(1, at) << QPointF(tipLength + 2, at - tipHalf) << QPointF(tipLength + 2, at + tipHalf);
    else if (m_side == Side::left)
        tip << QPointF(width() - 1, at) << QPointF(width() - tipLength - 2, at - tipHalf)
            << QPointF(width() - tipLength - 2, at + tipHalf);
    else if (m_side == Side::below)
        tip << QPointF(at, 1) << QPointF(at - tipHalf, tipLength + 2) << QPointF(at + tipHalf, tipLength + 2);
    else if (m_side == Side::above)
        tip << QPointF(at, height() - 1) << QPointF(at - tipHalf, height() - tipLength - 2)
            << QPointF(at + tipHalf, height() - tipLength - 2);
    if (!tip.isEmpty()) {
        QPainterPath point;
        point.addPolygon(tip);
        point.closeSubpath();
        card = card.united(point);
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_theme.tokens().ink, 1.5));
    painter.setBrush(m_theme.tokens().panel);
    painter.drawPath(card);
}

}
