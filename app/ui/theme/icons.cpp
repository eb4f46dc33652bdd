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

namespace {

QByteArray textOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}

QIcon iconOf(const QString &name, const QColor &color)
{
    QByteArray svg = textOf(":/app/icons/" + name + ".svg");
    if (svg.isEmpty())
        return {};
    svg.replace("currentColor", color.name().toUtf8());
    return QIcon(new SvgInk(svg));
}

QIcon signOf(const QColor &ground, const QColor &line)
{
    QByteArray svg = textOf(":/app/springstep.svg");
    svg.replace("#22262B", ground.name().toUtf8());
    svg.replace("#FFFFFF", line.name().toUtf8());
    return QIcon(new SvgInk(svg));
}

}
