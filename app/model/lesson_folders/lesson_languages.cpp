#include "app/model/lesson_folders/lesson_languages.h"

#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

namespace {

struct LessonLanguagesText
{
    Q_DECLARE_TR_FUNCTIONS(LessonLanguagesText)
};

[[noreturn]] void refuseDifference(const LessonEntry &lesson, const QString &step, const QString &what)
{
    throw UserError(LessonLanguagesText::tr("%1, step %2: the languages differ in %3. Make them the same.")
                        .arg(lesson.id, quoted(step), what));
}

/// Returns a text that two runs share if they are the same.
QString keyOf(const lessons::RunSetup &run)
{
    QStringList parts = {run.step, run.method, run.until, QString::number(run.frames)};
    for (const auto &[id, value] : run.values)
        parts << id + '=' + value;
    for (const auto &place : run.places)
        parts << QStringLiteral("%1@%2,%3").arg(place.body).arg(place.at.x).arg(place.at.y);
    for (const auto &drag : run.drags)
        parts << QStringLiteral("%1>%2,%3,%4").arg(drag.body).arg(drag.to.x).arg(drag.to.y).arg(drag.frames);
    return parts.join(';');
}

QStringList predictionKeys(const lessons::Step &step)
{
    QStringList keys;
    for (const lessons::Prediction &one : step.predictions)
        keys << one.id + ':' + keyOf(one.run) + ':' + one.question.of;
    return keys;
}

QStringList taskKeys(const lessons::Step &step)
{
    QStringList keys;
    for (const lessons::CodeTask &task : step.codeTasks) {
        keys << task.id;
        for (const lessons::NearMiss &miss : task.nearMisses)
            keys << miss.gap + ':' + miss.code;
    }
    return keys;
}

QStringList recallKeys(const LessonEntry &lesson)
{
    QStringList keys;
    for (const lessons::RecallQuestion &one : lesson.recall.questions)
        keys << QStringLiteral("%1:%2:%3")
                    .arg(one.id)
                    .arg(one.choices.size())
                    .arg(one.task ? keyOf(one.task->setup) : QString());
    return keys;
}

}

QStringList languagesOf(const LessonFiles &files)
{
    QStringList languages;
    for (const auto &[file, content] : files.all) {
        const QStringList parts = file.split('.');
        if (parts.size() == 3 && !languages.contains(parts[1]))
            languages << parts[1];
    }
    languages.sort();
    return languages;
}

void checkSameQuestions(const LessonEntry &one, const LessonEntry &other)
{
    for (std::size_t i = 0; i < std::min(one.steps.size(), other.steps.size()); ++i) {
        const lessons::Step &a = one.steps[i], &b = other.steps[i];
        if (predictionKeys(a) != predictionKeys(b))
            refuseDifference(one, a.id, LessonLanguagesText::tr("their predictions"));
        if (taskKeys(a) != taskKeys(b))
            refuseDifference(one, a.id, LessonLanguagesText::tr("their tasks"));
    }
    if (recallKeys(one) != recallKeys(other))
        refuseDifference(one, QStringLiteral("recall"), LessonLanguagesText::tr("their questions"));
}

}
