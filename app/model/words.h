#pragma once

#include <QString>
#include <QStringList>

/// How messages write names and numbers, so that each stays one readable line.
namespace app {

/// `text` with an escape for each character that would break the line, steer a terminal or not be seen: "\\n", "\\u2028".
/// Doing it again changes nothing.
QString escaped(const QString &text);
/// `text` in quotation marks: escaped, and cut when it is long.
QString quoted(const QString &text);
/// The name of a file, with its folders or without: escaped, and shortened in the middle.
QString shownPath(const QString &path);
/// Each of `texts` in quotation marks, with commas. Where that would be long, those that are most like `given` come first,
/// and after a few of them the number of the others.
QString quotedList(const QStringList &texts, const QString &given = {});
/// "1e-7" for "1e-07".
QString withoutPadding(QString number);
/// A number in the shortest form that means exactly this number, as files write it.
QString exactNumber(double value);
/// A tolerance in px, as tables have it: "1", "1e-1", "2.5e-7".
QString toleranceNumber(double tolerance);
/// `text` on one line, without a full stop at its end: for what other libraries report.
QString oneLine(const QString &text);

}
