#pragma once

#include <QImage>
#include <QString>

#include <cstdint>
#include <vector>

/// A reader of films that uses other libraries: libwebm's parser for the container, libvpx's decoder for the pictures.
namespace webm_reader {

struct Film
{
    QString fault; ///< empty: there is none
    std::vector<QImage> pictures;
    std::vector<std::int64_t> times;                  ///< ms, of each picture
    std::vector<bool> keys;                           ///< whether it stands by itself
    double duration = 0.0;                            ///< ms, that the file says
    std::vector<std::int64_t> cues;                   ///< ms, of the pictures that a player can go to
    std::vector<std::int64_t> clusters, cuePositions; ///< bytes from the segment's start
};

Film read(const QString &path);

}
