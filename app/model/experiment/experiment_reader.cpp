#include "app/model/experiment/experiment.h"

#include "app/model/experiment/experiment_method.h"
#include "app/model/experiment/experiment_run.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>

namespace app {

namespace {

constexpr auto format = "springstep-experiment/1";

/// A reader of an experiment file: its lesson and step, its run, and its branches.
class ExperimentReader
{
    Q_DECLARE_TR_FUNCTIONS(Experiment)

public:
    ExperimentReader(const QString &file, const JsonValue &root, const LessonLibrary &library,
                     const std::vector<lessons::Parameter> &more)
        : m_file(file), m_fields(file, root, tr("the file")), m_library(library), m_more(more)
    {
    }

    Experiment read()
    {
        readFormat();
        readStep();
        const ReadRun run = readRun(m_file, m_fields, *m_step);
        m_experiment.frames = run.frames;
        m_experiment.script = run.script;
        readOwnName();
        if (m_fields.find("draft"))
            m_experiment.draft = learnersText(m_fields, "draft", m_step->listing);
        if (const JsonValue *branches = m_fields.find("branches"))
            readBranches(*branches);
        return m_experiment;
    }

private:
    void readFormat() const
    {
        const QString given = m_fields.text("format", quoted(format));
        if (given.startsWith("springstep-notebook/"))
            m_fields.refuse(
                "format",
                tr("this is a notebook, not an experiment; \"springstep notebook check\" replays it."));
        if (given != format)
            m_fields.refuse(
                "format", tr("\"format\" is %1; this program reads %2.").arg(quoted(given), quoted(format)));
    }

    void readStep()
    {
        m_fields.refuseOthers(QStringList{"format", "lesson", "step"} + runFields() +
                              QStringList{"draft", "name", "named", "kept", "branches"});
        m_experiment.lesson = m_fields.text("lesson", lessonIds(m_library));
        const LessonEntry *lesson = m_library.lesson(m_experiment.lesson);
        if (!lesson)
            m_fields.refuse("lesson", noLesson(m_experiment.lesson, m_library) + ' ' +
                                          tr("If it is a lesson without C++, open it in the window, or "
                                             "name its folder in SPRINGSTEP_LESSONS."));
        m_experiment.step = m_fields.text("step", stepIds(*lesson));
        m_step = lesson->step(m_experiment.step);
        if (!m_step)
            m_fields.refuse("step", noStep(m_experiment.step, *lesson));
        if (m_more.empty())
            return;
        m_stepWithMore = *m_step;
        m_stepWithMore.addParameters(m_more);
        m_step = &m_stepWithMore;
    }

    QString nameOf(const JsonValue &value) const
    {
        const QString name = textOf(m_file, value, "name").simplified();
        if (name.isEmpty() || name.size() > longestRunName)
            refuse(m_file, value.line,
                   tr("\"name\" has %1 letters; it can have 1 to %2.").arg(name.size()).arg(longestRunName));
        return name;
    }

    /// Reads the learner's name for the file's own run.
    void readOwnName()
    {
        const JsonValue *name = m_fields.find("name");
        const bool isNamed = m_fields.boolean("named", true);
        const bool isKept = m_fields.boolean("kept", true);
        if (!name)
            return;
        const QString given = nameOf(*name);
        m_experiment.branches.setOwn({given, isNamed ? given : QString(), isKept, 0});
    }

    void readBranches(const JsonValue &value)
    {
        const JsonValue::List &list = listOf(m_file, value, "branches");
        if (list.size() > mostKeptBranches)
            refuse(
                m_file, value.line,
                tr("\"branches\" has %1 runs; it can have up to %2.").arg(list.size()).arg(mostKeptBranches));
        for (const JsonValue &one : list) {
            m_experiment.branches.add(readBranch(one));
            if (m_events > mostBranchEvents)
                refuse(m_file, one.line,
                       tr("the runs in \"branches\" have more than %1 events together; remove some.")
                           .arg(mostBranchEvents));
        }
        m_experiment.branches.settle(m_experiment.script);
    }

    Branch readBranch(const JsonValue &value)
    {
        const JsonFields fields(m_file, value, tr("a branch"));
        const QString name = nameOf(fields.require("name", tr("a text that tells it from others")));
        const std::int64_t fork = fields.integer("fork", 0, mostFrames, 0);
        const QStringList about = {"name", "named", "kept", "fork"};
        fields.refuseOthers(about + (fork > 0 ? QStringList{"frames", "input"} : runFields()));
        const ReadRun run = fork > 0 ? readRunFrom(m_file, fields, *m_step, m_experiment.script, fork)
                                     : readRun(m_file, fields, *m_step);
        m_events += run.script.input.size();
        return {++m_branches,
                name,
                fields.boolean("named", true),
                fields.boolean("kept", true),
                run.frames,
                std::make_shared<const sim::Script>(run.script)};
    }

    QString m_file;
    JsonFields m_fields;
    const LessonLibrary &m_library;
    const std::vector<lessons::Parameter> &m_more;
    const lessons::Step *m_step = nullptr;
    lessons::Step m_stepWithMore; ///< if there are m_more
    Experiment m_experiment;
    int m_branches = 0;       ///< branches read so far
    std::size_t m_events = 0; ///< events in these branches
};

}

Experiment parseExperiment(const QByteArray &text, const QString &name, const LessonLibrary &library)
{
    return parseExperimentWith({}, text, name, library);
}

Experiment parseExperimentWith(const std::vector<lessons::Parameter> &more, const QByteArray &text,
                               const QString &name, const LessonLibrary &library)
{
    const JsonValue root = parseJson(text, name);
    return ExperimentReader(name, root, library, more).read();
}

}
