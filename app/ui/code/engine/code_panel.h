#pragma once

#include "app/model/code/code_history.h"
#include "app/model/code/code_marks.h"
#include "app/model/session/session.h"
#include "app/ui/code/parameter_drag.h"
#include "app/ui/code/title_actions.h"
#include "app/ui/dock/number_pace.h"

#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QToolButton>
#include <QWidget>

#include <memory>

namespace app {

class CodeCard;
class CodeView;
class BreakpointList;
class Theme;

/// A panel with the code that runs for the open step and the selected body's values beside it.
/// From here the learner runs to a line, sets breakpoints, and changes parameters by dragging or typing.
class CodePanel : public QWidget
{
    Q_OBJECT

public:
    CodePanel(Session &session, const Theme &theme, QWidget *parent = nullptr);

    /// Returns the caption for the title, for example "values of foot 0".
    QString caption() const { return m_caption; }
    /// Returns the buttons for the right end of the title, such as next new lines and copy.
    /// The code that creates the title must place them.
    QWidget *titleActions() { return m_actions.widget(); }
    CodeView &view() { return *m_view; }
    const CodeListing &listing() const { return m_listing; }
    BreakpointList &stops() { return *m_stops; }
    const CodeCard &card() const { return *m_card; }
    /// Returns the context menu for a row.
    QMenu *menuFor(std::size_t row);

signals:
    void captionChanged(const QString &caption);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// A line that the learner ran to, and the position of the run there.
    struct RanTo
    {
        std::size_t section = 0;
        std::size_t line = 0;
        sim::Cursor at;
    };
    struct ShownSymbol
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
    std::optional<std::size_t> rowOf(const ParameterSpot &spot) const;
    void takeNumber(const ParameterSpot &spot);
    void dragNumber(int pixels, bool fine);
    void leaveNumber(bool keep);
    void editNumber(const ParameterSpot &spot);
    void takeTyped();
    void closeEditor();
    void askSymbol(std::size_t row, qsizetype column);
    void showCard();
    void hideCard();
    QString whose(const CodeSymbol &symbol) const;
    void pointAt(std::optional<std::size_t> row);
    void followPreview();
    void follow();
    void rebuild();
    void refresh();
    std::vector<SectionMark> marksNow(const sim::Timeline &timeline,
                                      const std::vector<CodeChip> &values) const;
    /// Scrolls to the current position of the run.
    void showCurrent();
    void showCaption();
    void showNewLines();
    void showGoneLines(bool shown);
    void copyAll();
    std::optional<CodeListing> listingBefore() const;
    int point() const;

    Session &m_session;
    const Theme &m_theme;
    CodeView *m_view;
    BreakpointList *m_stops;
    CodeCard *m_card;
    ParameterDrag m_drag{m_session.run(), m_session.editor()};
    ParameterSpot m_dragged;                  ///< the number that was dragged last
    std::optional<ShownSymbol> m_shownSymbol; ///< the symbol on the card
    QPointer<QLineEdit> m_editor;             ///< editor of the number being typed over
    QString m_edited;                         ///< id of its parameter
    TitleActions m_actions;
    QToolButton *m_newLines = nullptr;
    QToolButton *m_goneLines = nullptr;
    CodeListing m_listing;
    std::shared_ptr<const sim::ComposedInterval> m_interval; ///< the source of m_listing
    sim::MethodPtr m_method;
    const lessons::Step *m_step = nullptr;
    std::optional<RanTo> m_ranTo;
    bool m_wasInside = false;   ///< whether the run was inside a frame when the code last scrolled to it
    bool m_begun = false;       ///< whether the values have left frame 0 since this code was shown
    bool m_ownsPreview = false; ///< whether the marked moment is that of the line under the mouse
    std::optional<int> m_top;   ///< the first visible line before the preview began
    NumberPace m_pace{m_session.playback()};
    QString m_caption;
};

}
