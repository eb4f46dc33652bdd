#include "app/ui/help/key_caps.h"

#include "app/ui/actions/command.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int capHeight = 22;
constexpr double padding = 7.0;
constexpr double gap = 4.0;
constexpr double fontSize = 12.0;

}

KeyCaps::KeyCaps(const QList<QKeySequence> &keys, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_theme(theme)
{
    for (const QKeySequence &sequence : keys) {
        if (sequence.isEmpty())
            continue;
        if (!m_pieces.empty())
            m_pieces.push_back({tr("or"), false});
        for (int i = 0; i < sequence.count(); ++i) {
            for (const QString &cap : keyNames(sequence[static_cast<uint>(i)]))
                m_pieces.push_back({cap, true});
        }
    }
    finish();
}

KeyCaps::KeyCaps(const QString &text, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_theme(theme), m_pieces({{text, true}})
{
    finish();
}

void KeyCaps::finish()
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setFont(m_theme.ui(fontSize));
    QStringList words;
    for (const Piece &piece : m_pieces)
        words.push_back(piece.text);
    setAccessibleName(words.join(' '));
}

double KeyCaps::widthOf(const Piece &piece) const
{
    const double text = QFontMetricsF(m_theme.ui(fontSize)).horizontalAdvance(piece.text);
    return piece.isCap ? std::max<double>(capHeight, std::ceil(text + 2 * padding)) : std::ceil(text);
}

QSize KeyCaps::sizeHint() const
{
    double width = 0.0;
    for (const Piece &piece : m_pieces)
        width += widthOf(piece) + gap;
    return {static_cast<int>(std::max(0.0, width - gap)), capHeight};
}

void KeyCaps::paintEvent(QPaintEvent *)
{
    const Tokens &tokens = m_theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(m_theme.ui(fontSize));
    double x = 0.0;
    for (const Piece &piece : m_pieces) {
        const QRectF place(x, 0, widthOf(piece), capHeight);
        if (piece.isCap) {
            // The lower edge is twice as thick, so that the key looks tilted towards the reader.
            painter.setPen(Qt::NoPen);
            painter.setBrush(tokens.line2);
            painter.drawRoundedRect(place, 5, 5);
            painter.setBrush(tokens.scene);
            painter.drawRoundedRect(place.adjusted(1, 1, -1, -2), 4, 4);
        }
        painter.setPen(piece.isCap ? tokens.ink : tokens.ink3);
        painter.drawText(place.adjusted(0, 0, 0, piece.isCap ? -1 : 0), Qt::AlignCenter, piece.text);
        x += place.width() + gap;
    }
}

}
