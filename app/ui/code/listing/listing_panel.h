#pragma once

#include "app/model/breakpoints/breakpoints.h"
#include "app/model/listing/vector_mark.h"
#include "app/model/session/session.h"
#include "app/ui/code/title_actions.h"
#include "app/ui/dock/number_pace.h"

#include <QWidget>

class QLabel;

namespace app {

class BreakpointList;
class ListingEditor;
class MistakeRow;
class Theme;

/// A panel with the listing of the open step: the whole program of a frame, which the learner steps through and changes.
/// Each change is compiled after a short pause, and the run is computed again.
class ListingPanel : public QWidget
{
    Q_OBJECT

public:
    ListingPanel(Session &session, const Theme &theme, QWidget *parent = nullptr);
    /// Applies the text that was typed last.
    ~ListingPanel() override;

    ListingEditor &editor() { return *m_editor; }
    BreakpointList &stops() { return *m_stops; }
    /// Returns the buttons for the right end of the title. The code that creates the title must place them.
    QWidget *titleActions() { return m_actions.widget(); }
    /// Returns the sentence under the editor; empty if the listing has no mistake.
    QString sentence() const;
    /// Returns the calls around the next line, "frame › grow"; empty outside of functions that `frame` calls.
    QString calls() const;
    /// Marks where the listing uses a body of the scene. An empty name marks nothing.
    void setPointedBody(const QString &body);

signals:
    /// Emitted when the mouse moves onto a Vec2 of the listing, or off it.
    void vectorPointedAt(const std::optional<app::VectorMark> &vector);
    /// Emitted when the learner chooses a breakpoint on a line.
    void placeChosen(const app::CodePlace &place);
    /// Emitted when the learner leaves the editor by keyboard.
    void left();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void connectEditor();
    void follow(const Change &change);
    void refresh();
    void showText();
    void showMistakes();
    void showValues();
    void showUses();
    void showStops();
    void toggleStop(int line);
    void pointAt(const std::optional<TextRange> &place);

    Session &m_session;
    QLabel *m_calls;
    ListingEditor *m_editor;
    MistakeRow *m_mistake;
    BreakpointList *m_stops;
    TitleActions m_actions;
    QToolButton *m_reset;
    const lessons::Step *m_step = nullptr; ///< the step that is shown
    std::optional<TextRange> m_pointed;
    QString m_pointedBody;
    NumberPace m_pace{m_session.playback()};
};

}
