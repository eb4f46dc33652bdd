#include "tests/lessons/support/documents.h"

#include <QDir>
#include <QFile>

#include <algorithm>

namespace support {

const std::vector<LoadedLesson> &allLessons()
{
    static const std::vector<LoadedLesson> lessons = [] {
        std::vector<LoadedLesson> all;
        for (const QString &id : lessonIds())
            all.push_back(loadLesson(id));
        std::sort(all.begin(), all.end(), [](const LoadedLesson &a, const LoadedLesson &b) {
            return a.metadata.value("order").toInt() < b.metadata.value("order").toInt();
        });
        return all;
    }();
    return lessons;
}

QStringList documentLanguages()
{
    QStringList codes = {"en"};
    for (const LoadedLesson &lesson : allLessons()) { // the plugins bring the documents
        for (const QString &name : QDir(documentFolder + idOf(lesson)).entryList({"*.*.md"})) {
            if (!codes.contains(name.section('.', 1, 1)))
                codes << name.section('.', 1, 1);
        }
    }
    return codes;
}

QString idOf(const LoadedLesson &lesson)
{
    return lesson.metadata.value("id").toString();
}

lessons::Document documentOf(const QString &lesson, const QString &step, const QString &language)
{
    const QString name = language == u"en" ? step : step + '.' + language;
    QFile file(QStringLiteral("%1%2/%3.md").arg(documentFolder, lesson, name));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return lessons::parseDocument(file.readAll(), file.fileName());
}

std::vector<DocumentPlace> placesIn(const lessons::Document &document)
{
    std::vector<DocumentPlace> all = {{"title", document.title}, {"story", document.story}};
    for (const lessons::TryText &one : document.tries) {
        const QString name = "try " + one.id;
        all.insert(all.end(), {{name, one.text}, {name + " hint", one.hint}, {name + " answer", one.answer}});
        for (auto at = one.missing.begin(); at != one.missing.end(); ++at)
            all.push_back({name + " missing " + at.key(), at.value()});
        for (const QString &choice : one.choices.texts)
            all.push_back({name + " choice", choice});
    }
    for (const lessons::Prediction &one : document.predictions) {
        const QString name = "prediction " + one.id;
        all.insert(all.end(), {{name, one.text}, {name + " answer", one.answer}});
    }
    for (const lessons::CodeTask &task : document.tasks) {
        const QString name = "task " + task.id;
        all.insert(all.end(),
                   {{name + " title", task.title}, {name, task.text}, {name + " comment", task.comment}});
        for (const QString &hint : task.hints)
            all.push_back({name + " hint", hint});
        for (const lessons::NearMiss &miss : task.nearMisses)
            all.push_back({name + " near miss", miss.sentence});
    }
    for (const lessons::Term &term : document.explanation.terms)
        all.push_back({"word " + term.name, term.text});
    for (const lessons::Concept &one : document.explanation.concepts)
        all.insert(all.end(), {{"concept " + one.id + " title", one.title}, {"concept " + one.id, one.text}});
    for (const lessons::Why &why : document.explanation.whys)
        all.insert(all.end(), {{"why", why.question}, {"answer of " + why.question, why.answer}});
    all.push_back({"learnt", document.explanation.learnt});
    return all;
}

}
