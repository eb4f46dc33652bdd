#pragma once

#include "app/model/stances.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

namespace app {

class TimelineStrip;

/// The feet diagram under the timeline: which foot stands when, and how far it slips. Has no height in steps without
/// feet that stand.
class FootfallStrip : public QWidget
{
    Q_OBJECT

public:
    FootfallStrip(Session &session, const Course &course, TimelineStrip &timeline, const Theme &theme,
                  QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {280, sizeHint().height()}; }
    /// "foot0 stands, slipped 0.4 px. foot1 is in the air." at the cursor.
    QString sentence() const;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    void open();
    void read();
    void say();
    int rowHeight() const;
    int rowAt(int y) const;
    const Stance *stanceAt(std::size_t foot, std::int64_t frame) const;
    void paintFoot(QPainter &painter, std::size_t foot, double top, const QFontMetricsF &metrics) const;
    void paintSlip(QPainter &painter, const Stance &stance, const QRectF &bar,
                   const QFontMetricsF &metrics) const;
    void paintCursors(QPainter &painter) const;
    QString tipAt(const QPoint &place) const;

    Session &m_session;
    const Course &m_course;
    TimelineStrip &m_timeline;
    const Theme &m_theme;
    std::vector<QString> m_names;
    Stances m_stances;
};

}
