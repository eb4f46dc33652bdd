#pragma once

#include "app/model/listing/changed_lines.h"
#include "app/model/listing/learner_code.h"
#include "app/model/listing/line_values.h"
#include "app/model/listing/vector_mark.h"
#include "app/ui/code/parameter_drag.h"
#include "app/ui/code/scintilla_style.h"
#include "app/ui/code/value_chip.h"

#include <QTimer>

#include <optional>
#include <vector>

class QMenu;

namespace app {

class Theme;

/// The lines of a listing that the editor marks.
struct LineMarks
{
    int next = 0;          ///< runs next, with an arrow; from 1, 0: none
    bool isInside = false; ///< whether the run is inside a frame, so that the next line has a background
    int failed = 0;        ///< its mistake ended the run; from 1, 0: none
    friend bool operator==(const LineMarks &, const LineMarks &) = default;
};

/// A breakpoint on a line of the listing.
struct LineStop
{
    int line = 0; ///< from 1
    bool isOn = true;
    bool hasCondition = false;
    friend bool operator==(const LineStop &, const LineStop &) = default;
};

/// An editor for the listing of a step, with values at the ends of lines, or for a rule of the sandbox. It
/// reports what the learner typed.
///
/// A click in the margin asks to run to a line; Ctrl and a click, F9, or a click on its dot ask for a breakpoint or remove
/// it. A parameter or a number can be dragged sideways. Esc leaves the editor. Tab
/// and Shift+Tab indent, but a learner who has come by Tab goes on by Tab. Undo and redo are the window's.
class ListingEditor : public QsciScintilla
{
    Q_OBJECT

public:
    /// The time from the last key to written(), in ms.
    static constexpr int pauseMilliseconds = 150;

    enum class Kind {
        listing, ///< its lines run one by one, so the run can go to them and stop before them
        rule,
    };

    /// `drag` changes the parameters that the learner drags.
    ListingEditor(const Theme &theme, Kind kind, const ParameterDrag &drag, QWidget *parent = nullptr);

    /// Shows `text`. Only the part that differs is replaced. The caret goes behind it if the learner types.
    void setListing(const QString &text);
    /// Moves caret and view to the first line.
    void showTop();
    /// Returns whether the learner typed something that written() has not told yet.
    bool isPending() const { return m_typing.isActive(); }
    /// Emits written() now if it is pending.
    void flush();
    /// Forgets what is pending.
    void dropPending() { m_typing.stop(); }

    /// Underlines the mistakes.
    void setMistakes(const std::vector<CodeMistake> &mistakes);
    void setChangedLines(const ChangedLines &changed);
    void setMarks(const LineMarks &marks);
    const LineMarks &marks() const { return m_marks; }
    /// Sets the breakpoints, which have dots in the margin.
    void setStops(std::vector<LineStop> stops);
    const std::vector<LineStop> &stops() const { return m_stops; }
    /// Moves the caret to a line and scrolls to it.
    void showLine(int line);
    /// Moves the caret to the end of a line.
    void writeBehind(int line);
    /// Sets the values at the ends of lines. While they are `earlier` ones, they are paler.
    void setValues(LineValues values);
    const LineValues &values() const { return m_values; }
    /// Underlines the parameters of the open step, which can be dragged.
    void readParameters();
    /// Marks the places that use a body.
    void setUses(const std::vector<TextRange> &uses);
    /// Shows the names that can continue the word before the caret, or hides the list if there are none.
    void showCompletions(const QStringList &names);

    // For tests: lines from 1, columns in characters from 1, places in the viewport, px.
    QString chipText(int line) const { return chipOf(line).text; }
    /// Returns the place of all rows of a line.
    QRect lineRect(int line) const;
    /// Returns the place of the dot of a breakpoint.
    QRect stopRect(int line) const;
    QString tipAt(const QPoint &place) const;
    QRect wordRect(const TextRange &range) const;
    bool isUnderlined(int line, int column) const;
    bool isUse(int line, int column) const;
    /// Returns whether the list of completions is open.
    bool isListActive() const;
    static constexpr int marginsWidth() { return CodeMargins::text; }

signals:
    /// Emitted when the learner has changed the text and then paused.
    void written(const QString &text);
    /// Emitted when names are wanted for the word before a position.
    void completionsWanted(int line, int column);
    void runRequested(int line);
    /// Emitted when a breakpoint is to be set on a line, or removed from it.
    void stopRequested(int line);
    /// Emitted when the mouse moves to another place of the text, or off the text.
    void pointedAt(std::optional<app::TextRange> place);
    /// Emitted when the learner leaves the editor with the Esc key.
    void left();
    void resetRequested();

protected:
    bool event(QEvent *event) override;
    bool viewportEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    bool focusNextPrevChild(bool next) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    /// A parameter or a number of the text that can be dragged.
    struct Spot
    {
        TextRange range;
        QString text;
        bool isNumber = false;
    };
    struct Drag
    {
        Spot spot;
        QPoint from;
        bool hasBegun = false; ///< whether the mouse has moved far enough
        QString before;        ///< the number's text
    };

    void setUp();
    void applyTheme();
    void styleText();
    void underlineSpots();
    void showBrackets();
    void followText();
    void followCharacter(int character);
    std::vector<Spot> spotsOf(int line) const;
    std::optional<Spot> spotAt(const QPoint &place) const;
    std::optional<TextRange> placeAt(const QPoint &place) const;
    int lineAt(const QPoint &place) const;
    void setPointed(std::optional<TextRange> place);
    void drag(const QPoint &to, bool fine);
    void endDrag(bool keep);

    void breakLine();
    /// Returns the text above the line with this number (from 0).
    QString linesAbove(int line) const;
    void openBrace();
    void closeBrace();
    /// Moves the cursor back to `column` if there are only spaces before it and nothing is selected.
    void indentTo(int column);
    void indentLines(int by);
    QString textBefore(int line, int index) const;

    long positionOf(int line, int column) const { return positionFromLineIndex(line - 1, column - 1); }
    long positionOf(const TextRange &range) const { return positionOf(range.line, range.column); }
    /// Returns the position behind the last character.
    long endOf(const TextRange &range) const { return positionOf(range.line, range.column + range.length); }
    /// Returns the place of the end of the code in a line, without a trailing comment.
    QPoint endOfCode(int line) const;
    /// Returns the first row of a line, which has more rows if it is wrapped.
    QRect firstRow(int line) const;
    QPoint placeOf(long position) const;
    int rowHeight() const;
    /// Returns the forms of the value or loop beside a line, longest first.
    QStringList formsOf(int line) const;
    const LineChip *valueOf(int line) const;
    bool isTypedIn(int line) const;
    ValueChip chipOf(int line) const;
    bool isChanged(int line) const;
    const LineStop *stopOf(int line) const;
    void requestStop(int line);
    void addLineActions(QMenu &menu, int line);
    void paintLine(QPainter &painter, int line) const;
    void paintChange(QPainter &painter, int line) const;

    const Theme &m_theme;
    const Kind m_kind;
    ParameterDrag m_parameterDrag;
    QTimer m_typing;
    bool m_isSetting = false; ///< whether the program changes the text, not the learner
    LineMarks m_marks;
    LineValues m_values;
    std::vector<LineStop> m_stops;
    ChangedLines m_changed;
    QStringList m_parameters;
    std::vector<TextRange> m_parameterUses; ///< where the text reads them
    std::vector<CodeMistake> m_mistakes;
    std::optional<Drag> m_drag;
    bool m_isPassedThrough = false; ///< whether the focus came by Tab and no other key was pressed since
    std::optional<TextRange> m_pointed;
};

}
