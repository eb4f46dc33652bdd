#include "app/model/lesson_folders/lesson_folder.h"

#include "app/listing/limits.h"
#include "app/listing/program.h"
#include "app/model/catalog/lists.h"
#include "app/model/experiment/json_fields.h"
#include "app/model/learning/recall_desk.h"
#include "app/model/lesson_folders/lesson_languages.h"
#include "app/model/lesson_folders/lesson_parameters.h"
#include "app/model/lesson_folders/lesson_step.h"
#include "app/model/run/run_program.h"
#include "app/model/text/listing_text.h"
#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"
#include "lessons/api/text/document.h"
#include "sim/run/script/composed_interval.h"
#include "sim/scene/scene.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringDecoder>

#include <algorithm>

namespace app {

namespace {

struct LessonFolderText
{
    Q_DECLARE_TR_FUNCTIONS(LessonFolderText)
};

constexpr auto lessonFormat = "springstep-lesson/1";
constexpr std::size_t mostSteps = 30;
constexpr std::size_t mostParts = 20;     ///< of each kind, in a step
constexpr qsizetype longestTitle = 80;    ///< characters
constexpr qsizetype longestSummary = 300; ///< characters
const QString description = QStringLiteral("lesson.json");
const QString projectScene = QStringLiteral("project.json");
const QString projectPrefix = QStringLiteral("project_"); ///< solutions of levels: project_LEVEL.json

/// Returns the error's sentence as one line, shortened if it quotes a long text of the document.
QString sentenceOf(const lessons::DocumentError &error)
{
    constexpr qsizetype most = 800; // characters
    const QString sentence = escaped(QString::fromStdString(error.what()));
    return sentence.size() <= most
               ? sentence
               : sentence.left(most / 2) + QStringLiteral(" … ") + sentence.right(most / 2);
}

/// Reads the files of a lesson.
class LessonReader
{
public:
    LessonReader(const LessonFiles &files, const QString &language, const LessonLibrary &library)
        : m_files(files), m_language(language), m_library(library)
    {
    }

    LessonEntry read()
    {
        m_entry.source = m_files.path;
        withUserErrors([this] {
            const QStringList steps = readDescription();
            for (const QString &id : steps)
                m_entry.steps.push_back(step(id));
            refuseOtherFiles(steps);
            readRecall();
            readProject();
        });
        return std::move(m_entry);
    }

    Experiment beginning(const QString &id, const sim::Values &values) const
    {
        Beginning from;
        withUserErrors([&] {
            const lessons::Document own = document(id + QStringLiteral(".md"));
            from = beginning(id, own, own);
        });
        sim::Values &begun = from.scene.script.values;
        for (const auto &[parameter, value] : values.all()) {
            if (begun.has(parameter))
                begun.set(parameter, value);
        }
        begun.blueprint = blueprintWith(begun.blueprint, from.targets, begun);
        return from.scene;
    }

    std::vector<lessons::ParameterText> parameterTexts(const QString &id) const
    {
        std::vector<lessons::ParameterText> texts;
        withUserErrors([&] {
            const lessons::Document own = document(id + QStringLiteral(".md"));
            const lessons::Document shownTexts = document(documentFile(id));
            static_cast<void>(declaredParameters(own, shownTexts)); // they are the same
            for (lessons::ParameterText text : own.parameters) {
                const lessons::ParameterText *same = findById(shownTexts.parameters, text.id);
                text.name = same->name;
                text.help = same->help;
                if (!same->unit.isEmpty())
                    text.unit = same->unit;
                texts.push_back(text);
            }
        });
        return texts;
    }

private:
    /// A step's scene, with the parameters that the step declares and the numbers that they set in it.
    struct Beginning
    {
        Experiment scene;
        std::vector<lessons::Parameter> declared;
        std::vector<ParameterTarget> targets;
    };

    /// Calls `read`, and turns mistakes in documents into user errors.
    template <class Read>
    static void withUserErrors(const Read &read)
    {
        try {
            read();
        } catch (const lessons::DocumentError &error) {
            throw UserError(sentenceOf(error));
        }
    }

    QString shown(const QString &file) const { return m_files.shown(file); }

    QStringList readDescription()
    {
        const QString name = shown(description);
        const JsonValue root = parseJson(m_files.content(description), name);
        const JsonFields fields(name, root, LessonFolderText::tr("the file"));
        const QString format = fields.text("format", quoted(lessonFormat));
        if (format != QLatin1String(lessonFormat))
            fields.refuse("format", LessonFolderText::tr("\"format\" is %1; this program reads %2.")
                                        .arg(quoted(format), quoted(lessonFormat)));
        QStringList known = {"format", "id", "title", "summary", "steps"};
        for (const QString &language : languagesOf(m_files))
            known << "title." + language << "summary." + language;
        fields.refuseOthers(known);
        readId(fields);
        m_entry.title = shortText(fields, "title", longestTitle);
        m_entry.summary = shortText(fields, "summary", longestSummary);
        return stepsIn(fields);
    }

    static bool isId(const QString &id)
    {
        static const QRegularExpression allowed(QStringLiteral("\\A[a-z][a-z0-9_]{0,39}\\z"));
        return allowed.match(id).hasMatch();
    }

    void readId(const JsonFields &fields)
    {
        m_entry.id = fields.text("id", LessonFolderText::tr("a name of your own"));
        if (!isId(m_entry.id))
            fields.refuse("id", LessonFolderText::tr(
                                    "a lesson cannot have the id %1; an id has up to 40 characters, a to z, "
                                    "0 to 9 and _, and begins with a letter.")
                                    .arg(quoted(m_entry.id)));
        const LessonEntry *other = m_library.lesson(m_entry.id);
        if (other && other->source != m_entry.source)
            fields.refuse(
                "id", LessonFolderText::tr("there is another lesson with the id %1, “%2”. Choose another id.")
                          .arg(quoted(m_entry.id), other->title));
    }

    /// Returns a text in the language, or in that of the lesson.
    QString shortText(const JsonFields &fields, const QString &field, qsizetype longest) const
    {
        const QString own = field + '.' + m_language, used = fields.find(own) ? own : field;
        const QString text = fields.text(used, LessonFolderText::tr("a text")).simplified();
        if (text.isEmpty() || text.size() > longest)
            fields.refuse(used, LessonFolderText::tr("%1 has %2 characters; it can have 1 to %3.")
                                    .arg(quoted(used))
                                    .arg(text.size())
                                    .arg(longest));
        return text;
    }

    QStringList stepsIn(const JsonFields &fields) const
    {
        const QString name = shown(description);
        const JsonValue &value = fields.require("steps", LessonFolderText::tr("a list of ids"));
        QStringList ids;
        for (const JsonValue &one : listOf(name, value, "steps")) {
            const QString id = textOf(name, one, "steps");
            if (!isId(id) || id == u"lesson" || id == u"recall" || id == u"project" ||
                id.startsWith(projectPrefix) || ids.contains(id))
                refuse(
                    name, one.line,
                    LessonFolderText::tr("a step cannot have the id %1; each has one of its own, made of a "
                                         "to z, 0 to 9 and _, and not lesson, recall or project.")
                        .arg(quoted(id)));
            ids << id;
        }
        if (ids.isEmpty() || static_cast<std::size_t>(ids.size()) > mostSteps)
            fields.refuse("steps", LessonFolderText::tr("a lesson has 1 to %1 steps, and \"steps\" lists %2.")
                                       .arg(mostSteps)
                                       .arg(ids.size()));
        return ids;
    }

    /// Returns the name of the document in the language, or in that of the lesson.
    QString documentFile(const QString &id) const
    {
        const QString own = QStringLiteral("%1.%2.md").arg(id, m_language);
        return m_files.has(own) ? own : id + QStringLiteral(".md");
    }

    void requireFile(const QString &file, const QString &what) const
    {
        if (!m_files.has(file))
            throw UserError(
                LessonFolderText::tr("%1: the file is missing. It has %2.").arg(shown(file), what));
    }

    /// Returns a document. Pictures are refused: they could show files of the reader's machine.
    lessons::Document document(const QString &file) const
    {
        const QByteArray content = m_files.content(file);
        const qsizetype picture = content.indexOf("![");
        if (picture >= 0)
            throw lessons::DocumentError(
                shown(file), static_cast<int>(content.left(picture).count('\n')) + 1,
                LessonFolderText::tr("a text cannot show pictures. The scene is the picture; remove “![”."));
        lessons::Document document = lessons::parseDocument(content, shown(file));
        std::size_t most =
            std::max({document.tries.size(), document.predictions.size(), document.tasks.size()});
        for (const lessons::TryText &text : document.tries)
            most = std::max({most, text.doneWhen.size(), text.solution.drags.size()});
        if (most > mostParts)
            throw UserError(
                LessonFolderText::tr("%1: a step has at most %2 things to try, predictions and tasks, "
                                     "and a thing to try as many conditions and drags.")
                    .arg(shown(file))
                    .arg(mostParts));
        return document;
    }

    lessons::Step step(const QString &id) const
    {
        const QString sceneFile = id + QStringLiteral(".json"), ownDocument = id + QStringLiteral(".md");
        requireFile(
            sceneFile,
            LessonFolderText::tr(
                "the scene of the step: save it in the window under this name, with the ending .json"));
        requireFile(ownDocument,
                    LessonFolderText::tr(
                        "the texts of the step. Write the file, or remove the step from lesson.json"));
        const lessons::Document own = document(ownDocument);
        const QString shownDocument = documentFile(id);
        lessons::Document texts = shownDocument == ownDocument ? own : document(shownDocument);
        const Beginning from = beginning(id, own, texts);
        lessons::Step step = stepOf(id, baseOf(from.scene), from.scene, from.declared, from.targets);
        readListing(id, step);
        step.checks = checksOf(own, step);
        takeSolutions(texts, own);
        checkRuns(texts, step);
        step.setTexts(texts);
        checkNearMisses(step, shownDocument);
        return step;
    }

    const lessons::Step &baseOf(const Experiment &scene) const
    {
        return *m_library.lesson(scene.lesson)->step(scene.step);
    }

    Beginning beginning(const QString &id, const lessons::Document &own, const lessons::Document &texts) const
    {
        const QString file = id + QStringLiteral(".json");
        Beginning from;
        from.declared = declaredParameters(own, texts);
        from.scene = parseExperimentWith(from.declared, m_files.content(file), shown(file), m_library);
        checkScene(id, from.scene);
        from.targets = targetsOf(own, from.scene);
        takeValues(from.declared, own, from.targets, from.scene);
        checkNamesAndUse(own, from.targets, baseOf(from.scene), from.scene);
        refuseValues(file, own);
        return from;
    }

    /// The document says where its parameters begin.
    void refuseValues(const QString &file, const lessons::Document &own) const
    {
        const JsonValue root = parseJson(m_files.content(file), shown(file));
        const JsonValue *values =
            JsonFields(shown(file), root, LessonFolderText::tr("the file")).find("parameters");
        if (!values)
            return;
        const JsonFields fields(shown(file), *values, quoted("parameters"));
        for (const lessons::ParameterText &text : own.parameters) {
            if (fields.find(text.id))
                fields.refuse(text.id,
                              LessonFolderText::tr("%1 says where the parameter %2 begins. Remove it here.")
                                  .arg(own.file, quoted(text.id)));
        }
    }

    void checkScene(const QString &id, const Experiment &scene) const
    {
        const QString file = id + QStringLiteral(".json");
        const LessonEntry *lesson = m_library.lesson(scene.lesson);
        if (!lesson->source.isEmpty())
            throw UserError(
                LessonFolderText::tr("%1: the scene is one of the lesson %2, which is not built in. "
                                     "Open that lesson, choose File > New lesson from this scene, and take "
                                     "the scene that this writes.")
                    .arg(shown(file), quoted(scene.lesson)));
        if (programOf(scene.script.method))
            throw UserError(LessonFolderText::tr("%1: a listing computes this scene. Choose a method in the "
                                                 "window, and write the listing into %2.code.")
                                .arg(shown(file), id));
    }

    static QString textIn(const QByteArray &content, const QString &file)
    {
        QStringDecoder decoder(QStringDecoder::Utf8);
        QString text = decoder(content);
        if (decoder.hasError())
            throw UserError(
                LessonFolderText::tr("%1: this is not UTF-8. Save the file with the encoding UTF-8.")
                    .arg(file));
        return text.remove('\r');
    }

    void readListing(const QString &id, lessons::Step &step) const
    {
        const QString file = id + QStringLiteral(".code");
        if (!m_files.has(file))
            return;
        const QString source = textIn(m_files.content(file), shown(file));
        if (m_files.content(file).size() > static_cast<qsizetype>(listing::maxTextBytes))
            throw UserError(LessonFolderText::tr("%1: the listing has more than %2 bytes.")
                                .arg(shown(file))
                                .arg(listing::maxTextBytes));
        try {
            step.listing = lessons::parseListing(source);
        } catch (const std::runtime_error &error) {
            throw UserError(QStringLiteral("%1: %2").arg(shown(file), QString::fromUtf8(error.what())));
        }
        if (step.h != 1.0)
            throw UserError(
                LessonFolderText::tr("%1: a listing computes whole frames, and the scene has steps "
                                     "of another length. Set \"h\" to 1 in %2.json.")
                    .arg(shown(file), id));
        const std::optional<listing::CompileError> error = mistakeIn(step, step.listing.text);
        if (error)
            throw lessons::DocumentError(shown(file), lineInFile(source, error->line),
                                         listingSentence(error->sentence));
    }

    static std::optional<listing::CompileError> mistakeIn(const lessons::Step &step, const QString &code)
    {
        const listing::Compiled compiled = compiledFor(step.script(), code);
        return compiled.program ? std::nullopt : std::optional(compiled.errors.front());
    }

    /// Returns the line of a file for a line of its listing, which lacks the marks of gaps.
    static int lineInFile(const QString &source, int line)
    {
        int number = 0;
        for (const QString &text : source.split('\n')) {
            ++number;
            const QString trimmed = text.trimmed();
            if (!trimmed.startsWith(QStringLiteral("//>")) && trimmed != u"//<" && --line == 0)
                return number;
        }
        return number;
    }

    void checkNearMisses(const lessons::Step &step, const QString &file) const
    {
        for (const lessons::CodeTask &task : step.codeTasks) {
            for (const lessons::NearMiss &miss : task.nearMisses) {
                const QString gap = miss.gap.isEmpty() ? task.id : miss.gap;
                const auto error = mistakeIn(step, step.listing.with(gap, miss.code));
                if (error)
                    throw UserError(
                        LessonFolderText::tr("%1: a near miss of the task %2 does not compile: %3")
                            .arg(shown(file), quoted(task.id), listingSentence(error->sentence)));
            }
        }
    }

    /// Gives a translation the conditions and solutions of the lesson's own document.
    static void takeSolutions(lessons::Document &texts, const lessons::Document &own)
    {
        for (lessons::TryText &text : texts.tries) {
            const lessons::TryText *same = findById(own.tries, text.id);
            if (!same)
                continue; // setTexts() says so
            if (text.doneWhen.empty())
                text.doneWhen = same->doneWhen;
            if (text.solution.line == 0)
                text.solution = same->solution;
        }
    }

    /// A file that belongs to no step is most likely misspelt.
    void refuseOtherFiles(const QStringList &steps) const
    {
        for (const auto &[file, content] : m_files.all) {
            const QString stem = file.section('.', 0, 0), ending = file.section('.', -1);
            if (ending != u"md" && ending != u"json" && ending != u"code")
                throw UserError(
                    LessonFolderText::tr("%1: a lesson has files .md, .json and .code. Remove it.")
                        .arg(shown(file)));
            const bool isOfStep = steps.contains(stem);
            const bool isOfLesson = file == description || (stem == u"recall" && ending == u"md") ||
                                    (stem == u"project" && ending != u"code") ||
                                    (stem.startsWith(projectPrefix) && ending == u"json");
            if (!isOfStep && !isOfLesson)
                throw UserError(LessonFolderText::tr("%1: there is no step %2 in \"steps\" of lesson.json; "
                                                     "there is %3. Add it there, or rename the file.")
                                    .arg(shown(file), quoted(stem), quotedList(steps, stem)));
        }
    }

    /// Returns the library with this lesson in it, for scenes of its own questions.
    LessonLibrary libraryWithThis() const
    {
        LessonLibrary library = m_library;
        library.yours = {m_entry};
        return library;
    }

    void readRecall()
    {
        const QString file = documentFile(QStringLiteral("recall"));
        if (!m_files.has(file))
            return;
        m_entry.recall = lessons::parseRecall(m_files.content(file), shown(file));
        checkRecall(m_entry.recall, libraryWithThis());
    }

    void readProject()
    {
        const QString file = documentFile(QStringLiteral("project"));
        if (!m_files.has(file))
            return;
        requireFile(projectScene, LessonFolderText::tr("the scene that the project starts with"));
        m_entry.project = lessons::parseProject(m_files.content(file), shown(file));
        m_entry.projectStart = m_files.content(projectScene);
        parseExperiment(m_entry.projectStart, shown(projectScene), libraryWithThis());
    }

    const LessonFiles &m_files;
    const QString m_language;
    const LessonLibrary &m_library;
    LessonEntry m_entry;
};

}

LessonEntry readLesson(const QString &path, const LessonLibrary &library)
{
    return lessonOf(readLessonFiles(path), lessons::documentLanguage(), library);
}

LessonEntry lessonOf(const LessonFiles &files, const QString &language, const LessonLibrary &library)
{
    return LessonReader(files, language, library).read();
}

Experiment beginningOf(const LessonFiles &lesson, const QString &step, const sim::Values &values,
                       const LessonLibrary &library)
{
    return LessonReader(lesson, {}, library).beginning(step, values);
}

std::vector<lessons::ParameterText> parameterTexts(const LessonFiles &lesson, const QString &step,
                                                   const QString &language)
{
    return LessonReader(lesson, language, {}).parameterTexts(step);
}

}
