// Zips of lessons from strangers: every damaged zip is refused with one sentence, or read within the bounds.

#include "app/model/lesson_folders/lesson_folder.h"
#include "app/model/lesson_folders/zip_reader.h"
#include "app/model/text/quoting.h"
#include "tests/app/experiment/experiment_support.h"
#include "tests/app/support/zip_writer.h"
#include "tests/suite.h"

#include <functional>
#include <random>

using namespace app;

namespace {

using ZipFiles = std::map<QString, QByteArray>;

const ZipLimits strictLimits{mostLessonFiles, largestLessonFile, largestLesson};
const QString strangerName = QStringLiteral("stranger.springstep-lesson");

/// Returns a small lesson that has most of what a lesson can have.
const ZipFiles &smallLesson()
{
    static const ZipFiles files = {
        {"lesson.json", R"({ "format": "springstep-lesson/1", "id": "lamp", "title": "A lamp",
  "title.de": "Eine Lampe", "summary": "It bounces.", "steps": ["first"] })"},
        {"first.json", R"({ "format": "springstep-experiment/1", "lesson": "sandbox", "step": "build",
  "parameters": { "gravity": 0.2 },
  "scene": { "bodies": { "hook": { "x": 270, "y": 60, "fixed": true }, "lamp": { "x": 270, "y": 180 } },
   "springs": [ { "a": "hook", "b": "lamp", "k": 0.05, "length": 100 } ], "effects": ["gravity", "damping"],
   "rule": "Vec2 force(Body me)\n{\n    return Vec2(draught, 0);\n}\n" } })"},
        {"first.md", R"(# A lamp

Pull the **lamp** down.

## Parameter: Draught {#draught}

How hard the air pushes.

- value: 0
- minimum: -1
- maximum: 1

## Parameter: Stiffness {#stiff}

How hard the spring pulls.

- sets: k of hook-lamp
- minimum: 0
- maximum: 0.2

## Try {#pull}

Pull it.

### Hint

Use the mouse.

### Done when

- begun: held(lamp) or released(lamp)
- low: lamp.y > 200

### Missing

- low: it is at %1.

### Solution

- drag lamp: 270, 260, 10
- frames: 30

## Predict {#where}

Where is it?

### Run

- stiff: 0.1
- frames: 30

### Ask

- place: lamp

### Answer

Higher.

## Word: Lamp

It shines.

## Concept: A lamp {#lamp_hangs}

It hangs.

## Why: Why does it hang?

`k * length = gravity` {stiff, lamp}

## Learnt

It bounces.
)"},
        {"first.de.md", "# Eine Lampe\n\nZieh.\n"}};
    return files;
}

/// Reads a zip as the window does. Returns the sentence with which it is refused; empty if it is read.
QString refusalOfZip(const QByteArray &zip, const std::function<void(const ZipFiles &)> &read = {})
{
    try {
        const ZipFiles files = readZip(zip, strangerName, strictLimits);
        if (read)
            read(files);
    } catch (const UserError &error) {
        return error.sentence();
    }
    return {};
}

QString refusalOfLesson(const ZipFiles &all)
{
    LessonFiles files{strangerName, '/' + strangerName};
    files.all = all;
    try {
        lessonOf(files, "en", experiment_support::library());
    } catch (const UserError &error) {
        return error.sentence();
    }
    return {};
}

bool isSentence(const QString &text)
{
    return (text.endsWith('.') || text.endsWith('?')) && text.size() < 1200 && escaped(text) == text;
}

/// Checks that a zip is refused with a sentence, or that all of its files stay within the limits.
void checkIsSafe(const QByteArray &zip)
{
    const QString refusal = refusalOfZip(zip, [](const ZipFiles &files) {
        qsizetype all = 0;
        for (const auto &[name, content] : files) {
            QVERIFY2(!name.contains('/') && name != u"..", qPrintable(name));
            all += content.size();
        }
        QVERIFY(files.size() <= strictLimits.files && all <= strictLimits.all);
    });
    QVERIFY2(refusal.isEmpty() || (refusal.startsWith(strangerName + ": ") && isSentence(refusal)),
             qPrintable(refusal));
}

QByteArray withByte(QByteArray bytes, qsizetype at, int byte)
{
    bytes[at] = static_cast<char>(byte);
    return bytes;
}

QByteArray withBytes(QByteArray bytes, qsizetype at, const QByteArray &by)
{
    return bytes.replace(at, by.size(), by);
}

}

class TestLessonZips : public QObject
{
    Q_OBJECT

private slots:
    void theSmallLessonIsRead();
    void aCutZipIsRefused();
    void changedBytesAreRefusedOrHarmless();
    void aDamagedZipIsNamed_data();
    void aDamagedZipIsNamed();
    void aZipWithFoldersOnlyIsEmpty();
    void randomlyChangedTextsAreReadOrRefusedWithASentence();
    void namesOfFilesStayOnOneLine();
};

void TestLessonZips::theSmallLessonIsRead()
{
    QCOMPARE(refusalOfZip(tests::zipOf(smallLesson()),
                          [](const ZipFiles &files) { QVERIFY(files == smallLesson()); }),
             QString());
    QCOMPARE(refusalOfLesson(smallLesson()), QString());
}

void TestLessonZips::aCutZipIsRefused()
{
    const QByteArray zip = tests::zipOf(smallLesson());
    for (qsizetype size = 0; size < zip.size(); ++size) {
        const QString refusal = refusalOfZip(zip.left(size));
        QVERIFY2(refusal.contains("its end is missing") && isSentence(refusal), qPrintable(refusal));
    }
    for (qsizetype missing = 1; missing < 40; ++missing) // the places of all files are wrong
        QVERIFY(!refusalOfZip(zip.mid(missing)).isEmpty());
}

void TestLessonZips::changedBytesAreRefusedOrHarmless()
{
    const QByteArray zip = tests::zipOf(smallLesson());
    for (qsizetype at = 0; at < zip.size(); ++at) {
        for (const int byte : {0, 0xff, static_cast<int>(static_cast<unsigned char>(zip[at])) ^ 1})
            checkIsSafe(withByte(zip, at, byte));
        if (QTest::currentTestFailed())
            QFAIL(qPrintable(QStringLiteral("byte %1").arg(at)));
    }
}

void TestLessonZips::aDamagedZipIsNamed_data()
{
    QTest::addColumn<QByteArray>("zip");
    QTest::addColumn<QString>("said");
    const QByteArray good = tests::zipOf({{"aa.md", "first"}, {"bb.md", "other"}});
    const qsizetype table = good.indexOf("PK\x01\x02"), end = good.indexOf("PK\x05\x06");
    const QByteArray all(4, '\xff');
    QTest::newRow("a smaller size") << withBytes(good, table + 24, QByteArray("\2\0\0\0", 4))
                                    << "\"aa.md\" is larger than the zip says";
    QTest::newRow("a larger size") << withBytes(good, table + 24, QByteArray("\x20\0\0\0", 4))
                                   << "the zip is damaged";
    QTest::newRow("a size of ZIP64") << withBytes(good, table + 24, all) << "\"aa.md\" is packed as ZIP64";
    QTest::newRow("a packed size of ZIP64") << withBytes(good, table + 20, all) << "is packed as ZIP64";
    QTest::newRow("a place of ZIP64") << withBytes(good, table + 42, all) << "is packed as ZIP64";
    QTest::newRow("a packed size beyond the end")
        << withBytes(good, table + 20, QByteArray("\0\0\1\0", 4)) << "the zip is damaged";
    QTest::newRow("a place beyond the end")
        << withBytes(good, table + 42, QByteArray("\0\0\1\0", 4)) << "the zip is damaged";
    QTest::newRow("a password") << withBytes(good, table + 8, QByteArray(1, '\1')) << "has a password";
    QTest::newRow("a name twice") << QByteArray(good).replace("bb.md", "aa.md") << "\"aa.md\" is there twice";
    QTest::newRow("upwards in the table") << QByteArray(good).replace("bb.md", "../bb") << "is not safe";
    QTest::newRow("more entries than there are")
        << withBytes(good, end + 8, QByteArray("\3\0\3\0", 4)) << "the zip is damaged";
    QTest::newRow("two parts") << withBytes(good, end + 4, QByteArray("\1\0", 2)) << "several parts";
    QTest::newRow("a table inside itself")
        << withBytes(good, end + 16, QByteArray("\0\0\0\0", 4)) << "the zip is damaged";
    const QByteArray zeros(largestLessonFile, '\0'); // 4 MiB in 4 kB
    ZipFiles bombs;
    for (const char *name : {"a.md", "b.md", "c.md", "d.md", "e.md"})
        bombs[name] = zeros;
    QTest::newRow("a bomb of many files") << tests::zipOf(bombs) << "larger than 16 MiB together";
}

void TestLessonZips::aDamagedZipIsNamed()
{
    QFETCH(QByteArray, zip);
    QFETCH(QString, said);
    const QString refusal = refusalOfZip(zip);
    QVERIFY2(refusal.contains(said) && isSentence(refusal), qPrintable(refusal));
}

void TestLessonZips::aZipWithFoldersOnlyIsEmpty()
{
    const QString refusal = refusalOfZip(tests::zipOf({{"a/", ""}, {"b/", ""}}));
    QVERIFY2(refusal.contains("the zip is empty"), qPrintable(refusal));
}

void TestLessonZips::randomlyChangedTextsAreReadOrRefusedWithASentence()
{
    std::minstd_rand random(22);
    const auto below = [&random](qsizetype end) {
        return static_cast<qsizetype>(random() % std::size_t(end));
    };
    for (int i = 0; i < 60; ++i) {
        ZipFiles files = smallLesson();
        QByteArray &content = std::next(files.begin(), 1 + below(3))->second; // all but the German text
        for (int change = 0; change < 2; ++change) {
            const qsizetype from = below(content.size()), length = below(30);
            switch (below(3)) {
            case 0:
                content.remove(from, length);
                break;
            case 1:
                content.insert(below(content.size()), content.mid(from, length));
                break;
            default:
                content[from] = static_cast<char>(below(256));
            }
        }
        const QString refusal = refusalOfLesson(files);
        QVERIFY2(refusal.isEmpty() || isSentence(refusal), qPrintable(refusal));
    }
}

void TestLessonZips::namesOfFilesStayOnOneLine()
{
    ZipFiles files = smallLesson();
    files["other\n\x1b[31m.md"] = "# X";
    QVERIFY2(isSentence(refusalOfLesson(files)), qPrintable(refusalOfLesson(files)));
    files = smallLesson();
    files["first.md"].replace("## Word: Lamp", "## Wort: \x07" + QByteArray(3000, 'x'));
    QVERIFY2(isSentence(refusalOfLesson(files)), qPrintable(refusalOfLesson(files)));
}

SUITE(tst_lesson_zips, TestLessonZips)
#include "tst_lesson_zips.moc"
