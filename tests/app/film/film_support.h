#pragma once

#include <QImage>
#include <QImageReader>

#include <algorithm>
#include <cstdlib>
#include <vector>

/// Shared by the suites of films and pictures: readers of other libraries, and the difference of two pictures.
namespace film_support {

struct Decoded
{
    std::vector<QImage> pictures;
    std::vector<int> milliseconds;
    int loops = 0;
};

inline Decoded decoded(const QString &path)
{
    Decoded film;
    QImageReader reader(path);
    film.loops = reader.loopCount();
    for (QImage picture = reader.read(); !picture.isNull(); picture = reader.read()) {
        film.pictures.push_back(picture.convertToFormat(QImage::Format_RGB32));
        film.milliseconds.push_back(reader.nextImageDelay());
    }
    return film;
}

struct Difference
{
    double mean = 0.0; ///< of all channels of all pixels
    int worst = 0;
};

inline Difference difference(const QImage &a, const QImage &b)
{
    Difference found;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb one = a.pixel(x, y), two = b.pixel(x, y);
            for (const int by : {qRed(one) - qRed(two), qGreen(one) - qGreen(two), qBlue(one) - qBlue(two)}) {
                found.mean += std::abs(by);
                found.worst = std::max(found.worst, std::abs(by));
            }
        }
    }
    found.mean /= 3.0 * a.width() * a.height();
    return found;
}

}
