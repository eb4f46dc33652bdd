#pragma once

#include <QImage>
#include <QSize>
#include <QString>

#include <functional>

class QCPPainter;
class QIODevice;

namespace app {

class Theme;

/// A plot as it is saved: a line with its title, and the plot below.
struct PlotPicture
{
    QString title;
    QString fileName; ///< without a suffix
    QSize size;       ///< px, of the plot
    std::function<void(QCPPainter &)> draw;
};

/// Returns the picture with two pixels per px, so that it stays sharp in a document.
QImage imageOf(const PlotPicture &picture, const Theme &theme);

/// Writes the picture as an SVG file, whose texts stay texts. Returns whether this worked.
bool writeSvg(QIODevice &file, const PlotPicture &picture, const Theme &theme);
/// Writes the picture as a PDF file with one page. Returns whether this worked.
bool writePdf(QIODevice &file, const PlotPicture &picture, const Theme &theme);

}
