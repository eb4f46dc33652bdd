#include "app/ui/learn/step/try_row.h"

#include <QAbstractTextDocumentLayout>
#include <QPainter>
#include <QStyleOption>

namespace app {

namespace {

constexpr int boxSize = 16;
constexpr int tryTextLeft = boxSize + 9;
constexpr int tryPadding = 4; ///< px, above and below
constexpr int lineHeight = 18;
constexpr int lift = 1; ///< px; a fixed line height adds its space above the letters, the design splits it

}

TryRow::TryRow(const QString &text, const Theme &theme, QWidget *parent)
    : QCheckBox(parent), m_theme(theme), m_text(text)
{
    setFocusPolicy(Qt::NoFocus); // the learner cannot operate it
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    setToolTip(tr("Springstep ticks this when it sees you do it."));
    connect(&theme, &Theme::changed, this, &TryRow::applyTheme);
    applyTheme();
}

void TryRow::setDone(bool done)
{
    if (done == isChecked())
        return;
    setChecked(done);
    applyTheme();
}

void TryRow::applyTheme()
{
    const QColor color = isChecked() ? m_theme.tokens().ink3 : m_theme.tokens().ink;
    setProse(m_document, m_text, {13, lineHeight, 0, color, color, QFont::Medium}, m_theme);
    m_heights.forget();
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
    // Clicks are ignored: only events in the run tick the box.
}

int TryRow::heightForWidth(int width) const
{
    return 2 * tryPadding + m_heights.at(width - tryTextLeft, m_document);
}

QSize TryRow::sizeHint() const
{
    return {240, heightForWidth(std::max(width(), 160))};
}

QSize TryRow::minimumSizeHint() const
{
    return {120, lineHeight + 2 * tryPadding};
}

void TryRow::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    QStyleOptionButton box;
    box.initFrom(this);
    box.state |= isChecked() ? QStyle::State_On : QStyle::State_Off;
    box.rect = QRect(0, tryPadding + 1, boxSize, boxSize);
    style()->drawPrimitive(QStyle::PE_IndicatorCheckBox, &box, &painter, this);
    layOut(m_document, width() - tryTextLeft);
    painter.translate(tryTextLeft, tryPadding - lift);
    m_document.drawContents(&painter);
}

}
