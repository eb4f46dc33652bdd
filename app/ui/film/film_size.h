#pragma once

#include <QSize>
#include <QWidget>

class QComboBox;
class QLabel;
class QSpinBox;

namespace app {

/// The size of a picture `width` px wide whose sides are as those of `shape`.
QSize sizeInShape(int width, QSize shape);

/// Asks how large the pictures of a film are: a width, and a shape that gives the height.
class FilmSize : public QWidget
{
    Q_OBJECT

public:
    static constexpr int least = 200; ///< px, of a width
    static constexpr int most = 3840;

    /// One of the shapes is that of `scene`, as it is when it is asked for; it must outlive this.
    explicit FilmSize(const QWidget &scene, QWidget *parent = nullptr);

    QSize size() const;
    /// The field for the width.
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
