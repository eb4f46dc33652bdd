// Keys and mouse of the listing's editor.

#include "app/model/listing/line_of_code.h"
#include "app/ui/code/code_keys.h"
#include "app/ui/code/code_scintilla.h"
#include "app/ui/code/listing/listing_editor.h"
#include "app/ui/code/listing/listing_editor_styles.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QResizeEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

namespace {

constexpr int dragStart = 3;          ///< px that the mouse moves before a number counts as dragged
constexpr double pixelsPerUnit = 2.0; ///< px of a drag that change the last digit of a number by one
constexpr int leastDecimals = 2;      ///< of a dragged number that has a point
constexpr int columnsOfIndent = 4;

/// Returns whether the editor handles a key itself. All other keys go to the window.
bool editsWith(const QKeyEvent &key)
{
    if (key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo))
        return false;
    for (const auto edit :
         {QKeySequence::Copy, QKeySequence::Cut, QKeySequence::Paste, QKeySequence::SelectAll}) {
        if (key.matches(edit))
            return true;
    }
    const Qt::KeyboardModifiers modifiers = key.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier);
    const bool isPlain = modifiers == Qt::NoModifier, isControl = modifiers == Qt::ControlModifier;
    switch (key.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
        return isPlain || isControl;
    case Qt::Key_Space:
        return isPlain || isControl; // Ctrl: completion
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
    case Qt::Key_Escape:
    case codeKeys::toggleBreakpoint:
        return isPlain;
    default:
        break;
    }
    // AltGr is Ctrl and Alt on some systems, and makes brackets there.
    const bool makesText = !key.text().isEmpty() && key.text()[0].isPrint();
    return makesText && (isPlain || modifiers == (Qt::ControlModifier | Qt::AltModifier) ||
                         modifiers == Qt::GroupSwitchModifier);
}

int indentOf(const QString &line)
{
    return static_cast<int>(std::find_if(line.begin(), line.end(), [](QChar one) { return one != ' '; }) -
                            line.begin());
}

/// Returns the number `text`, changed by a drag of `pixels`.
QString draggedNumber(const QString &text, int pixels, bool fine)
{
    const qsizetype point = text.indexOf('.');
    if (point < 0)
        return QString::number(
            std::max(0, text.toInt() + static_cast<int>(std::lround(pixels / pixelsPerUnit / 2.0))));
    const int decimals = std::max(leastDecimals, static_cast<int>(text.size() - point - 1)) + int(fine);
    const double value = text.toDouble() + std::round(pixels / pixelsPerUnit) * std::pow(10.0, -decimals);
    return QString::number(std::max(0.0, value), 'f', decimals);
}

}

bool ListingEditor::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto &key = *static_cast<QKeyEvent *>(event);
        const bool isTab = key.key() == Qt::Key_Tab || key.key() == Qt::Key_Backtab;
        const bool isOurs = editsWith(key) && !(isTab && m_isPassedThrough);
        if (!isOurs)
            flush(); // undo and the other commands of the window act on what was typed
        event->setAccepted(isOurs);
        return true;
    }
    return QsciScintilla::event(event);
}

void ListingEditor::keyPressEvent(QKeyEvent *event)
{
    if (!editsWith(*event)) {
        event->ignore();
        return;
    }
    m_isPassedThrough = false;
    const bool hasList = isListActive();
    const bool isPlain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    switch (event->key()) {
    case Qt::Key_Escape:
        if (m_drag && m_drag->hasBegun)
            return endDrag(false);
        if (hasList)
            break;
        flush();
        emit left();
        return;
    case codeKeys::completeName.key():
        if (event->keyCombination() != codeKeys::completeName)
            break;
        followCharacter(0);
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (hasList || !isPlain)
            break;
        return breakLine();
    case Qt::Key_Tab:
        if (hasList)
            break;
        return indentLines(1);
    case Qt::Key_Backtab:
        return indentLines(-1);
    case codeKeys::toggleBreakpoint: {
        int line = 0, index = 0;
        getCursorPosition(&line, &index);
        return requestStop(line + 1);
    }
    case Qt::Key_BraceLeft:
        openBrace();
        break;
    case Qt::Key_BraceRight:
        closeBrace();
        break;
    default:
        break;
    }
    QsciScintilla::keyPressEvent(event);
}

void ListingEditor::focusInEvent(QFocusEvent *event)
{
    QsciScintilla::focusInEvent(event);
    m_isPassedThrough = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
}

bool ListingEditor::focusNextPrevChild(bool next)
{
    return m_isPassedThrough && QAbstractScrollArea::focusNextPrevChild(next);
}

void ListingEditor::focusOutEvent(QFocusEvent *event)
{
    QsciScintilla::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason || !isListActive())
        flush();
}

/// Starts a line with the indent of this one, and one level more behind a brace or the head of an `if` or a loop. Behind
/// the only statement of such a head, the line starts below the head.
void ListingEditor::breakLine()
{
    removeSelectedText();
    int line = 0, index = 0;
    getCursorPosition(&line, &index);
    const QString before = textBefore(line + 1, index);
    const QString behind = text(line).mid(index).trimmed();
    int indent = std::min(indentOf(before), index);
    const bool opens = before.trimmed().endsWith('{');
    const bool isInside = opens || endsWithHead(linesAbove(line) + before);
    if (before.trimmed().endsWith(';')) {
        for (int above = line; above > 0 && endsWithHead(linesAbove(above)); --above)
            indent = std::min(indent, indentOf(text(above - 1)));
    }
    const QString inner = '\n' + QString(indent + (isInside ? columnsOfIndent : 0), ' ');
    const QString outer = opens && behind.startsWith('}') ? '\n' + QString(indent, ' ') : QString();
    insert(inner + outer);
    setCursorPosition(line + 1, static_cast<int>(inner.size()) - 1);
    ensureCursorVisible();
}

QString ListingEditor::linesAbove(int line) const
{
    return line > 0 ? text().section('\n', 0, line - 1) + '\n' : QString();
}

/// Moves an opening brace that begins a line below the head of its `if` or loop.
void ListingEditor::openBrace()
{
    int line = 0, index = 0;
    getCursorPosition(&line, &index);
    if (endsWithHead(linesAbove(line)))
        indentTo(indentOf(text(line - 1)));
}

/// Moves a closing brace that begins a line below the line of its partner; without one, a level to the left.
void ListingEditor::closeBrace()
{
    int line = 0, index = 0;
    getCursorPosition(&line, &index);
    const int opened = lineOfOpenBrace(text(), line + 1);
    indentTo(opened > 0 ? indentOf(text(opened - 1)) : std::max(0, index - columnsOfIndent));
}

void ListingEditor::indentTo(int column)
{
    int line = 0, index = 0;
    getCursorPosition(&line, &index);
    const QString before = textBefore(line + 1, index);
    if (hasSelectedText() || !before.trimmed().isEmpty() || column >= index)
        return;
    setSelection(line, column, line, index);
    removeSelectedText();
}

void ListingEditor::indentLines(int by)
{
    int fromLine = 0, fromIndex = 0, toLine = 0, toIndex = 0;
    getSelection(&fromLine, &fromIndex, &toLine, &toIndex);
    if (fromLine < 0) { // nothing is selected
        int index = 0;
        getCursorPosition(&fromLine, &index);
        toLine = fromLine;
        if (by > 0) {
            insert(QString(columnsOfIndent - index % columnsOfIndent, ' '));
            setCursorPosition(fromLine, index + columnsOfIndent - index % columnsOfIndent);
            return;
        }
    } else if (toIndex == 0 && toLine > fromLine) {
        --toLine; // the selection ends before the last line
    }
    for (int line = fromLine; line <= toLine; ++line)
        by > 0 ? indent(line) : unindent(line);
}

void ListingEditor::followCharacter(int character)
{
    static const QRegularExpression twoLetters(QStringLiteral("(?:^|[^\\w.])[A-Za-z_]\\w+$"));
    static const QRegularExpression member(QStringLiteral("[\\w\\])]\\.\\w*$"));
    static const QRegularExpression note(QStringLiteral("//"));
    int line = 0, index = 0;
    getCursorPosition(&line, &index);
    const QString before = textBefore(line + 1, index);
    const bool wasAsked = character == 0;
    const QString behind = text(line).mid(index);
    const bool isInsideWord = !behind.isEmpty() && (behind[0].isLetterOrNumber() || behind[0] == '_');
    if (note.match(before).hasMatch() || (isInsideWord && !wasAsked) ||
        (!wasAsked && !twoLetters.match(before).hasMatch() && !member.match(before).hasMatch())) {
        send(*this, SCI_AUTOCCANCEL);
        return;
    }
    emit completionsWanted(line + 1, index + 1);
}

int ListingEditor::lineAt(const QPoint &place) const
{
    for (int line = 1; line <= lines(); ++line) {
        if (lineRect(line).contains(place))
            return line;
    }
    return 0;
}

std::optional<TextRange> ListingEditor::placeAt(const QPoint &place) const
{
    const int line = lineAt(place);
    if (line == 0 || place.x() < marginsWidth() || chipOf(line).rect.contains(place))
        return std::nullopt;
    static const QRegularExpression words(QStringLiteral("[A-Za-z_]\\w*|\\d[\\w.]*|[-+*/.()]"));
    for (auto found = words.globalMatch(text(line - 1)); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const TextRange range{line, static_cast<int>(match.capturedStart()) + 1,
                              static_cast<int>(match.capturedLength())};
        if (wordRect(range).contains(place))
            return range;
    }
    return std::nullopt;
}

std::optional<ListingEditor::Spot> ListingEditor::spotAt(const QPoint &place) const
{
    const std::optional<TextRange> at = placeAt(place);
    if (!at)
        return std::nullopt;
    for (const Spot &spot : spotsOf(at->line)) {
        if (spot.range.column == at->column)
            return spot;
    }
    return std::nullopt;
}

void ListingEditor::setPointed(std::optional<TextRange> place)
{
    if (place == m_pointed)
        return;
    m_pointed = place;
    emit pointedAt(place);
}

void ListingEditor::mousePressEvent(QMouseEvent *event)
{
    m_isPassedThrough = false;
    const bool isLeft = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier;
    const bool isControl =
        event->button() == Qt::LeftButton && event->modifiers() == Qt::KeyboardModifiers(Qt::ControlModifier);
    const int line = lineAt(event->pos());
    const bool isInMargin = m_kind == Kind::listing && line > 0 && event->pos().x() < marginsWidth();
    if (isInMargin && (isControl || (isLeft && stopOf(line) && stopRect(line).contains(event->pos()))))
        return requestStop(line);
    if (isInMargin && isLeft) {
        flush();
        emit runRequested(line);
        return;
    }
    if (const std::optional<Spot> spot = isLeft ? spotAt(event->pos()) : std::nullopt) {
        setFocus(Qt::MouseFocusReason);
        m_drag = Drag{*spot, event->pos(), false, spot->text};
        return; // without a move, the release sets the caret
    }
    QsciScintilla::mousePressEvent(event);
}

void ListingEditor::requestStop(int line)
{
    flush();
    emit stopRequested(line);
}

void ListingEditor::mouseMoveEvent(QMouseEvent *event)
{
    if (m_drag) {
        drag(event->pos(), event->modifiers().testFlag(Qt::ShiftModifier));
        return;
    }
    if (event->buttons() == Qt::NoButton) {
        setPointed(placeAt(event->pos()));
        if (m_kind == Kind::listing && lineAt(event->pos()) > 0 && event->pos().x() < marginsWidth()) {
            viewport()->setCursor(Qt::PointingHandCursor);
            return;
        }
        if (spotAt(event->pos())) {
            viewport()->setCursor(Qt::SizeHorCursor);
            return;
        }
    }
    QsciScintilla::mouseMoveEvent(event);
}

void ListingEditor::mouseReleaseEvent(QMouseEvent *event)
{
    if (!m_drag || event->button() != Qt::LeftButton) {
        QsciScintilla::mouseReleaseEvent(event);
        return;
    }
    if (m_drag->hasBegun)
        return endDrag(true);
    m_drag.reset();
    send(*this, SCI_GOTOPOS, send(*this, SCI_POSITIONFROMPOINT, event->pos().x(), event->pos().y()));
}

void ListingEditor::mouseDoubleClickEvent(QMouseEvent *event)
{
    m_drag.reset();
    if (event->pos().x() < marginsWidth())
        mousePressEvent(event); // a double click counts as two clicks
    else
        QsciScintilla::mouseDoubleClickEvent(event);
}

void ListingEditor::drag(const QPoint &to, bool fine)
{
    const int pixels = to.x() - m_drag->from.x();
    if (!m_drag->hasBegun) {
        if (std::abs(pixels) < dragStart)
            return;
        m_drag->hasBegun = true;
        if (m_drag->spot.isNumber)
            m_parameterDrag.endGesture();
        else
            m_parameterDrag.take(m_drag->spot.text);
    }
    if (!m_drag->spot.isNumber) {
        m_parameterDrag.drag(pixels, fine);
        return;
    }
    const QString number = draggedNumber(m_drag->before, pixels, fine);
    if (number == m_drag->spot.text)
        return;
    replaceText(*this, positionOf(m_drag->spot.range), endOf(m_drag->spot.range), number.toUtf8());
    m_drag->spot.text = number;
    m_drag->spot.range.length = static_cast<int>(number.size());
    flush();
}

void ListingEditor::endDrag(bool keep)
{
    const Drag drag = *std::exchange(m_drag, std::nullopt);
    if (!drag.spot.isNumber) {
        m_parameterDrag.leave(keep);
        return;
    }
    if (!keep)
        replaceText(*this, positionOf(drag.spot.range), endOf(drag.spot.range), drag.before.toUtf8());
    flush();
    m_parameterDrag.endGesture();
}

void ListingEditor::wheelEvent(QWheelEvent *event)
{
    // Scintilla would zoom the text but not the values.
    if (event->modifiers() & Qt::ControlModifier)
        event->ignore();
    else
        QsciScintilla::wheelEvent(event);
}

void ListingEditor::addLineActions(QMenu &menu, int line)
{
    connect(menu.addAction(tr("Run to this line")), &QAction::triggered, this, [this, line] {
        flush();
        emit runRequested(line);
    });
    connect(menu.addAction(stopOf(line) ? tr("Remove breakpoint") : tr("Set breakpoint")),
            &QAction::triggered, this, [this, line] { requestStop(line); });
    menu.addSeparator();
}

void ListingEditor::contextMenuEvent(QContextMenuEvent *event)
{
    int line = 0, index = 0;
    getCursorPosition(&line, &index);
    ++line;
    if (event->reason() == QContextMenuEvent::Mouse)
        line = std::max(1, lineAt(viewport()->mapFromGlobal(event->globalPos())));
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (m_kind == Kind::listing)
        addLineActions(*menu, line);
    const auto add = [&](const QString &text, bool isEnabled, void (QsciScintilla::*slot)()) {
        QAction *action = menu->addAction(text);
        action->setEnabled(isEnabled);
        connect(action, &QAction::triggered, this, [this, slot] { (this->*slot)(); });
    };
    add(tr("Cut"), hasSelectedText(), &QsciScintilla::cut);
    add(tr("Copy"), hasSelectedText(), &QsciScintilla::copy);
    add(tr("Paste"), send(*this, SCI_CANPASTE) != 0, &QsciScintilla::paste);
    menu->addSeparator();
    connect(menu->addAction(tr("Select all")), &QAction::triggered, this, [this] { selectAll(); });
    menu->addSeparator();
    connect(menu->addAction(m_kind == Kind::listing ? tr("Reset listing") : tr("Delete rule")),
            &QAction::triggered, this, &ListingEditor::resetRequested);
    menu->popup(event->reason() == QContextMenuEvent::Mouse
                    ? event->globalPos()
                    : viewport()->mapToGlobal(lineRect(line).topLeft() + QPoint(marginsWidth(), 20)));
}

bool ListingEditor::viewportEvent(QEvent *event)
{
    if (event->type() == QEvent::Leave)
        setPointed(std::nullopt);
    if (event->type() == QEvent::Resize) {
        const auto *resize = static_cast<QResizeEvent *>(event);
        if (isNarrow(resize->oldSize().width()) != isNarrow(resize->size().width()))
            applyTheme();
    }
    if (event->type() != QEvent::ToolTip)
        return QsciScintilla::viewportEvent(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    QToolTip::showText(help->globalPos(), tipAt(help->pos()), this); // an empty text hides the tooltip
    return true;
}

}
