#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

namespace app {

class LessonList;
class Narration;
class PanelTitle;

/// The left side of the window: the lessons over the text of the open step.
class LearnPanel : public QWidget
{
    Q_OBJECT

public:
    LearnPanel(Session &session, const Theme &theme, QWidget *parent = nullptr);

    QSize sizeHint() const override { return {280, 700}; }
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void shareHeight();
    void showCount();

    PanelTitle *m_title;
    LessonList *m_list;
    Narration *m_narration;
};

}
