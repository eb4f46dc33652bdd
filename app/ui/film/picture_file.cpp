#include "app/ui/film/picture_file.h"

#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSaveFile>
#include <QSvgGenerator>

namespace app {

namespace {

struct PictureFileText
{
    Q_DECLARE_TR_FUNCTIONS(PictureFileText)
};

bool drawSvg(SceneView &view, QSaveFile &file)
{
    const QSize size = view.viewport()->size();
    QSvgGenerator svg;
    svg.setOutputDevice(&file);
    svg.setSize(size);
    svg.setViewBox(QRect({}, size));
    svg.setTitle(QStringLiteral("Springstep"));
    QPainter painter;
    if (!painter.begin(&svg))
        return false;
    painter.setClipRect(QRect({}, size));
    view.paintPicture(painter);
    return painter.end();
}

bool drawPng(SceneView &view, QSaveFile &file)
{
    return view.picture(pngScale).save(&file, "PNG");
}

}

void savePicture(SceneView &view, const QString &path)
{
    const bool isSvg = path.endsWith(".svg", Qt::CaseInsensitive);
    if (!isSvg && !path.endsWith(".png", Qt::CaseInsensitive))
        throw UserError(PictureFileText::tr("%1 is not the name of a picture; it ends in .png or .svg.")
                            .arg(quoted(QFileInfo(path).fileName())));
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !(isSvg ? drawSvg(view, file) : drawPng(view, file)) ||
        !file.commit())
        throw UserError(PictureFileText::tr("%1 could not be written: %2. Choose another folder or name.")
                            .arg(shownPath(path), oneLine(file.errorString())));
}

}
