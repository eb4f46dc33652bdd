#include "app/cli/trace_rows.h"
#include "tests/app/experiment/experiment_support.h"
#include "tests/suite.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QTest>

#include <cmath>
#include <cstdint>
#include <cstring>

using namespace app;
using namespace experiment_support;

namespace {

/// Returns the SHA-256 of `springstep trace` for each file, as the program of 24 November 2026 printed it. `tst_trace` starts the
/// program itself.
QHash<QString, QByteArray> recordedTraces()
{
    QHash<QString, QByteArray> hashes;
    for (const QByteArray &line : contentsOf(TEST_DATA "/saved/traces.sha256").split('\n')) {
        const QList<QByteArray> fields = line.simplified().split(' ');
        if (fields.size() == 2)
            hashes[QString::fromUtf8(fields[1])] = fields[0];
    }
    return hashes;
}

/// Returns a hash of what this machine's C library computes. Its last bits depend on its version and on the
/// processor, and some scenes use its sine, cosine, arc tangent and exponential.
QByteArray bitsOfTheLibrary()
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (int i = 1; i <= 20'000; ++i) {
        const double x = 0.037 * i;
        for (const double y :
             {std::sin(x), std::cos(x), std::atan2(std::sin(x), x - 300.0), std::exp(-0.01 * x),
              std::pow(0.9, 0.001 * i), std::log(x), std::hypot(x, 0.3)}) {
            char bytes[sizeof y];
            std::memcpy(bytes, &y, sizeof y);
            hash.addData(QByteArrayView(bytes, sizeof bytes));
        }
    }
    return hash.result().toHex();
}

/// The machine that recorded the traces.
constexpr const char *recordedBitsOfTheLibrary =
    "9a81c72229e83d5cff9c9083cc10b5847cc749be06c0c87dc5e6834c805baa9f";

/// The sandbox's examples were written by hand, so their layout is not the program's.
bool isWrittenByTheProgram(const QString &name)
{
    return !name.startsWith("sandbox-");
}

/// Returns what `springstep trace` prints for an experiment.
std::string traceOf(const Experiment &experiment)
{
    const lessons::TraceColumns columns =
        library().lesson(experiment.lesson)->step(experiment.step)->traceColumns;
    sim::Track track(experiment.script, 1 << 20);
    std::string rows = traceTitles(columns);
    appendTraceRow(rows, track, columns);
    for (std::int64_t frame = track.framesPerOutput(); frame <= experiment.frames;
         frame += track.framesPerOutput()) {
        track.seek({frame, 0});
        appendTraceRow(rows, track, columns);
    }
    return rows;
}

void everyFile()
{
    QTest::addColumn<QString>("path");
    for (const QFileInfo &info : QDir(TEST_DATA "/saved").entryInfoList({"*.json"}))
        QTest::newRow(qPrintable(info.completeBaseName())) << info.absoluteFilePath();
}

}

/// Files saved by an earlier version open, are written back unchanged, and give the same bits.
class TestSavedFiles : public QObject
{
    Q_OBJECT

private slots:
    void everyFileHasARecordedTrace()
    {
        const QFileInfoList files = QDir(TEST_DATA "/saved").entryInfoList({"*.json"});
        const QHash<QString, QByteArray> recorded = recordedTraces();
        QCOMPARE(recorded.size(), files.size());
        for (const QFileInfo &file : files)
            QVERIFY2(recorded.contains(file.fileName()), qPrintable(file.fileName()));
    }

    void aSavedFileIsWrittenBackUnchanged_data() { everyFile(); }
    void aSavedFileIsWrittenBackUnchanged()
    {
        QFETCH(QString, path);
        const Experiment experiment = readExperiment(path, library());
        if (isWrittenByTheProgram(QFileInfo(path).fileName()))
            QCOMPARE(experimentText(experiment, library()), contentsOf(path));
        compareAfterRoundTrip(experiment);
    }

    void aSavedFileRunsToTheSameBits_data() { everyFile(); }
    void aSavedFileRunsToTheSameBits()
    {
        QFETCH(QString, path);
        const Experiment experiment = readExperiment(path, library());
        const std::string rows = traceOf(experiment);
        if (bitsOfTheLibrary() != recordedBitsOfTheLibrary)
            QSKIP("the C library of this machine rounds sine, cosine or another function differently");
        const QByteArray hash =
            QCryptographicHash::hash(QByteArrayView(rows), QCryptographicHash::Sha256).toHex();
        QCOMPARE(hash, recordedTraces().value(QFileInfo(path).fileName()));
    }
};

SUITE(tst_saved_files, TestSavedFiles)

#include "tst_saved_files.moc"
