#include "app/ui/code/code_view.h"

#include <QApplication>
#include <QClipboard>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

namespace app {

namespace {

/// The keys that the view takes for itself; all others steer the window.
bool isOurs(const QKeyEvent &key)
{
    if (key.matches(QKeySequence::Copy) || key.matches(QKeySequence::SelectAll))
        return true;
    const bool plain = !(key.modifiers() & ~Qt::KeypadModifier);
    switch (key.key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return plain;
    default:
        return false;
    }
}

}

bool CodeView::event(QEvent *event)
{
    // Scintilla would claim every letter and arrow as a shortcut of its own.
    if (event->type() == QEvent::ShortcutOverride) {
        event->setAccepted(isOurs(*static_cast<QKeyEvent *>(event)));
        return true;
    }
    return QsciScintilla::event(event);
}

void CodeView::keyPressEvent(QKeyEvent *event)
{
    if (!isOurs(*event)) {
        event->ignore();
        return;
    }
    m_byKeyboard = true;
    if (event->matches(QKeySequence::Copy))
        hasSelectedText() ? copy() : QApplication::clipboard()->setText(shownText());
    else if (event->matches(QKeySequence::SelectAll))
        selectAll();
    else if (event->key() == Qt::Key_Down)
        select(m_current + 1);
    else if (event->key() == Qt::Key_Up)
        select(m_current == 0 ? 0 : m_current - 1);
    else
        toggle(m_current);
    viewport()->update();
}

std::optional<std::size_t> CodeView::headingAt(const QPoint &position) const
{
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        if (m_rows[row].kind == CodeRow::Kind::heading && rowRect(row).contains(position))
            return m_rows[row].section;
    }
    return std::nullopt;
}

void CodeView::mousePressEvent(QMouseEvent *event)
{
    const auto heading = headingAt(event->pos());
    if (!heading || event->button() != Qt::LeftButton) {
        QsciScintilla::mousePressEvent(event);
        return;
    }
    setFocus(Qt::MouseFocusReason);
    m_current = *heading;
    toggle(*heading);
}

void CodeView::mouseMoveEvent(QMouseEvent *event)
{
    const bool onHeading = headingAt(event->pos()).has_value();
    if (onHeading && event->buttons() == Qt::NoButton) {
        viewport()->setCursor(Qt::PointingHandCursor);
        return;
    }
    QsciScintilla::mouseMoveEvent(event);
}

void CodeView::wheelEvent(QWheelEvent *event)
{
    // Scintilla would zoom, and chips and headings would not.
    if (event->modifiers() & Qt::ControlModifier)
        event->ignore();
    else
        QsciScintilla::wheelEvent(event);
}

void CodeView::focusInEvent(QFocusEvent *event)
{
    QsciScintilla::focusInEvent(event);
    switch (event->reason()) {
    case Qt::MouseFocusReason:
        m_byKeyboard = false;
        break;
    case Qt::TabFocusReason:
    case Qt::BacktabFocusReason:
    case Qt::ShortcutFocusReason:
        m_byKeyboard = true;
        break;
    default: // the window or a menu came or went: as it was
        break;
    }
    viewport()->update();
}

void CodeView::focusOutEvent(QFocusEvent *event)
{
    QsciScintilla::focusOutEvent(event);
    viewport()->update();
}

QString CodeView::tipAt(const QPoint &position) const
{
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        const QRect rect = rowRect(row);
        if (!rect.contains(position))
            continue;
        const CodeRow &its = m_rows[row];
        if (its.kind == CodeRow::Kind::heading) {
            const QString files = m_listing.sections[its.section].files().join('\n');
            return tr("%1\nClick to fold or unfold (Enter)").arg(files);
        }
        if (its.kind == CodeRow::Kind::code && chip(its) && chipBox(row).rect.contains(position))
            return chip(its)->tip;
        const CodeLine *shown = line(its);
        if (shown && shown->isNew && position.x() < marginsWidth())
            return tr("New in this step");
    }
    return {};
}

bool CodeView::viewportEvent(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QsciScintilla::viewportEvent(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    QToolTip::showText(help->globalPos(), tipAt(help->pos()), this); // an empty text hides it
    return true;
}

}
