#include "lessons/api/text/project.h"

#include "lessons/api/text/document.h"
#include "lessons/api/text/document_source.h"
#include "lessons/api/text/run_setup.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>

namespace lessons {

namespace {

struct ProjectText
{
    Q_DECLARE_TR_FUNCTIONS(Project)
};

/// Interprets the sections of a project. Errors name the file.
class ProjectReader
{
public:
    ProjectReader(const ScannedDocument &scanned, const QString &file) : m_scanned(scanned)
    {
        m_project.file = file;
    }

    Project read()
    {
        m_project.title = m_scanned.title.heading;
        m_project.brief = joinedText(m_scanned.title.body);
        if (m_project.brief.isEmpty())
            reject(m_scanned.title.line, ProjectText::tr("the brief is missing. Write it below the title."));
        for (const DocumentSection &section : m_scanned.sections)
            readLevel(section);
        if (m_project.levels.size() != Project::levelCount)
            reject(m_scanned.title.line,
                   ProjectText::tr(
                       "the number of levels is %1, not 3. Write each below a “## Level: title {#id}”.")
                       .arg(m_project.levels.size()));
        return std::move(m_project);
    }

private:
    [[noreturn]] void reject(int line, const QString &why) const
    {
        throw DocumentError(m_project.file, line, why);
    }

    void readLevel(const DocumentSection &section)
    {
        static const QRegularExpression pattern(QStringLiteral("^Level: (\\S.*?)\\s*\\{#([a-z0-9_]+)\\}$"));
        const int line = section.part.line;
        const auto match = pattern.match(section.part.heading);
        if (!match.hasMatch())
            reject(line,
                   ProjectText::tr("“## %1” is not a heading of a project. Write “## Level: title {#id}”.")
                       .arg(section.part.heading));
        ProjectLevel level{.id = match.captured(2),
                           .title = match.captured(1),
                           .text = joinedText(section.part.body),
                           .line = line};
        if (std::any_of(m_project.levels.begin(), m_project.levels.end(),
                        [&](const ProjectLevel &one) { return one.id == level.id; }))
            reject(line, ProjectText::tr("the id “%1” was used above. Choose another one.").arg(level.id));
        QStringList known;
        for (const DocumentPart &field : section.fields) {
            if (known.contains(field.heading))
                reject(field.line,
                       ProjectText::tr("“### %1” is there twice. Remove one of them.").arg(field.heading));
            known << field.heading;
            readField(level, field);
        }
        check(level);
        m_project.levels.push_back(std::move(level));
    }

    void readField(ProjectLevel &level, const DocumentPart &field) const
    {
        if (field.heading == u"Run")
            level.run = parseRunSetup(field, m_project.file);
        else if (field.heading == u"Holds")
            readDemands(level, field);
        else if (field.heading == u"Show")
            readRings(level, field);
        else if (field.heading == u"Hint")
            level.hint = joinedText(field.body);
        else
            reject(field.line, ProjectText::tr("“### %1” does not belong here. Here you can write “### Run”, "
                                               "“### Holds”, “### Show”, “### Hint”.")
                                   .arg(field.heading));
    }

    void readRings(ProjectLevel &level, const DocumentPart &field) const
    {
        for (const ListItem &item : parseList(field, m_project.file)) {
            const std::vector<double> numbers = numbersIn(item.value);
            if (item.name != u"ring" || numbers.size() != 3 || !(numbers[2] > 0.0))
                reject(
                    item.line,
                    ProjectText::tr(
                        "“%1: %2” is not a ring. Write its place and radius in px: “- ring: 300, 220, 12”.")
                        .arg(item.name, item.value));
            level.rings.push_back({{numbers[0], numbers[1]}, numbers[2]});
        }
    }

    void readDemands(ProjectLevel &level, const DocumentPart &field) const
    {
        for (const ListItem &item : parseList(field, m_project.file)) {
            if (item.name == u"unchanged")
                level.unchanged = namesIn(item);
            else if (item.name == u"effects")
                level.effects = namesIn(item);
            else
                level.demands.push_back(demand(item));
        }
    }

    QStringList namesIn(const ListItem &item) const
    {
        static const QRegularExpression pattern(QStringLiteral("^[A-Za-z0-9_]+$"));
        QStringList names;
        for (const QString &part : item.value.split(',')) {
            names << part.trimmed();
            if (!pattern.match(names.back()).hasMatch())
                reject(item.line, ProjectText::tr("“%1” is not a list of names. Write “- %2: one, other”.")
                                      .arg(item.value, item.name));
        }
        return names;
    }

    ProjectDemand demand(const ListItem &item) const
    {
        using When = ProjectDemand::When;
        static const QRegularExpression pattern(
            QStringLiteral("^(at the start|always|once|at the end) `([^`]+)`$"));
        const auto match = pattern.match(item.name);
        if (!match.hasMatch())
            reject(item.line,
                   ProjectText::tr(
                       "“%1” is not a condition. Write “- always `condition`: sentence”, or “once”, “at "
                       "the start” or “at the end” in place of “always”.")
                       .arg(item.name));
        const QString when = match.captured(1);
        return {when == u"always"         ? When::always
                : when == u"once"         ? When::once
                : when == u"at the start" ? When::atTheStart
                                          : When::atTheEnd,
                match.captured(2), item.value, item.line};
    }

    void check(const ProjectLevel &level) const
    {
        const std::pair<QString, bool> required[] = {
            {QStringLiteral("Run"), level.run.line > 0},
            {QStringLiteral("Holds"), !level.demands.empty()},
            {QStringLiteral("Hint"), !level.hint.isEmpty()},
        };
        if (level.text.isEmpty())
            reject(level.line,
                   ProjectText::tr("the level “%1” does not say what it asks. Write it below the heading.")
                       .arg(level.id));
        for (const auto &[heading, isThere] : required) {
            if (!isThere)
                reject(
                    level.line,
                    ProjectText::tr("the level “%1” is incomplete. Write “### %2” and what belongs below it.")
                        .arg(level.id, heading));
        }
        if (level.run.frames == 0)
            reject(level.run.line,
                   ProjectText::tr(
                       "this run has no end. Write “- frames: ” and the number of frames to judge."));
        if (!level.run.until.isEmpty() || !level.run.step.isEmpty())
            reject(level.run.line,
                   ProjectText::tr("the run of a level has no “until” and no “step”. Remove them."));
    }

    const ScannedDocument &m_scanned;
    Project m_project;
};

}

Project parseProject(const QByteArray &source, const QString &file)
{
    const ScannedDocument scanned = scanDocument(source, file);
    return ProjectReader(scanned, file).read();
}

std::optional<Project> readProject(const QString &lesson)
{
    const std::optional<DocumentSource> source = documentSource(lesson, QStringLiteral("project"));
    if (!source)
        return {};
    return parseProject(source->text, source->file);
}

QString projectStartFile(const QString &lesson)
{
    return QStringLiteral(":/documents/%1/project.json").arg(lesson);
}

}
