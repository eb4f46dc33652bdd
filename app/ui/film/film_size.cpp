#include "app/ui/film/film_size.h"

#include "app/ui/dock/panel_parts.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int usualWidth = 640;
constexpr int leastHeight = 100; ///< px, smallest height of a picture
constexpr int mostHeight = 9999;

}

QSize sizeInShape(int width, QSize shape)
{
    const double height = static_cast<double>(width) * shape.height() / std::max(1, shape.width());
    return {width, std::clamp(static_cast<int>(std::lround(height)), leastHeight, mostHeight)};
}

FilmSize::FilmSize(const QWidget &scene, QWidget *parent)
    : QWidget(parent), m_scene(scene), m_width(new QSpinBox(this)), m_height(new QLabel(this)),
      m_shape(new QComboBox(this))
{
    m_width->setRange(least, most);
    m_width->setValue(usualWidth);
    m_width->setCorrectionMode(QAbstractSpinBox::CorrectToNearestValue);
    m_width->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_width->setAlignment(Qt::AlignRight);
    m_width->setFixedWidth(96);
    m_width->setAccessibleName(tr("Width in pixels"));
    m_width->setToolTip(tr("How wide the pictures are, %1 to %2 pixels").arg(least).arg(most));
    m_shape->addItem(tr("4 : 3"), QSize(4, 3));
    m_shape->addItem(tr("16 : 9"), QSize(16, 9));
    m_shape->addItem(tr("square"), QSize(1, 1));
    m_shape->addItem(tr("as the scene is"));
    m_shape->setMinimumHeight(m_width->sizeHint().height());
    m_shape->setAccessibleName(tr("Shape"));
    m_shape->setToolTip(
        tr("The width of the pictures compared with their height; the height follows the width"));
    QHBoxLayout *row = makeRow(this, 8);
    row->addWidget(m_width);
    row->addWidget(m_height);
    row->addSpacing(8);
    row->addWidget(m_shape);
    row->addStretch(1);
    connect(m_width, &QSpinBox::valueChanged, this, &FilmSize::showHeight);
    connect(m_shape, &QComboBox::currentIndexChanged, this, &FilmSize::showHeight);
    showHeight();
}

QSize FilmSize::size() const
{
    const QVariant shape = m_shape->currentData();
    return sizeInShape(m_width->value(), shape.isValid() ? shape.toSize() : m_scene.size());
}

void FilmSize::showHeight()
{
    m_height->setText(QStringLiteral("× %1").arg(size().height()));
    m_height->setAccessibleName(tr("Height: %1 pixels").arg(size().height()));
}

void FilmSize::showEvent(QShowEvent *event)
{
    showHeight(); // the scene's aspect ratio may have changed
    QWidget::showEvent(event);
}

}
