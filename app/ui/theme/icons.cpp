#include "app/ui/theme/icons.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

namespace app {

namespace {

class SvgInk : public QIconEngine
{
public:
    explicit SvgInk(QByteArray svg) : m_svg(std::move(svg)) {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        QSvgRenderer renderer(m_svg);
        const qreal was = painter->opacity();
        if (mode == QIcon::Disabled)
            painter->setOpacity(was * 0.4);
        renderer.render(painter, QRectF(rect));
        painter->setOpacity(was);
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap result(size);
        result.fill(Qt::transparent);
        QPainter painter(&result);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return result;
    }

    QIconEngine *clone() const override { return new SvgInk(m_svg); }

private:
    QByteArray m_svg;
};

}

QIcon iconOf(const QString &name, const QColor &color)
{
    QFile file(":/app/icons/" + name + ".svg");
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QByteArray svg = file.readAll();
    svg.replace("currentColor", color.name().toUtf8());
    return QIcon(new SvgInk(svg));
}

}
