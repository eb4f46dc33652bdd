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
void refuseCodeOfOthers(const JsonFields &fields, const sim::MethodPtr &method)
{
    const JsonValue *code = fields.find("code");
    const bool isListing = programOf(method) != nullptr;
    if (code && !isListing)
        fields.refuse("code", ExperimentMethodText::tr(
                                  "\"code\" needs the method %1; set \"method\" to it, or remove \"code\".")
                                  .arg(quoted(listingMethod)));
    if (!code && isListing)
        fields.refuse("method",
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

sim::StepSize readH(const JsonFields &fields)
{
    const double h = fields.number("h");
    try {
        return sim::StepSize::ofLength(h);
    } catch (const sim::Error &) {
        fields.refuse(
            "h", ExperimentMethodText::tr(
                     "\"h\" is %1; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: "
                     "2, 1, 0.5, 0.25...")
                     .arg(exactNumber(h)));
    }
}

sim::StepSize readTolerance(const JsonFields &fields)
{
    const double tolerance = fields.number("tolerance");
    try {
        return sim::StepSize::withTolerance(tolerance);
    } catch (const sim::Error &) {
        fields.refuse("tolerance", ExperimentMethodText::tr("\"tolerance\" is %1; it can be 1e-13 to 100 px.")
                                       .arg(exactNumber(tolerance)));
    }
}

}

void readMethod(const JsonFields &fields, sim::Script &script)
{
    if (fields.find("method")) {
        const QString id = fields.optionalText("method");
        script.method = id == listingMethod ? emptyListing() : sim::findMethod(id.toStdString());
        if (!script.method)
            fields.refuse("method", noMethod(id));
    }
    refuseCodeOfOthers(fields, script.method);
    const bool isAdaptive = script.method->stepping() == sim::Stepping::adaptive;
    const QString id = quoted(QString::fromStdString(script.method->id()));
    const bool hasH = fields.find("h"), hasTolerance = fields.find("tolerance");
    if (hasH && isAdaptive)
        fields.refuse("h", ExperimentMethodText::tr(
                               "the method %1 chooses its own steps; give \"tolerance\" instead of \"h\".")
                               .arg(id));
    if (hasTolerance && !isAdaptive)
        fields.refuse("tolerance", ExperimentMethodText::tr(
                                       "the method %1 has fixed steps; give \"h\" instead of \"tolerance\".")
                                       .arg(id));
    if (hasH)
        script.step = readH(fields);
    else if (hasTolerance)
        script.step = readTolerance(fields);
    else
        script.step = sim::stepFor(*script.method, script.step);
}

QString codeText(const JsonFields &fields, const QString &name)
{
    const QString text = fields.optionalText(name);
    const std::size_t bytes = text.toStdString().size();
    if (bytes > listing::maxTextBytes)
        fields.refuse(name,
                      ExperimentMethodText::tr("%1 has %2 bytes; it can have up to %3.")
                          .arg(quoted(name), QString::number(bytes), QString::number(listing::maxTextBytes)));
    return text;
}

QString learnersText(const JsonFields &fields, const QString &name, const lessons::Listing &original)
{
    const QString written = codeText(fields, name);
    const QString text = original.inLanguageOfWindow(written);
    return text.toStdString().size() <= listing::maxTextBytes ? text : written;
}

void readCode(const JsonFields &fields, const lessons::Listing &original, sim::Script &script)
{
    if (!fields.find("code"))
        return;
    const listing::Compiled compiled = compiledFor(script, learnersText(fields, "code", original));
    if (!compiled.program) {
        const listing::CompileError &error = compiled.errors.front();
        fields.refuse("code", ExperimentMethodText::tr("\"code\" does not compile. Line %1: %2")
                                  .arg(QString::number(error.line), listingSentence(error.sentence)));
    }
    script.method = std::make_shared<const listing::ListingMethod>(compiled.program);
}

}
