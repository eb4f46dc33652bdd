#pragma once

#include "app/model/breakpoints.h"
#include "app/model/code_marks.h"
#include "app/model/code_symbols.h"
#include "app/ui/code/code_rows.h"

#include <Qsci/qsciscintilla.h>

#include <QSet>

#include <optional>

namespace app {

class Theme;

/// The code that runs, to be read: its files' own line numbers, what is new, what is now, and values at the ends
/// of lines. A click on a line, or Enter, asks to run to it; a click in the margin, or F9, for a breakpoint. What is a
/// parameter can be dragged, or typed over (F2). Up and Down go from line to line, with Ctrl from heading to heading;
/// Ctrl with Left and Right from word to word; Enter on a heading folds.
class CodeView : public QsciScintilla
{
    Q_OBJECT

public:
    explicit CodeView(const Theme &theme, QWidget *parent = nullptr);

    /// Shows `listing` from its top. Sections that were folded stay folded.
    void setListing(const CodeListing &listing);
    void setValues(std::vector<CodeChip> chips, std::vector<SectionMark> marks);

    /// The lines that stop the run, and those of them that are switched on.
    void setBreakpoints(std::vector<Breakpoint> breakpoints);
    /// Where a parameter's number stands.
    void setSpots(std::vector<ParameterSpot> spots);
    const std::vector<ParameterSpot> &spots() const { return m_spots; }
    /// Whether lines of the step before that are gone are shown, where they were.
    void setGone(Gone gone);
    Gone gone() const { return m_gone; }
    /// Goes to the first of them, if any is shown.
    void showFirstGone();
    /// Scrolls, if need be, to a line, and takes the keyboard's place there.
    void showPlace(const CodePlace &place);
    const CodeLine *lineAt(std::size_t row) const { return line(m_rows[row]); }

    /// The row that the keyboard is on.
    std::size_t row() const { return m_row; }
    CodePlace placeOf(std::size_t row) const;
    /// The section's text as it is copied: the one that the keyboard is on.
    QString sectionText() const;
    /// Where a stretch of a row's text stands in the viewport.
    QRect wordRect(std::size_t row, const CodeWord &word) const;
    /// The row and the column under a place of the viewport; empty where there is no code.
    std::optional<std::pair<std::size_t, qsizetype>> textAt(const QPoint &position) const;
    /// Whether a place is on a line's marks, left of its text.
    bool isInMargin(const QPoint &position) const { return position.x() < marginsWidth(); }

    /// Scrolls, if need be, to the section of the phase that was done last.
    void showNow();
    /// The same, and the keyboard stays where it is. Returns the row of the section's heading, if there is one.
    std::optional<std::size_t> scrollToNow();
    /// Scrolls from the top, if the view is there, to what runs in every frame.
    void showPhases();
    /// Goes to the next lines that are new, and selects them; after the last ones to the first.
    void showNextNew();

    bool isFolded(std::size_t section) const;
    void setFolded(std::size_t section, bool folded);
    /// Whether the lines are folded that add up what effects have computed: all of them fold together.
    bool isPlumbingFolded() const { return m_folded.contains(keyOfPlumbing()); }
    /// The sections that are not folded, as text with file names.
    QString shownText() const;

    // How it looks: for drawing, and for tests.
    const std::vector<CodeRow> &rows() const { return m_rows; }
    const std::vector<CodeChip> &values() const { return m_chips; }
    /// What stands on the row's chip, which may be narrower than its value; empty without one.
    QString chipText(std::size_t row) const { return chipBox(row).text; }
    /// The row's place in the viewport, as wide as that; empty while it is folded away.
    QRect rowRect(std::size_t row) const;
    /// The colour behind the text of a row, if it is marked.
    QColor wash(std::size_t row) const;
    /// How wide numbers, symbols and colour bar are together.
    static int marginsWidth();
    bool isToCome(std::size_t row) const;
    /// Whether a row is pale because a learner need not read it: see CodeLine.
    bool isQuiet(std::size_t row) const;

    static constexpr const char *foldedKey = "code/folded"; ///< of the settings: what is folded

signals:
    /// A breakpoint on this row is to be set, or taken away.
    void stopAsked(std::size_t row);
    /// The run is to go to the phase of this row.
    void runAsked(std::size_t row);
    /// The mouse took hold of a number, moved by so many pixels since, and let go (or gave up).
    void numberTaken(const app::ParameterSpot &spot);
    void numberDragged(int pixels, bool fine);
    void numberLeft(bool keep);
    /// A number is to be typed over.
    void numberAsked(const app::ParameterSpot &spot);
    /// Lines that are gone are to be shown, or no longer.
    void goneAsked();
    /// What stands at this column of a row is asked for.
    void symbolAsked(std::size_t row, qsizetype column);
    /// Nobody asks any more.
    void symbolDropped();
    /// The mouse is on a row, or on none any more.
    void rowPointedAt(std::optional<std::size_t> row);
    /// A menu is asked for at a place of the screen, about a row.
    void menuAsked(const QPoint &place, std::size_t row);

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
    struct Box
    {
        QRect rect;
        QString text;
    };

    void setUp();
    void applyTheme();
    void defineStyle(int style, const QFont &font, const QColor &ink, const QColor &paper);
    void makeRowsAsHigh(int pixels);
    /// Writes the rows of the listing.
    void layRows();
    void styleText();
    void dressGone(const QColor &ink);
    void strikeGone();
    /// The row of the same kind, section and line; else the section's heading.
    std::size_t rowOf(const CodeRow &sought) const;
    void applyMarks();
    void markRow(std::size_t row);
    /// By which key a row folds what is below it; empty where it folds nothing.
    QString foldKey(const CodeRow &row) const;
    void fold(const QString &key, bool folded);
    /// Folds or unfolds, as a learner does: that is remembered.
    void toggle(const QString &key);
    /// Unfolds all that hides a row.
    void unfold(std::size_t row);
    void goToRow(std::size_t row);
    /// By so many rows, or headings, or words of the row.
    void moveByRows(int by, bool onlyHeadings);
    void moveByWords(int by);
    std::vector<CodeWord> wordsOfRow(std::size_t row) const;
    /// The column that the keyboard is on, or that of the first word whose number may be known.
    qsizetype column() const;
    void steer(const QKeyEvent &event);
    void actOnRow();
    void askNumber();
    void askSymbol();
    std::optional<std::size_t> rowAt(const QPoint &position) const;
    /// The parameter under a place: its word, or the value at the end of its line.
    const ParameterSpot *spotAt(const QPoint &position) const;
    const ParameterSpot *spotOf(std::size_t row, qsizetype column) const;
    void forgetWord(const QPoint &position);
    void setPointed(std::optional<std::size_t> row);
    void underlineSpots();
    void scrollTo(std::size_t first, std::size_t row);
    QFont inPoints(QFont font, double pixels) const;

    std::size_t headingRow(std::size_t section) const;
    const SectionMark *mark(const CodeRow &row) const;
    const CodeLine *line(const CodeRow &row) const;
    const CodeChip *chip(const CodeRow &row) const;
    bool isResult(const CodeRow &row) const;
    int rowHeight() const;
    int endOfText(std::size_t row) const;
    int endOfCode(std::size_t row) const; ///< as endOfText(), without a comment
    Box chipBox(std::size_t row) const;
    QString tipAt(const QPoint &position) const;

    void paintRow(QPainter &painter, std::size_t row) const;
    void paintHeading(QPainter &painter, std::size_t row) const;
    void paintChevron(QPainter &painter, std::size_t row) const;
    void paintSymbol(QPainter &painter, std::size_t row) const;
    void paintSign(QPainter &painter, std::size_t row, const QString &sign, const QColor &ink) const;
    void paintStop(QPainter &painter, std::size_t row, const Breakpoint &breakpoint) const;
    const Breakpoint *breakpoint(std::size_t row) const;
    void paintChip(QPainter &painter, std::size_t row) const;
    void paintFocus(QPainter &painter) const;

    const Theme &m_theme;
    CodeListing m_listing;
    Gone m_gone = Gone::hidden;
    std::vector<CodeRow> m_rows;
    std::vector<CodeChip> m_chips;
    std::vector<SectionMark> m_marks;
    /// Keys of what is folded. The order and how things are added up are for the curious.
    QSet<QString> m_folded = {QStringLiteral("order"), keyOfPlumbing()};
    std::vector<Breakpoint> m_breakpoints;
    std::vector<ParameterSpot> m_spots;
    std::size_t m_row = 0;           ///< that the keyboard is on
    std::optional<CodeWord> m_word;  ///< of that row, likewise
    bool m_keepsRow = false;         ///< whether m_row stays in sight when the view gets smaller
    std::size_t m_newRow = 0;        ///< where showNextNew() was
    bool m_byKeyboard = false;       ///< whether the focus came from it
    std::optional<QPoint> m_pressed; ///< where the mouse went down on a line
    std::optional<QPoint> m_taken;   ///< where it took hold of a number
    std::optional<std::pair<std::size_t, qsizetype>> m_asked; ///< the word that the mouse asked for
    std::optional<std::size_t> m_pointed;                     ///< the row that it is on
};

}
