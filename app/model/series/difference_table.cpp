#include "app/model/series/difference_table.h"

#include "app/model/text/csv.h"
#include "app/model/text/phrases.h"

#include <QCoreApplication>

namespace app {

namespace {

struct DifferenceTableText
{
    Q_DECLARE_TR_FUNCTIONS(DifferenceTableText)
};

}

QByteArray differenceTable(const DifferenceSeries &series)
{
    if (series.samples().empty())
        return {};
    QByteArray text = quotedField(frameHeading()) + ',' +
                      quotedField(DifferenceTableText::tr("distance [px]")) + ',' +
                      quotedField(DifferenceTableText::tr("body")) + '\n';
    for (const Difference &one : series.samples()) {
        text += QByteArray::number(static_cast<qlonglong>(one.frame)) + ',';
        appendNumber(text, one.distance);
        text += ',' + quotedField(QString::fromStdString(one.body)) + '\n';
    }
    return text;
}

}
