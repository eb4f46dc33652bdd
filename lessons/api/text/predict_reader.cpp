#include "lessons/api/text/predict_reader.h"

#include "lessons/api/text/document.h"
#include "lessons/api/text/run_setup.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <utility>

namespace lessons {

namespace {

struct PredictText
{
    Q_DECLARE_TR_FUNCTIONS(Predict)
};

constexpr std::size_t wrongCurves = 2;
constexpr int leastTryChoices = 2;
constexpr int mostTryChoices = 4;

/// Interprets the fields of a prediction.
class PredictReader
{
public:
    PredictReader(const DocumentSection &section, const QString &id, const QString &file)
        : m_section(section), m_file(file)
    {
        m_prediction.id = id;
        m_prediction.line = section.part.line;
    }

    Prediction read()
    {
        m_prediction.text = joinedText(m_section.part.body);
        if (m_prediction.text.isEmpty())
            reject(m_section.part,
                   PredictText::tr("the question of the prediction “%1” is missing. Write it below "
                                   "the heading.")
                       .arg(m_prediction.id));
        for (const DocumentPart &field : m_section.fields)
            readField(field);
        check();
        for (RunSetup &other : m_prediction.otherCurves)
            other = withChanges(m_prediction.run, other);
        return std::move(m_prediction);
    }

private:
    [[noreturn]] void reject(const DocumentPart &part, const QString &why) const
    {
        throw DocumentError(m_file, part.line, why);
    }

    void readField(const DocumentPart &field)
    {
        if (field.heading == u"Other curve") {
            m_prediction.otherCurves.push_back(parseRunSetup(field, m_file));
            return;
        }
        checkOnce(field);
        if (field.heading == u"Run")
            m_prediction.run = parseRunSetup(field, m_file);
        else if (field.heading == u"Ask")
            m_prediction.question = question(field);
        else if (field.heading == u"Answer")
            m_prediction.answer = joinedText(field.body);
        else
            reject(field,
                   PredictText::tr("“### %1” does not belong here. Here you can write “### Run”, “### Ask”, "
                                   "“### Other curve”, “### Answer”.")
                       .arg(field.heading));
    }

    void checkOnce(const DocumentPart &field)
    {
        if (m_fields.contains(field.heading))
            reject(field, PredictText::tr("“### %1” is there twice. Remove one of them.").arg(field.heading));
        m_fields << field.heading;
    }

    Question question(const DocumentPart &field) const
    {
        Question result;
        for (const ListItem &item : parseList(field, m_file)) {
            if (item.name == u"unit" && !result.of.isEmpty())
                result.unit = item.value == u"none" ? QString() : item.value;
            else if (result.of.isEmpty())
                result = kindOf(item);
            else
                throw DocumentError(
                    m_file, item.line,
                    PredictText::tr(
                        "“%1” does not belong here. A prediction asks one question, and can have a "
                        "“- unit: px” after it.")
                        .arg(item.name));
        }
        return result;
    }

    Question kindOf(const ListItem &item) const
    {
        const QString px = QStringLiteral("px");
        if (item.name == u"place")
            return {Question::Kind::place, item.value, px};
        if (item.name == u"number")
            return {Question::Kind::number, item.value, item.value == u"frames" ? QString() : px};
        if (item.name == u"curve")
            return {Question::Kind::curve, item.value, px};
        throw DocumentError(
            m_file, item.line,
            PredictText::tr("“%1” cannot be asked. Write “- place: body”, “- number: frames”, "
                            "“- number: foot.x” or “- curve: foot.x”.")
                .arg(item.name));
    }

    void check() const
    {
        const std::pair<QString, bool> required[] = {
            {QStringLiteral("Run"), m_prediction.run.line > 0},
            {QStringLiteral("Ask"), !m_prediction.question.of.isEmpty()},
            {QStringLiteral("Answer"), !m_prediction.answer.isEmpty()},
        };
        for (const auto &[heading, isThere] : required) {
            if (!isThere)
                reject(m_section.part,
                       PredictText::tr(
                           "the prediction “%1” is incomplete. Write “### %2” and what belongs below it.")
                           .arg(m_prediction.id, heading));
        }
        if (m_prediction.run.frames == 0)
            throw DocumentError(
                m_file, m_prediction.run.line,
                PredictText::tr(
                    "this run has no end. Write “- frames: ” and the frame at which it ends at the "
                    "latest."));
        if (m_prediction.question.asksFrames() && m_prediction.run.until.isEmpty())
            throw DocumentError(
                m_file, m_prediction.run.line,
                PredictText::tr("the number of frames is given away by the run. Write “- until: ” "
                                "and the condition at which it ends."));
        checkCurves();
    }

    void checkCurves() const
    {
        const bool isCurve = m_prediction.question.kind == Question::Kind::curve;
        const std::size_t count = m_prediction.otherCurves.size();
        if (isCurve && count != wrongCurves)
            reject(
                m_section.part,
                PredictText::tr("the number of other curves of the prediction “%1” is %2, not 2. Write each "
                                "below an “### Other curve”.")
                    .arg(m_prediction.id)
                    .arg(count));
        if (!isCurve && count > 0)
            throw DocumentError(
                m_file, m_prediction.otherCurves.front().line,
                PredictText::tr(
                    "“### Other curve” does not belong here. Remove it, or ask for a “- curve: ”."));
    }

    const DocumentSection &m_section;
    QString m_file;
    Prediction m_prediction;
    QStringList m_fields;
};

}

Prediction parsePrediction(const DocumentSection &section, const QString &id, const QString &file)
{
    return PredictReader(section, id, file).read();
}

Choices parseChoices(const DocumentPart &field, const QString &file)
{
    static const QRegularExpression pattern(QStringLiteral("^- \\[([ x])\\] (\\S.*)$"));
    Choices choices;
    int right = 0;
    const QStringList lines = joinedText(field.body).split('\n', Qt::SkipEmptyParts);
    for (const QString &line : lines) {
        const auto match = pattern.match(line);
        if (!match.hasMatch())
            throw DocumentError(
                file, field.line,
                PredictText::tr("“%1” is not a choice. Write “- [ ] text”, or “- [x] text” if it is right.")
                    .arg(line));
        if (match.captured(1) == u"x") {
            choices.right = static_cast<int>(choices.texts.size());
            ++right;
        }
        choices.texts << match.captured(2);
    }
    if (choices.texts.size() < leastTryChoices || choices.texts.size() > mostTryChoices)
        throw DocumentError(
            file, field.line,
            PredictText::tr("the number of choices is %1. Write two to four.").arg(choices.texts.size()));
    if (right != 1)
        throw DocumentError(
            file, field.line,
            PredictText::tr("the number of right choices is %1, not 1. Write “- [x] ” before the right one.")
                .arg(right));
    return choices;
}

}
