// How long it takes until the window shows another moment of a ten-minute run: seeking and painting the whole window,
// 1280 x 800 px, for moments drawn at random: bench_scrub [LESSON/STEP[,PARAMETER=VALUE]...]...
// Times are processor time of this thread, so that a machine with other things to do does not add to them.

#include "app/model/lesson_library.h"
#include "app/ui/window/main_window.h"
#include "sim/accuracy/cpu_clock.h"

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextStream>

#include <algorithm>
#include <cmath>
#include <random>

using namespace app;

namespace {

constexpr std::int64_t tenMinutes = 10 * 60 * 30; ///< frames
constexpr int moments = 300;

void waitThere(const Session &session)
{
    while (session.goingTo())
        QApplication::processEvents();
}

QString percentiles(std::vector<double> seconds)
{
    const auto slowest = std::max_element(seconds.begin(), seconds.end()) - seconds.begin() + 1;
    std::sort(seconds.begin(), seconds.end());
    const auto at = [&](double share) {
        const auto last = static_cast<double>(seconds.size() - 1);
        return QString::number(1e3 * seconds[static_cast<std::size_t>(std::lround(share * last))], 'f', 2);
    };
    return QString("median %1 ms, 90 %: %2, 99 %: %3, most %4 (number %5)")
        .arg(at(0.5), at(0.9), at(0.99), at(1.0))
        .arg(slowest);
}

/// Opens "LESSON/STEP,PARAMETER=VALUE...".
void open(Session &session, const QString &what)
{
    const QStringList parts = what.split(',');
    session.openStep(parts.front().section('/', 0, 0), parts.front().section('/', 1));
    for (const QString &part : parts.mid(1))
        session.setParameter(part.section('=', 0, 0), part.section('=', 1).toDouble());
}

void measure(Session &session, Theme &theme, const QString &what, QTextStream &out)
{
    open(session, what);
    MainWindow window(session, theme);
    window.resize(1280, 800);
    window.show();
    QApplication::processEvents();
    session.goTo({tenMinutes, 0});
    waitThere(session);
    std::mt19937 random(1);
    std::uniform_int_distribution<std::int64_t> anywhere(0, session.timeline().computed());
    std::vector<double> seeking, all;
    QImage image(window.size(), QImage::Format_RGB32);
    for (int i = 0; i < moments; ++i) {
        const double start = sim::computedSeconds();
        session.goTo({anywhere(random), 0});
        waitThere(session);
        seeking.push_back(sim::computedSeconds() - start);
        window.render(&image);
        all.push_back(sim::computedSeconds() - start);
        QApplication::processEvents(); // what is due later: readings, courses
    }
    out << what << ": " << session.timeline().now().points() << " points, "
        << session.timeline().track().keptStates() << " moments kept of " << session.timeline().computed()
        << "\n  seeking: " << percentiles(seeking) << "\n  seeking and painting: " << percentiles(all)
        << Qt::endl;
}

}

int main(int count, char **arguments)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(count, arguments);
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QStringList what = QApplication::arguments().mid(1);
    if (what.isEmpty())
        what = {"gravity_walls/gravity", "accuracy/crowd,creatures=800"};
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    Theme theme(Scheme::light);
    theme.apply(application);
    Session session(library);
    QTextStream out(stdout);
    for (const QString &one : what)
        measure(session, theme, one, out);
    return 0;
}
