#include "app/ui/learn/choice_row.h"

#include <QAbstractTextDocumentLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QStyleOption>

namespace app {

namespace {

constexpr int choiceBox = 16;
constexpr int choiceTextLeft = choiceBox + 9;
constexpr int choiceMark = 14; ///< px, the tick or the cross
constexpr int choiceTextRight =
    choiceMark + 8;              ///< px; kept free, so that the text does not move when it is chosen
constexpr int choicePadding = 5; ///< px, above and below
constexpr int choiceLine = 19;

}

ChoiceRow::ChoiceRow(const QString &text, const Theme &theme, QWidget *parent)
    : QRadioButton(parent), m_theme(theme), m_text(text)
{
    setAutoExclusive(false); // an exclusive button would be chosen by the arrow keys
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    setToolTip(tr("Choose this answer (Space)"));
    connect(&theme, &Theme::changed, this, &ChoiceRow::applyTheme);
    applyTheme();
}

void ChoiceRow::setVerdict(Verdict verdict)
{
    m_verdict = verdict;
    applyTheme();
}

void ChoiceRow::applyTheme()
{
    const QColor ink = m_theme.tokens().ink;
    setProse(m_document, m_text, {13, choiceLine, 0, ink, ink, QFont::Medium}, m_theme);
    m_heights.forget();
    const QString plain = plainText(m_text);
    switch (m_verdict) {
    case Verdict::none:
        setAccessibleName(plain);
        break;
    case Verdict::right:
        setAccessibleName(tr("%1, right").arg(plain));
        break;
    case Verdict::wrong:
        setAccessibleName(tr("%1, wrong").arg(plain));
        break;
    }
    updateGeometry();
    update();
}

void ChoiceRow::nextCheckState()
{
    setChecked(true); // a choice is not taken back by a second click
}

bool ChoiceRow::hitButton(const QPoint &at) const
{
    return rect().contains(at);
}

void ChoiceRow::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        click();
    else
        QRadioButton::keyPressEvent(event);
}

int ChoiceRow::heightForWidth(int width) const
{
    return 2 * choicePadding +
           m_heights.at(std::max(1, width - choiceTextLeft - choiceTextRight), m_document);
}

QSize ChoiceRow::sizeHint() const
{
    return {240, heightForWidth(std::max(width(), 160))};
}

QSize ChoiceRow::minimumSizeHint() const
{
    return {120, choiceLine + 2 * choicePadding};
}

void ChoiceRow::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    QStyleOptionButton box;
    box.initFrom(this);
    box.state |= isChecked() ? QStyle::State_On : QStyle::State_Off;
    box.rect = QRect(0, choicePadding + 2, choiceBox, choiceBox);
    style()->drawPrimitive(QStyle::PE_IndicatorRadioButton, &box, &painter, this);
    if (m_verdict != Verdict::none) {
        const bool isRight = m_verdict == Verdict::right;
        const Tokens &tokens = m_theme.tokens();
        m_theme.icon(isRight ? "check" : "close", isRight ? tokens.ok : tokens.past)
            .paint(&painter, QRect(width() - choiceMark, choicePadding + 3, choiceMark, choiceMark));
    }
    layOut(m_document, std::max(1, width() - choiceTextLeft - choiceTextRight));
    painter.translate(choiceTextLeft, choicePadding);
    m_document.drawContents(&painter);
}

}
