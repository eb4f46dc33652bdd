#pragma once

#include "app/ui/actions/step_by.h"

#include <QWidget>

class QAbstractButton;
class QButtonGroup;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace lessons {
struct Step;
}

namespace app {

class CodePanel;
struct CodePlace;
class ListingPanel;
class RulePanel;
class RunCommands;
class SceneView;
class Session;
class Theme;

/// The pages of the code: the one that the learner writes, which is the listing of a step or the rule of a sandbox scene,
/// and the engine's own code. Steps without a listing have the engine's page only. While another method computes the run,
/// its page is shown, and the listing offered.
class CodePages : public QWidget
{
    Q_OBJECT

public:
    enum class Page { listing, rule, engine };
    static constexpr const char *pageKey = "code/page"; ///< settings key of the page that the learner chose

    CodePages(Session &session, const Theme &theme, QWidget *parent = nullptr);
    ~CodePages() override;

    ListingPanel &listing() const { return *m_listing; }
    RulePanel &rule() const { return *m_rule; }
    CodePanel &engine() const { return *m_engine; }
    Page page() const;
    /// Shows a page on the learner's wish, and remembers it.
    void choose(Page page);
    /// Shows the listing, with the caret at the end of a line, so that the learner can write there.
    void writeAt(int line);
    /// Shows what the listing points at in `scene`, and lets the step commands go as the page does; see stepBy().
    void attach(SceneView &scene, RunCommands &commands);
    /// Returns how the step commands go while this page is shown: by lines if the listing computes the run.
    StepBy stepBy() const;
    QString caption() const;
    /// Returns the caption in a word or two, for narrow titles.
    QString shortCaption() const;
    /// Returns the tabs for the title. The code that creates the title must place them, and the actions.
    QWidget *titleTabs() const { return m_tabs; }
    QWidget *titleActions() const { return m_actions; }

signals:
    void captionChanged(const QString &caption);
    void stepByChanged();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    void makeTitle();
    void makeOffer();
    QAbstractButton &tab(Page page) const;
    void follow();
    void show(Page page);
    bool isOffered(Page page) const;
    /// Returns the page that the learner has chosen among those of the open step.
    Page wantedPage() const;
    /// Shows the line of a breakpoint, on its page.
    void showPlace(const CodePlace &place);

    Session &m_session;
    CodePanel *m_engine;
    ListingPanel *m_listing;
    RulePanel *m_rule;
    QStackedWidget *m_pages;
    QWidget *m_offer;
    QLabel *m_offerText;
    QPushButton *m_use;
    QWidget *m_tabs;
    QWidget *m_actions;
    QButtonGroup *m_tabGroup = nullptr;
    bool m_wantsEngine; ///< whether the learner wants the engine's page rather than the one to write
    bool m_wasInUse = true;
    bool m_hadRule = false;
    const lessons::Step *m_step = nullptr; ///< the step that is shown
};

}
