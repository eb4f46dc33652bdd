// The words that the lessons explain, and their mentions in texts.

#include "app/model/text/glossary.h"
#include "tests/suite.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>

using namespace app;

namespace {

/// A library of one lesson whose steps teach `terms`, one a step.
LessonLibrary teaching(const std::vector<lessons::Term> &terms)
{
    LessonEntry lesson;
    lesson.id = "one";
    lesson.title = "Lesson one";
    for (const lessons::Term &term : terms) {
        lessons::Step step;
        step.id = "step" + QString::number(lesson.steps.size());
        step.title = "Step " + QString::number(lesson.steps.size());
        step.explanation.terms = {term};
        lesson.steps.push_back(step);
    }
    LessonLibrary library;
    library.lessons = {lesson};
    return library;
}

Glossary springsAndMethods()
{
    return Glossary(teaching({{"Spring", "spring|springs", "It pulls."},
                              {"Semi-implicit Euler", "semi-implicit Euler", "A method."},
                              {"Euler", "Euler", "A man who was no spring."},
                              {"Listed only", {}, "It stands in no text."}}));
}

/// Words as a reader sees them, without the marks of Markdown.
QString readable(QString markdown)
{
    return markdown.remove(QRegularExpression("[*`]"));
}

}

class GlossaryTest : public QObject
{
    Q_OBJECT

    const LessonLibrary m_library = LessonLibrary::load({LESSON_DIR});
    const Glossary m_glossary{m_library};

private slots:
    void mentionsAreTheFirstWholeWords_data();
    void mentionsAreTheFirstWholeWords();
    void theSearchFindsNamesBeforeMeanings_data();
    void theSearchFindsNamesBeforeMeanings();
    void firstOfTwoEqualWordsIsUsed();
    void everyWordIsExplainedShortly();
    void everyWordOccursInTheTextThatTeachesIt();
    void theRadiusOfADiscIsNoRestLength();
    void lessonsExplainTheEssentialWords_data();
    void lessonsExplainTheEssentialWords();
};

void GlossaryTest::mentionsAreTheFirstWholeWords_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QStringList>("found");
    QTest::newRow("once, though it stands there twice") << "A spring and a spring." << QStringList{"spring"};
    QTest::newRow("another form") << "Two springs pull." << QStringList{"springs"};
    QTest::newRow("the form that stands first") << "One spring, two springs." << QStringList{"spring"};
    QTest::newRow("with a capital letter") << "Springs pull." << QStringList{"Springs"};
    QTest::newRow("not within a word") << "Springstep has offspring." << QStringList{};
    QTest::newRow("the longer of two") << "Semi-implicit Euler moves." << QStringList{"Semi-implicit Euler"};
    QTest::newRow("the shorter one elsewhere")
        << "Semi-implicit Euler is by Euler." << QStringList{"Semi-implicit Euler", "Euler"};
    QTest::newRow("next to signs") << "(spring)" << QStringList{"spring"};
    QTest::newRow("nothing in nothing") << QString() << QStringList{};
    QTest::newRow("what is only listed") << "It is Listed only." << QStringList{};
}

void GlossaryTest::mentionsAreTheFirstWholeWords()
{
    QFETCH(QString, text);
    const Glossary glossary = springsAndMethods();
    QStringList found;
    for (const Mention &mention : glossary.mentionsIn(text))
        found << text.mid(mention.start, mention.length);
    QTEST(found, "found");
}

void GlossaryTest::theSearchFindsNamesBeforeMeanings_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QStringList>("found");
    QTest::newRow("all, by name") << QString()
                                  << QStringList{"Euler", "Listed only", "Semi-implicit Euler", "Spring"};
    QTest::newRow("part of a name") << "EULER" << QStringList{"Euler", "Semi-implicit Euler"};
    QTest::newRow("a form") << " springs " << QStringList{"Spring"};
    QTest::newRow("a meaning") << "method" << QStringList{"Semi-implicit Euler"};
    QTest::newRow("a name before a meaning") << "spring" << QStringList{"Spring", "Euler"};
    QTest::newRow("nothing") << "xyz" << QStringList{};
}

void GlossaryTest::theSearchFindsNamesBeforeMeanings()
{
    QFETCH(QString, typed);
    QFETCH(QStringList, found);
    const Glossary glossary = springsAndMethods();
    QStringList names;
    for (const GlossaryEntry *one : glossary.matching(typed))
        names << one->term.name;
    QCOMPARE(names, found);
}

void GlossaryTest::firstOfTwoEqualWordsIsUsed()
{
    const Glossary glossary(teaching({{"Spring", "spring", "First."}, {"spring", "coil", "Second."}}));
    QCOMPARE(glossary.entries().size(), 1u);
    QCOMPARE(glossary.find("SPRING")->term.text, QString("First."));
    QCOMPARE(glossary.find("SPRING")->where, QString("Lesson one: Step 0"));
    QVERIFY(!glossary.find("coil"));
}

void GlossaryTest::everyWordIsExplainedShortly()
{
    QVERIFY(m_glossary.entries().size() >= 50);
    for (const GlossaryEntry &one : m_glossary.entries()) {
        const qsizetype sentences = one.term.text.count(QRegularExpression("[.?](\\s|$)"));
        QVERIFY2(sentences >= 1 && sentences <= 3, qPrintable(one.term.name));
        QVERIFY2(one.term.text.size() <= 260, qPrintable(one.term.name));
        QVERIFY2(!one.term.text.contains('!'), qPrintable(one.term.name));
    }
}

void GlossaryTest::everyWordOccursInTheTextThatTeachesIt()
{
    for (const GlossaryEntry &one : m_glossary.entries()) {
        if (one.term.forms.isEmpty())
            continue;
        const lessons::Step *step = m_library.lesson(one.lesson)->step(one.step);
        QString text = step->narration;
        for (const lessons::Try &what : step->tries)
            text += "\n" + what.text;
        for (const lessons::Parameter &parameter : step->parameters)
            text += "\n" + parameter.name + "\n" + parameter.help;
        QStringList names;
        for (const Mention &mention : m_glossary.mentionsIn(readable(text)))
            names << m_glossary.entries()[mention.entry].term.name;
        QVERIFY2(names.contains(one.term.name), qPrintable(one.term.name + " in " + one.where));
    }
}

void GlossaryTest::theRadiusOfADiscIsNoRestLength()
{
    QStringList names;
    for (const Mention &mention : m_glossary.mentionsIn("right - me.radius"))
        names << m_glossary.entries()[mention.entry].term.name;
    QCOMPARE(names, QStringList{"Radius of a disc"});
}

void GlossaryTest::lessonsExplainTheEssentialWords_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"Spring", "Stiffness", "Damping", "Rest length", "Step", "Phase", "Frame",
                             "Semi-implicit Euler", "Gait", "Constraint", "Energy drift", "Momentum", "Ghost",
                             "Velocity", "Order", "Stability limit", "Coincident points"})
        QTest::newRow(name) << name;
}

void GlossaryTest::lessonsExplainTheEssentialWords()
{
    QFETCH(QString, name);
    QVERIFY(m_glossary.find(name));
}

SUITE(tst_glossary, GlossaryTest)
#include "tst_glossary.moc"
