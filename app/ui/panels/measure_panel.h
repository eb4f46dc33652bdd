#pragma once

#include "app/model/course.h"
#include "app/ui/theme/theme.h"

#include <QElapsedTimer>
#include <QWidget>

namespace app {

class MeasureRow;

/// What the open step measures of its run: each with its number at the cursor and its course. Hidden where a step
/// measures nothing.
class MeasurePanel : public QWidget
{
    Q_OBJECT

public:
    MeasurePanel(Session &session, const Course &course, const Theme &theme, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {300, sizeHint().height()}; }
    bool isEmpty() const { return m_rows.empty(); }

signals:
    /// Another step: isEmpty() and sizeHint() may be others.
    void contentChanged();

private:
    void open();
    void refresh();
    void refreshNow();

    Session &m_session;
    const Course &m_course;
    const Theme &m_theme;
    std::vector<MeasureRow *> m_rows;
    QElapsedTimer m_sinceRefresh;
};

}
