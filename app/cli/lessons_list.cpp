#include "app/cli/lessons_list.h"

#include "app/cli/terminal.h"
#include "app/model/lesson_library.h"
#include "app/model/sentences.h"
#include "app/model/words.h"
#include "sim/methods/methods.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(LessonsList)
};

QString presetChoice(const lessons::Parameter &parameter)
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

QJsonObject parameterJson(const lessons::Parameter &parameter)
{
    if (!parameter.choices.isEmpty())
        return {{"id", parameter.id},
                {"default", presetChoice(parameter)},
                {"choices", QJsonArray::fromStringList(parameter.choices)}};
    return {{"id", parameter.id},
            {"unit", parameter.unit},
            {"default", parameter.defaultValue},
            {"min", parameter.min},
            {"max", parameter.max}};
}

QJsonObject lessonJson(const LessonEntry &lesson)
{
    QJsonArray steps;
    for (const lessons::Step &step : lesson.steps) {
        QJsonArray parameters;
        for (const lessons::Parameter &parameter : step.parameters)
            parameters.append(parameterJson(parameter));
        steps.append(QJsonObject{{"id", step.id}, {"title", step.title}, {"parameters", parameters}});
    }
    return {{"id", lesson.id}, {"order", lesson.order}, {"title", lesson.title}, {"steps", steps}};
}

QString jsonList(const LessonLibrary &library)
{
    QJsonArray lessons;
    for (std::size_t i = 0; i < library.entries(); ++i)
        lessons.append(lessonJson(library.entry(i)));
    QJsonArray methods;
    for (const sim::MethodPtr &method : sim::allMethods())
        methods.append(QJsonObject{{"id", QString::fromStdString(method->id())},
                                   {"order", method->order()},
                                   {"needs", QJsonArray::fromStringList(needsOf(*method))}});
    const QJsonDocument document(QJsonObject{{"lessons", lessons}, {"methods", methods}});
    return QString::fromUtf8(document.toJson());
}

QString parameterLine(const lessons::Parameter &parameter)
{
    const QString start = "      " + parameter.id.leftJustified(16);
    if (!parameter.choices.isEmpty())
        return start + Text::tr("%1; one of %2").arg(presetChoice(parameter), parameter.choices.join(", ")) +
               '\n';
    QString line = start + Text::tr("%1; %2 to %3")
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
        text += QString::number(lesson.order) + ". " + lesson.id + ": " + lesson.title + '\n';
        for (const lessons::Step &step : lesson.steps) {
            text += "   " + lesson.id + '/' + step.id + ": " + step.title + '\n';
            for (const lessons::Parameter &parameter : step.parameters)
                text += parameterLine(parameter);
        }
        text += '\n';
    }
    text += Text::tr("Methods") + '\n';
    for (const sim::MethodPtr &method : sim::allMethods()) {
        text += "   " + QString::fromStdString(method->id()).leftJustified(22) + phrase(method->title()) +
                ", " + Text::tr("order %1").arg(method->order());
        const QStringList needs = needsOf(*method);
        text += needs.isEmpty() ? QStringLiteral("\n") : Text::tr("; needs %1").arg(needs.join(", ")) + '\n';
    }
    return text;
}

}

int listLessons(bool asJson)
{
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    print(asJson ? jsonList(library) : readableList(library));
    for (const LessonProblem &problem : library.problems)
        say(shownPath(problem.file) + ": " + problem.why);
    if (library.lessons.empty())
        say(Text::tr("No lesson was found in %1; SPRINGSTEP_LESSONS can name a folder that has them.")
                .arg(shownPath(LessonLibrary::folders().join(", "))));
    return exitDone;
}

}
