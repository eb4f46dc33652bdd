#include "tests/app/film/webm_reader.h"

#include <QFile>

#include <vpx/vp8dx.h>
#include <vpx/vpx_decoder.h>
#include <webm/callback.h>
#include <webm/file_reader.h>
#include <webm/webm_parser.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace webm_reader {

namespace {

/// A pixel of BT.709 in studio range, as the standard has it.
QRgb rgb(double y, double u, double v)
{
    const double light = (y - 16.0) / 219.0, blue = (u - 128.0) / 224.0, red = (v - 128.0) / 224.0;
    const auto byte = [](double part) {
        return static_cast<int>(std::clamp(std::lround(255.0 * part), 0L, 255L));
    };
    return qRgb(byte(light + 1.5748 * red), byte(light - 0.1873 * blue - 0.4681 * red),
                byte(light + 1.8556 * blue));
}

QImage imageOf(const vpx_image_t &image)
{
    QImage picture(static_cast<int>(image.d_w), static_cast<int>(image.d_h), QImage::Format_RGB32);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const auto at = [&](int plane, int column, int row) {
                return image.planes[plane][row * image.stride[plane] + column];
            };
            picture.setPixel(
                x, y,
                rgb(at(VPX_PLANE_Y, x, y), at(VPX_PLANE_U, x / 2, y / 2), at(VPX_PLANE_V, x / 2, y / 2)));
        }
    }
    return picture;
}

class Reader : public webm::Callback
{
public:
    Reader()
    {
        if (vpx_codec_dec_init(&m_codec, vpx_codec_vp9_dx(), nullptr, 0) != VPX_CODEC_OK)
            film.fault = "no decoder";
    }
    ~Reader() override { vpx_codec_destroy(&m_codec); }
    Reader(const Reader &) = delete;
    Reader &operator=(const Reader &) = delete;

    webm::Status OnSegmentBegin(const webm::ElementMetadata &metadata, webm::Action *action) override
    {
        m_segment = static_cast<std::int64_t>(metadata.position + metadata.header_size);
        *action = webm::Action::kRead;
        return webm::Status(webm::Status::kOkCompleted);
    }
    webm::Status OnInfo(const webm::ElementMetadata &, const webm::Info &info) override
    {
        film.duration = info.duration.value();
        return webm::Status(webm::Status::kOkCompleted);
    }
    webm::Status OnTrackEntry(const webm::ElementMetadata &, const webm::TrackEntry &track) override
    {
        if (track.codec_id.value() != "V_VP9")
            film.fault = "another codec";
        return webm::Status(webm::Status::kOkCompleted);
    }
    webm::Status OnClusterBegin(const webm::ElementMetadata &metadata, const webm::Cluster &cluster,
                                webm::Action *action) override
    {
        m_cluster = static_cast<std::int64_t>(cluster.timecode.value());
        film.clusters.push_back(static_cast<std::int64_t>(metadata.position) - m_segment);
        *action = webm::Action::kRead;
        return webm::Status(webm::Status::kOkCompleted);
    }
    webm::Status OnSimpleBlockBegin(const webm::ElementMetadata &, const webm::SimpleBlock &block,
                                    webm::Action *action) override
    {
        film.times.push_back(m_cluster + block.timecode);
        film.keys.push_back(block.is_key_frame);
        *action = webm::Action::kRead;
        return webm::Status(webm::Status::kOkCompleted);
    }
    webm::Status OnFrame(const webm::FrameMetadata &, webm::Reader *reader, std::uint64_t *remaining) override
    {
        std::vector<std::uint8_t> data(*remaining);
        std::uint64_t count = 0;
        while (*remaining > 0) {
            const webm::Status status =
                reader->Read(*remaining, data.data() + data.size() - *remaining, &count);
            *remaining -= count;
            if (!status.ok())
                return status;
        }
        decode(data);
        return webm::Status(webm::Status::kOkCompleted);
    }
    webm::Status OnCuePoint(const webm::ElementMetadata &, const webm::CuePoint &point) override
    {
        film.cues.push_back(static_cast<std::int64_t>(point.time.value()));
        for (const auto &positions : point.cue_track_positions)
            film.cuePositions.push_back(
                static_cast<std::int64_t>(positions.value().cluster_position.value()));
        return webm::Status(webm::Status::kOkCompleted);
    }

    Film film;

private:
    void decode(const std::vector<std::uint8_t> &data)
    {
        if (vpx_codec_decode(&m_codec, data.data(), static_cast<unsigned>(data.size()), nullptr, 0) !=
            VPX_CODEC_OK)
            film.fault = "a picture that cannot be decoded";
        vpx_codec_iter_t next = nullptr;
        while (const vpx_image_t *image = vpx_codec_get_frame(&m_codec, &next))
            film.pictures.push_back(imageOf(*image));
    }

    vpx_codec_ctx_t m_codec = {};
    std::int64_t m_segment = 0;
    std::int64_t m_cluster = 0;
};

}

Film read(const QString &path)
{
    Reader reader;
    webm::FileReader file(std::fopen(QFile::encodeName(path).constData(), "rb"));
    webm::WebmParser parser;
    const webm::Status status = parser.Feed(&reader, &file);
    if (!status.completed_ok())
        reader.film.fault = QString("not WebM (%1)").arg(status.code);
    return reader.film;
}

}
