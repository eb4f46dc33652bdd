#include "app/model/lesson_folders/zip_reader.h"

#include "app/model/text/phrases.h"
#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"

#include <QCoreApplication>
#include <QStringDecoder>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace app {

namespace {

// The layout of a zip: PKWARE's APPNOTE.TXT, sections 4.3.7, 4.3.12 and 4.3.16.
constexpr quint32 localSign = 0x04034b50, centralSign = 0x02014b50, endSign = 0x06054b50;
constexpr qsizetype localSize = 30, centralSize = 46, endSize = 22;
constexpr qsizetype longestComment = 0xffff;
constexpr quint32 stored = 0, deflated = 8;
constexpr quint32 isEncrypted = 1;
constexpr qsizetype elsewhere = 0xffffffff; ///< the number is in a field of ZIP64, see section 4.5.3
constexpr quint32 typeOfFile = 0170000, isLink = 0120000; ///< of the mode that Unix writes

/// Numbers of a zip, with the lowest byte first.
class ZipBytes
{
    Q_DECLARE_TR_FUNCTIONS(ZipText)

public:
    ZipBytes(const QByteArray &bytes, const QString &name) : m_bytes(bytes), m_name(name) {}

    [[noreturn]] void refuse(const QString &why) const { throw UserError(labelled(shownPath(m_name), why)); }

    [[noreturn]] void refuseDamaged() const
    {
        refuse(tr("the zip is damaged. Get it again, or make a new zip of the folder."));
    }

    quint32 number(qsizetype at, int size) const
    {
        quint32 value = 0;
        const QByteArray bytes = slice(at, size);
        for (int i = size; i > 0; --i)
            value = (value << 8U) | static_cast<quint8>(bytes[i - 1]);
        return value;
    }

    QByteArray slice(qsizetype at, qsizetype size) const
    {
        if (at < 0 || size < 0 || at > m_bytes.size() || size > m_bytes.size() - at)
            refuseDamaged();
        return m_bytes.mid(at, size);
    }

    qsizetype size() const { return m_bytes.size(); }

    /// Returns where the end of the table of files begins.
    qsizetype end() const
    {
        const qsizetype first = std::max<qsizetype>(0, size() - endSize - longestComment);
        for (qsizetype at = size() - endSize; at >= first; --at) {
            if (number(at, 4) == endSign)
                return at;
        }
        refuse(
            tr("this is not a zip, or its end is missing. Choose the lesson.json or the zip of a lesson, or "
               "get the zip again."));
    }

private:
    const QByteArray &m_bytes;
    const QString &m_name;
};

/// A file as the table of a zip describes it.
struct ZipEntry
{
    QString path;
    quint32 flags = 0, method = 0, crc = 0, mode = 0;
    qsizetype packed = 0, size = 0, local = 0;
};

/// Reads the files of a zip.
class ZipReader
{
    Q_DECLARE_TR_FUNCTIONS(ZipText)

public:
    ZipReader(const QByteArray &zip, const QString &name, const ZipLimits &limits)
        : m_bytes(zip, name), m_limits(limits)
    {
    }

    std::map<QString, QByteArray> read()
    {
        readTable();
        const QString folder = sharedFolder();
        std::map<QString, QByteArray> files;
        for (const ZipEntry &entry : m_entries) {
            const QString name = entry.path.mid(folder.size());
            if (name.contains('/'))
                m_bytes.refuse(
                    tr("%1 is in a folder. All files of a lesson are side by side.").arg(quoted(entry.path)));
            if (!files.try_emplace(name, contentOf(entry)).second)
                m_bytes.refuse(
                    tr("%1 is there twice. Make a new zip of the folder.").arg(quoted(entry.path)));
        }
        return files;
    }

private:
    void readTable()
    {
        const qsizetype end = m_bytes.end();
        const quint32 count = m_bytes.number(end + 10, 2);
        if (m_bytes.number(end + 4, 2) != 0 || m_bytes.number(end + 8, 2) != count || count == 0xffff)
            m_bytes.refuse(tr("the zip has several parts, or is too large for a lesson."));
        qsizetype at = m_bytes.number(end + 16, 4);
        qsizetype all = 0;
        for (quint32 i = 0; i < count; ++i) {
            const ZipEntry entry = entryAt(at);
            if (entry.path.endsWith('/'))
                continue; // a folder
            check(entry);
            all += entry.size;
            m_entries.push_back(entry);
            if (m_entries.size() > m_limits.files)
                m_bytes.refuse(tr("the zip has more than %1 files.").arg(m_limits.files));
            if (all > m_limits.all)
                m_bytes.refuse(tr("the files are larger than %1 MiB together.").arg(m_limits.all >> 20));
        }
    }

    /// Reads the entry at `at`, and moves `at` behind it.
    ZipEntry entryAt(qsizetype &at) const
    {
        if (m_bytes.number(at, 4) != centralSign)
            m_bytes.refuseDamaged();
        const qsizetype nameSize = m_bytes.number(at + 28, 2);
        ZipEntry entry;
        entry.flags = m_bytes.number(at + 8, 2);
        entry.method = m_bytes.number(at + 10, 2);
        entry.crc = m_bytes.number(at + 16, 4);
        entry.packed = m_bytes.number(at + 20, 4);
        entry.size = m_bytes.number(at + 24, 4);
        entry.mode = m_bytes.number(at + 38, 4) >> 16U;
        entry.local = m_bytes.number(at + 42, 4);
        QStringDecoder decoder(QStringDecoder::Utf8);
        entry.path = decoder(m_bytes.slice(at + centralSize, nameSize));
        if (decoder.hasError())
            m_bytes.refuse(tr("the name of a file is not UTF-8. Give it a name without accents."));
        at += centralSize + nameSize + m_bytes.number(at + 30, 2) + m_bytes.number(at + 32, 2);
        return entry;
    }

    void check(const ZipEntry &entry) const
    {
        const QString &path = entry.path;
        const QStringList parts = path.split('/');
        if (path.startsWith('/') || path.contains('\\') || path.contains(':') || parts.contains(".."))
            m_bytes.refuse(
                tr("%1 leads out of the lesson. This zip is not safe; nothing was read.").arg(quoted(path)));
        if ((entry.mode & typeOfFile) == isLink)
            m_bytes.refuse(tr("%1 is a link. Put the file itself into the zip.").arg(quoted(path)));
        if (entry.flags & isEncrypted)
            m_bytes.refuse(tr("%1 has a password. Make a zip without one.").arg(quoted(path)));
        if (entry.method != stored && entry.method != deflated)
            m_bytes.refuse(tr("%1 is compressed by a method that this program cannot read. "
                              "Save it as an ordinary zip file.")
                               .arg(quoted(path)));
        if (entry.size == elsewhere || entry.packed == elsewhere || entry.local == elsewhere)
            m_bytes.refuse(tr("%1 is packed as ZIP64, which is for very large files. "
                              "Save it as an ordinary zip file.")
                               .arg(quoted(path)));
        if (entry.size > m_limits.file)
            m_bytes.refuse(tr("%1 is larger than %2 MiB.").arg(quoted(path)).arg(m_limits.file >> 20));
    }

    /// Returns the folder that all files are in, with its slash. Empty if there is none.
    QString sharedFolder() const
    {
        if (m_entries.empty())
            m_bytes.refuse(tr("the zip is empty."));
        const QString folder = m_entries.front().path.section('/', 0, 0) + '/';
        const bool isShared = std::all_of(m_entries.begin(), m_entries.end(), [&](const ZipEntry &entry) {
            return entry.path.startsWith(folder);
        });
        return isShared ? folder : QString();
    }

    QByteArray contentOf(const ZipEntry &entry) const
    {
        if (m_bytes.number(entry.local, 4) != localSign)
            m_bytes.refuseDamaged();
        const qsizetype begin = entry.local + localSize + m_bytes.number(entry.local + 26, 2) +
                                m_bytes.number(entry.local + 28, 2);
        const QByteArray packed = m_bytes.slice(begin, entry.packed);
        const QByteArray content = entry.method == stored ? packed : inflated(packed, entry);
        const uLong crc =
            crc32(0, reinterpret_cast<const Bytef *>(content.constData()), static_cast<uInt>(content.size()));
        if (content.size() != entry.size || crc != entry.crc)
            m_bytes.refuseDamaged();
        return content;
    }

    /// Expands the content of a file, up to the size that the table names.
    QByteArray inflated(QByteArray packed, const ZipEntry &entry) const
    {
        z_stream stream = {};
        if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
            m_bytes.refuseDamaged();
        const std::unique_ptr<z_stream, decltype(&inflateEnd)> end(&stream, &inflateEnd);
        stream.next_in = reinterpret_cast<Bytef *>(packed.data());
        stream.avail_in = static_cast<uInt>(packed.size());
        QByteArray content;
        std::array<char, 1 << 16> piece;
        int state = Z_OK;
        while (state == Z_OK) {
            stream.next_out = reinterpret_cast<Bytef *>(piece.data());
            stream.avail_out = static_cast<uInt>(piece.size());
            state = inflate(&stream, Z_NO_FLUSH);
            content.append(piece.data(), static_cast<qsizetype>(piece.size() - stream.avail_out));
            if (content.size() > entry.size)
                m_bytes.refuse(tr("%1 is larger than the zip says. This zip is not safe; nothing was "
                                  "read.")
                                   .arg(quoted(entry.path)));
        }
        if (state != Z_STREAM_END)
            m_bytes.refuseDamaged();
        return content;
    }

    ZipBytes m_bytes;
    ZipLimits m_limits;
    std::vector<ZipEntry> m_entries;
};

}

std::map<QString, QByteArray> readZip(const QByteArray &zip, const QString &name, const ZipLimits &limits)
{
    return ZipReader(zip, name, limits).read();
}

}
