#include "app/ui/panels/try_row.h"

#include "app/ui/panels/prose.h"

#include <QAbstractTextDocumentLayout>
#include <QPainter>
#include <QStyleOption>

#include <cmath>

namespace app {

namespace {

constexpr int boxSize = 16;
constexpr int textLeft = boxSize + 9;
constexpr int padding = 4; ///< above and below
constexpr int lineHeight = 18;
constexpr int lift = 1; ///< fixed line heights put the room above the letters; the design shares it

}

TryRow::TryRow(const QString &text, const Theme &theme, QWidget *parent)
    : QCheckBox(parent), m_theme(theme), m_text(text)
{
    setFocusPolicy(Qt::NoFocus); // there is nothing to do with it
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setToolTip(tr("Springstep ticks this when it sees you do it."));
    connect(&theme, &Theme::changed, this, &TryRow::dress);
    dress();
}

void TryRow::setDone(bool done)
{
    if (done == isChecked())
        return;
    setChecked(done);
    dress();
}

void TryRow::dress()
{
    const QColor color = isChecked() ? m_theme.tokens().ink3 : m_theme.tokens().ink;
    setProse(m_document, m_text, {13, lineHeight, 0, color, color, QFont::Medium}, m_theme);
    setAccessibleName(isChecked() ? tr("%1 done").arg(plain()) : tr("%1 not yet").arg(plain()));
    updateGeometry();
    update();
}

QString TryRow::plain() const
{
    return plainText(m_text);
}

void TryRow::nextCheckState()
{
    // Only what happens in the run ticks the box.
}

int TryRow::heightForWidth(int width) const
{
    m_document.setTextWidth(width - textLeft);
    return 2 * padding + static_cast<int>(std::ceil(m_document.size().height()));
}

QSize TryRow::sizeHint() const
{
    return {240, heightForWidth(std::max(width(), 160))};
}

QSize TryRow::minimumSizeHint() const
{
    return {120, lineHeight + 2 * padding};
}

void TryRow::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    QStyleOptionButton box;
    box.initFrom(this);
    box.state |= isChecked() ? QStyle::State_On : QStyle::State_Off;
    box.rect = QRect(0, padding + 1, boxSize, boxSize);
    style()->drawPrimitive(QStyle::PE_IndicatorCheckBox, &box, &painter, this);
    m_document.setTextWidth(width() - textLeft);
    painter.translate(textLeft, padding - lift);
    m_document.drawContents(&painter);
}

}
