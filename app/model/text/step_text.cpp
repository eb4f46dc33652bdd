#include "app/model/text/step_text.h"

#include "app/model/text/numbers.h"
#include "app/model/text/phrases.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace app {

namespace {

struct StepText
{
    Q_DECLARE_TR_FUNCTIONS(StepText)
};

}

QString stepTitle(double h)
{
    const double parts = std::round(1.0 / h);
    if (h < 1.0 && std::abs(parts * h - 1.0) < 1e-9)
        return StepText::tr("1/%1 frame").arg(parts, 0, 'f', 0);
    if (h == 1.0)
        return StepText::tr("1 frame");
    return StepText::tr("%1 frames").arg(QLocale().toString(h, 'g', 6));
}

QString toleranceTitle(double tolerance)
{
    return pixels(roughNumber(tolerance));
}

QString stepTitle(const sim::StepSize &step)
{
    return step.isAdaptive() ? toleranceTitle(step.tolerance) : stepTitle(step.h);
}

double stepFromText(const QString &text)
{
    QString number = text.section(' ', 0, 0).trimmed();
    number.replace(',', '.');
    bool isNumber = false;
    const double above = number.section('/', 0, 0).toDouble(&isNumber);
    if (!isNumber)
        return 0.0;
    if (!number.contains('/'))
        return above;
    const double below = number.section('/', 1).toDouble(&isNumber);
    return isNumber && below != 0.0 ? above / below : 0.0;
}

}
