#pragma once

#include <QString>
#include <QStringList>

/// Functions that write names and numbers for messages, so that each message stays on one readable line.
namespace app {

/// Returns `text` with escapes for characters that break the line, control a terminal or are invisible: "\\n",
/// "\\u2028". Escaping a second time changes nothing.
QString escaped(const QString &text);
/// Returns `text` in quotation marks, escaped, and shortened if it is long.
QString quoted(const QString &text);
/// Returns the name of a file, with or without folders, escaped and shortened in the middle.
QString shownPath(const QString &path);
/// Returns `texts` in quotation marks, separated by commas. If the list would be long, it gives a few texts that
/// are most similar to `given`, then the number of the others.
QString quotedList(const QStringList &texts, const QString &given = {});
/// Returns `number` without leading zeros in its exponent: "1e-7" for "1e-07".
QString withoutPadding(QString number);
/// Returns the shortest text that reads back as exactly `value`, as files write it.
QString exactNumber(double value);
/// Returns a tolerance in px, as tables write it: "1", "1e-1", "2.5e-7".
QString toleranceNumber(double tolerance);
/// Returns `text` on one line without a final full stop. Use it for messages of other libraries.
QString oneLine(const QString &text);

}
