#pragma once

#include "app/model/learning/project_desk.h"
#include "app/ui/learn/fold_box.h"

class QLabel;
class QToolButton;

namespace app {

class ButtonFlow;
class NarrationText;

/// A level of a project, folded to its title. Unfolded, it shows what the level asks, its conditions with a mark for each
/// that held when it was judged last, the judgement, and buttons to judge it and to show a hint.
class LevelBox : public FoldBox
{
    Q_OBJECT

public:
    /// `level` is a level of the project of `lesson`. The other arguments must outlive this object.
    LevelBox(ProjectDesk &desk, const QString &lesson, const lessons::ProjectLevel &level, const Theme &theme,
             QWidget *parent = nullptr);

    const QString &level() const { return m_id; }
    /// Shows the present state of the desk.
    void refresh();

signals:
    /// The height can be another.
    void changed();

protected:
    void fill() override;

private:
    void refreshContent();
    QString demandText() const;

    ProjectDesk &m_desk;
    const QString m_lesson;
    const QString m_id;
    const QString m_name;
    const QString m_text;
    const std::vector<lessons::ProjectDemand> m_demands;
    const QString m_hintMarkdown;
    NarrationText *m_list = nullptr; ///< the conditions
    NarrationText *m_hintText = nullptr;
    QLabel *m_sentence = nullptr;
    ButtonFlow *m_buttons = nullptr;
    QToolButton *m_judge = nullptr;
    QToolButton *m_cancel = nullptr;
    QToolButton *m_hint = nullptr;
};

}
