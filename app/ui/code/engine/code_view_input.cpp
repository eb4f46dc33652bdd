#include "app/ui/code/engine/code_view.h"

#include "app/ui/actions/command.h"
#include "app/ui/code/code_keys.h"
#include "app/ui/theme/focus_ring.h"

#include <QApplication>
#include <QClipboard>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

namespace app {

namespace {

/// Returns whether the view handles a key itself; all other keys go to the window.
bool isOurs(const QKeyEvent &key, bool isDragging)
{
    if (key.matches(QKeySequence::Copy) || key.matches(QKeySequence::SelectAll))
        return true;
    const Qt::KeyboardModifiers modifiers = key.modifiers() & ~Qt::KeypadModifier;
    const bool plain = modifiers == Qt::NoModifier, control = modifiers == Qt::ControlModifier;
    switch (key.key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
        return plain || control;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case codeKeys::showValue.key():
        return control;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case codeKeys::changeNumber:
    case codeKeys::showRemovedLines:
    case codeKeys::toggleBreakpoint:
        return plain;
    case Qt::Key_Escape:
        return plain && isDragging;
    default:
        return false;
    }
}

constexpr int trembling = 3; ///< px that the mouse may move during a click

}

bool CodeView::event(QEvent *event)
{
    // Scintilla would claim every letter and arrow key as its own shortcut.
    if (event->type() == QEvent::ShortcutOverride) {
        event->setAccepted(isOurs(*static_cast<QKeyEvent *>(event), m_taken.has_value()));
        return true;
    }
    return QsciScintilla::event(event);
}

void CodeView::keyPressEvent(QKeyEvent *event)
{
    if (!isOurs(*event, m_taken.has_value())) {
        event->ignore();
        return;
    }
    m_byKeyboard = true;
    if (event->matches(QKeySequence::Copy))
        hasSelectedText() ? copy() : QApplication::clipboard()->setText(sectionText());
    else if (event->matches(QKeySequence::SelectAll))
        selectAll();
    else
        steer(*event);
    viewport()->update();
}

void CodeView::steer(const QKeyEvent &event)
{
    const bool control = event.modifiers().testFlag(Qt::ControlModifier);
    switch (event.key()) {
    case Qt::Key_Down:
        return moveByRows(1, control);
    case Qt::Key_Up:
        return moveByRows(-1, control);
    case Qt::Key_Right:
        return moveByWords(1);
    case Qt::Key_Left:
        return moveByWords(-1);
    case codeKeys::showValue.key():
        return askSymbol();
    case codeKeys::changeNumber:
        return askNumber();
    case codeKeys::showRemovedLines:
        emit removedLinesRequested();
        return;
    case codeKeys::toggleBreakpoint:
        if (line(m_rows[m_row]))
            emit stopRequested(m_row);
        return;
    case Qt::Key_Escape:
        m_taken.reset();
        emit numberLeft(false);
        return;
    default:
        actOnRow();
    }
}

void CodeView::mousePressEvent(QMouseEvent *event)
{
    emit symbolDropped();
    m_hoveredWord.reset();
    const auto row = rowAt(event->pos());
    if (event->button() != Qt::LeftButton || !row || m_rows[*row].kind == CodeRow::Kind::gap) {
        QsciScintilla::mousePressEvent(event);
        return;
    }
    m_byKeyboard = false;
    const QString key = foldKey(m_rows[*row]);
    if (key.isEmpty() && !line(m_rows[*row])) {
        QsciScintilla::mousePressEvent(event);
        return;
    }
    setFocus(Qt::MouseFocusReason);
    m_row = *row;
    m_word.reset();
    viewport()->update();
    if (!key.isEmpty()) {
        toggle(key);
    } else if (isInMargin(event->pos())) {
        emit stopRequested(*row);
    } else if (const ParameterSpot *spot = spotAt(event->pos())) {
        m_taken = event->pos();
        emit numberTaken(*spot);
    } else {
        m_pressed = hasSelectedText() || event->modifiers() != Qt::NoModifier ? std::nullopt
                                                                              : std::optional(event->pos());
        QsciScintilla::mousePressEvent(event);
    }
}

void CodeView::mouseMoveEvent(QMouseEvent *event)
{
    forgetWord(event->pos());
    if (m_taken) {
        emit numberDragged(event->pos().x() - m_taken->x(), event->modifiers().testFlag(Qt::ShiftModifier));
        return;
    }
    const auto row = rowAt(event->pos());
    setPointed(event->buttons() == Qt::NoButton ? row : std::nullopt);
    if (row && event->buttons() == Qt::NoButton) {
        const bool isLine = line(m_rows[*row]);
        if (isLine && !isInMargin(event->pos()) && spotAt(event->pos())) {
            viewport()->setCursor(Qt::SizeHorCursor);
            return;
        }
        if (!foldKey(m_rows[*row]).isEmpty() || (isLine && isInMargin(event->pos()))) {
            viewport()->setCursor(Qt::PointingHandCursor);
            return;
        }
    }
    QsciScintilla::mouseMoveEvent(event);
}

void CodeView::setPointed(std::optional<std::size_t> row)
{
    if (row == m_pointed)
        return;
    m_pointed = row;
    emit rowPointedAt(row);
}

void CodeView::mouseReleaseEvent(QMouseEvent *event)
{
    if (m_taken && event->button() == Qt::LeftButton) {
        m_taken.reset();
        emit numberLeft(true);
        return;
    }
    QsciScintilla::mouseReleaseEvent(event);
    const bool isClick = m_pressed && (event->pos() - *m_pressed).manhattanLength() <= trembling;
    const auto row = isClick ? rowAt(*m_pressed) : std::nullopt;
    m_pressed.reset();
    if (row && event->button() == Qt::LeftButton && !hasSelectedText())
        emit runRequested(*row);
}

void CodeView::mouseDoubleClickEvent(QMouseEvent *event)
{
    const auto row = rowAt(event->pos());
    const bool isLine = row && line(m_rows[*row]);
    if (event->button() != Qt::LeftButton || !row) {
        QsciScintilla::mouseDoubleClickEvent(event);
    } else if (isLine && !isInMargin(event->pos()) && spotAt(event->pos())) {
        emit numberRequested(*spotAt(event->pos()));
    } else if (isLine && !isInMargin(event->pos())) {
        QsciScintilla::mouseDoubleClickEvent(event); // selects a word
    } else {
        mousePressEvent(event); // a double click counts as two clicks
    }
}

void CodeView::contextMenuEvent(QContextMenuEvent *event)
{
    std::size_t row = m_row;
    QPoint place = event->globalPos();
    if (event->reason() == QContextMenuEvent::Keyboard)
        place = viewport()->mapToGlobal(rowRect(m_row).topLeft() + QPoint(marginsWidth(), rowHeight()));
    else
        row = rowAt(viewport()->mapFromGlobal(place)).value_or(m_row);
    if (row < m_rows.size())
        emit menuRequested(place, row);
}

void CodeView::resizeEvent(QResizeEvent *event)
{
    QsciScintilla::resizeEvent(event);
    if (m_keepsRow)
        scrollTo(m_row, m_row);
}

void CodeView::wheelEvent(QWheelEvent *event)
{
    m_keepsRow = false;
    // Scintilla would zoom the text but not the chips and headings.
    if (event->modifiers() & Qt::ControlModifier)
        event->ignore();
    else
        QsciScintilla::wheelEvent(event);
}

void CodeView::focusInEvent(QFocusEvent *event)
{
    QsciScintilla::focusInEvent(event);
    if (isByKeyboard(event->reason()))
        m_byKeyboard = true;
    else if (event->reason() == Qt::MouseFocusReason)
        m_byKeyboard = false; // not changed when a window or menu opens or closes
    viewport()->update();
}

void CodeView::focusOutEvent(QFocusEvent *event)
{
    QsciScintilla::focusOutEvent(event);
    emit symbolDropped(); // drops the keyboard's request; the mouse makes its own
    viewport()->update();
}

QString CodeView::tipAt(const QPoint &position) const
{
    const auto row = rowAt(position);
    if (!row)
        return {};
    const CodeRow &its = m_rows[*row];
    if (its.kind == CodeRow::Kind::heading) {
        const QString files = m_listing.sections[its.section].files().join('\n');
        return tr("%1\nClick to fold or unfold (Enter)").arg(files);
    }
    if (!foldKey(its).isEmpty())
        return tr("These lines add up the values computed above. They are the same for every force.\nClick "
                  "to fold or unfold (Enter)");
    if (its.kind == CodeRow::Kind::gone)
        return tr("The previous step has this line; this step removed it.");
    const CodeLine *shown = line(its);
    if (!shown)
        return {};
    if (chip(its) && chipBox(*row).rect.contains(position))
        return chip(its)->tip;
    if (!isInMargin(position))
        return {};
    const QString what = withKeys(
        breakpoint(*row) ? tr("The run stops before this line's phase. Click to remove the breakpoint")
                         : tr("Click to set a breakpoint before this line's phase"),
        codeKeys::toggleBreakpoint);
    return shown->isNew ? tr("New in this step. %1").arg(what) : what;
}

bool CodeView::viewportEvent(QEvent *event)
{
    if (event->type() == QEvent::Leave) {
        forgetWord({-1, -1});
        setPointed(std::nullopt);
    }
    if (event->type() != QEvent::ToolTip)
        return QsciScintilla::viewportEvent(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    const QString tip = tipAt(help->pos());
    QToolTip::showText(help->globalPos(), tip, this); // an empty text hides the tooltip
    const auto at = tip.isEmpty() && !m_taken ? textAt(help->pos()) : std::nullopt;
    if (at && at != m_hoveredWord) {
        m_hoveredWord = at;
        emit symbolRequested(at->first, at->second);
    }
    return true;
}

}
