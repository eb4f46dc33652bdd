#include "app/ui/map/concept_button.h"

#include "app/ui/learn/prose.h"
#include "app/ui/theme/focus_ring.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>

namespace app {

namespace {

constexpr int conceptPadding = 9; ///< px, beside the title
constexpr int conceptTick = 14;
constexpr int tickGap = 5;
constexpr double conceptRadius = 6.0;
constexpr double conceptFont = 12.0;

QString stateName(ConceptState state)
{
    switch (state) {
    case ConceptState::known:
        return ConceptButton::tr("known");
    case ConceptState::next:
        return ConceptButton::tr("can come next");
    case ConceptState::later:
        break;
    }
    return ConceptButton::tr("for later");
}

}

void paintConcept(QPainter &painter, const QRectF &box, const QString &title, ConceptState state,
                  double strength, const Theme &theme)
{
    const Tokens &tokens = theme.tokens();
    const bool isKnown = state == ConceptState::known, isNext = state == ConceptState::next;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(tokens.panel); // edges end at the box, also if it is in the background
    painter.setPen(Qt::NoPen);
    painter.drawRoundedRect(box, conceptRadius, conceptRadius);
    painter.setOpacity(strength);
    QPen outline(isNext ? tokens.ink : tokens.ctl, isNext ? 2.0 : 1.0);
    if (state == ConceptState::later)
        outline.setDashPattern({4.0, 3.0});
    painter.setPen(outline);
    painter.setBrush(isKnown ? tokens.well : tokens.panel);
    const double inset = outline.widthF() / 2.0;
    painter.drawRoundedRect(box.adjusted(inset, inset, -inset, -inset), conceptRadius, conceptRadius);
    QRectF text = box.adjusted(conceptPadding, 0, -conceptPadding, 0);
    if (isKnown) {
        theme.icon("check", tokens.ok)
            .paint(&painter,
                   QRectF(text.left() - 2.0, box.center().y() - conceptTick / 2.0, conceptTick, conceptTick)
                       .toRect());
        text.setLeft(text.left() + conceptTick + tickGap - 2);
    }
    painter.setFont(theme.ui(conceptFont, isNext ? QFont::DemiBold : QFont::Normal));
    painter.setPen(state == ConceptState::later ? tokens.ink2 : tokens.ink);
    painter.drawText(text, Qt::AlignCenter, title);
    painter.restore();
}

ConceptButton::ConceptButton(const ConceptNode &node, const Theme &theme, QWidget *parent)
    : QPushButton(parent), m_theme(theme)
{
    setAutoDefault(false); // Enter opens the concept that has the focus
    setObjectName(node.id);
    setText(node.title);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAccessibleDescription(QStringLiteral("%1 %2").arg(plainText(node.text), node.where));
    setToolTip(tr("Opens %1").arg(node.where));
    setState(ConceptState::later);
}

void ConceptButton::setState(ConceptState state)
{
    m_state = state;
    setAccessibleName(QStringLiteral("%1, %2").arg(text(), stateName(state)));
    update();
}

void ConceptButton::setFaded(bool faded)
{
    if (faded == m_isFaded)
        return;
    m_isFaded = faded;
    update();
}

int ConceptButton::widthFor(const std::vector<ConceptNode> &nodes, const Theme &theme)
{
    double widest = 0.0;
    for (const QFont::Weight weight : {QFont::Normal, QFont::DemiBold}) {
        const QFontMetricsF metrics(theme.ui(conceptFont, weight));
        const int tick = weight == QFont::Normal ? conceptTick + tickGap : 0;
        for (const ConceptNode &node : nodes)
            widest = std::max(widest, metrics.horizontalAdvance(node.title) + tick);
    }
    return static_cast<int>(widest) + 2 * conceptPadding + 3;
}

QSize ConceptButton::sizeHint() const
{
    return {160, height};
}

void ConceptButton::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    constexpr double background = 0.35;
    paintConcept(painter, rect(), text(), m_state, m_isFaded ? background : 1.0, m_theme);
}

void ConceptButton::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        click();
        break;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
        emit arrowPressed(event->key());
        break;
    default:
        QPushButton::keyPressEvent(event);
    }
}

void ConceptButton::enterEvent(QEnterEvent *event)
{
    QPushButton::enterEvent(event);
    emit pointed(true);
}

void ConceptButton::leaveEvent(QEvent *event)
{
    QPushButton::leaveEvent(event);
    emit pointed(false);
}

void ConceptButton::focusInEvent(QFocusEvent *event)
{
    QPushButton::focusInEvent(event);
    // The page gives the focus to one concept when it opens; that does not point at it.
    if (isByKeyboard(event->reason()))
        emit pointed(true);
}

void ConceptButton::focusOutEvent(QFocusEvent *event)
{
    QPushButton::focusOutEvent(event);
    emit pointed(false);
}

}
