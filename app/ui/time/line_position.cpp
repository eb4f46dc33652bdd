#include "app/ui/time/line_position.h"

#include "app/model/listing/line_stepper.h"
#include "app/model/text/phrases.h"

#include <QCoreApplication>

namespace app {

namespace {

struct LinePositionText
{
    Q_DECLARE_TR_FUNCTIONS(LinePositionText)
};

}

QString progressOf(const LineStepper &lines)
{
    if (lines.index() == 0)
        return {};
    if (const auto frame = lines.nextFrame();
        frame && !frame->isComplete()) // it has more lines than are counted
        return LinePositionText::tr("before line %1, %2 lines run").arg(lines.nextLine()).arg(lines.index());
    return LinePositionText::tr("before line %1, %2 of %3 lines run")
        .arg(lines.nextLine())
        .arg(lines.index())
        .arg(lines.count());
}

QString shortProgressOf(const LineStepper &lines)
{
    return lines.index() == 0 ? QString() : LinePositionText::tr("line %1").arg(lines.nextLine());
}

QString sentenceOf(const LineStepper &lines, std::int64_t frame)
{
    const QString progress = progressOf(lines);
    const QString position = LinePositionText::tr("Frame %1").arg(frame);
    return progress.isEmpty() ? position : listed(position, progress);
}

}
