#include "app/model/text/difference_text.h"

#include "app/model/text/numbers.h"
#include "app/model/text/phrases.h"
#include "app/model/text/sentences.h"

#include <QCoreApplication>

namespace app {

namespace {

struct DifferenceText
{
    Q_DECLARE_TR_FUNCTIONS(DifferenceText)
};

}

QString differenceSentence(const DifferenceSeries &series)
{
    if (!series.isComparing())
        return series.comparisons().isComputing()
                   ? DifferenceText::tr("The other run is being computed again…")
                   : DifferenceText::tr("There is no other run to compare with.");
    if (series.isTooLarge())
        return DifferenceText::tr("More than %1 points: too many to compare at every frame.")
            .arg(DifferenceSeries::mostPoints);
    const Difference *largest = series.largest();
    if (!largest)
        return series.of() == DifferenceSeries::Of::selected
                   ? DifferenceText::tr("The other run does not have the selected body.")
                   : DifferenceText::tr("The two runs have no body in common.");
    if (largest->distance == 0.0)
        return DifferenceText::tr("No difference up to frame %1. Play on to see whether one appears.")
            .arg(series.end());
    QString sentence =
        DifferenceText::tr("Largest: %1\u2009px apart, %2, at frame %3.")
            .arg(roughNumber(largest->distance), bodyTitle(QString::fromStdString(largest->body)))
            .arg(largest->frame);
    if (series.spacing() > 1)
        sentence += ' ' + DifferenceText::tr("Compared every %1 frames.").arg(series.spacing());
    return sentence;
}

QString branchLine(const Branch &branch, const sim::Script &run)
{
    const std::int64_t shared = lastShared(run, *branch.script);
    const QString place = shared > 0 ? DifferenceText::tr("branches off at frame %1").arg(shared)
                                     : DifferenceText::tr("branches off at the start");
    return branch.isKept ? DifferenceText::tr("%1, %2, kept").arg(branch.name, place)
                         : listed(branch.name, place);
}

}
