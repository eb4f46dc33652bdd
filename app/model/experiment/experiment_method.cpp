#include "app/model/experiment/experiment_method.h"

#include "app/listing/limits.h"
#include "app/listing/listing_method.h"
#include "app/model/run/run_program.h"
#include "app/model/text/listing_text.h"
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

/// The id of *Your code*, whose text is the field "code".
constexpr auto listingMethod = "listing";

/// Returns a listing that does nothing. The one of the file needs the scene, which is read later.
sim::MethodPtr emptyListing()
{
    return std::make_shared<const listing::ListingMethod>(
        listing::Program::compile("void frame() {}", {}).program);
}

/// Rejects a field "code" with another method, and the method of listings without it.
void refuseCodeOfOthers(const QString &file, const JsonFields &fields, const sim::MethodPtr &method)
{
    const JsonValue *code = fields.find("code");
    const bool isListing = programOf(method) != nullptr;
    if (code && !isListing)
        refuse(file, code->line,
               ExperimentMethodText::tr(
                   "\"code\" needs the method %1; set \"method\" to it, or remove \"code\".")
                   .arg(quoted(listingMethod)));
    if (!code && isListing)
        refuse(file, fields.find("method")->line,
               ExperimentMethodText::tr("the method %1 needs \"code\", the text of a listing.")
                   .arg(quoted(listingMethod)));
}

QString noMethod(const QString &id)
{
    QStringList ids;
    for (const sim::MethodPtr &method : sim::allMethods())
        ids.push_back(QString::fromStdString(method->id()));
    ids.push_back(listingMethod);
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
        script.method = id == listingMethod ? emptyListing() : sim::findMethod(id.toStdString());
        if (!script.method)
            refuse(file, method->line, noMethod(id));
    }
    refuseCodeOfOthers(file, fields, script.method);
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

QString codeText(const QString &file, const JsonValue &value, const QString &name)
{
    const QString text = textOf(file, value, name);
    const std::size_t bytes = text.toStdString().size();
    if (bytes > listing::maxTextBytes)
        refuse(file, value.line,
               ExperimentMethodText::tr("%1 has %2 bytes; it can have up to %3.")
                   .arg(quoted(name), QString::number(bytes), QString::number(listing::maxTextBytes)));
    return text;
}

QString learnersText(const QString &file, const JsonValue &value, const QString &name,
                     const lessons::Listing &original)
{
    const QString written = codeText(file, value, name);
    const QString text = original.inLanguageOfWindow(written);
    return text.toStdString().size() <= listing::maxTextBytes ? text : written;
}

void readCode(const QString &file, const JsonFields &fields, const lessons::Listing &original,
              sim::Script &script)
{
    const JsonValue *code = fields.find("code");
    if (!code)
        return;
    const std::string text = learnersText(file, *code, "code", original).toStdString();
    const listing::Compiled compiled =
        listing::Program::compile(text, listing::vocabularyOf(sim::sceneOf(script, script.values)));
    if (!compiled.program) {
        const listing::CompileError &error = compiled.errors.front();
        refuse(file, code->line,
               ExperimentMethodText::tr("\"code\" does not compile. Line %1: %2")
                   .arg(QString::number(error.line), listingSentence(error.sentence)));
    }
    script.method = std::make_shared<const listing::ListingMethod>(compiled.program);
}

}
