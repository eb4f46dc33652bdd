#include "app/cli/terminal.h"
#include "app/cli/verbs.h"
#include "app/model/catalog/lesson_library.h"
#include "app/model/text/json_writer.h"
#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "sim/methods/methods.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct LessonsText
{
    Q_DECLARE_TR_FUNCTIONS(LessonsText)
};

QString defaultChoice(const lessons::Parameter &parameter)
{
    return parameter.choices.value(qsizetype(std::lround(parameter.defaultValue)));
}

QStringList needsOf(const sim::Method &method)
{
    QStringList needs;
    for (const std::string &need : method.requirements())
        needs.push_back(QString::fromStdString(need));
    if (method.stepping() == sim::Stepping::adaptive)
        needs.push_back(QStringLiteral("tolerance"));
    return needs;
}

void writeParameter(const lessons::Parameter &parameter, JsonWriter &json)
{
    json.beginObject();
    json.field("id", parameter.id);
    if (parameter.choices.isEmpty()) {
        json.field("default", parameter.defaultValue);
        json.field("unit", parameter.unit);
        json.field("min", parameter.min);
        json.field("max", parameter.max);
    } else {
        json.field("default", defaultChoice(parameter));
        json.list("choices", parameter.choices);
    }
    json.endObject();
}

void writeLesson(const LessonEntry &lesson, JsonWriter &json)
{
    json.beginObject();
    json.field("id", lesson.id);
    json.field("order", lesson.order);
    json.field("title", lesson.title);
    json.beginList("steps");
    for (const lessons::Step &step : lesson.steps) {
        json.beginObject();
        json.field("id", step.id);
        json.field("title", step.title);
        json.beginList("parameters");
        for (const lessons::Parameter &parameter : step.parameters)
            writeParameter(parameter, json);
        json.endList();
        json.endObject();
    }
    json.endList();
    json.endObject();
}

void writeMethod(const sim::Method &method, JsonWriter &json)
{
    json.beginObject();
    json.field("id", method.id());
    json.field("order", method.order());
    json.list("needs", needsOf(method));
    json.endObject();
}

QString jsonList(const LessonLibrary &library)
{
    JsonWriter json(4);
    json.beginObject();
    json.beginList("lessons");
    for (std::size_t i = 0; i < library.entries(); ++i)
        writeLesson(library.entry(i), json);
    json.endList();
    json.beginList("methods");
    for (const sim::MethodPtr &method : sim::allMethods())
        writeMethod(*method, json);
    json.endList();
    json.endObject();
    return QString::fromUtf8(json.text()) + '\n';
}

QString parameterLine(const lessons::Parameter &parameter)
{
    const QString start = "      " + parameter.id.leftJustified(16);
    if (!parameter.choices.isEmpty())
        return start +
               LessonsText::tr("%1; one of %2").arg(defaultChoice(parameter), parameter.choices.join(", ")) +
               '\n';
    QString line = start + LessonsText::tr("%1; %2 to %3")
                               .arg(exactNumber(parameter.defaultValue), exactNumber(parameter.min),
                                    exactNumber(parameter.max));
    if (!parameter.unit.isEmpty())
        line += ' ' + parameter.unit;
    return line + '\n';
}

QString readableList(const LessonLibrary &library)
{
    QString text;
    for (std::size_t i = 0; i < library.entries(); ++i) {
        const LessonEntry &lesson = library.entry(i);
        if (lesson.source.isEmpty()) // lessons without C++ have no number
            text += QString::number(lesson.order) + ". ";
        text += lesson.id + ": " + lesson.title + '\n';
        for (const lessons::Step &step : lesson.steps) {
            text += "   " + lesson.id + '/' + step.id + ": " + step.title + '\n';
            for (const lessons::Parameter &parameter : step.parameters)
                text += parameterLine(parameter);
        }
        text += '\n';
    }
    text += LessonsText::tr("Methods") + '\n';
    for (const sim::MethodPtr &method : sim::allMethods()) {
        text += "   " + QString::fromStdString(method->id()).leftJustified(22) + phrase(method->title()) +
                ", " + LessonsText::tr("order %1").arg(method->order());
        const QStringList needs = needsOf(*method);
        text += needs.isEmpty() ? QStringLiteral("\n")
                                : LessonsText::tr("; needs %1").arg(needs.join(", ")) + '\n';
    }
    return text;
}

}

int runLessons(const Arguments &arguments)
{
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    print(arguments.has("json") ? jsonList(library) : readableList(library));
    for (const LessonProblem &problem : library.problems)
        printMessage(shownPath(problem.file) + ": " + problem.why);
    if (library.lessons.empty())
        printMessage(
            LessonsText::tr("No lesson was found in %1; SPRINGSTEP_LESSONS can name a folder that has them.")
                .arg(shownPath(LessonLibrary::folders().join(", "))));
    return exitDone;
}

}
