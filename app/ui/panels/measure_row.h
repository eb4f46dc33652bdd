#pragma once

#include "app/model/course.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

namespace app {

/// One measure: its name, its course over the last frames with the cursor in it, its number and unit.
class MeasureRow : public QWidget
{
    Q_OBJECT

public:
    static constexpr int height = 34;
    static constexpr int shownRows = 240; ///< of its course

    /// `index`: which of the step's measures.
    MeasureRow(const Session &session, const Course &course, std::size_t index, const Theme &theme,
               QWidget *parent = nullptr);

    /// Reads the number at the cursor.
    void refresh();
    /// As it is shown: "12.3", or "–" where there is nothing to measure.
    QString number() const;
    QSize sizeHint() const override { return {300, height}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    double valueAt(std::int64_t frame) const;
    double valueNow() const;
    void paintCourse(QPainter &painter, const QRectF &area) const;

    const Session &m_session;
    const Course &m_course;
    std::size_t m_index;
    lessons::Measure m_measure;
    const Theme &m_theme;
    double m_value;
};

}
