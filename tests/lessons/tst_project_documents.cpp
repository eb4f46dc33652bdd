// The documents of projects: their format, mistakes in them, and equal levels in all languages.

#include "lessons/api/text/document.h"
#include "lessons/api/text/project.h"
#include "tests/lessons/support/mistakes.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

using namespace support;

namespace {

const QByteArray goodProject = R"(# A bridge

Build it.

## Level: First {#first}

It carries.

### Run

- frames: 60
- gravity: 3
- drag stone: 350, 200, 20

### Holds

- unchanged: stone, k
- effects: gravity, walls
- at the start `bodies >= 3`: there are three bodies
- always `stone.y < 240`: the stone stays up
- once `fastest > 1`: it moves
- at the end `fastest < 0.1`: it rests

### Hint

Use sticks.

## Level: Second {#second}

Again.

### Run

- frames: 10

### Holds

- always `stone.y < 240`: the stone stays up

### Hint

No.

## Level: Third {#third}

Once more.

### Run

- frames: 10

### Holds

- always `stone.y < 240`: the stone stays up

### Hint

Yes.
)";

const QString projectName = QStringLiteral("one/project.md");

QString mistakeInProject(const QByteArray &source)
{
    return mistakeOf([&] { lessons::parseProject(source, projectName); });
}

const Mistake projectMistakes[] = {
    {"no brief", "Build it.\n", "", "# A bridge", "the brief is missing. Write it below the title."},
    {"two levels",
     "## Level: Third {#third}\n\nOnce more.\n\n### Run\n\n- frames: 10\n\n### Holds\n\n- always `stone.y < "
     "240`: the stone stays up\n\n### Hint\n\nYes.\n",
     "", "# A bridge", "the number of levels is 2, not 3."},
    {"an unknown heading", "## Level: First", "## Step: First", "## Step",
     "“## Step: First {#first}” is not a heading of a project."},
    {"no id", "First {#first}", "First", "## Level", "Write “## Level: title {#id}”."},
    {"an id twice", "{#second}", "{#first}", "## Level: Second", "the id “first” was used above."},
    {"no text", "It carries.\n", "", "## Level: First", "the level “first” does not say what it asks."},
    {"no run", "### Run\n\n- frames: 60\n- gravity: 3\n- drag stone: 350, 200, 20\n", "", "## Level: First",
     "the level “first” is incomplete. Write “### Run”"},
    {"no end", "- frames: 60\n", "", "### Run", "this run has no end. Write “- frames: ”"},
    {"an until", "- frames: 60\n", "- frames: 60\n- until: frame > 3\n", "### Run",
     "the run of a level has no “until” and no “step”."},
    {"no conditions",
     "- at the start `bodies >= 3`: there are three bodies\n- always `stone.y < 240`: the stone stays up\n- "
     "once `fastest "
     "> 1`: it moves\n- at the end `fastest < 0.1`: it rests\n",
     "", "## Level: First", "Write “### Holds”"},
    {"no hint", "### Hint\n\nUse sticks.\n", "", "## Level: First", "Write “### Hint”"},
    {"an unknown field", "### Hint\n\nUse", "### Help\n\nUse", "### Help",
     "“### Help” does not belong here."},
    {"a field twice", "### Hint\n\nUse", "### Run\n\n- frames: 3\n\n### Hint\n\nUse",
     "### Run\n\n- frames: 3", "“### Run” is there twice."},
    {"a time that is none", "- once `fastest", "- often `fastest", "- often",
     "“often `fastest > 1`” is not a condition. Write “- always `condition`: sentence”"},
    {"a condition without signs", "`bodies >= 3`", "bodies >= 3", "- at the start", "is not a condition."},
    {"a ring without a radius", "### Hint\n\nUse", "### Show\n\n- ring: 400, 150\n\n### Hint\n\nUse",
     "- ring", "“ring: 400, 150” is not a ring. Write its place and radius in px"},
    {"names that are none", "unchanged: stone, k", "unchanged: stone, k h", "- unchanged",
     "is not a list of names."},
};

/// Returns the project of a lesson in a language; "en" has no code in its name.
lessons::Project projectIn(const QString &lesson, const QString &language)
{
    const QString name = language == u"en" ? QStringLiteral("project") : "project." + language;
    QFile file(QStringLiteral(":/documents/%1/%2.md").arg(lesson, name));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return lessons::parseProject(file.readAll(), file.fileName());
}

int wordsInProject(QString text)
{
    return static_cast<int>(
        text.remove(QRegularExpression("[`*]")).split(QRegularExpression("\\s+"), Qt::SkipEmptyParts).size());
}

QStringList codeInProject(const QString &text)
{
    QStringList codes;
    static const QRegularExpression pattern("`[^`]+`");
    for (auto found = pattern.globalMatch(text); found.hasNext();)
        codes << found.next().captured();
    return codes;
}

}

class ProjectDocumentsTest : public QObject
{
    Q_OBJECT

private slots:
    void everyFieldIsRead();
    void eachMistakeIsNamed_data();
    void eachMistakeIsNamed();
    void everyLessonHasAProjectInEveryLanguage_data() { addLessonRows(); }
    void everyLessonHasAProjectInEveryLanguage();
    void textsAreNeitherShortNorLong_data() { addLessonRows(); }
    void textsAreNeitherShortNorLong();
    void languagesHaveTheSameLevels_data() { addLessonRows(); }
    void languagesHaveTheSameLevels();

private:
    static void addLessonRows();
};

void ProjectDocumentsTest::addLessonRows()
{
    QTest::addColumn<QString>("lesson");
    for (const QString &lesson : lessonIds()) {
        loadLesson(lesson); // the plugin brings the documents
        if (lesson != u"sandbox")
            QTest::addRow("%s", qPrintable(lesson)) << lesson;
    }
}

void ProjectDocumentsTest::everyFieldIsRead()
{
    using When = lessons::ProjectDemand::When;
    const lessons::Project project = lessons::parseProject(goodProject, projectName);
    QCOMPARE(project.title, "A bridge");
    QCOMPARE(project.brief, "Build it.");
    QCOMPARE(project.levels.size(), 3U);
    const lessons::ProjectLevel &first = project.levels.front();
    QCOMPARE(first.id, "first");
    QCOMPARE(first.title, "First");
    QCOMPARE(first.text, "It carries.");
    QCOMPARE(first.hint, "Use sticks.");
    QCOMPARE(first.run.frames, 60);
    QCOMPARE(first.run.values.size(), 1U);
    QCOMPARE(first.run.drags.size(), 1U);
    QCOMPARE(first.unchanged, (QStringList{"stone", "k"}));
    QCOMPARE(first.effects, (QStringList{"gravity", "walls"}));
    QCOMPARE(first.demands.size(), 4U);
    QVERIFY(first.demands[0].when == When::atTheStart);
    QVERIFY(first.demands[1].when == When::always);
    QVERIFY(first.demands[2].when == When::once);
    QVERIFY(first.demands[3].when == When::atTheEnd);
    QCOMPARE(first.demands[1].condition, "stone.y < 240");
    QCOMPARE(first.demands[1].sentence, "the stone stays up");
}

void ProjectDocumentsTest::eachMistakeIsNamed_data()
{
    support::addMistakeRows(projectMistakes);
}

void ProjectDocumentsTest::eachMistakeIsNamed()
{
    support::checkMistake(goodProject, projectName, mistakeInProject);
}

void ProjectDocumentsTest::everyLessonHasAProjectInEveryLanguage()
{
    QFETCH(QString, lesson);
    QVERIFY(!projectIn(lesson, "en").title.isEmpty());
    QVERIFY(!projectIn(lesson, "de").title.isEmpty());
    QVERIFY(QFile::exists(lessons::projectStartFile(lesson)));
}

void ProjectDocumentsTest::textsAreNeitherShortNorLong()
{
    QFETCH(QString, lesson);
    for (const char *language : {"en", "de"}) {
        const lessons::Project project = projectIn(lesson, language);
        const int brief = wordsInProject(project.brief);
        QVERIFY2(brief >= 40 && brief <= 80, qPrintable(QString::number(brief)));
        for (const lessons::ProjectLevel &level : project.levels) {
            const int words = wordsInProject(level.text);
            QVERIFY2(words >= 15 && words <= 40, qPrintable(level.id + ' ' + QString::number(words)));
        }
    }
}

void ProjectDocumentsTest::languagesHaveTheSameLevels()
{
    QFETCH(QString, lesson);
    const lessons::Project english = projectIn(lesson, "en"), german = projectIn(lesson, "de");
    QCOMPARE(german.brief.count("**"), english.brief.count("**"));
    for (std::size_t i = 0; i < english.levels.size(); ++i) {
        const lessons::ProjectLevel &here = english.levels[i], &there = german.levels[i];
        QCOMPARE(there.id, here.id);
        QCOMPARE(there.run.frames, here.run.frames);
        QCOMPARE(there.run.values, here.run.values);
        QCOMPARE(there.run.drags.size(), here.run.drags.size());
        QCOMPARE(there.unchanged, here.unchanged);
        QCOMPARE(there.effects, here.effects);
        QVERIFY(there.rings == here.rings);
        QCOMPARE(there.demands.size(), here.demands.size());
        for (std::size_t j = 0; j < here.demands.size(); ++j) {
            QVERIFY(there.demands[j].when == here.demands[j].when);
            QCOMPARE(there.demands[j].condition, here.demands[j].condition);
        }
        for (const auto &[text, other] :
             {std::pair{here.text, there.text}, std::pair{here.hint, there.hint}}) {
            QCOMPARE(codeInProject(other), codeInProject(text));
            QCOMPARE(other.count("**"), text.count("**"));
        }
    }
}

SUITE(tst_project_documents, ProjectDocumentsTest)
#include "tst_project_documents.moc"
