#pragma once

#include "app/model/code_marks.h"
#include "app/model/session.h"

#include <QElapsedTimer>
#include <QPointer>
#include <QToolButton>
#include <QWidget>

#include <memory>

namespace app {

class CodeView;
class Theme;

/// The code that runs for the open step, with the selected body's values beside it.
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

signals:
    void captionChanged(const QString &caption);
    /// Something for the status line.
    void said(const QString &sentence);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void makeActions();
    void applyTheme();
    void follow();
    void rebuild();
    void refresh();
    void showCaption();
    void showNewLines();
    void copyAll();
    std::optional<CodeListing> listingBefore() const;
    int point() const;

    Session &m_session;
    const Theme &m_theme;
    CodeView *m_view;
    QPointer<QWidget> m_actions;
    QToolButton *m_newLines = nullptr;
    QToolButton *m_copy = nullptr;
    CodeListing m_listing;
    std::shared_ptr<const sim::Segment> m_segment; ///< what m_listing was made of
    sim::MethodPtr m_method;
    const lessons::Step *m_step = nullptr;
    bool m_begun = false;      ///< whether the values have left frame 0 since the code is on show
    QElapsedTimer m_refreshed; ///< since the values were last shown
    QString m_caption;
};

}
