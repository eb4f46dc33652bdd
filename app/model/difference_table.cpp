#include "app/model/difference_table.h"

#include "app/model/csv_text.h"

#include <QCoreApplication>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(DifferenceTable)
};

}

QByteArray differenceTable(const DifferenceCourse &course)
{
    if (course.samples().empty())
        return {};
    QByteArray text = quotedField(Text::tr("frame")) + ',' + quotedField(Text::tr("distance [px]")) + ',' +
                      quotedField(Text::tr("body")) + '\n';
    for (const Difference &one : course.samples()) {
        text += QByteArray::number(static_cast<qlonglong>(one.frame)) + ',';
        appendNumber(text, one.distance);
        text += ',' + quotedField(QString::fromStdString(one.body)) + '\n';
    }
    return text;
}

}
