// Numbers in the code: dragging and typing of parameters, and the card that explains a symbol.

#include "app/model/code/code_targets.h"
#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "app/ui/code/engine/code_card.h"
#include "app/ui/code/engine/code_panel.h"
#include "app/ui/code/engine/code_view.h"
#include "app/ui/theme/theme.h"
#include "sim/run/script/composed_interval.h"

#include <QKeyEvent>
#include <QScrollBar>

#include <algorithm>

namespace app {

namespace {

constexpr int editorWidth = 92;
constexpr int editorHeight = 26;
constexpr int moreOnCard = 3; ///< additional decimals of a value on the card

}

void CodePanel::connectNumbers()
{
    connect(m_view, &CodeView::numberTaken, this, &CodePanel::takeNumber);
    connect(m_view, &CodeView::numberDragged, this, &CodePanel::dragNumber);
    connect(m_view, &CodeView::numberLeft, this, &CodePanel::leaveNumber);
    connect(m_view, &CodeView::numberRequested, this, &CodePanel::editNumber);
    connect(m_view, &CodeView::symbolRequested, this, &CodePanel::askSymbol);
    for (const QScrollBar *bar : {m_view->verticalScrollBar(), m_view->horizontalScrollBar()}) {
        // The editor and the card belong to a word that has now moved.
        connect(bar, &QScrollBar::valueChanged, this, [this] {
            closeEditor();
            hideCard();
        });
    }
    connect(m_view, &CodeView::symbolDropped, this, &CodePanel::hideCard);
}

std::optional<std::size_t> CodePanel::rowOf(const ParameterSpot &spot) const
{
    const std::vector<CodeRow> &rows = m_view->rows();
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const CodeRow &one) {
        return one.kind == CodeRow::Kind::code && one.section == spot.section && one.line == spot.line;
    });
    return row == rows.end() ? std::nullopt : std::optional(static_cast<std::size_t>(row - rows.begin()));
}

void CodePanel::takeNumber(const ParameterSpot &spot)
{
    closeEditor();
    m_dragged = spot;
    m_drag.take(spot.word.parameter);
}

void CodePanel::dragNumber(int pixels, bool fine)
{
    if (!m_drag.drag(pixels, fine))
        return;
    if (const std::optional<std::size_t> row = rowOf(m_dragged))
        askSymbol(*row, m_dragged.word.from);
}

void CodePanel::leaveNumber(bool keep)
{
    if (m_drag.leave(keep))
        hideCard();
}

void CodePanel::editNumber(const ParameterSpot &spot)
{
    const lessons::Parameter *parameter = m_step->parameter(spot.word.parameter);
    const std::optional<std::size_t> row = rowOf(spot);
    if (!parameter || !row)
        return;
    leaveNumber(true);
    closeEditor();
    m_edited = parameter->id;
    // A child of the panel, not of the view, because keys that the editor ignores would otherwise steer the
    // view.
    m_editor = new QLineEdit(typedText(*parameter, m_session.editor().parameter(m_edited)), this);
    m_editor->setObjectName("parameter");
    m_editor->setAcceptDrops(false); // the window takes files
    m_editor->setFont(m_theme.mono(13));
    m_editor->setAccessibleName(parameter->unit.isEmpty() ? parameter->name
                                                          : parameter->name + ", " + parameter->unit);
    m_editor->setToolTip(tr("%1 Press Enter to apply, Esc to cancel.").arg(parameter->help));
    const QRect word = m_view->wordRect(*row, spot.word);
    const int left = std::clamp(word.left() - 6, 0, std::max(0, m_view->viewport()->width() - editorWidth));
    const QPoint corner(left, word.center().y() - editorHeight / 2);
    m_editor->setGeometry({m_view->viewport()->mapTo(this, corner), QSize(editorWidth, editorHeight)});
    m_editor->selectAll();
    m_editor->installEventFilter(this);
    connect(m_editor, &QLineEdit::returnPressed, this, &CodePanel::takeTyped);
    m_editor->show();
    m_editor->setFocus(Qt::OtherFocusReason);
}

void CodePanel::takeTyped()
{
    const lessons::Parameter *parameter = m_step->parameter(m_edited);
    if (!m_editor || !parameter)
        return;
    double value = 0.0;
    try {
        value = typedValue(*parameter, m_editor->text());
    } catch (const UserError &error) {
        m_session.showMessage(error.sentence());
        m_editor->selectAll();
        return;
    }
    closeEditor();
    m_session.editor().endGesture();
    m_session.editor().setParameter(parameter->id, value);
    m_session.editor().endGesture();
}

void CodePanel::closeEditor()
{
    if (!m_editor)
        return;
    QLineEdit *editor = m_editor;
    m_editor = nullptr;
    const bool hadFocus = editor->hasFocus();
    editor->removeEventFilter(this);
    editor->hide();
    editor->deleteLater(); // the editor may be the caller
    if (hadFocus)
        m_view->setFocus(Qt::OtherFocusReason);
}

bool CodePanel::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_editor || !m_editor)
        return QWidget::eventFilter(watched, event);
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (isKey && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape) {
        event->accept();
        if (event->type() == QEvent::KeyPress)
            closeEditor();
        return true;
    }
    if (event->type() == QEvent::FocusOut &&
        static_cast<QFocusEvent *>(event)->reason() != Qt::PopupFocusReason &&
        static_cast<QFocusEvent *>(event)->reason() != Qt::ActiveWindowFocusReason)
        closeEditor();
    return QWidget::eventFilter(watched, event);
}

void CodePanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    leaveNumber(true);
    closeEditor();
    hideCard();
}

bool CodePanel::event(QEvent *event)
{
    if (event->type() == QEvent::WindowDeactivate)
        hideCard(); // it would otherwise stay on top of other programs
    return QWidget::event(event);
}

void CodePanel::askSymbol(std::size_t row, qsizetype column)
{
    const CodeRow &its = m_view->rows()[row];
    const std::vector<CodeWord> words = wordsOf(its.text);
    const auto word = std::find_if(words.begin(), words.end(),
                                   [column](const CodeWord &one) { return one.contains(column); });
    if (word == words.end())
        return;
    const auto symbol =
        symbolAt(m_listing, its.section, its.line, column, m_view->spots(), *m_step, *m_interval, point());
    if (!symbol) {
        if (m_view->hasFocus() && !m_view->viewport()->underMouse())
            m_session.showMessage(tr("“%1” has no known value.").arg(word->name));
        return;
    }
    m_shownSymbol = ShownSymbol{*symbol, m_view->wordRect(row, *word)};
    showCard();
}

QString CodePanel::whose(const CodeSymbol &symbol) const
{
    if (symbol.phase < 0)
        return {};
    const sim::Pipeline &pipeline = m_interval->pipeline;
    const QString phase = phrase(pipeline.phases[static_cast<std::size_t>(symbol.phase)].title);
    return tr("Of %1, in “%2”.").arg(bodyTitle(m_session.selected()), phase);
}

void CodePanel::hideCard()
{
    m_shownSymbol.reset();
    m_card->hide();
}

void CodePanel::showCard()
{
    if (!m_shownSymbol)
        return;
    const CodeSymbol &symbol = m_shownSymbol->symbol;
    CodeHistory history = historyOf(symbol, m_session.timeline().track(), m_session.selected().toStdString());
    for (CodeHistory::Sample &sample : history.samples) {
        if (symbol.parameter.isEmpty())
            sample.value = withoutNoise(sample.value, noiseOf(m_interval->scene));
    }
    QString value = tr("none yet");
    if (const lessons::Parameter *parameter = m_step->parameter(symbol.parameter))
        value = typedText(*parameter, m_session.editor().parameter(symbol.parameter));
    else if (!history.samples.empty())
        value = shownValue(history.samples.back().value, moreOnCard);
    if (!symbol.unit.isEmpty() && (!history.samples.empty() || !symbol.parameter.isEmpty()))
        value += QChar(0x2009) + symbol.unit;
    const QRect word(m_view->viewport()->mapToGlobal(m_shownSymbol->word.topLeft()),
                     m_shownSymbol->word.size());
    m_card->show(symbol, whose(symbol), history, value, word);
}

}
