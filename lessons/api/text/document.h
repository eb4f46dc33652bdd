#pragma once

#include "lessons/api/explanation.h"
#include "lessons/api/listing.h"
#include "lessons/api/prediction.h"
#include "lessons/api/text/parameter_text.h"
#include "lessons/api/text/run_setup.h"
#include "lessons/api/try.h"

#include <QByteArray>
#include <QMap>
#include <QString>

#include <stdexcept>
#include <vector>

namespace lessons {

/// The texts of a thing to try. The id joins them with their Check.
struct TryText
{
    QString id;
    QString text;   ///< Markdown, one or two short sentences
    QString hint;   ///< Markdown, one to three sentences
    QString answer; ///< Markdown; may be empty
    /// The sentences about what is missing, by name; see Condition::sentence.
    QMap<QString, QString> missing = {};
    Choices choices = {};
    /// The conditions of a lesson without C++, in the language of conditions: the first tells whether the learner has begun.
    /// The names are those of the sentences in `missing`. Empty in other lessons.
    std::vector<ListItem> doneWhen = {};
    /// A run that does what the text asks for. Without `frames` if the document does not say.
    RunSetup solution = {};
    int line = 0;        ///< of its heading, from 1
    int missingLine = 0; ///< of the heading of `missing`; 0 if there is none
};

/// Everything that a learner reads at a step, in one language.
struct Document
{
    QString file; ///< the name that errors show
    QString title;
    QString story;                              ///< Markdown
    std::vector<ParameterText> parameters = {}; ///< of a lesson without C++; empty in other lessons
    std::vector<TryText> tries = {};
    std::vector<Prediction> predictions = {};
    std::vector<CodeTask> tasks = {};
    std::vector<int> taskLines = {}; ///< of the headings of `tasks`, from 1
    Explanation explanation = {};
};

/// A mistake in a document. what() is a sentence with the file, the line, the mistake and the remedy.
class DocumentError : public std::runtime_error
{
public:
    DocumentError(const QString &file, int line, const QString &why);
};

/// Reads a document. lessons/README.md describes its format. `file` is the name that errors show.
/// @throws DocumentError if a heading or a text is missing, unknown or there twice, or if `source` is not UTF-8
Document parseDocument(const QByteArray &source, const QString &file);

/// Returns the language of the documents to show, such as "en" or "de" (that of the installed translations).
QString documentLanguage();

/// Returns the names of the files that can hold the document of a step, the best first: STEP.de.md, then STEP.md.
QStringList documentNames(const QString &step);

/// Returns the document `:/documents/LESSON/STEP.md` of the resources, in the language of documentLanguage() if it is
/// there and otherwise in English.
/// @throws DocumentError if there is none, or as parseDocument()
Document readDocument(const QString &lesson, const QString &step);

}
