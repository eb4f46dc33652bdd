#include "tests/app/language/drawn_text.h"

#include <QBuffer>
#include <QSvgGenerator>
#include <QWidget>
#include <QXmlStreamReader>

QStringList drawnBy(QWidget &widget)
{
    QByteArray picture;
    QBuffer buffer(&picture);
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(widget.size());
    widget.render(&generator, {}, {}, QWidget::DrawWindowBackground);
    QStringList texts;
    QXmlStreamReader xml(picture);
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.name() == u"text")
            texts << xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
    }
    return texts;
}
