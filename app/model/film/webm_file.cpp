#include "app/model/film/webm_file.h"

#include "app/model/film/film_file.h"

#include <QtEndian>

#include <vpx/vp8cx.h>
#include <vpx/vpx_encoder.h>

#include <algorithm>
#include <bit>
#include <new>

namespace app {

namespace {

constexpr int quality = 10;                     ///< of 0 (the best) to 63
constexpr int speed = 6;                        ///< of 0 (slow, the smallest files) to 9
constexpr int mostBetweenKeys = 150;            ///< pictures between key pictures, to which players can seek
constexpr std::int64_t longestCluster = 30'000; ///< ms, because the times in a cluster have 16 bits

// Matroska elements (RFC 9559) and their ids.
enum Id : std::uint32_t {
    ebml = 0x1A45DFA3,
    ebmlVersion = 0x4286,
    ebmlReadVersion = 0x42F7,
    ebmlMaxIdLength = 0x42F2,
    ebmlMaxSizeLength = 0x42F3,
    docType = 0x4282,
    docTypeVersion = 0x4287,
    docTypeReadVersion = 0x4285,
    segment = 0x18538067,
    seekHead = 0x114D9B74,
    seek = 0x4DBB,
    seekId = 0x53AB,
    seekPosition = 0x53AC,
    info = 0x1549A966,
    timecodeScale = 0x2AD7B1,
    duration = 0x4489,
    muxingApp = 0x4D80,
    writingApp = 0x5741,
    tracks = 0x1654AE6B,
    trackEntry = 0xAE,
    trackNumber = 0xD7,
    trackUid = 0x73C5,
    trackType = 0x83,
    flagLacing = 0x9C,
    codecId = 0x86,
    video = 0xE0,
    pixelWidth = 0xB0,
    pixelHeight = 0xBA,
    colour = 0x55B0,
    matrixCoefficients = 0x55B1,
    colourRange = 0x55B9,
    transferCharacteristics = 0x55BA,
    primaries = 0x55BB,
    cluster = 0x1F43B675,
    timecode = 0xE7,
    simpleBlock = 0xA3,
    cues = 0x1C53BB6B,
    cuePoint = 0xBB,
    cueTime = 0xB3,
    cueTrackPositions = 0xB7,
    cueTrack = 0xF7,
    cueClusterPosition = 0xF1,
};

QByteArray bigEndian(std::uint64_t value)
{
    QByteArray bytes(8, '\0');
    qToBigEndian(value, bytes.data());
    return bytes;
}

/// Returns the bytes of an element's id, without leading zeros.
QByteArray idBytes(Id id)
{
    const QByteArray bytes = bigEndian(id);
    return bytes.mid(bytes.lastIndexOf('\0') + 1);
}

/// Returns a size in the longest form, so that it can be overwritten later: seven 0 bits, a 1, and 56 bits.
QByteArray sizeBytes(std::int64_t size)
{
    return bigEndian(static_cast<std::uint64_t>(size) | std::uint64_t{1} << 56);
}

QByteArray element(Id id, const QByteArray &content)
{
    return idBytes(id) + sizeBytes(content.size()) + content;
}

QByteArray number(Id id, std::int64_t value)
{
    return element(id, bigEndian(static_cast<std::uint64_t>(value)));
}

QByteArray real(Id id, double value)
{
    return element(id, bigEndian(std::bit_cast<std::uint64_t>(value)));
}

QByteArray fileHead()
{
    return element(ebml, number(ebmlVersion, 1) + number(ebmlReadVersion, 1) + number(ebmlMaxIdLength, 4) +
                             number(ebmlMaxSizeLength, 8) + element(docType, "webm") +
                             number(docTypeVersion, 4) + number(docTypeReadVersion, 2));
}

QByteArray trackList(QSize size)
{
    constexpr int bt709 = 1, studioRange = 1, isVideo = 1;
    const QByteArray colours = number(matrixCoefficients, bt709) + number(colourRange, studioRange) +
                               number(transferCharacteristics, bt709) + number(primaries, bt709);
    const QByteArray picture =
        number(pixelWidth, size.width()) + number(pixelHeight, size.height()) + element(colour, colours);
    return element(tracks, element(trackEntry, number(trackNumber, 1) + number(trackUid, 1) +
                                                   number(trackType, isVideo) + number(flagLacing, 0) +
                                                   element(codecId, "V_VP9") + element(video, picture)));
}

std::uint8_t byteOf(int value)
{
    return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
}

/// Returns the luma of a colour as in BT.709, in studio range.
std::uint8_t brightness(QRgb c)
{
    return byteOf(16 + ((47 * qRed(c) + 157 * qGreen(c) + 16 * qBlue(c) + 128) >> 8));
}

/// Fills the planes of `image`: luma of each pixel, and chroma of each square of four pixels.
void fill(vpx_image_t &image, const QImage &picture)
{
    const int width = picture.width(), height = picture.height();
    const auto row = [&](int y) {
        return reinterpret_cast<const QRgb *>(picture.constScanLine(std::min(y, height - 1)));
    };
    for (int y = 0; y < height; ++y)
        std::transform(row(y), row(y) + width, image.planes[VPX_PLANE_Y] + y * image.stride[VPX_PLANE_Y],
                       brightness);
    for (int y = 0; y < height; y += 2) {
        const QRgb *upper = row(y), *lower = row(y + 1);
        std::uint8_t *u = image.planes[VPX_PLANE_U] + y / 2 * image.stride[VPX_PLANE_U];
        std::uint8_t *v = image.planes[VPX_PLANE_V] + y / 2 * image.stride[VPX_PLANE_V];
        for (int x = 0; x < width; x += 2) {
            const int next = std::min(x + 1, width - 1);
            const QRgb all[] = {upper[x], upper[next], lower[x], lower[next]};
            int r = 0, g = 0, b = 0;
            for (const QRgb c : all) {
                r += qRed(c);
                g += qGreen(c);
                b += qBlue(c);
            }
            u[x / 2] = byteOf(128 + ((-26 * r - 86 * g + 112 * b + 512) >> 10));
            v[x / 2] = byteOf(128 + ((112 * r - 102 * g - 10 * b + 512) >> 10));
        }
    }
}

}

void WebmFile::CloseCodec::operator()(vpx_codec_ctx *codec) const
{
    vpx_codec_destroy(codec);
    delete codec;
}

void WebmFile::FreeImage::operator()(vpx_image *image) const
{
    vpx_img_free(image);
}

WebmFile::WebmFile(const QString &path, QSize size)
    : m_file(path), m_size(size),
      m_image(vpx_img_alloc(nullptr, VPX_IMG_FMT_I420, static_cast<unsigned>(size.width()),
                            static_cast<unsigned>(size.height()), 16)),
      m_start(fileHead().size() + idBytes(segment).size() + sizeBytes(0).size())
{
    if (!m_image)
        throw std::bad_alloc();
    openCodec();
    if (!m_file.open(QIODevice::WriteOnly))
        fail(m_file.errorString());
    write(header(0, 0));
}

WebmFile::~WebmFile() = default;

void WebmFile::fail(const QString &why)
{
    throw filmWriteError(m_file.fileName(), why);
}

void WebmFile::write(const QByteArray &bytes)
{
    if (m_file.write(bytes) != bytes.size())
        fail(m_file.errorString());
}

void WebmFile::openCodec()
{
    vpx_codec_enc_cfg_t config;
    vpx_codec_enc_config_default(vpx_codec_vp9_cx(), &config, 0);
    config.g_w = static_cast<unsigned>(m_size.width());
    config.g_h = static_cast<unsigned>(m_size.height());
    config.g_timebase = {1, 1000};
    config.g_lag_in_frames = 0;
    config.rc_end_usage = VPX_Q;
    config.kf_max_dist = mostBetweenKeys;
    auto codec = std::make_unique<vpx_codec_ctx>();
    const vpx_codec_err_t begun = vpx_codec_enc_init(codec.get(), vpx_codec_vp9_cx(), &config, 0);
    if (begun == VPX_CODEC_MEM_ERROR)
        throw std::bad_alloc();
    if (begun != VPX_CODEC_OK)
        fail(QString::fromUtf8(vpx_codec_err_to_string(begun)));
    m_codec.reset(codec.release());
    vpx_codec_control(m_codec.get(), VP8E_SET_CPUUSED, speed);
    vpx_codec_control(m_codec.get(), VP8E_SET_CQ_LEVEL, static_cast<unsigned>(quality));
    vpx_codec_control(m_codec.get(), VP9E_SET_TUNE_CONTENT, VP9E_CONTENT_SCREEN);
    vpx_codec_control(m_codec.get(), VP9E_SET_COLOR_SPACE, VPX_CS_BT_709);
    vpx_codec_control(m_codec.get(), VP9E_SET_COLOR_RANGE, VPX_CR_STUDIO_RANGE);
}

void WebmFile::encode(const vpx_image *image, std::int64_t time, std::int64_t duration)
{
    const bool isFar = !m_clusters.empty() && time - m_clusters.back().time > longestCluster;
    const vpx_codec_err_t done =
        vpx_codec_encode(m_codec.get(), image, time, static_cast<unsigned long>(duration),
                         isFar ? VPX_EFLAG_FORCE_KF : 0, VPX_DL_REALTIME);
    if (done == VPX_CODEC_MEM_ERROR)
        throw std::bad_alloc();
    if (done != VPX_CODEC_OK)
        fail(QString::fromUtf8(vpx_codec_error(m_codec.get())));
    vpx_codec_iter_t next = nullptr;
    while (const vpx_codec_cx_pkt_t *packet = vpx_codec_get_cx_data(m_codec.get(), &next)) {
        if (packet->kind != VPX_CODEC_CX_FRAME_PKT)
            continue;
        const auto &frame = packet->data.frame;
        addBlock(QByteArray(static_cast<const char *>(frame.buf), static_cast<qsizetype>(frame.sz)),
                 frame.pts, frame.flags & VPX_FRAME_IS_KEY);
    }
}

void WebmFile::addBlock(const QByteArray &data, std::int64_t time, bool isKey)
{
    if (isKey) {
        endCluster();
        m_clusters.push_back({time, m_file.pos() - m_start});
    }
    constexpr char firstTrack = '\x81', keyFlag = '\x80';
    const auto within = static_cast<std::uint16_t>(time - m_clusters.back().time);
    QByteArray head(4, '\0');
    head[0] = firstTrack;
    qToBigEndian(within, head.data() + 1);
    head[3] = isKey ? keyFlag : '\0';
    m_blocks += element(simpleBlock, head + data);
}

void WebmFile::endCluster()
{
    if (!m_clusters.empty())
        write(element(cluster, number(timecode, m_clusters.back().time) + m_blocks));
    m_blocks.clear();
}

void WebmFile::add(const QImage &picture, std::int64_t until)
{
    fill(*m_image, picture);
    const std::int64_t time = m_time;
    m_time = std::max(until, time + 1);
    encode(m_image.get(), time, m_time - time);
}

QByteArray WebmFile::header(std::int64_t segmentSize, std::int64_t cuesPosition) const
{
    const auto seekEntry = [](Id id, std::int64_t position) {
        return element(seek, element(seekId, idBytes(id)) + number(seekPosition, position));
    };
    const QByteArray infoElement =
        element(info, number(timecodeScale, 1'000'000) + real(duration, static_cast<double>(m_time)) +
                          element(muxingApp, "Springstep") + element(writingApp, "Springstep"));
    const auto seeks = [&](std::int64_t size) {
        return element(seekHead, seekEntry(info, size) + seekEntry(tracks, size + infoElement.size()) +
                                     seekEntry(cues, cuesPosition));
    };
    return fileHead() + idBytes(segment) + sizeBytes(segmentSize) + seeks(seeks(0).size()) + infoElement +
           trackList(m_size);
}

QByteArray WebmFile::cueList() const
{
    QByteArray points;
    for (const Cluster &one : m_clusters)
        points +=
            element(cuePoint, number(cueTime, one.time) +
                                  element(cueTrackPositions,
                                          number(cueTrack, 1) + number(cueClusterPosition, one.position)));
    return element(cues, points);
}

void WebmFile::finish()
{
    encode(nullptr, m_time, 1);
    endCluster();
    const std::int64_t cuesPosition = m_file.pos() - m_start;
    write(cueList());
    const std::int64_t size = m_file.pos() - m_start;
    if (!m_file.seek(0))
        fail(m_file.errorString());
    write(header(size, cuesPosition));
    if (!m_file.commit())
        fail(m_file.errorString());
}

}
