#pragma once

#include <QString>
#include <QStringList>

/// How messages write names and numbers, so that each stays one readable line.
namespace app {

/// `text` in quotation marks: cut when it is long, without characters that would break the line.
QString quoted(const QString &text);
/// Each of `texts` in quotation marks, with commas; cut when there are many.
QString quotedList(const QStringList &texts);
/// "1e-7" for "1e-07".
QString withoutPadding(QString number);
/// A number in the shortest form that means exactly this number, as files write it.
QString exactNumber(double value);
/// A tolerance in px, as tables have it: "1", "1e-1", "2.5e-7".
QString toleranceNumber(double tolerance);
/// `text` on one line, without a full stop at its end: for what other libraries report.
QString oneLine(const QString &text);

}
