#pragma once

#include <QByteArray>
#include <QString>

#include <zlib.h>

#include <map>

namespace tests {

inline void appendNumber(QByteArray &bytes, quint32 number, int size)
{
    for (int i = 0; i < size; ++i)
        bytes.append(static_cast<char>((number >> (8U * static_cast<unsigned>(i))) & 0xffU));
}

/// Returns `content` without the length, the header and the checksum that qCompress() adds.
inline QByteArray deflated(const QByteArray &content)
{
    const QByteArray packed = qCompress(content, 9);
    return content.isEmpty() ? QByteArray("\x03\0", 2) : packed.sliced(6, packed.size() - 10);
}

/// Returns a zip of `files` (PKWARE's APPNOTE.TXT, sections 4.3.7, 4.3.12 and 4.3.16).
inline QByteArray zipOf(const std::map<QString, QByteArray> &files)
{
    constexpr quint32 version = 20, isUtf8 = 1U << 11U, isDeflated = 8,
                      firstDay = (1U << 5U) | 1U; // 1 January 1980
    QByteArray zip, table;
    for (const auto &[file, content] : files) {
        const QByteArray name = file.toUtf8(), packed = deflated(content);
        const auto crc = static_cast<quint32>(crc32(0, reinterpret_cast<const Bytef *>(content.constData()),
                                                    static_cast<uInt>(content.size())));
        QByteArray shared; // the part that both headers have
        appendNumber(shared, version, 2), appendNumber(shared, isUtf8, 2);
        appendNumber(shared, isDeflated, 2), appendNumber(shared, 0, 2), appendNumber(shared, firstDay, 2);
        appendNumber(shared, crc, 4), appendNumber(shared, static_cast<quint32>(packed.size()), 4);
        appendNumber(shared, static_cast<quint32>(content.size()), 4);
        appendNumber(shared, static_cast<quint32>(name.size()), 2), appendNumber(shared, 0, 2);
        table += "PK\x01\x02";
        appendNumber(table, version, 2);
        table += shared + QByteArray(10, '\0');
        appendNumber(table, static_cast<quint32>(zip.size()), 4);
        table += name;
        zip += "PK\x03\x04" + shared + name + packed;
    }
    const auto begin = static_cast<quint32>(zip.size()), count = static_cast<quint32>(files.size());
    zip += table + "PK\x05\x06" + QByteArray(4, '\0');
    appendNumber(zip, count, 2), appendNumber(zip, count, 2);
    appendNumber(zip, static_cast<quint32>(table.size()), 4), appendNumber(zip, begin, 4);
    return zip + QByteArray(2, '\0');
}

}
