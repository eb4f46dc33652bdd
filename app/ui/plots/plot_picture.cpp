#include "app/ui/plots/plot_picture.h"

#include "app/ui/theme/custom_plot.h"
#include "app/ui/theme/theme.h"

#include <QPdfWriter>
#include <QSvgGenerator>

namespace app {

namespace {

constexpr int titleHeight = 32;   ///< px, above the plot
constexpr int titleLeft = 12;     ///< px
constexpr double sharpness = 2.0; ///< pixels of an image per px, in each direction
constexpr int dotsPerInch = 96;   ///< 1 px is 1/96 inch on a page

QSize wholeSize(const PlotPicture &picture)
{
    return picture.size + QSize(0, titleHeight);
}

void paintPicture(QCPPainter &painter, const PlotPicture &picture, const Theme &theme)
{
    const Tokens &t = theme.tokens();
    painter.fillRect(QRect({0, 0}, wholeSize(picture)), t.panel);
    painter.setFont(theme.ui(13, QFont::DemiBold));
    painter.setPen(t.ink);
    const QRect title(titleLeft, 0, picture.size.width() - 2 * titleLeft, titleHeight);
    painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(picture.title, Qt::ElideRight, title.width()));
    painter.translate(0, titleHeight);
    picture.draw(painter);
}

bool paintVectors(QPaintDevice &device, const PlotPicture &picture, const Theme &theme)
{
    QCPPainter painter(&device);
    if (!painter.isActive())
        return false;
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNonCosmetic);
    paintPicture(painter, picture, theme);
    return painter.end();
}

}

QImage imageOf(const PlotPicture &picture, const Theme &theme)
{
    QImage image(wholeSize(picture) * sharpness, QImage::Format_RGB32);
    image.setDevicePixelRatio(sharpness);
    QCPPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    paintPicture(painter, picture, theme);
    return image;
}

bool writeSvg(QIODevice &file, const PlotPicture &picture, const Theme &theme)
{
    const QSize size = wholeSize(picture);
    QSvgGenerator svg;
    svg.setOutputDevice(&file);
    svg.setTitle(picture.title);
    svg.setSize(size);
    svg.setViewBox(QRect({0, 0}, size));
    svg.setResolution(dotsPerInch);
    return paintVectors(svg, picture, theme);
}

bool writePdf(QIODevice &file, const PlotPicture &picture, const Theme &theme)
{
    QPdfWriter pdf(&file);
    pdf.setTitle(picture.title);
    pdf.setCreator(QStringLiteral("Springstep"));
    pdf.setResolution(dotsPerInch);
    pdf.setPageSize(QPageSize(QSizeF(wholeSize(picture)) / dotsPerInch, QPageSize::Inch));
    pdf.setPageMargins({});
    return paintVectors(pdf, picture, theme);
}

}
