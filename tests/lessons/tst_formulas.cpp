// Formulas with braces: the subjects that they highlight, and mistakes in them.

#include "lessons/api/creature.h"
#include "lessons/api/parameters.h"
#include "lessons/api/step.h"
#include "lessons/api/text/formula_reader.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QRegularExpression>
#include <QTest>

using namespace support;
using lessons::Highlight;
using HighlightKind = lessons::Highlight::Kind;

namespace {

const QString formulaFile = QStringLiteral("one/step.md");

QByteArray documentWith(const QByteArray &answer)
{
    return "# A foot\n\nIt swings.\n\n## Why: Why?\n\n" + answer + "\n";
}

/// Returns a step with the bodies foot and body, a spring to a fixed place, and the parameters k, damp and radius.
lessons::Step springStep()
{
    lessons::Step step;
    step.parameters = {lessons::stiffness(), lessons::damping(), lessons::radius()};
    step.scene = [](const sim::Values &values) {
        sim::Scene scene = scenes::pair();
        scenes::add<sim::PointSpring>(scene, 0, sim::Vec2{270, 200}, values["k"]);
        return scene;
    };
    return step;
}

/// Returns what() of the mistake in a document with this answer. Empty if it has none.
QString mistakeInAnswer(const QByteArray &answer)
{
    try {
        springStep().setTexts(lessons::parseDocument(documentWith(answer), formulaFile));
    } catch (const lessons::DocumentError &error) {
        return QString::fromStdString(error.what());
    }
    return {};
}

/// Returns how many formulas an answer has.
qsizetype formulasIn(const lessons::Why &why)
{
    qsizetype count = 0;
    for (const QString &part : why.answer.split(QStringLiteral("\n\n")))
        count += part.startsWith('`') && part.endsWith('`') && part.count('`') == 2;
    return count;
}

}

class FormulasTest : public QObject
{
    Q_OBJECT

private slots:
    void wordsInBracesAreRead_data();
    void wordsInBracesAreRead();
    void theAnswerHasNoBraces();
    void severalWordsAreSeparatedByCommas();
    void aMistakeInBracesIsNamedWithItsRemedy_data();
    void aMistakeInBracesIsNamedWithItsRemedy();
    void highlightedSubjectsExistInEveryStep_data() { addStepRows(); }
    void highlightedSubjectsExistInEveryStep();
    void allLanguagesHighlightTheSame_data() { addStepRows(); }
    void allLanguagesHighlightTheSame();
    void eachLessonHasTwoDerivationsAndChecksOne();
};

void FormulasTest::wordsInBracesAreRead_data()
{
    QTest::addColumn<QByteArray>("words");
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("a");
    QTest::addColumn<QString>("b");
    const auto row = [](const char *words, HighlightKind kind, const char *a, const char *b = "") {
        QTest::newRow(words) << QByteArray(words) << int(kind) << QString(a) << QString(b);
    };
    row("foot", HighlightKind::thing, "foot");
    row("k", HighlightKind::thing, "k");
    row("centre", HighlightKind::thing, "centre");
    row("body -> foot", HighlightKind::arrow, "body", "foot");
    row("body->foot", HighlightKind::arrow, "body", "foot");
    row("centre -> foot", HighlightKind::arrow, "centre", "foot");
    row("body -> foot x", HighlightKind::xSide, "body", "foot");
    row("body -> foot y", HighlightKind::ySide, "body", "foot");
    row("foot.velocity", HighlightKind::velocity, "foot");
    row("circle body radius", HighlightKind::circle, "body", "radius");
}

void FormulasTest::wordsInBracesAreRead()
{
    QFETCH(QByteArray, words);
    QFETCH(int, kind);
    QFETCH(QString, a);
    QFETCH(QString, b);
    const QByteArray answer = "So\n\n`k * x` {" + words + "}";
    QCOMPARE(mistakeInAnswer(answer), QString());
    const lessons::Document document = lessons::parseDocument(documentWith(answer), formulaFile);
    const std::vector<lessons::Formula> &formulas = document.explanation.whys[0].formulas;
    QCOMPARE(formulas.size(), 1u);
    QCOMPARE(formulas[0].text, QString("k * x"));
    QCOMPARE(formulas[0].line, 9);
    QCOMPARE(formulas[0].highlights.size(), 1u);
    QVERIFY(formulas[0].highlights[0] == (Highlight{HighlightKind(kind), a, b}));
}

void FormulasTest::theAnswerHasNoBraces()
{
    const auto document = lessons::parseDocument(
        documentWith("So\n\n`k * x` {k}\n\nand\n\n`{ 1 }`\n\nThat is all."), formulaFile);
    const lessons::Why &why = document.explanation.whys[0];
    QCOMPARE(why.answer, QString("So\n\n`k * x`\n\nand\n\n`{ 1 }`\n\nThat is all."));
    QCOMPARE(why.formulas.size(), 1u);
}

void FormulasTest::severalWordsAreSeparatedByCommas()
{
    const auto document = lessons::parseDocument(
        documentWith("`a creature's`{creature0.body.velocity,  k , c.a -> c.b}"), formulaFile);
    const std::vector<Highlight> expected = {{HighlightKind::velocity, "creature0.body", {}},
                                             {HighlightKind::thing, "k", {}},
                                             {HighlightKind::arrow, "c.a", "c.b"}};
    QVERIFY(document.explanation.whys[0].formulas[0].highlights == expected);
}

void FormulasTest::aMistakeInBracesIsNamedWithItsRemedy_data()
{
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *name, const char *answer, int line, const char *says) {
        QTest::newRow(name) << QByteArray(answer) << line << QString::fromUtf8(says);
    };
    row("empty", "So\n\n`k * x` {}", 9,
        "“” is nothing that a formula can highlight. Write the name of a body");
    row("two words", "`k * x` {the foot}", 7, "“the foot” is nothing that a formula can highlight.");
    row("an arrow to nowhere", "`k * x` {foot ->}", 7, "“foot ->” is nothing that");
    row("another side", "`k * x` {body -> foot z}", 7, "“body -> foot z” is nothing that");
    row("no comma", "`k * x` {foot k}", 7, "with commas between them.");
    row("behind a sentence", "So it is {k}\n\n`k * x`", 7, "braces belong behind a formula");
    row("behind a sentence with code", "It is `k * x` {k}", 7, "braces belong behind a formula");
    row("within a paragraph", "So it is\n`k * x` {k}", 8, "Write them there, or remove them.");
    row("an unknown body", "So\n\n`k * x` {k, foot -> head}", 9,
        "“head” in the braces is not there in this step. It has the bodies foot, body, and the parameters k, "
        "damp, "
        "radius.");
    row("an unknown thing", "`k * x` {q}", 7, "“q” in the braces is not there in this step.");
    row("the velocity of a place", "`k * x` {centre.velocity}", 7, "“centre” in the braces is not there");
    row("a circle with a body as its radius", "`k * x` {circle body foot}", 7,
        "“foot” in the braces is not there");
    row("a place without input", "`k * x` {pointer -> foot}", 7, "“pointer” in the braces is not there");
}

void FormulasTest::aMistakeInBracesIsNamedWithItsRemedy()
{
    QFETCH(QByteArray, answer);
    QFETCH(int, line);
    QFETCH(QString, says);
    const QString mistake = mistakeInAnswer(answer);
    QVERIFY2(mistake.startsWith(QStringLiteral("one/step.md, line %1: ").arg(line)), qPrintable(mistake));
    QVERIFY2(mistake.contains(says), qPrintable(mistake));
    QVERIFY2(mistake.endsWith('.'), qPrintable(mistake));
}

namespace {

/// Returns the documents of a step in all languages, English first.
std::vector<lessons::Document> documentsOf(const lessons::Step &step)
{
    std::vector<lessons::Document> documents;
    for (const char *ending : {".md", ".de.md"}) {
        QFile file(QStringLiteral(":/documents/%1/%2%3").arg(step.lesson, step.id, QLatin1String(ending)));
        if (file.open(QIODevice::ReadOnly))
            documents.push_back(lessons::parseDocument(file.readAll(), step.lesson + '/' + step.id + ending));
    }
    return documents;
}

}

void FormulasTest::highlightedSubjectsExistInEveryStep()
{
    const lessons::Step step = stepOfRow();
    for (const lessons::Document &document : documentsOf(step)) {
        try {
            lessons::checkHighlights(document, step);
        } catch (const lessons::DocumentError &error) {
            QFAIL(error.what());
        }
    }
}

void FormulasTest::allLanguagesHighlightTheSame()
{
    const std::vector<lessons::Document> documents = documentsOf(stepOfRow());
    QCOMPARE(documents.size(), 2u);
    const std::vector<lessons::Why> &english = documents[0].explanation.whys,
                                    &german = documents[1].explanation.whys;
    QCOMPARE(german.size(), english.size());
    for (std::size_t i = 0; i < english.size(); ++i) {
        QCOMPARE(german[i].formulas.size(), english[i].formulas.size());
        for (std::size_t k = 0; k < english[i].formulas.size(); ++k)
            QVERIFY2(german[i].formulas[k].highlights == english[i].formulas[k].highlights,
                     qPrintable(english[i].formulas[k].text));
    }
}

void FormulasTest::eachLessonHasTwoDerivationsAndChecksOne()
{
    for (const QString &id : lessonIds()) {
        const LoadedLesson lesson = loadLesson(id);
        int derivations = 0, checked = 0;
        for (const lessons::Step &step : lesson.steps) {
            if (step.points == lessons::PointSource::scene)
                continue; // the sandbox has no lesson text
            for (const lessons::Why &why : step.explanation.whys) {
                const qsizetype formulas = formulasIn(why);
                if (formulas < 2 || formulas > 8 || why.formulas.size() < 2)
                    continue;
                ++derivations;
                checked += why.answer.contains("Check it") ? 1 : 0;
            }
        }
        const bool isSandbox = id == "sandbox";
        QVERIFY2(isSandbox || (derivations >= 2 && checked >= 1), qPrintable(id));
    }
}

SUITE(tst_formulas, FormulasTest)
#include "tst_formulas.moc"
