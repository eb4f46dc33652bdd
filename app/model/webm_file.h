#pragma once

#include <QByteArray>
#include <QImage>
#include <QSaveFile>
#include <QSize>

#include <cstdint>
#include <memory>
#include <vector>

struct vpx_codec_ctx;
struct vpx_image;

namespace app {

/// A film as a WebM file: pictures encoded as VP9 by libvpx, in the few elements of Matroska that a film without sound
/// needs. The file is there when it is whole, and not before.
class WebmFile
{
public:
    /// @throws Refusal: the file cannot be written
    WebmFile(const QString &path, QSize size);
    ~WebmFile();

    /// Adds a picture of that size in Format_RGB32, which is shown until `until`, in milliseconds from the film's start.
    /// @throws Refusal
    void add(const QImage &picture, std::int64_t until);
    /// Ends the film. @throws Refusal
    void finish();

private:
    /// Pictures that follow on one that stands by itself.
    struct Cluster
    {
        std::int64_t time = 0;     ///< ms
        std::int64_t position = 0; ///< bytes from the segment's start
    };
    struct EndCodec
    {
        void operator()(vpx_codec_ctx *codec) const;
    };
    struct FreeImage
    {
        void operator()(vpx_image *image) const;
    };

    [[noreturn]] void refuse(const QString &why);
    void write(const QByteArray &bytes);
    void beginCodec();
    void encode(const vpx_image *image, std::int64_t time, std::int64_t duration);
    void addBlock(const QByteArray &data, std::int64_t time, bool isKey);
    void endCluster();
    /// All that comes before the first cluster; as long with any numbers.
    QByteArray header(std::int64_t segmentSize, std::int64_t cues) const;
    QByteArray cueList() const;

    QSaveFile m_file;
    QSize m_size;
    std::unique_ptr<vpx_image, FreeImage> m_image;
    std::unique_ptr<vpx_codec_ctx, EndCodec> m_codec;
    std::vector<Cluster> m_clusters;
    QByteArray m_blocks;     ///< of the last cluster, not yet written
    std::int64_t m_start;    ///< bytes before the segment's own
    std::int64_t m_time = 0; ///< ms, where the next picture begins
};

}
