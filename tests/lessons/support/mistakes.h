#pragma once

#include "lessons/api/text/document.h"

#include <QByteArray>
#include <QString>

#include <span>

namespace support {

/// A mistake: `from` in a good document is replaced by `to`.
struct Mistake
{
    const char *name;
    QByteArray from;
    QByteArray to;
    QByteArray at;    ///< a text of the broken document that begins on the line with the mistake
    const char *says; ///< a part of the sentence
};

/// Returns what() of the mistake that `read` throws; empty if there is none.
template <class Read>
QString mistakeOf(const Read &read)
{
    try {
        read();
    } catch (const lessons::DocumentError &error) {
        return QString::fromStdString(error.what());
    }
    return {};
}

/// Adds one test row for each mistake.
void addMistakeRows(std::span<const Mistake> mistakes);
/// Fails unless the row's mistake in the text `good` is named in one sentence, with the file, the line and the remedy.
/// `mistakeIn` returns the sentence about a text of `file`.
void checkMistake(const QByteArray &good, const QString &file, QString (*mistakeIn)(const QByteArray &text));

}
