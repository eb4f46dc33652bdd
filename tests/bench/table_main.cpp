// bench_table [--figure OUT.svg] FILE...: reads files from --benchmark_out, and prints one table of them or
// draws the race against odeint and CVODE.

#include "tests/bench/race_figure.h"
#include "tests/bench/table.h"

#include <QApplication>
#include <QFile>

#include <cstdio>
#include <string_view>

namespace {

/// Returns whether the file could be written.
bool write(const char *file, const std::string &picture)
{
    QFile out(file);
    const QByteArray bytes = QByteArray::fromStdString(picture);
    return out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size() && out.flush();
}

/// Draws the race. Returns the exit code.
int drawRace(const char *file, const bench::Measurements &medians)
{
    const std::string picture = bench::raceFigure(medians);
    if (picture.empty()) {
        std::fprintf(stderr, "No figure: these are not the benchmarks \"springstep|odeint|cvode\".\n");
        return 1;
    }
    if (!write(file, picture)) {
        std::fprintf(stderr, "The figure cannot be written to %s.\n", file);
        return 2;
    }
    return 0;
}

}

int main(int argc, char **argv)
{
    const char *figure = nullptr;
    int first = 1;
    if (argc > 2 && std::string_view(argv[1]) == "--figure") {
        figure = argv[2];
        first = 3;
    }
    bench::Results results;
    for (int i = first; i < argc; ++i) {
        QFile file(argv[i]);
        const std::string wrong = file.open(QIODevice::ReadOnly) ? bench::addResults(file.readAll(), results)
                                                                 : file.errorString().toStdString();
        if (!wrong.empty()) {
            std::fprintf(stderr, "%s: %s\n", argv[i], wrong.c_str());
            return 2;
        }
    }
    std::fputs(bench::table(results, bench::allRows(results.medians), bench::allGrowingRows()).c_str(),
               stdout);
    if (!figure)
        return 0;
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv); // the plot is a widget
    return drawRace(figure, results.medians);
}
