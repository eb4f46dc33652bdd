#include "app/ui/dock/button_flow.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QEvent>
#include <QFrame>

#include <algorithm>

namespace app {

namespace {

constexpr int flowSpacing = 4;
constexpr int flowMargin = 4; ///< px above and below the buttons

}

ButtonFlow::ButtonFlow(QWidget *box) : QWidget(box), m_strip(new QWidget(box)), m_edge(new QFrame(m_strip))
{
    m_strip->setObjectName("panel"); // text scrolls past behind the buttons
    m_strip->setAttribute(Qt::WA_StyledBackground);
    m_edge->setObjectName("divider");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Minimum);
}

void ButtonFlow::append(QAbstractButton &button, const QString &name, const QString &text, const QString &tip)
{
    button.setObjectName(name);
    button.setText(text);
    button.setToolTip(tip);
    button.setFocusPolicy(Qt::TabFocus);
    m_buttons.push_back(&button);
    refresh();
}

void ButtonFlow::refresh()
{
    updateGeometry();
    if (isVisible())
        place();
}

template <class Set>
int ButtonFlow::arrange(int width, Set set) const
{
    int x = 0, y = flowMargin, lineHeight = 0;
    for (QAbstractButton *button : m_buttons) {
        if (button->isHidden())
            continue;
        const QSize size = button->sizeHint();
        if (x > 0 && x + size.width() > width) {
            x = 0;
            y += lineHeight + flowSpacing;
            lineHeight = 0;
        }
        set(*button, QRect(QPoint(x, y), QSize(std::min(size.width(), width), size.height())));
        x += size.width() + flowSpacing;
        lineHeight = std::max(lineHeight, size.height());
    }
    return y + lineHeight + flowMargin;
}

int ButtonFlow::heightForWidth(int width) const
{
    return arrange(width, [](QAbstractButton &, const QRect &) {});
}

QSize ButtonFlow::sizeHint() const
{
    const int width = std::max(this->width(), minimumSizeHint().width());
    return {width, heightForWidth(width)};
}

QSize ButtonFlow::minimumSizeHint() const
{
    int widest = 0, highest = 0;
    for (const QAbstractButton *button : m_buttons) {
        if (button->isHidden())
            continue;
        widest = std::max(widest, button->sizeHint().width());
        highest = std::max(highest, button->sizeHint().height());
    }
    return {widest, highest + 2 * flowMargin};
}

void ButtonFlow::watchScrolling()
{
    QWidget *above = parentWidget();
    while (above && !qobject_cast<QAbstractScrollArea *>(above))
        above = above->parentWidget();
    auto *area = qobject_cast<QAbstractScrollArea *>(above);
    // A card over a scroll area, beside its viewport, does not scroll with it.
    QWidget *viewport = area && area->viewport()->isAncestorOf(this) ? area->viewport() : nullptr;
    if (viewport == m_viewport)
        return;
    m_viewport = viewport;
    if (!viewport)
        return;
    // The place in the visible part changes when any widget in between moves: one of them does when the text scrolls.
    for (QWidget *between = parentWidget(); between != viewport; between = between->parentWidget())
        between->installEventFilter(this);
    viewport->installEventFilter(this);
}

void ButtonFlow::place()
{
    watchScrolling();
    arrange(width(), [](QAbstractButton &button, const QRect &place) { button.setGeometry(place); });
    int top = y();
    if (m_viewport) {
        const int visibleBottom = parentWidget()->mapFrom(m_viewport, QPoint(0, m_viewport->height())).y();
        top = std::max(0, std::min(top, visibleBottom - height()));
    }
    m_strip->setGeometry(x(), top, width(), height());
    m_edge->setGeometry(0, 0, width(), 1);
    m_edge->setVisible(top < y()); // where they cover text
    m_strip->raise();
}

bool ButtonFlow::event(QEvent *event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::Move || event->type() == QEvent::Show)
        place();
    return QWidget::event(event);
}

bool ButtonFlow::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Move:
    case QEvent::Show:
        place();
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

}
