#include "app/model/experiment/experiment_method.h"

#include "app/model/text/quoting.h"
#include "sim/base/error.h"
#include "sim/methods/methods.h"

#include <QCoreApplication>

namespace app {

namespace {

struct ExperimentMethodText
{
    Q_DECLARE_TR_FUNCTIONS(ExperimentMethodText)
};

QString noMethod(const QString &id)
{
    QStringList ids;
    for (const sim::MethodPtr &method : sim::allMethods())
        ids.push_back(QString::fromStdString(method->id()));
    return ExperimentMethodText::tr("there is no method %1; there is %2.")
        .arg(quoted(id), quotedList(ids, id));
}

sim::StepSize readH(const QString &file, const JsonValue &value)
{
    const double h = numberOf(file, value, "h");
    try {
        return sim::StepSize::ofLength(h);
    } catch (const sim::Error &) {
        refuse(file, value.line,
               ExperimentMethodText::tr(
                   "\"h\" is %1; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: "
                   "2, 1, 0.5, 0.25...")
                   .arg(exactNumber(h)));
    }
}

sim::StepSize readTolerance(const QString &file, const JsonValue &value)
{
    const double tolerance = numberOf(file, value, "tolerance");
    try {
        return sim::StepSize::withTolerance(tolerance);
    } catch (const sim::Error &) {
        refuse(file, value.line,
               ExperimentMethodText::tr("\"tolerance\" is %1; it can be 1e-13 to 100 px.")
                   .arg(exactNumber(tolerance)));
    }
}

}

void readMethod(const QString &file, const JsonFields &fields, sim::Script &script)
{
    if (const JsonValue *method = fields.find("method")) {
        const QString id = textOf(file, *method, "method");
        script.method = sim::findMethod(id.toStdString());
        if (!script.method)
            refuse(file, method->line, noMethod(id));
    }
    const bool isAdaptive = script.method->stepping() == sim::Stepping::adaptive;
    const QString id = quoted(QString::fromStdString(script.method->id()));
    const JsonValue *h = fields.find("h");
    const JsonValue *tolerance = fields.find("tolerance");
    if (h && isAdaptive)
        refuse(file, h->line,
               ExperimentMethodText::tr(
                   "the method %1 chooses its own steps; give \"tolerance\" instead of \"h\".")
                   .arg(id));
    if (tolerance && !isAdaptive)
        refuse(file, tolerance->line,
               ExperimentMethodText::tr("the method %1 has fixed steps; give \"h\" instead of \"tolerance\".")
                   .arg(id));
    if (h)
        script.step = readH(file, *h);
    else if (tolerance)
        script.step = readTolerance(file, *tolerance);
    else
        script.step = sim::stepFor(*script.method, script.step);
}

}
