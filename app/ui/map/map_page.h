#pragma once

#include "app/model/session/session.h"
#include "app/ui/theme/theme.h"

#include <QDialog>

#include <optional>

class QLabel;

namespace app {

class ConceptView;
class NarrationText;
class StepButton;

/// The start page of the lessons: a map of all concepts. It shows what rests on what, what the learner knows, and what can come
/// next. A click opens the step that teaches a concept, and closes the page.
class MapPage : public QDialog
{
    Q_OBJECT

public:
    /// `session` must outlive this.
    MapPage(Session &session, const Theme &theme, QWidget *parent = nullptr);

    /// Returns whether the lessons have concepts.
    static bool hasConcepts(const LessonLibrary &library);
    /// Shows the page over its parent, as large as that allows.
    void showMap();

private:
    QWidget *makeLegend();
    void makeFoot();
    void rebuild();
    void refresh();
    /// Tells about the concept that is lit, or how to use the page.
    void describe();
    void openStep(std::size_t node);
    QString stateOf(std::size_t node) const;

    Session &m_session;
    const Theme &m_theme;
    QLabel *m_count;
    ConceptView *m_view;
    NarrationText *m_text = nullptr;
    StepButton *m_next = nullptr;
    std::optional<std::size_t> m_nextNode; ///< the first concept that can come next
};

}
