#include "app/model/difference_words.h"

#include "app/model/numbers.h"
#include "app/model/sentences.h"

#include <QCoreApplication>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(DifferenceWords)
};

}

QString differenceSentence(const DifferenceCourse &course)
{
    if (!course.isComparing())
        return course.session().isBringing() ? Text::tr("The other run is being computed again…")
                                             : Text::tr("There is no other run beside this one.");
    if (course.isTooLarge())
        return Text::tr("More than %1 points: too many to compare at every frame.")
            .arg(DifferenceCourse::mostPoints);
    const Difference *largest = course.largest();
    if (!largest)
        return course.of() == DifferenceCourse::Of::selected
                   ? Text::tr("The other run does not have the body that is chosen.")
                   : Text::tr("The two runs have no body in common.");
    if (largest->distance == 0.0)
        return Text::tr("No difference up to frame %1. Play on to see what comes of it.").arg(course.end());
    QString sentence =
        Text::tr("Largest: %1\u2009px apart, %2, at frame %3.")
            .arg(roughNumber(largest->distance), bodyTitle(QString::fromStdString(largest->body)))
            .arg(largest->frame);
    if (course.spacing() > 1)
        sentence += ' ' + Text::tr("Looked at every %1 frames.").arg(course.spacing());
    return sentence;
}

QString branchLine(const Branch &branch, const sim::Script &run)
{
    const std::int64_t shared = lastShared(run, *branch.script);
    const QString place =
        shared > 0 ? Text::tr("parts at frame %1").arg(shared) : Text::tr("parts at the start");
    return branch.isKept ? Text::tr("%1, %2, kept").arg(branch.name, place)
                         : Text::tr("%1, %2").arg(branch.name, place);
}

}
