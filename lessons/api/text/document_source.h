#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

namespace lessons {

/// A document in the resources of a lesson.
struct DocumentSource
{
    QByteArray text;
    QString file; ///< the name that errors show
};

/// Returns the document `:/documents/LESSON/NAME.md` of the resources, in the language of documentLanguage() if it is
/// there and otherwise in English. Empty if there is none.
std::optional<DocumentSource> documentSource(const QString &lesson, const QString &name);

}
