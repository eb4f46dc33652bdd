#pragma once

#include "app/model/picture/arrow_angle.h"
#include "app/ui/theme/theme.h"

#include <QStringList>
#include <QWidget>

#include <optional>

namespace app {

class SceneView;

/// A card over a free corner of the scene: the angle of an arrow of the scene on a circle of radius 1, with its cosine and
/// sine as sides of a right triangle, their numbers, and Pythagoras. Hidden in steps without such an arrow, and where it is
/// switched off. The mouse goes through it.
class UnitCircle : public QWidget
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    UnitCircle(SceneView &scene, const Theme &theme);

    /// Returns the arrow that it shows; empty while it is hidden.
    const std::optional<ArrowAngle> &arrow() const { return m_arrow; }
    /// Returns its lines of text.
    QStringList lines() const;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    enum class Corner { topRight, topLeft, bottomRight, bottomLeft };

    void follow();
    /// Goes to another corner if it covers something here and less there.
    void place();
    QRect boxAt(Corner corner) const;
    /// Returns how much of the bodies and the arrow a box covers, px².
    double coveredBy(const QRect &box) const;
    void paintCircle(QPainter &painter) const;
    void paintLines(QPainter &painter) const;

    SceneView &m_scene;
    const Theme &m_theme;
    std::optional<ArrowAngle> m_arrow;
    Corner m_corner = Corner::topRight;
};

}
