#include "lessons/api/text/formula_reader.h"

#include "lessons/api/step.h"
#include "lessons/api/text/document.h"
#include "lessons/api/view/named_place.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>

namespace lessons {

namespace {

struct FormulaText
{
    Q_DECLARE_TR_FUNCTIONS(Formula)
};

constexpr std::size_t shownNames = 6; ///< bodies that an error lists

/// Returns what `words`, between two commas, highlights.
std::optional<Highlight> highlightOf(const QString &words)
{
    static const QString name = QStringLiteral("([A-Za-z_][A-Za-z0-9_]*(?:\\.[A-Za-z0-9_]+)*)");
    static const QRegularExpression circle(QStringLiteral("^circle\\s+%1\\s+%1$").arg(name));
    static const QRegularExpression arrow(QStringLiteral("^%1\\s*->\\s*%1(?:\\s+(x|y))?$").arg(name));
    static const QRegularExpression velocity(QStringLiteral("^%1\\.velocity$").arg(name));
    static const QRegularExpression thing(QStringLiteral("^%1$").arg(name));
    if (const auto found = circle.match(words); found.hasMatch())
        return Highlight{Highlight::Kind::circle, found.captured(1), found.captured(2)};
    if (const auto found = arrow.match(words); found.hasMatch()) {
        const QString side = found.captured(3);
        const Highlight::Kind kind = side == u"x"   ? Highlight::Kind::xSide
                                     : side == u"y" ? Highlight::Kind::ySide
                                                    : Highlight::Kind::arrow;
        return Highlight{kind, found.captured(1), found.captured(2)};
    }
    if (const auto found = velocity.match(words); found.hasMatch())
        return Highlight{Highlight::Kind::velocity, found.captured(1), {}};
    if (thing.match(words).hasMatch())
        return Highlight{Highlight::Kind::thing, words, {}};
    return std::nullopt;
}

/// What the scene of a step has.
class KnownNames
{
public:
    explicit KnownNames(const Step &step)
        : m_step(step), m_values(step.defaultValues()), m_scene(step.scene(m_values))
    {
    }

    bool isBody(const QString &name) const { return m_scene.find(name.toStdString()) >= 0; }
    bool isPlace(const QString &name) const
    {
        // A pointer has no place before the first event.
        return name == u"pointer" ? m_step.accepts(Interaction::pointer)
                                  : placeNamed(name, m_scene, m_scene.start, m_values).has_value();
    }
    bool isParameter(const QString &name) const { return m_step.parameter(name); }

    /// Returns the name in `one` that the scene lacks. Empty if it has them all.
    QString missingIn(const Highlight &one) const
    {
        using Kind = Highlight::Kind;
        const bool isThing = one.kind == Kind::thing;
        if (one.kind == Kind::velocity ? !isBody(one.a) : !isPlace(one.a) && !(isThing && isParameter(one.a)))
            return one.a;
        if (isThing || one.kind == Kind::velocity)
            return {};
        return (one.kind == Kind::circle ? isParameter(one.b) : isPlace(one.b)) ? QString() : one.b;
    }

    QString bodies() const
    {
        QStringList names;
        for (std::size_t i = 0; i < std::min(shownNames, m_scene.names.size()); ++i)
            names << QString::fromStdString(m_scene.names[i]);
        if (m_scene.names.size() > shownNames)
            names << QStringLiteral("…");
        return names.join(QStringLiteral(", "));
    }

    QString parameters() const
    {
        QStringList ids;
        for (const Parameter &parameter : m_step.parameters)
            ids << parameter.id;
        return ids.join(QStringLiteral(", "));
    }

private:
    const Step &m_step;
    const sim::Values m_values;
    const sim::Scene m_scene;
};

}

std::vector<Formula> takeFormulas(QStringList &lines, int firstLine, const QString &file)
{
    static const QRegularExpression formula(QStringLiteral("^`([^`]+)`\\s*\\{([^{}`]*)\\}$"));
    static const QRegularExpression braces(QStringLiteral("\\{[^{}`]*\\}$"));
    std::vector<Formula> formulas;
    const auto isBlank = [&lines](qsizetype i) {
        return i < 0 || i >= lines.size() || lines[i].trimmed().isEmpty();
    };
    bool isCode = false;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const int number = firstLine + static_cast<int>(i);
        const QString line = lines[i].trimmed();
        if (line.startsWith(QStringLiteral("```")))
            isCode = !isCode;
        if (isCode || !line.endsWith('}') || !braces.match(line).hasMatch())
            continue;
        const auto match = formula.match(line);
        if (!match.hasMatch() || !isBlank(i - 1) || !isBlank(i + 1))
            throw DocumentError(
                file, number,
                FormulaText::tr("braces belong behind a formula, which is a paragraph of its own in "
                                "backticks. Write them there, or remove them."));
        Formula one{match.captured(1), {}, number};
        for (const QString &words : match.captured(2).split(',')) {
            const std::optional<Highlight> highlight = highlightOf(words.trimmed());
            if (!highlight)
                throw DocumentError(
                    file, number,
                    FormulaText::tr(
                        "“%1” is nothing that a formula can highlight. Write the name of a body or a "
                        "parameter, “a -> b”, “a -> b x”, “a -> b y”, “a.velocity”, or “circle a "
                        "parameter”, with commas between them.")
                        .arg(words.trimmed()));
            one.highlights.push_back(*highlight);
        }
        lines[i] = QStringLiteral("`%1`").arg(one.text);
        formulas.push_back(std::move(one));
    }
    return formulas;
}

void checkHighlights(const Document &document, const Step &step)
{
    std::optional<KnownNames> names; // made only if there is something to check
    for (const Why &why : document.explanation.whys) {
        for (const Formula &formula : why.formulas) {
            for (const Highlight &one : formula.highlights) {
                if (!names)
                    names.emplace(step);
                const QString missing = names->missingIn(one);
                if (!missing.isEmpty())
                    throw DocumentError(
                        document.file, formula.line,
                        FormulaText::tr(
                            "“%1” in the braces is not there in this step. It has the bodies %2, and the "
                            "parameters %3.")
                            .arg(missing, names->bodies(), names->parameters()));
            }
        }
    }
}

}
