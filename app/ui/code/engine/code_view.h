#pragma once

#include "app/model/breakpoints/breakpoints.h"
#include "app/model/code/code_marks.h"
#include "app/model/code/code_symbols.h"
#include "app/ui/code/engine/code_rows.h"
#include "app/ui/code/scintilla_style.h"
#include "app/ui/code/value_chip.h"

#include <QSet>

#include <optional>

namespace app {

class Theme;

/// A read-only view of the code that runs.
/// It shows the line numbers of the source files, new lines, the current line, and values at the ends of lines.
///
/// A click on a line, or Enter, asks to run to it. A click in the margin, or F9, asks for a breakpoint.
/// A parameter can be dragged, or typed over (F2). Up and Down go from line to line; with Ctrl, from heading to heading.
/// Ctrl+Left and Ctrl+Right go from word to word. Enter on a heading folds its section.
class CodeView : public QsciScintilla
{
    Q_OBJECT

public:
    explicit CodeView(const Theme &theme, QWidget *parent = nullptr);

    /// Shows `listing` from its top. Folded sections stay folded.
    void setListing(const CodeListing &listing);
    void setValues(std::vector<CodeChip> chips, std::vector<SectionMark> marks);

    /// Sets the breakpoints, both enabled and disabled ones.
    void setBreakpoints(std::vector<Breakpoint> breakpoints);
    /// Sets the places in the code that show a parameter.
    void setSpots(std::vector<ParameterSpot> spots);
    const std::vector<ParameterSpot> &spots() const { return m_spots; }
    /// Shows or hides the lines that this step removed, at their old places.
    void setGone(Gone gone);
    Gone gone() const { return m_gone; }
    /// Goes to the first removed line, if one is shown.
    void showFirstGone();
    /// Scrolls to a line if necessary, and moves the keyboard's current row there.
    void showPlace(const CodePlace &place);
    const CodeLine *lineAt(std::size_t row) const { return line(m_rows[row]); }

    /// Returns the keyboard's current row.
    std::size_t row() const { return m_row; }
    CodePlace placeOf(std::size_t row) const;
    /// Returns the text to copy for the section with the keyboard's current row.
    QString sectionText() const;
    /// Returns the rectangle of a word of a row, in viewport coordinates (px).
    QRect wordRect(std::size_t row, const CodeWord &word) const;
    /// Returns the row and column at a viewport position; empty where there is no code.
    std::optional<std::pair<std::size_t, qsizetype>> textAt(const QPoint &position) const;
    /// Returns whether a viewport position is in the margins, left of the text.
    bool isInMargin(const QPoint &position) const { return position.x() < marginsWidth(); }

    /// Scrolls, if necessary, to the section of the last completed phase.
    void showNow();
    /// Does the same without moving the keyboard's current row.
    /// Returns the row of the section's heading, if there is one.
    std::optional<std::size_t> scrollToNow();
    /// Scrolls to the code that runs in every frame if the view is at the top.
    void showPhases();
    /// Goes to the next new lines and selects them. Wraps round after the last ones.
    void showNextNew();

    bool isFolded(std::size_t section) const;
    void setFolded(std::size_t section, bool folded);
    /// Returns whether the lines that add up the effects' results are folded. All of these lines fold together.
    bool isPlumbingFolded() const { return m_folded.contains(keyOfPlumbing()); }
    /// Returns the unfolded sections as text, with file names.
    QString shownText() const;

    // The appearance, for drawing and for tests.
    const std::vector<CodeRow> &rows() const { return m_rows; }
    const std::vector<CodeChip> &values() const { return m_chips; }
    /// Returns the text on the row's chip, which may be a shortened value; empty if the row has no chip.
    QString chipText(std::size_t row) const { return chipBox(row).text; }
    /// Returns the row's rectangle over the full width of the viewport; empty while the row is folded away.
    QRect rowRect(std::size_t row) const;
    /// Returns the background colour of a marked row; invalid if the row is not marked.
    QColor wash(std::size_t row) const;
    /// Returns the total width (px) of line numbers, symbols and colour bar.
    static constexpr int marginsWidth() { return CodeMargins::text; }
    bool isToCome(std::size_t row) const;
    /// Returns whether a row is pale because a learner need not read it; see CodeLine.
    bool isQuiet(std::size_t row) const;

    static constexpr const char *foldedKey = "code/folded"; ///< settings key of the folded sections

signals:
    /// Emitted when the user asks to set or remove a breakpoint on this row.
    void stopRequested(std::size_t row);
    /// Emitted when the user asks to run to the phase of this row.
    void runRequested(std::size_t row);
    /// Emitted when the user starts to drag a number, moves it (`pixels` since the start), and ends the drag.
    /// `keep` is false if the drag was cancelled.
    void numberTaken(const app::ParameterSpot &spot);
    void numberDragged(int pixels, bool fine);
    void numberLeft(bool keep);
    /// Emitted when the user asks to type over a number.
    void numberRequested(const app::ParameterSpot &spot);
    /// Emitted when the user asks to show or hide the removed lines.
    void removedLinesRequested();
    /// Emitted when the user asks about the symbol at this column of a row.
    void symbolRequested(std::size_t row, qsizetype column);
    /// Emitted when the request is cancelled.
    void symbolDropped();
    /// Emitted when the mouse moves onto another row, or off all rows.
    void rowPointedAt(std::optional<std::size_t> row);
    /// Emitted when the user asks for a row's context menu, at a screen position.
    void menuRequested(const QPoint &place, std::size_t row);

protected:
    bool event(QEvent *event) override;
    bool viewportEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void setUp();
    void applyTheme();
    /// Writes the rows of the listing.
    void layRows();
    void styleText();
    void styleRemovedLines(const QColor &ink);
    void strikeGone();
    /// Returns the row with the same kind, section and line, or else the section's heading.
    std::size_t rowOf(const CodeRow &sought) const;
    void applyMarks();
    void markRow(std::size_t row);
    /// Returns the fold key of a row; empty if the row folds nothing.
    QString foldKey(const CodeRow &row) const;
    void fold(const QString &key, bool folded);
    /// Folds or unfolds on user input, and saves the choice.
    void toggle(const QString &key);
    /// Unfolds everything that hides a row.
    void unfold(std::size_t row);
    void goToRow(std::size_t row);
    /// Moves by `by` rows or headings; moveByWords() by `by` words of the current row.
    void moveByRows(int by, bool onlyHeadings);
    void moveByWords(int by);
    std::vector<CodeWord> wordsOfRow(std::size_t row) const;
    /// Returns the keyboard's current column, or the column of the first word that may have a known value.
    qsizetype column() const;
    void steer(const QKeyEvent &event);
    void actOnRow();
    void askNumber();
    void askSymbol();
    std::optional<std::size_t> rowAt(const QPoint &position) const;
    /// Returns the parameter at a position, in its word or in the value at the end of its line; null for none.
    const ParameterSpot *spotAt(const QPoint &position) const;
    const ParameterSpot *spotOf(std::size_t row, qsizetype column) const;
    void forgetWord(const QPoint &position);
    void setPointed(std::optional<std::size_t> row);
    void underlineSpots();
    void scrollTo(std::size_t first, std::size_t row);

    std::size_t headingRow(std::size_t section) const;
    const SectionMark *mark(const CodeRow &row) const;
    const CodeLine *line(const CodeRow &row) const;
    const CodeChip *chip(const CodeRow &row) const;
    bool isResult(const CodeRow &row) const;
    /// Returns Scintilla's position of a column of a row.
    long positionOf(std::size_t row, qsizetype column) const;
    int rowHeight() const;
    int endOfText(std::size_t row) const;
    int endOfCode(std::size_t row) const; ///< like endOfText(), without a trailing comment
    ValueChip chipBox(std::size_t row) const;
    QString tipAt(const QPoint &position) const;

    void paintRow(QPainter &painter, std::size_t row) const;
    void paintHeading(QPainter &painter, std::size_t row) const;
    void paintChevron(QPainter &painter, std::size_t row) const;
    void paintSymbol(QPainter &painter, std::size_t row) const;
    void paintSign(QPainter &painter, std::size_t row, const QString &sign, const QColor &ink) const;
    const Breakpoint *breakpoint(std::size_t row) const;
    void paintChip(QPainter &painter, std::size_t row) const;
    void paintFocus(QPainter &painter) const;

    const Theme &m_theme;
    CodeListing m_listing;
    Gone m_gone = Gone::hidden;
    std::vector<CodeRow> m_rows;
    std::vector<CodeChip> m_chips;
    std::vector<SectionMark> m_marks;
    /// Keys of the folded sections. The order of effects and the adding-up code are folded at first: few learners need them.
    QSet<QString> m_folded = {QStringLiteral("order"), keyOfPlumbing()};
    std::vector<Breakpoint> m_breakpoints;
    std::vector<ParameterSpot> m_spots;
    std::size_t m_row = 0;           ///< the keyboard's current row
    std::optional<CodeWord> m_word;  ///< the keyboard's current word in that row
    bool m_keepsRow = false;         ///< whether m_row stays visible when the view shrinks
    std::size_t m_newRow = 0;        ///< the row that showNextNew() last went to
    bool m_byKeyboard = false;       ///< whether the keyboard gave the focus
    std::optional<QPoint> m_pressed; ///< where the mouse was pressed on a line
    std::optional<QPoint> m_taken;   ///< where it started to drag a number
    std::optional<std::pair<std::size_t, qsizetype>>
        m_hoveredWord;                    ///< the word under the mouse whose card is requested
    std::optional<std::size_t> m_pointed; ///< the row under the mouse
};

}
