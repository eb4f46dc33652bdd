#include "app/model/text/phrases.h"

#include <QCoreApplication>

namespace app {

namespace {

struct PhrasesText
{
    Q_DECLARE_TR_FUNCTIONS(PhrasesText)
};

}

QString listed(const QString &first, const QString &second)
{
    return PhrasesText::tr("%1, %2").arg(first, second);
}

QString labelled(const QString &name, const QString &text)
{
    return PhrasesText::tr("%1: %2").arg(name, text);
}

QString partOf(const QString &part, const QString &whole)
{
    return PhrasesText::tr("%1 of %2").arg(part, whole);
}

QString withRemark(const QString &name, const QString &remark)
{
    return PhrasesText::tr("%1 (%2)").arg(name, remark);
}

QString pixels(const QString &number)
{
    return PhrasesText::tr("%1\u2009px").arg(number);
}

QString frameHeading()
{
    return PhrasesText::tr("frame");
}

QString frameName(std::int64_t frame)
{
    return PhrasesText::tr("frame %1").arg(frame);
}

QString pointCount(std::int64_t count)
{
    return count == 1 ? PhrasesText::tr("1 point") : PhrasesText::tr("%1 points").arg(count);
}

}
