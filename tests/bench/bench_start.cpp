// How long a learner waits for the window: from the start of the program until the window is first painted
// and responds. Each start is a new process and is measured by wall-clock time, so the load of the machine
// adds to it.

#include "app/ui/window/gui.h"
#include "app/ui/window/main_window.h"

#include <QApplication>
#include <QProcess>
#include <QTemporaryDir>
#include <QTextStream>
#include <QTimer>

#include <benchmark/benchmark.h>

#include <chrono>

namespace {

constexpr int starts = 10; ///< per row
const char *const asWindow = "--as-window";

/// Returns ns on a clock that all processes share.
qint64 now()
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// An application that quits when the window has been painted, and records the time.
class Application : public QApplication
{
public:
    using QApplication::QApplication;

    bool notify(QObject *receiver, QEvent *event) override
    {
        const bool isPicture =
            event->type() == QEvent::Paint && qobject_cast<app::MainWindow *>(receiver) && !m_isPainted;
        const bool answer = QApplication::notify(receiver, event);
        if (isPicture) { // child widgets are painted after the window, within the same event
            m_isPainted = true;
            QTimer::singleShot(0, this, [] {
                QTextStream(stdout) << now() << Qt::endl;
                QApplication::quit();
            });
        }
        return answer;
    }

private:
    bool m_isPainted = false;
};

/// Returns the time of one start in s; 0 if there was no window.
double oneStart(const QProcessEnvironment &environment)
{
    QProcess process;
    process.setProcessEnvironment(environment);
    const qint64 before = now();
    process.start(QCoreApplication::applicationFilePath(), {asWindow});
    process.waitForFinished();
    const qint64 after = process.readAllStandardOutput().trimmed().toLongLong();
    return after > before ? 1e-9 * static_cast<double>(after - before) : 0.0;
}

void startUp(benchmark::State &bench)
{
    const QTemporaryDir home; // keeps the user's own settings out of the measurement
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char *variable : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"})
        environment.insert(variable, home.path());
    oneStart(environment); // a first start, which reads the program from the disk
    for (auto _ : bench) {
        const double took = oneStart(environment);
        if (took == 0.0)
            bench.SkipWithError("the window was not painted");
        bench.SetIterationTime(took);
    }
}

BENCHMARK(startUp)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(starts);

}

int main(int argc, char **argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    if (argc > 1 && QByteArray(argv[1]) == asWindow) {
        Application application(argc, argv);
        app::Work work;
        return app::runWindow(application, work, {}).code;
    }
    const QCoreApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
