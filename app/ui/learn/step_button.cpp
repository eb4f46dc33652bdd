#include "app/ui/learn/step_button.h"

#include "app/ui/theme/theme.h"

#include <QEvent>
#include <QStyle>

namespace app {

namespace {

constexpr int besideText = 2 * 13 + 16 + 12; ///< px: padding and border, icon, and the gap before it

}

StepButton::StepButton(QWidget *parent) : QPushButton(parent)
{
    setLayoutDirection(Qt::RightToLeft); // puts the icon after the text
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::TabFocus);
    setIconSize({16, 16});
    setPrimary(false);
}

void StepButton::showArrow(const Theme &theme)
{
    m_theme = &theme;
    connect(&theme, &Theme::changed, this, &StepButton::drawArrow);
    drawArrow();
}

void StepButton::drawArrow()
{
    const Tokens &tokens = m_theme->tokens();
    setIcon(isEnabled() ? m_theme->icon("right", isPrimary() ? tokens.buttonText : tokens.ink) : QIcon());
}

void StepButton::setFullText(const QString &text, const QString &brief)
{
    m_text = text;
    m_brief = brief;
    setAccessibleName(text);
    fit();
}

void StepButton::setPrimary(bool primary)
{
    setProperty("primary", primary);
    // A style sheet evaluates properties again only after a polish.
    style()->unpolish(this);
    style()->polish(this);
    update();
    if (m_theme)
        drawArrow();
}

void StepButton::changeEvent(QEvent *event)
{
    QPushButton::changeEvent(event);
    if (event->type() == QEvent::EnabledChange && m_theme)
        drawArrow();
}

QSize StepButton::minimumSizeHint() const
{
    return {96, QPushButton::minimumSizeHint().height()};
}

void StepButton::fit()
{
    const int room = width() - besideText;
    const QString &fitting = fontMetrics().horizontalAdvance(m_text) <= room ? m_text : m_brief;
    QString shown = fontMetrics().elidedText(fitting, Qt::ElideRight, room);
    shown.replace('&', "&&");
    // Adds a gap between text and icon that the right-to-left layout does not remove.
    setText(shown + QChar(0x00A0) + QChar(0x200E));
}

void StepButton::resizeEvent(QResizeEvent *event)
{
    QPushButton::resizeEvent(event);
    fit();
}

}
