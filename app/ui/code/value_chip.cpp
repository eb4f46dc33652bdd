#include "app/ui/code/value_chip.h"

#include "app/ui/theme/theme.h"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>

namespace app {

namespace {

constexpr int chipRight = 8;      ///< from the right edge
constexpr int chipRightOfBar = 4; ///< likewise, if there is a scroll bar
constexpr int chipGap = 2;        ///< between code and chip
constexpr int chipHeight = 16;
constexpr int chipPixels = 11; ///< of its letters
constexpr int chipPadding = 6;
constexpr int tightPadding = 3;

}

ValueChip fitChip(const QStringList &forms, const ChipRoom &room, const Theme &theme)
{
    const QFontMetrics metrics(theme.mono(chipPixels));
    const int right = room.row.right() + 1 - (room.hasScrollBar ? chipRightOfBar : chipRight);
    const int available = right - room.endOfCode - chipGap;
    QString text = QStringLiteral("…");
    int width = metrics.horizontalAdvance(text) + 2 * chipPadding;
    for (const int padding : {tightPadding, chipPadding}) {
        const auto fits = std::find_if(forms.begin(), forms.end(), [&](const QString &form) {
            return metrics.horizontalAdvance(form) + 2 * padding <= available;
        });
        if (fits == forms.end())
            continue;
        text = *fits;
        width = metrics.horizontalAdvance(text) + 2 * padding;
    }
    const int top = room.row.top() + (room.row.height() - chipHeight) / 2;
    QRect cover = room.row;
    cover.setLeft(right - width - chipGap);
    return {QRect(right - width, top, width, chipHeight), cover, text};
}

void ValueChip::paint(QPainter &painter, Look look, const QColor &behind, const Theme &theme) const
{
    if (text.isEmpty())
        return;
    const Tokens &t = theme.tokens();
    painter.fillRect(cover, behind);
    painter.setPen(look == Look::changed ? QPen(t.now, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(look == Look::now ? t.now : t.chip);
    painter.drawRoundedRect(rect, 4, 4);
    painter.setFont(theme.mono(chipPixels));
    painter.setPen(look == Look::now       ? t.nowText
                   : look == Look::changed ? t.ink
                   : look == Look::earlier ? t.ink3
                                           : t.ink2);
    painter.drawText(rect, Qt::AlignCenter, text);
}

}
