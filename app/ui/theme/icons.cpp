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
    SvgInk(QByteArray off, QByteArray on) : m_off(std::move(off)), m_on(std::move(on)) {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State state) override
    {
        QSvgRenderer renderer(state == QIcon::On ? m_on : m_off);
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

    QIconEngine *clone() const override { return new SvgInk(m_off, m_on); }

private:
    QByteArray m_off, m_on;
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
    return iconOf(name, color, color);
}

QIcon iconOf(const QString &name, const QColor &off, const QColor &on)
{
    const QByteArray svg = textOf(":/app/icons/" + name + ".svg");
    if (svg.isEmpty())
        return {};
    const auto in = [&svg](const QColor &color) {
        return QByteArray(svg).replace("currentColor", color.name().toUtf8());
    };
    return QIcon(new SvgInk(in(off), in(on)));
}

QIcon signOf(const QColor &ground, const QColor &line)
{
    QByteArray svg = textOf(":/app/springstep.svg");
    svg.replace("#22262B", ground.name().toUtf8());
    svg.replace("#FFFFFF", line.name().toUtf8());
    return QIcon(new SvgInk(svg, svg));
}

}
