#pragma once

#include "lessons/api/text/document.h"
#include "tests/lessons/support/support.h"

namespace support {

/// The resource path of the documents in lesson plugins.
inline const QString documentFolder = QStringLiteral(":/documents/");

/// Returns all lessons in their order, loaded once. Their documents can be read from then on.
const std::vector<LoadedLesson> &allLessons();
/// Returns the codes of all languages that documents have, of which "en" comes first.
QStringList documentLanguages();
QString idOf(const LoadedLesson &lesson);
/// Returns the document of a step in a language. Without a title if there is none.
lessons::Document documentOf(const QString &lesson, const QString &step, const QString &language);

/// A text of a document and its position.
struct DocumentPlace
{
    QString where;
    QString text;
};

/// Returns all texts of a document in order. Code of near misses is left out.
std::vector<DocumentPlace> placesIn(const lessons::Document &document);

}
