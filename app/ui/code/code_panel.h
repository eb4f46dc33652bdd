#pragma once

#include "app/model/code_history.h"
#include "app/model/code_marks.h"
#include "app/model/session.h"

#include <QElapsedTimer>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QToolButton>
#include <QWidget>

#include <memory>

namespace app {

class CodeCard;
class CodeView;
class StopList;
class Theme;

/// The code that runs for the open step, with the selected body's values beside it, and with what a learner does to the
/// run from there: running to a line, breakpoints, and parameters that are dragged or typed over.
class CodePanel : public QWidget
{
    Q_OBJECT

public:
    CodePanel(Session &session, const Theme &theme, QWidget *parent = nullptr);
    ~CodePanel() override;

    /// Whose values are shown, for the title: "values of foot 0".
    QString caption() const { return m_caption; }
    /// The buttons for the right end of the title: next new lines, copy. To be placed by whoever makes the title.
    QWidget *titleActions() { return m_actions; }
    CodeView &view() { return *m_view; }
    const CodeListing &listing() const { return m_listing; }
    StopList &stops() { return *m_stops; }
    const CodeCard &card() const { return *m_card; }
    /// The menu for a row.
    QMenu *menuFor(std::size_t row);

signals:
    void captionChanged(const QString &caption);
    /// Something for the status line.
    void said(const QString &sentence);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Drag
    {
        ParameterSpot spot;
        double from;
    };
    /// A line that a learner ran to, and where the run is then.
    struct RanTo
    {
        std::size_t section = 0;
        std::size_t line = 0;
        sim::Cursor at;
    };
    struct Asked
    {
        CodeSymbol symbol;
        QRect word; ///< in the view's viewport
    };

    void makeActions();
    void connectView();
    void connectNumbers();
    void showBreakpoints();
    void toggleStop(std::size_t row);
    void runTo(std::size_t row);
    const lessons::Parameter *parameterOf(const ParameterSpot &spot) const;
    void takeNumber(const ParameterSpot &spot);
    void dragNumber(int pixels, bool fine);
    void leaveNumber(bool keep);
    void editNumber(const ParameterSpot &spot);
    void takeTyped();
    void closeEditor();
    void askSymbol(std::size_t row, qsizetype column);
    void showCard();
    QString whose(const CodeSymbol &symbol) const;
    void applyTheme();
    void pointAt(std::optional<std::size_t> row);
    void followGlance();
    void follow();
    void rebuild();
    void refresh();
    std::vector<SectionMark> marksNow(const sim::Timeline &timeline,
                                      const std::vector<CodeChip> &values) const;
    /// Scrolls to where the run stands.
    void showStand();
    void showCaption();
    void showNewLines();
    void showGoneLines(bool shown);
    void copyAll();
    std::optional<CodeListing> listingBefore() const;
    int point() const;

    Session &m_session;
    const Theme &m_theme;
    CodeView *m_view;
    StopList *m_stops;
    CodeCard *m_card;
    std::optional<Drag> m_drag;   ///< the number that the mouse holds
    std::optional<Asked> m_asked; ///< what the card shows
    QPointer<QLineEdit> m_editor; ///< of the number that is typed over
    QString m_edited;             ///< its parameter
    QPointer<QWidget> m_actions;
    QToolButton *m_newLines = nullptr;
    QToolButton *m_goneLines = nullptr;
    QToolButton *m_copy = nullptr;
    CodeListing m_listing;
    std::shared_ptr<const sim::ComposedInterval> m_interval; ///< what m_listing was made of
    sim::MethodPtr m_method;
    const lessons::Step *m_step = nullptr;
    std::optional<RanTo> m_ranTo;
    bool m_wasInside = false;  ///< whether the run stood inside a frame when the code last scrolled to it
    bool m_begun = false;      ///< whether the values have left frame 0 since the code is on show
    bool m_looks = false;      ///< whether the moment that is marked is that of the line under the mouse
    std::optional<int> m_top;  ///< the first line in sight before somebody looked at another moment
    QElapsedTimer m_refreshed; ///< since the values were last shown
    QString m_caption;
};

}
