// Programs that are killed at random moments during user input. The next start loses at most the last two seconds of
// input, and no file is damaged. The environment variable SPRINGSTEP_KILLS sets the number of programs, and
// SPRINGSTEP_RANDOM_SEED the seed. tests/kill runs 200.

#include "app/model/files/autosave.h"
#include "tests/sizes.h"
#include "tests/suite.h"

#include <QCryptographicHash>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>

#include <map>

using namespace app;

namespace {

constexpr int mostLost = 2000; ///< ms of input
constexpr int atOnce = 5;      ///< programs

/// A state of a run, and when it was reached.
struct Noted
{
    int at = 0; ///< ms that the user had waited
    QByteArray digest;
};

struct Log
{
    std::map<QString, std::vector<Noted>> steps;
    int end = 0; ///< ms, of the last line
    int lines = 0;
};

Log readLog(const QString &path)
{
    Log log;
    QFile file(path);
    if (!file.open(QFile::ReadOnly))
        return log;
    for (const QByteArray &line : file.readAll().split('\n')) {
        const QList<QByteArray> words = line.split(' ');
        if (words.size() != 3)
            continue;
        log.end = words[0].toInt();
        ++log.lines;
        log.steps[words[1]].push_back({log.end, words[2]});
    }
    return log;
}

QByteArray digestOf(const QString &path, const LessonLibrary &library)
{
    Experiment experiment = readExperiment(path, library);
    experiment.frames = 1;
    return QCryptographicHash::hash(experimentText(experiment, library), QCryptographicHash::Sha1).toHex();
}

/// Returns how many ms of input of a step are lost if `kept` was recovered; -1 if `kept` never existed.
int lost(const std::vector<Noted> &states, const QByteArray &kept, int end)
{
    for (std::size_t i = states.size(); i-- > 0;) {
        if (states[i].digest == kept)
            return i + 1 < states.size() ? end - states[i + 1].at : 0;
    }
    return kept == "-" ? end - states.front().at : -1; // it was opened as it is published
}

struct Killed
{
    QTemporaryDir folder;
    QProcess process;
    int moment = 0; ///< ms after its first line

    void start(quint32 seed, QRandomGenerator &random)
    {
        moment = random.bounded(200, 4000);
        process.setProgram(KILLED_PROGRAM);
        process.setArguments({folder.path(), QString::number(seed)});
        process.setStandardErrorFile(QProcess::nullDevice());
        process.start();
    }
    QString log() const { return folder.filePath("log"); }
};

}

class KillsTest : public QObject
{
    Q_OBJECT

private slots:
    void atMostTwoSecondsAreLost();

private:
    void check(const Killed &killed);

    const LessonLibrary m_library = LessonLibrary::load({LESSON_DIR});
    std::vector<int> m_lost;
    int m_kept = 0;
    int m_states = 0;
};

void KillsTest::check(const Killed &killed)
{
    const Log log = readLog(killed.log());
    m_states += log.lines;
    std::map<QString, QByteArray> kept;
    for (const RecoveredScene &scene : recoveredScenes(killed.folder.filePath("scenes"))) {
        QVERIFY(scene.wasEnded);
        kept[scene.name.lesson + '.' + scene.name.step] =
            digestOf(scene.file, m_library); // throws if damaged
        ++m_kept;
    }
    int most = 0;
    for (const auto &[step, states] : log.steps) {
        const auto found = kept.find(step);
        const int one = lost(states, found == kept.end() ? QByteArray("-") : found->second, log.end);
        QVERIFY2(one >= 0, qPrintable(step + ": " + killed.folder.path()));
        most = std::max(most, one);
    }
    QVERIFY2(most <= mostLost, qPrintable(QString("%1 ms").arg(most)));
    m_lost.push_back(most);
}

void KillsTest::atMostTwoSecondsAreLost()
{
    const quint32 seed = tests::setting("SPRINGSTEP_RANDOM_SEED", 1u);
    const quint32 count = tests::setting("SPRINGSTEP_KILLS", 5u);
    QRandomGenerator random(seed);
    for (quint32 first = 0; first < count; first += atOnce) {
        std::vector<std::unique_ptr<Killed>> programs;
        for (quint32 i = first; i < std::min(count, first + atOnce); ++i) {
            programs.push_back(std::make_unique<Killed>());
            programs.back()->start(1000 * seed + i, random);
        }
        std::sort(programs.begin(), programs.end(),
                  [](const auto &a, const auto &b) { return a->moment < b->moment; });
        for (const auto &one : programs)
            QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(one->log()).size() > 0, 120'000);
        QElapsedTimer clock;
        clock.start();
        for (const auto &one : programs) {
            QVERIFY(!one->process.waitForFinished(std::max<int>(0, one->moment - int(clock.elapsed()))));
            one->process.kill();
            QVERIFY(one->process.waitForFinished());
            check(*one);
            if (QTest::currentTestFailed())
                return;
        }
    }
    std::sort(m_lost.begin(), m_lost.end());
    qInfo("%u programs killed, from seed %u: %d states, %d scenes kept, none damaged; input lost: median %d "
          "ms, most %d "
          "ms",
          count, seed, m_states, m_kept, m_lost[m_lost.size() / 2], m_lost.back());
    QVERIFY(m_states > int(count) && m_kept > 0);
}

SUITE(tst_kills, KillsTest)
#include "tst_kills.moc"
