#include "app/ui/scene/flat_button.h"

#include <QPainter>

namespace app {

namespace {

constexpr int tall = 28;
constexpr int padding = 8;
constexpr int space = 6;
constexpr int glyph = 16;
constexpr int arrow = 12;

/// Returns whether the pointer is over `button`. A menu that has closed may have left Qt's flag for it set.
bool isHovered(const QWidget &button)
{
    return button.underMouse() && button.rect().contains(button.mapFromGlobal(QCursor::pos()));
}

}

FlatButton::FlatButton(const Theme &theme, QWidget *parent) : QToolButton(parent), m_theme(theme)
{
    setPopupMode(QToolButton::InstantPopup);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void FlatButton::setTexts(const QString &caption, const QString &value)
{
    m_caption = caption;
    m_value = value;
    setAccessibleName(caption.isEmpty() ? value : caption + ' ' + value);
    updateGeometry();
    update();
}

void FlatButton::setIconName(const QString &name)
{
    m_icon = name;
    updateGeometry();
    update();
}

void FlatButton::setShort(bool isShort)
{
    if (isShort == m_short)
        return;
    m_short = isShort;
    updateGeometry();
    update();
}

int FlatButton::widthWith(const QString &caption) const
{
    int width = 2 * padding - space;
    if (!m_icon.isEmpty())
        width += glyph + space;
    if (!caption.isEmpty())
        width += QFontMetrics(m_theme.ui()).horizontalAdvance(caption) + space;
    if (!m_value.isEmpty())
        width += QFontMetrics(m_theme.ui(13, QFont::Medium)).horizontalAdvance(m_value) + space;
    if (menu())
        width += arrow + space;
    return width;
}

QSize FlatButton::sizeHint() const
{
    return {m_short ? shortWidth() : fullWidth(), tall};
}

int FlatButton::fullWidth() const
{
    return widthWith(m_caption);
}

int FlatButton::shortWidth() const
{
    return widthWith(m_value.isEmpty() ? m_caption : QString());
}

void FlatButton::paintEvent(QPaintEvent *)
{
    const Tokens &t = m_theme.tokens();
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    if (isHovered(*this) || isDown())
        m_theme.paintSurface(p, rect(), 6, Surface::hovered);
    int x = m_icon.isEmpty() || !m_value.isEmpty() || !m_caption.isEmpty() ? padding : (width() - glyph) / 2;
    if (!m_icon.isEmpty()) {
        m_theme.icon(m_icon).paint(&p, QRect(x, (rect().height() - glyph) / 2, glyph, glyph));
        x += glyph + space;
    }
    const auto write = [&](const QString &text, const QFont &font, const QColor &color) {
        if (text.isEmpty())
            return;
        p.setFont(font);
        p.setPen(color);
        p.drawText(QRect(x, 0, width() - x, rect().height()), Qt::AlignVCenter | Qt::AlignLeft, text);
        x += QFontMetrics(font).horizontalAdvance(text) + space;
    };
    if (!m_short || m_value.isEmpty())
        write(m_caption, m_theme.ui(), t.ink2);
    write(m_value, m_theme.ui(13, QFont::Medium), t.ink);
    if (menu())
        m_theme.icon("down").paint(&p, QRect(x, (rect().height() - arrow) / 2, arrow, arrow));
}

}
