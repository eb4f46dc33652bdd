#pragma once

#include <QSize>
#include <QWidget>

class QComboBox;
class QLabel;
class QSpinBox;

namespace app {

/// Returns the size of a picture `width` px wide with the aspect ratio of `shape`.
QSize sizeInShape(int width, QSize shape);

/// Fields for the size of a film's pictures: a width, and an aspect ratio that gives the height.
class FilmSize : public QWidget
{
    Q_OBJECT

public:
    static constexpr int least = 200; ///< px, of the width
    static constexpr int most = 3840;

    /// Offers the aspect ratio of `scene` among others, also after `scene` has changed its size. `scene` must outlive this
    /// object.
    explicit FilmSize(const QWidget &scene, QWidget *parent = nullptr);

    QSize size() const;
    /// Returns the field for the width.
    QSpinBox &width() const { return *m_width; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    void showHeight();

    const QWidget &m_scene;
    QSpinBox *m_width;
    QLabel *m_height;
    QComboBox *m_shape;
};

}
