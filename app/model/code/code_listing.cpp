#include "app/model/code/code_listing.h"

#include "app/model/catalog/lists.h"
#include "app/model/code/code_lines.h"
#include "app/model/text/sentences.h"
#include "sim/base/error.h"
#include "sim/pipeline/method.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>

namespace app {

namespace {

struct CodeListingText
{
    Q_DECLARE_TR_FUNCTIONS(CodeListingText)
};

void append(std::vector<CodeLine> &lines, SourceFiles &book, const sim::Region &region)
{
    const auto text = book.text(region);
    if (!text)
        return;
    for (const SourceLine &line : *text)
        lines.push_back({line, QString::fromStdString(region.file)});
}

/// Returns whether a whole statement computes, decides or calls something. Signatures, braces and returns of named
/// values do not.
bool saysSomething(const QString &statement)
{
    static const QRegularExpression decides(QStringLiteral("^\\W*(else|if|for|while|switch)\\b|= \\["));
    static const QRegularExpression plainReturn(QStringLiteral("^return( \\w+| ?\\{[\\w, ]*\\})?;$"));
    return decides.match(statement).hasMatch() ||
           (statement.endsWith(';') && !plainReturn.match(statement).hasMatch());
}

/// Marks the lines from `first` on that a learner need not read.
void markQuiet(std::vector<CodeLine> &lines, std::size_t first, bool isPlumbing)
{
    QString statement;
    for (std::size_t i = first, begin = first; i < lines.size(); ++i) {
        const QString code = lines[i].code();
        statement = (statement + ' ' + code).simplified();
        if (!code.endsWith(';') && !code.endsWith('{') && !code.endsWith('}') && i + 1 < lines.size())
            continue;
        for (; begin <= i; ++begin) {
            lines[begin].isPlumbing = isPlumbing;
            lines[begin].isQuiet =
                isPlumbing || (!lines[begin].code().isEmpty() && !saysSomething(statement));
        }
        statement.clear();
    }
}

/// Returns whether `region` shows what the phase's effect does, rather than how the method sums it up.
bool isOfEffect(const sim::Phase &phase, const sim::Region &region)
{
    if (!phase.effect)
        return true;
    for (const sim::DirectionRule way : {sim::DirectionRule::published, sim::DirectionRule::regularised}) {
        const std::vector<sim::Region> own = phase.effect->regions(way);
        if (contains(own, region))
            return true;
    }
    return false;
}

void appendPhase(std::vector<CodeLine> &lines, SourceFiles &book, const sim::Phase &phase)
{
    for (const sim::Region &region : phase.regions) {
        const std::size_t first = lines.size();
        append(lines, book, region);
        markQuiet(lines, first, !isOfEffect(phase, region));
    }
}

bool groupsDiffer(const sim::Pipeline &pipeline, const std::vector<int> &phases, const sim::Phase &phase)
{
    return std::none_of(phases.begin(), phases.end(), [&](int other) {
        return pipeline.phases[static_cast<std::size_t>(other)].group == phase.group;
    });
}

/// Returns the section of an earlier phase that does the same work on another group.
CodeSection *sharedBy(CodeListing &listing, const sim::Pipeline &pipeline, const sim::Phase &phase)
{
    for (CodeSection &section : listing.sections) {
        if (section.role != CodeSection::Role::phase)
            continue;
        const sim::Phase &first = pipeline.phases[static_cast<std::size_t>(section.phases.front())];
        if (first.id == phase.id && first.regions == phase.regions &&
            groupsDiffer(pipeline, section.phases, phase))
            return &section;
    }
    return nullptr;
}

void appendPhases(CodeListing &listing, SourceFiles &book, const sim::Pipeline &pipeline)
{
    int number = 0;
    for (int i = 0; i < pipeline.phasesPerStep(); ++i) {
        const sim::Phase &phase = pipeline.phases[static_cast<std::size_t>(i)];
        if (CodeSection *shared = sharedBy(listing, pipeline, phase)) {
            shared->phases.push_back(i);
            continue;
        }
        CodeSection section;
        section.title = QStringLiteral("%1 %2").arg(++number).arg(capitalised(phrase(phase.title)));
        section.kind = phase.kind;
        section.phases = {i};
        appendPhase(section.lines, book, phase);
        listing.sections.push_back(std::move(section));
    }
}

}

QString comparable(const CodeLine &line)
{
    static const QRegularExpression nothing(QStringLiteral("^[{};\\s)]*$"));
    const QString text = line.source.text.simplified();
    return nothing.match(text).hasMatch() ? QString() : text;
}

QHash<QString, int> countsOf(const CodeListing &listing)
{
    QHash<QString, int> counts;
    QSet<CodeLinePlace> counted;
    for (const CodeSection &section : listing.sections) {
        for (const CodeLine &line : section.lines) {
            if (counted.contains(placeOf(line)))
                continue;
            counted.insert(placeOf(line));
            ++counts[comparable(line)];
        }
    }
    return counts;
}

QString CodeLine::code() const
{
    const qsizetype comment = source.text.indexOf(QLatin1String("//"));
    return (comment < 0 ? source.text : source.text.left(comment)).trimmed();
}

QStringList CodeSection::files() const
{
    QStringList files;
    for (const CodeLine &line : lines) {
        if (!files.contains(line.file))
            files.append(line.file);
    }
    return files;
}

bool CodeSection::has(int phase) const
{
    return contains(phases, phase);
}

int CodeListing::newLines() const
{
    QSet<CodeLinePlace> places;
    for (const CodeSection &section : sections) {
        for (const CodeLine &line : section.lines) {
            if (line.isNew)
                places.insert(placeOf(line));
        }
    }
    return static_cast<int>(places.size());
}

int CodeListing::goneLines() const
{
    std::size_t count = 0;
    for (const CodeSection &section : sections)
        count += section.gone.size();
    return static_cast<int>(count);
}

CodeListing listingOf(const lessons::Step &step, const sim::ComposedInterval &interval,
                      const sim::Method &method)
{
    SourceFiles book;
    CodeListing listing;
    CodeSection scene{
        CodeSection::Role::scene, CodeListingText::tr("Scene"), sim::EffectKind::motion, {}, {}};
    append(scene.lines, book, step.sceneSource);
    listing.sections.push_back(std::move(scene));
    CodeSection order{CodeSection::Role::order,
                      CodeListingText::tr("%1: order of the phases").arg(phrase(method.title())),
                      sim::EffectKind::motion,
                      {},
                      {}};
    append(order.lines, book, method.region());
    listing.sections.push_back(std::move(order));
    appendPhases(listing, book, interval.pipeline);
    return listing;
}

std::optional<CodeListing> listingAtStart(const lessons::Step &step, const sim::MethodPtr &method)
{
    sim::Script script = step.script();
    for (const sim::MethodPtr &tried : {method, script.method}) {
        try {
            script.method = tried;
            sim::ComposedInterval interval{script.values, sceneOf(script, script.values), {}};
            interval.pipeline = sim::compose(interval.scene, *tried, script.step);
            return listingOf(step, interval, *tried);
        } catch (const sim::Error &) {
            continue; // then try the other method
        }
    }
    return std::nullopt;
}

void markNew(CodeListing &listing, const CodeListing &before)
{
    QHash<QString, int> had = countsOf(before);
    QHash<CodeLinePlace, bool> known;
    for (CodeSection &section : listing.sections) {
        for (CodeLine &line : section.lines) {
            const QString text = comparable(line);
            if (!known.contains(placeOf(line)))
                known[placeOf(line)] = !text.isEmpty() && --had[text] < 0;
            line.isNew = known[placeOf(line)];
        }
    }
}

QString fileName(const QString &file)
{
    return file.section('/', -1);
}

}
