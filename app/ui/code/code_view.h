#pragma once

#include "app/model/code_marks.h"
#include "app/ui/code/code_rows.h"

#include <Qsci/qsciscintilla.h>

#include <QSet>

#include <optional>

namespace app {

class Theme;

/// The code that runs, to be read: its files' own line numbers, what is new, what is now, and values at the ends
/// of lines. Up and Down go from heading to heading, Enter folds.
class CodeView : public QsciScintilla
{
    Q_OBJECT

public:
    explicit CodeView(const Theme &theme, QWidget *parent = nullptr);

    /// Shows `listing` from its top. Sections that were folded stay folded.
    void setListing(const CodeListing &listing);
    void setValues(std::vector<CodeChip> chips, std::vector<SectionMark> marks);

    /// Scrolls, if need be, to the section of the phase that was done last.
    void showNow();
    /// Scrolls from the top, if the view is there, to what runs in every frame.
    void showPhases();
    /// Goes to the next lines that are new, and selects them; after the last ones to the first.
    void showNextNew();

    bool isFolded(std::size_t section) const;
    void setFolded(std::size_t section, bool folded);
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

protected:
    bool event(QEvent *event) override;
    bool viewportEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
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
    void styleText();
    void applyMarks();
    void markRow(std::size_t row);
    void toggle(std::size_t section);
    void select(std::size_t section);
    void scrollTo(std::size_t first, std::size_t row);
    QFont inPoints(QFont font, double pixels) const;

    std::size_t headingRow(std::size_t section) const;
    std::optional<std::size_t> headingAt(const QPoint &position) const;
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
    void paintSymbol(QPainter &painter, std::size_t row) const;
    void paintChip(QPainter &painter, std::size_t row) const;
    void paintFocus(QPainter &painter) const;

    const Theme &m_theme;
    CodeListing m_listing;
    std::vector<CodeRow> m_rows;
    std::vector<CodeChip> m_chips;
    std::vector<SectionMark> m_marks;
    QSet<QString> m_folded = {QStringLiteral("order")}; ///< keys of sections; the order is for the curious
    std::size_t m_current = 0;                          ///< the section that the keyboard is on
    std::size_t m_newRow = 0;                           ///< where showNextNew() was
    bool m_byKeyboard = false;                          ///< whether the focus came from it
};

}
