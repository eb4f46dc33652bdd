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

/// A film as a WebM file: pictures encoded as VP9 by libvpx. It contains only the few Matroska elements that a film
/// without sound needs. The file appears only when it is complete.
class WebmFile
{
public:
    /// @throws UserError: the file cannot be written
    WebmFile(const QString &path, QSize size);
    ~WebmFile();

    /// Adds a picture of the film's size in Format_RGB32, shown until `until`, in milliseconds from the film's
    /// start.
    /// @throws UserError: it cannot be written
    void add(const QImage &picture, std::int64_t until);
    /// Completes the film.
    /// @throws UserError: it cannot be written
    void finish();

private:
    /// A key picture and the pictures that depend on it.
    struct Cluster
    {
        std::int64_t time = 0;     ///< ms
        std::int64_t position = 0; ///< bytes from the segment's start
    };
    struct CloseCodec
    {
        void operator()(vpx_codec_ctx *codec) const;
    };
    struct FreeImage
    {
        void operator()(vpx_image *image) const;
    };

    [[noreturn]] void fail(const QString &why);
    void write(const QByteArray &bytes);
    void openCodec();
    void encode(const vpx_image *image, std::int64_t time, std::int64_t duration);
    void addBlock(const QByteArray &data, std::int64_t time, bool isKey);
    void endCluster();
    /// Returns everything before the first cluster. Its length does not depend on the arguments.
    QByteArray header(std::int64_t segmentSize, std::int64_t cues) const;
    QByteArray cueList() const;

    QSaveFile m_file;
    QSize m_size;
    std::unique_ptr<vpx_image, FreeImage> m_image;
    std::unique_ptr<vpx_codec_ctx, CloseCodec> m_codec;
    std::vector<Cluster> m_clusters;
    QByteArray m_blocks;     ///< blocks of the last cluster, not yet written
    std::int64_t m_start;    ///< bytes before the segment's content
    std::int64_t m_time = 0; ///< ms, start of the next picture
};

}
