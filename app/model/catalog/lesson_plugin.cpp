#include "app/model/catalog/lesson_plugin.h"

#include "app/model/text/language.h"
#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"
#include "lessons/api/lesson.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/pipeline.h"
#include "sim/run/script/script.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonObject>
#include <QPluginLoader>
#include <QRegularExpression>
#include <QSet>

#include <cmath>

namespace app {

namespace {

struct LessonPluginText
{
    Q_DECLARE_TR_FUNCTIONS(LessonPluginText)
};

/// Throws the error for a lesson that its author must fix.
[[noreturn]] void refuseLesson(const QString &why)
{
    throw UserError(LessonPluginText::tr("It is not a lesson that can be used: %1.").arg(why));
}

void checkInterface(const QPluginLoader &loader)
{
    const QString iid = loader.metaData().value("IID").toString();
    if (iid.isEmpty())
        throw UserError(LessonPluginText::tr(
            "It is not a plugin, or it is damaged; install it again, or move it to another "
            "folder."));
    const QString wanted = QStringLiteral(SpringstepLesson_iid);
    if (iid == wanted)
        return;
    const QString family = wanted.left(wanted.indexOf('/') + 1);
    if (iid.startsWith(family))
        throw UserError(LessonPluginText::tr(
                            "It is a lesson for another version of the program (%1, not %2); build it again "
                            "for this one.")
                            .arg(oneLine(iid), wanted));
    throw UserError(LessonPluginText::tr("It is a plugin of another program (%1); move it to another folder.")
                        .arg(oneLine(iid)));
}

QString requireText(const QJsonObject &data, const QString &name)
{
    const QString text = data.value(name).toString();
    if (text.isEmpty())
        refuseLesson(LessonPluginText::tr("its description has no text %1").arg(quoted(name)));
    return text;
}

void checkId(const QString &id)
{
    static const QRegularExpression allowed(QStringLiteral("\\A[a-z][a-z0-9_]*\\z"));
    if (!allowed.match(id).hasMatch())
        refuseLesson(LessonPluginText::tr("the id %1 is not made of a to z, 0 to 9 and _").arg(quoted(id)));
}

QStringList stepIds(const QJsonObject &data)
{
    QStringList ids;
    for (const QJsonValue &value : data.value("steps").toArray()) {
        checkId(value.toString());
        ids.push_back(value.toString());
    }
    if (ids.isEmpty())
        refuseLesson(LessonPluginText::tr("its description lists no \"steps\""));
    if (QSet<QString>(ids.begin(), ids.end()).size() != ids.size())
        refuseLesson(LessonPluginText::tr("its description lists a step twice"));
    return ids;
}

void checkStep(const lessons::Step &step)
{
    if (!step.scene || !step.view)
        refuseLesson(LessonPluginText::tr("the step %1 has no scene or no view").arg(quoted(step.id)));
    if (!sim::findMethod(step.method.toStdString()))
        refuseLesson(LessonPluginText::tr("the step %1 needs the method %2, which does not exist")
                         .arg(quoted(step.id), quoted(step.method)));
    if (step.companion && !sim::findMethod(step.companion->method.toStdString()))
        refuseLesson(LessonPluginText::tr("the step %1 needs the method %2, which does not exist")
                         .arg(quoted(step.id), quoted(step.companion->method)));
    try {
        const sim::Script script = step.script();
        sim::compose(sim::sceneOf(script, script.values), *script.method, script.step);
    } catch (const std::exception &error) {
        refuseLesson(LessonPluginText::tr("the step %1 cannot start (%2)")
                         .arg(quoted(step.id), oneLine(QString::fromUtf8(error.what()))));
    }
}

/// Returns what `read` returns. Refuses the lesson if it throws: `why` has %1 in place of the error.
template <class Read>
auto readOrRefuse(const QString &why, const Read &read)
{
    try {
        return read();
    } catch (const std::exception &error) {
        refuseLesson(why.arg(oneLine(QString::fromUtf8(error.what()))));
    }
}

/// Returns a text of lesson.json in the learner's language.
QString told(const QString &text)
{
    return QCoreApplication::translate("lesson.json", text.toUtf8().constData());
}

}

LessonDescription describedLesson(const QJsonObject &data)
{
    LessonEntry lesson;
    lesson.id = requireText(data, "id");
    checkId(lesson.id);
    const double order = data.value("order").toDouble(-1.0);
    if (order < 0.0 || order > 1e6 || order != std::floor(order))
        refuseLesson(LessonPluginText::tr("its description has no whole number \"order\""));
    lesson.order = int(order);
    lesson.title = requireText(data, "title");
    lesson.summary = requireText(data, "summary");
    return {std::move(lesson), stepIds(data)};
}

LessonEntry loadLesson(const QString &file, Language *language)
{
    QPluginLoader loader(file);
    checkInterface(loader);
    const QJsonObject data = loader.metaData().value("MetaData").toObject();
    auto [lesson, ids] = describedLesson(data);
    QObject *instance = loader.instance();
    if (!instance)
        throw UserError(LessonPluginText::tr("It could not be loaded: %1. Build or install it again.")
                            .arg(oneLine(loader.errorString())));
    if (language)
        language->learn();
    lesson.title = told(lesson.title);
    lesson.summary = told(lesson.summary);
    const auto *code = qobject_cast<lessons::Lesson *>(instance);
    if (!code)
        refuseLesson(LessonPluginText::tr("its code has no lesson"));
    lesson.steps = readOrRefuse(LessonPluginText::tr("its steps could not be created (%1)"),
                                [&] { return code->steps(); });
    QStringList made;
    for (const lessons::Step &step : lesson.steps)
        made.push_back(step.id);
    if (made != ids)
        refuseLesson(
            LessonPluginText::tr("its description lists the steps %1, its code has %2")
                .arg(quotedList(ids), made.isEmpty() ? LessonPluginText::tr("none") : quotedList(made)));
    for (const lessons::Step &step : lesson.steps)
        checkStep(step);
    const QString folder = lesson.steps.front().lesson;
    lesson.recall = readOrRefuse(LessonPluginText::tr("its questions could not be read (%1)"),
                                 [&] { return lessons::readRecall(folder); });
    lesson.project = readOrRefuse(LessonPluginText::tr("its project could not be read (%1)"),
                                  [&] { return lessons::readProject(folder); });
    return lesson;
}

}
