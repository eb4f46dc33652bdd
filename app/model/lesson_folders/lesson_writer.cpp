#include "app/model/lesson_folders/lesson_writer.h"

#include "app/model/files/whole_file.h"
#include "app/model/lesson_folders/lesson_folder.h"
#include "app/model/lesson_folders/lesson_package.h"
#include "app/model/lesson_folders/lesson_parameters.h"
#include "app/model/run/run_program.h"
#include "app/model/text/json_writer.h"
#include "app/model/text/quoting.h"
#include "lessons/api/text/document.h"
#include "lessons/api/view/view.h"
#include "sim/scene/scene.h"

#include <QCoreApplication>
#include <QDir>
#include <QRegularExpression>

#include <algorithm>

namespace app {

namespace {

struct LessonWriterText
{
    Q_DECLARE_TR_FUNCTIONS(LessonWriterText)
};

const QString firstStep = QStringLiteral("first");
constexpr double pulled = 40.0; ///< px: how far the example of a try pulls a body

/// Returns an id for a lesson in a folder with this name.
QString idFor(const QString &folder, const LessonLibrary &library)
{
    static const QRegularExpression others(QStringLiteral("[^a-z0-9_]+"));
    static const QRegularExpression ends(QStringLiteral("^_+|_+$"));
    QString id = folder.toLower().replace(others, QStringLiteral("_")).left(30).remove(ends);
    if (id.isEmpty() || id[0] < 'a' || id[0] > 'z')
        id.prepend(QStringLiteral("lesson_"));
    QString free = id;
    for (int number = 2; library.lesson(free); ++number)
        free = id + QString::number(number);
    return free;
}

/// Returns the first body that a learner can drag, or -1.
int draggedBody(const lessons::Step &step, const sim::Scene &scene, const sim::Values &values)
{
    if (!step.accepts(lessons::Interaction::drag))
        return -1;
    const lessons::View view = step.view(scene, values);
    for (int i = 0; i < scene.start.pointCount(); ++i) {
        const lessons::BodyView &body = view.bodies[static_cast<std::size_t>(i)];
        if (scene.start.isDynamic(i) && body.shape != lessons::BodyView::Shape::none)
            return i;
    }
    return -1;
}

/// Returns a thing to try with a body, as an example for the writer.
QString tryWith(const QString &body, sim::Vec2 at)
{
    return LessonWriterText::tr(
               "## Try {#pull}\n\n"
               "Pull **%1** aside, and let go of it. What does it do?\n\n"
               "### Hint\n\n"
               "Press **Space**. Hold the mouse button on %1, move the mouse, and let go.\n\n"
               "### Answer\n\n"
               "Write here what one can see then.\n\n"
               "### Done when\n\n"
               "- begun: held(%1) or released(%1)\n"
               "- let_go: released(%1)\n\n"
               "### Missing\n\n"
               "- let_go: let go of it.\n\n"
               "### Solution\n\n"
               "- drag %1: %2, %3, 10\n"
               "- frames: 30\n\n")
        .arg(body, QString::number(at.x + pulled, 'f', 0), QString::number(at.y, 'f', 0));
}

/// Returns a prediction about a body, as an example for the writer.
QString predictionAbout(const QString &body)
{
    return LessonWriterText::tr("## Predict {#where}\n\n"
                                "Nobody touches anything. Where is %1 after 60 frames? Click the place.\n\n"
                                "### Run\n\n"
                                "- frames: 60\n\n"
                                "### Ask\n\n"
                                "- place: %1\n\n"
                                "### Answer\n\n"
                                "Write here why it is there.\n\n")
        .arg(body);
}

QString documentFor(const QString &body, sim::Vec2 at, bool canDrag,
                    const std::vector<lessons::ParameterText> &parameters)
{
    QString text = LessonWriterText::tr(
        "# The title of the step\n\n"
        "Write here what a learner should look at, why it is so, and the rule to keep. Save this file, and "
        "the window "
        "shows what you wrote.\n\n"
        "Below are parts that a step can have. Change them, copy them, or remove them.\n\n");
    for (const lessons::ParameterText &parameter : parameters)
        text += sectionFor(parameter);
    if (canDrag)
        text += tryWith(body, at);
    text += predictionAbout(body);
    return text + LessonWriterText::tr("## Word: Step\n\n"
                                       "Forms: none\n\n"
                                       "A word that the text uses, in one sentence.\n\n"
                                       "## Why: Why is it so?\n\n"
                                       "Write here a question that learners ask, and the answer.\n\n"
                                       "## Learnt\n\n"
                                       "Write here in one sentence what a learner knows now.\n");
}

QByteArray descriptionOf(const QString &id)
{
    JsonWriter json(1);
    json.beginObject();
    json.field("format", "springstep-lesson/1");
    json.field("id", id);
    json.field("title", LessonWriterText::tr("My lesson"));
    json.field("summary", LessonWriterText::tr("What it is about, in one sentence."));
    json.beginList("steps", JsonWriter::Layout::oneLine);
    json.value(firstStep);
    json.endList();
    json.endObject();
    return json.text() + '\n';
}

/// What a new lesson begins with.
struct LessonSeed
{
    Experiment scene; ///< of a step of the program
    std::vector<lessons::ParameterText> parameters = {};
};

/// Returns the scene without what a lesson does not have: input, other runs, and a listing as its method.
Experiment withoutInput(Experiment scene, const lessons::Step &step)
{
    if (programOf(scene.script.method)) {
        scene.script.method = step.script().method;
        scene.script.step = step.script().step;
    }
    scene.script.input = step.scriptWith(scene.script.values, scene.script.method).input;
    scene.branches = {};
    scene.draft.reset();
    return scene;
}

/// Returns the scene of a lesson without C++ as one of the step that it builds on, with the parameters, the method and the
/// places of `scene`.
LessonSeed seedFromYours(const Experiment &scene, const LessonEntry &lesson, const LessonLibrary &library)
{
    const LessonFiles files = readLessonFiles(lesson.source);
    const sim::Script given = withoutInput(scene, *lesson.step(scene.step)).script;
    LessonSeed seed{beginningOf(files, scene.step, given.values, library),
                    parameterTexts(files, scene.step, lessons::documentLanguage())};
    sim::Script &script = seed.scene.script;
    script.values.seed = given.values.seed;
    script.method = given.method;
    script.step = given.step;
    script.bodies = given.bodies;
    script.effectsOff = given.effectsOff;
    for (lessons::ParameterText &parameter : seed.parameters) {
        if (parameter.value && script.values.has(parameter.id.toStdString()))
            parameter.value = script.values[parameter.id.toStdString()];
    }
    return seed;
}

LessonSeed seedFrom(const Experiment &scene, const LessonLibrary &library)
{
    const LessonEntry *lesson = library.lesson(scene.lesson);
    const lessons::Step *step = lesson ? lesson->step(scene.step) : nullptr;
    if (!step)
        throw UserError(LessonWriterText::tr("There is no step %1 any more. Open another one, and begin the "
                                             "lesson with its scene.")
                            .arg(quoted(scene.step)));
    LessonSeed seed = lesson->source.isEmpty() ? LessonSeed{scene} : seedFromYours(scene, *lesson, library);
    seed.scene = withoutInput(seed.scene, *library.lesson(seed.scene.lesson)->step(seed.scene.step));
    return seed;
}

}

void writeLesson(const Experiment &scene, const QString &folder, const LessonLibrary &library)
{
    const LessonSeed seed = seedFrom(scene, library);
    const Experiment &beginning = seed.scene;
    const lessons::Step &step = *library.lesson(beginning.lesson)->step(beginning.step);
    QDir dir(folder);
    const bool wasThere = dir.exists();
    if (wasThere && !dir.isEmpty())
        throw UserError(LessonWriterText::tr("%1 is not empty. Choose a new folder for the lesson.")
                            .arg(shownPath(folder)));
    const sim::Scene built = sim::sceneOf(beginning.script, beginning.script.values);
    const int dragged = draggedBody(step, built, beginning.script.values);
    const int body = std::max(dragged, 0);
    const QString name = QString::fromStdString(built.names[static_cast<std::size_t>(body)]);
    const QByteArray texts =
        documentFor(name, built.start.positionOf(body), dragged >= 0, seed.parameters).toUtf8();
    const QByteArray experiment = experimentText(beginning, library);
    if (!dir.mkpath(QStringLiteral(".")))
        throw UserError(LessonWriterText::tr("%1: the folder could not be made. Choose another place.")
                            .arg(shownPath(folder)));
    try {
        writeWholeFile(dir.filePath(QStringLiteral("lesson.json")),
                       descriptionOf(idFor(QDir(dir.absolutePath()).dirName(), library)));
        writeWholeFile(dir.filePath(firstStep + QStringLiteral(".json")), experiment);
        writeWholeFile(dir.filePath(firstStep + QStringLiteral(".md")), texts);
    } catch (const UserError &) {
        for (const QString &file : dir.entryList(QDir::Files))
            dir.remove(file);
        if (!wasThere)
            dir.removeRecursively();
        throw;
    }
}

}
