// Damaged experiment files: each is refused with a sentence, or it opens. A refused file leaves the open experiment
// unchanged. The environment variables SPRINGSTEP_RANDOM_SEED and SPRINGSTEP_RANDOM_COUNT choose other files.

#include "tests/app/support/window_fixture.h"
#include "tests/sizes.h"
#include "tests/suite.h"

#include <QDir>
#include <QRandomGenerator>
#include <QTemporaryDir>

using namespace app;
using namespace tests;

namespace {

/// A source of damaged copies of good experiments.
class DamagedFiles
{
public:
    DamagedFiles(quint32 seed, std::vector<QByteArray> made) : m_random(seed), m_good(std::move(made))
    {
        const QDir folder(TEST_DATA "/published");
        for (const QString &name : folder.entryList({"*.json"})) {
            QFile file(folder.filePath(name));
            if (file.open(QFile::ReadOnly))
                m_good.push_back(file.readAll());
        }
    }
    std::size_t count() const { return m_good.size(); }

    QByteArray next()
    {
        QByteArray text = m_good[pick(m_good.size())];
        const int times = 1 + m_random.bounded(3);
        for (int i = 0; i < times && !text.isEmpty(); ++i)
            spoil(text);
        return text;
    }

private:
    std::size_t pick(std::size_t count) { return m_random.bounded(quint32(count)); }
    qsizetype place(const QByteArray &text) { return qsizetype(pick(std::size_t(text.size()))); }

    void spoil(QByteArray &text)
    {
        switch (m_random.bounded(8)) {
        case 0:
            text.truncate(place(text));
            break;
        case 1: { // bits
            char &c = *(text.begin() + place(text));
            c = char(c ^ (1 << m_random.bounded(8)));
            break;
        }
        case 2: // a part again, somewhere
            text.insert(place(text), text.mid(place(text), m_random.bounded(60)));
            break;
        case 3:
            text.remove(place(text), 1 + m_random.bounded(40));
            break;
        case 4: // deep
            text.insert(place(text), QByteArray(1 << m_random.bounded(18), m_random.bounded(2) ? '[' : '{'));
            break;
        default:
            replaceValue(text);
        }
    }

    /// Another value in place of a number, a text, a list or an object.
    void replaceValue(QByteArray &text)
    {
        static const QByteArray values[] = {"NaN",
                                            "-Infinity",
                                            "1e999",
                                            "-1e308",
                                            "1e308",
                                            "999999999999999999999",
                                            "-1",
                                            "0",
                                            "1e-320",
                                            "0.5",
                                            "true",
                                            "null",
                                            "\"x\"",
                                            "\"\\u0000\"",
                                            "[]",
                                            "{}",
                                            "[[]]",
                                            "1000000000",
                                            "\"published\"",
                                            "\"dop853\"",
                                            "\"\xff\"",
                                            "01",
                                            "1.",
                                            "\"\\ud800\""};
        const qsizetype colon = text.indexOf(':', place(text));
        if (colon < 0)
            return;
        qsizetype end = colon + 1;
        while (end < text.size() && !QByteArray(",\n}]").contains(text[end]))
            ++end;
        text.replace(colon + 1, end - colon - 1, ' ' + values[pick(std::size(values))]);
    }

    QRandomGenerator m_random;
    std::vector<QByteArray> m_good;
};

/// Returns the texts of experiments with two named and kept branches: one parts at the start, one later.
std::vector<QByteArray> textsWithBranches()
{
    std::vector<QByteArray> texts;
    for (const char *step : {"two_feet", "any_number"}) {
        WindowFixture fixture({"multi_foot", step});
        for (const std::int64_t frame : {0, 20}) {
            fixture.goTo(60);
            fixture.session.playback().goTo({frame, 0});
            fixture.drag(frame == 0 ? "foot1" : "foot0", {30, 10});
            fixture.session.editor().setParameter("k", 0.3 + 0.01 * double(frame));
            fixture.session.editor().endGesture();
            fixture.session.comparisons().rename(fixture.session.comparisons().branches().all().back().id,
                                                 QString("run %1").arg(frame));
            fixture.session.comparisons().keep(fixture.session.comparisons().branches().all().back().id,
                                               true);
        }
        texts.push_back(experimentText(fixture.session.experiment(), fixture.library));
    }
    return texts;
}

}

class MalformedTest : public QObject
{
    Q_OBJECT

private slots:
    void damagedFileIsRefusedWithASentenceOrOpens();
    void aFileThatIsTooLargeIsRefusedUnread();

private:
    QByteArray textOf(const WindowFixture &fixture)
    {
        return experimentText(fixture.session.experiment(), fixture.library);
    }
    QTemporaryDir m_folder;
};

void MalformedTest::damagedFileIsRefusedWithASentenceOrOpens()
{
    const quint32 seed = setting("SPRINGSTEP_RANDOM_SEED", 1u);
    const quint32 count = setting("SPRINGSTEP_RANDOM_COUNT", 500u);
    const std::vector<QByteArray> made = textsWithBranches();
    QVERIFY(made.front().contains("\"branches\"") && made.back().contains("\"fork\""));
    DamagedFiles files(seed, made);
    QVERIFY(files.count() > 10);
    WindowFixture fixture({"multi_foot", "two_feet"});
    fixture.session.editor().setParameter("k", 0.31);
    fixture.drag("foot0", {40, 10});
    fixture.goTo(40);
    const Experiment mine = fixture.session.experiment();
    const QByteArray before = textOf(fixture);
    const sim::State now = fixture.session.timeline().state();
    const QString path = m_folder.filePath("spoiled.json");
    quint32 refused = 0;
    for (quint32 i = 0; i < count; ++i) {
        const QByteArray text = files.next();
        QFile file(path);
        QVERIFY(file.open(QFile::WriteOnly) && file.write(text) == text.size());
        file.close();
        fixture.window.openFile(path);
        const QString said = fixture.notice.sentence();
        const QByteArray what =
            "seed " + QByteArray::number(seed) + ", number " + QByteArray::number(i) + ": " + said.toUtf8();
        if (said.isEmpty()) {
            QVERIFY2(fixture.window.windowTitle().contains("spoiled.json"), what);
            fixture.goTo(3);
            fixture.session.open(mine);
            fixture.goTo(40);
            QCOMPARE(textOf(fixture), before);
            continue;
        }
        ++refused;
        QVERIFY2(said.startsWith("Could not open the experiment: spoiled.json: ") &&
                     said.contains(": line ") && said.endsWith(" Your scene is unchanged.") &&
                     !said.contains('\n') && said.size() < 600,
                 what);
        QVERIFY2(textOf(fixture) == before, what);
        QVERIFY2(sim::sameBits(fixture.session.timeline().state(), now), what);
    }
    qInfo("%u files from seed %u: %u refused, %u opened", count, seed, refused, count - refused);
    QVERIFY(refused > count / 2);
}

void MalformedTest::aFileThatIsTooLargeIsRefusedUnread()
{
    WindowFixture fixture;
    fixture.session.editor().setParameter("k", 0.31);
    const QByteArray before = textOf(fixture);
    QFile file(m_folder.filePath("large.json"));
    QVERIFY(file.open(QFile::WriteOnly) && file.resize(qint64(1) << 30)); // a sparse file
    file.close();
    fixture.window.openFile(file.fileName());
    QVERIFY2(fixture.notice.sentence().contains("32 MiB"), qPrintable(fixture.notice.sentence()));
    QCOMPARE(textOf(fixture), before);
}

SUITE(tst_malformed, MalformedTest)
#include "tst_malformed.moc"
