#include "app/ui/learn/why_text.h"

#include "app/model/text/numbers.h"

#include <QAbstractTextDocumentLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextCursor>

namespace app {

namespace {

const QString formulaScheme = QStringLiteral("formula");

QString formulaLink(std::size_t formula)
{
    return QStringLiteral("%1:%2").arg(formulaScheme).arg(formula);
}

/// Returns the formula of such a link; empty for another link.
std::optional<std::size_t> formulaOf(const QUrl &link)
{
    return link.scheme() == formulaScheme ? std::optional<std::size_t>(link.path().toUInt()) : std::nullopt;
}

}

WhyText::WhyText(const lessons::Why &why, const Theme &theme, QWidget *parent)
    : NarrationText(theme, parent, Kind::aside), m_theme(theme), m_formulas(why.formulas)
{
    viewport()->setMouseTracking(true);
    connect(this, &QTextBrowser::anchorClicked, this, &WhyText::keep);
    setText(why.answer);
}

void WhyText::decorate()
{
    m_blocks.clear();
    QTextBlock block = document()->begin();
    for (std::size_t i = 0; i < m_formulas.size(); ++i) {
        const QString shown = withoutBreaksInNumbers(m_formulas[i].text); // as setProse() wrote it
        while (block.isValid() && block.text() != shown)
            block = block.next();
        m_blocks.push_back(block.isValid() ? block.blockNumber() : -1);
        if (!block.isValid())
            continue;
        QTextCursor cursor(block);
        cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
        QTextCharFormat format;
        format.setAnchor(true);
        format.setAnchorHref(formulaLink(i));
        format.setUnderlineStyle(QTextCharFormat::DotLine);
        format.setUnderlineColor(m_theme.tokens().ink3);
        cursor.mergeCharFormat(format);
        block = block.next();
    }
    markLine();
}

QRect WhyText::formulaBox(std::size_t formula) const
{
    const QTextBlock block = document()->findBlockByNumber(m_blocks.at(formula));
    if (m_blocks.at(formula) < 0 || !block.isValid())
        return {};
    return document()
        ->documentLayout()
        ->blockBoundingRect(block)
        .translated(-horizontalScrollBar()->value(), -verticalScrollBar()->value())
        .toAlignedRect();
}

WhyText::Place WhyText::formulaAt(QPoint place) const
{
    for (std::size_t i = 0; i < m_formulas.size(); ++i) {
        const QRect box = formulaBox(i);
        if (!box.isEmpty() && place.y() >= box.top() && place.y() <= box.bottom())
            return i;
    }
    return std::nullopt;
}

WhyText::Place WhyText::formulaOfFocus() const
{
    const QTextCursor cursor = textCursor();
    return hasFocus() && cursor.hasSelection() ? formulaOf(QUrl(cursor.charFormat().anchorHref()))
                                               : std::nullopt;
}

void WhyText::keep(const QUrl &link)
{
    if (const Place formula = formulaOf(link)) {
        m_kept = m_kept == formula ? Place() : formula;
        highlight();
    }
}

void WhyText::highlight()
{
    const Place next = m_pointed ? m_pointed : m_focused ? m_focused : m_kept;
    if (next == m_shown)
        return;
    m_shown = next;
    markLine();
    emit highlightsChanged(m_shown ? m_formulas[*m_shown].highlights : std::vector<lessons::Highlight>());
}

void WhyText::markLine()
{
    QList<QTextEdit::ExtraSelection> marks;
    if (m_shown && m_blocks[*m_shown] >= 0) {
        QTextEdit::ExtraSelection mark;
        mark.cursor = QTextCursor(document()->findBlockByNumber(m_blocks[*m_shown]));
        mark.format.setProperty(QTextFormat::FullWidthSelection, true);
        mark.format.setBackground(m_theme.tokens().sunk);
        mark.format.setForeground(m_theme.tokens().onSunk);
        marks << mark;
    }
    setExtraSelections(marks);
}

bool WhyText::focusNextPrevChild(bool next)
{
    const bool isDone = NarrationText::focusNextPrevChild(next);
    m_focused = formulaOfFocus();
    highlight();
    return isDone;
}

void WhyText::focusInEvent(QFocusEvent *event)
{
    NarrationText::focusInEvent(event);
    const bool isTab = event->reason() == Qt::TabFocusReason,
               isBack = event->reason() == Qt::BacktabFocusReason;
    if ((isTab || isBack) && !textCursor().hasSelection())
        focusNextPrevChild(isTab); // to the first formula, without another Tab
}

void WhyText::focusOutEvent(QFocusEvent *event)
{
    NarrationText::focusOutEvent(event);
    m_focused.reset();
    highlight();
}

void WhyText::hideEvent(QHideEvent *event)
{
    NarrationText::hideEvent(event);
    m_pointed.reset();
    m_focused.reset();
    m_kept.reset();
    highlight();
}

void WhyText::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && m_kept) {
        m_kept.reset();
        highlight();
        return;
    }
    NarrationText::keyPressEvent(event);
}

void WhyText::leaveEvent(QEvent *event)
{
    NarrationText::leaveEvent(event);
    m_pointed.reset();
    highlight();
}

void WhyText::mouseMoveEvent(QMouseEvent *event)
{
    NarrationText::mouseMoveEvent(event);
    m_pointed = formulaAt(event->position().toPoint());
    viewport()->setToolTip(m_pointed ? tr("Click the line to keep the marks.") : QString());
    highlight();
}

}
