#include "app/model/experiment_method.h"

#include "app/model/words.h"
#include "sim/base/error.h"
#include "sim/methods/methods.h"

#include <QCoreApplication>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Experiment)
};

QString noMethod(const QString &id)
{
    QStringList ids;
    for (const sim::MethodPtr &method : sim::allMethods())
        ids.push_back(QString::fromStdString(method->id()));
    return Text::tr("there is no method %1; there is %2.").arg(quoted(id), quotedList(ids, id));
}

sim::StepSize readH(const QString &file, const JsonValue &value)
{
    const double h = numberOf(file, value, "h");
    try {
        return sim::StepSize::ofLength(h);
    } catch (const sim::Error &) {
        refuse(file, value.line,
               Text::tr("\"h\" is %1; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: "
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
               Text::tr("\"tolerance\" is %1; it can be 1e-13 to 100 px.").arg(exactNumber(tolerance)));
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
        refuse(
            file, h->line,
            Text::tr("the method %1 chooses its own steps; give \"tolerance\" in place of \"h\".").arg(id));
    if (tolerance && !isAdaptive)
        refuse(file, tolerance->line,
               Text::tr("the method %1 takes steps of one length; give \"h\" in place of \"tolerance\".")
                   .arg(id));
    if (h)
        script.step = readH(file, *h);
    else if (tolerance)
        script.step = readTolerance(file, *tolerance);
    else
        script.step = sim::stepFor(*script.method, script.step);
}

}
