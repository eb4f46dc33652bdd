#pragma once

#include "app/model/learning/project_desk.h"
#include "app/ui/theme/theme.h"

#include <QFrame>

#include <vector>

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace app {

class ButtonFlow;
class LevelBox;
class NarrationText;

/// A project with its brief, its three levels, and the buttons that open the place where it is built.
class ProjectBox : public QFrame
{
    Q_OBJECT

public:
    /// Which projects the box shows.
    enum class Shows {
        lesson, ///< that of the open lesson, after its text
        current, ///< the one that the learner works on, while its place in the sandbox is open: folded to its title
    };

    /// The arguments must outlive this object.
    ProjectBox(const OpenRun &run, ProjectDesk &desk, Shows shows, const Theme &theme,
               QWidget *parent = nullptr);

    /// Returns the id of the lesson whose project is shown; empty if the box is hidden.
    const QString &lesson() const { return m_lesson; }
    const std::vector<LevelBox *> &levels() const { return m_levels; }

signals:
    /// The height can be another.
    void heightChanged();

protected:
    void showEvent(QShowEvent *event) override;

private:
    void makeHead();
    /// Shows the brief and the levels, or the title only.
    void unfold(bool isOpen);
    QString wantedLesson() const;
    void follow();
    void makeLevels();
    void refresh();
    void refreshButtons();

    const OpenRun &m_run;
    ProjectDesk &m_desk;
    const Shows m_shows;
    const Theme &m_theme;
    QString m_lesson;
    bool m_isStale = false; ///< while the box is hidden, its texts are not made
    QString m_shownTitle;   ///< of the project that m_levels belong to, to see another language
    QToolButton *m_fold = nullptr;
    QLabel *m_title;
    QLabel *m_count;
    QWidget *m_content;
    NarrationText *m_brief;
    ButtonFlow *m_buttons = nullptr;
    QToolButton *m_start = nullptr;
    QToolButton *m_goOn = nullptr;
    QToolButton *m_putAway = nullptr;
    QVBoxLayout *m_column; ///< of the levels
    std::vector<LevelBox *> m_levels;
};

}
