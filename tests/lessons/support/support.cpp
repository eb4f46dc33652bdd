#include "tests/lessons/support/support.h"

#include "lessons/api/lesson.h"
#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/pipeline.h"
#include "sim/run/script/script.h"
#include "sim/run/track.h"

#include <QDir>
#include <QFile>
#include <QLibrary>
#include <QPluginLoader>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace support {

namespace {

const QString filePrefix = QStringLiteral("liblesson_");

}

const lessons::Step &LoadedLesson::step(const QString &id) const
{
    for (const lessons::Step &step : steps) {
        if (step.id == id)
            return step;
    }
    throw std::out_of_range("no step " + id.toStdString());
}

QStringList lessonIds()
{
    QStringList ids;
    for (const QFileInfo &file : QDir(QStringLiteral(LESSON_DIR)).entryInfoList(QDir::Files, QDir::Name)) {
        if (QLibrary::isLibrary(file.fileName()) && file.fileName().startsWith(filePrefix))
            ids << file.baseName().mid(filePrefix.size());
    }
    return ids;
}

LoadedLesson loadLesson(const QString &id)
{
    QPluginLoader loader(QStringLiteral(LESSON_DIR "/") + filePrefix + id);
    const auto *lesson = qobject_cast<lessons::Lesson *>(loader.instance());
    if (!lesson)
        throw std::runtime_error(loader.errorString().toStdString());
    return {loader.metaData().value(QStringLiteral("MetaData")).toObject(), lesson->steps()};
}

void addStepRows()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("id");
    for (const QString &lesson : lessonIds()) {
        for (const lessons::Step &step : loadLesson(lesson).steps)
            QTest::addRow("%s/%s", qPrintable(lesson), qPrintable(step.id)) << lesson << step.id;
    }
}

lessons::Step stepOfRow()
{
    QFETCH(QString, lesson);
    QFETCH(QString, id);
    return loadLesson(lesson).step(id);
}

bool fits(const lessons::Step &step, const sim::Method &method)
{
    const sim::Script script = scriptOf(step, method.id(), 1.0);
    try {
        sim::compose(sim::sceneOf(script, script.values), method, script.step);
        return true;
    } catch (const sim::Error &) {
        return false;
    }
}

void addStepAndMethodRows(const std::function<bool(const lessons::Step &, const sim::Method &)> &accept)
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("method");
    for (const QString &lesson : lessonIds()) {
        for (const lessons::Step &step : loadLesson(lesson).steps) {
            for (const sim::MethodPtr &method : sim::allMethods()) {
                if (accept(step, *method))
                    QTest::addRow("%s/%s with %s", qPrintable(lesson), qPrintable(step.id),
                                  method->id().c_str())
                        << lesson << step.id << QString::fromStdString(method->id());
            }
        }
    }
}

std::optional<QString> regionText(const sim::Region &region)
{
    QFile file(QStringLiteral(":/source/") + QString::fromStdString(region.file));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString marker = QStringLiteral("//! [%1]").arg(QString::fromStdString(region.marker));
    QString text;
    int markers = 0;
    for (const QString &line : QString::fromUtf8(file.readAll()).split(u'\n')) {
        if (line.trimmed() == marker)
            ++markers;
        else if (markers == 1)
            text += line + u'\n';
    }
    if (markers != 2)
        return {};
    return text;
}

std::vector<sim::MethodPtr> walkingMethods()
{
    std::vector<sim::MethodPtr> methods = sim::allMethods();
    std::erase_if(methods, [](const sim::MethodPtr &method) {
        const bool isStable = method->id() == "published" || method->symplectic() == sim::Symplectic::yes ||
                              method->stepLimit() == sim::StepLimit::none;
        return method->stepping() == sim::Stepping::adaptive || method->order() > 2 || !isStable;
    });
    return methods;
}

void addWalkingMethodRows()
{
    QTest::addColumn<QString>("method");
    for (const sim::MethodPtr &method : walkingMethods())
        QTest::addRow("%s", method->id().c_str()) << QString::fromStdString(method->id());
}

std::string figurePointName(std::size_t point)
{
    return std::string("p").append(std::to_string(point));
}

sim::Script scriptOf(const lessons::Step &step, const std::string &method, double h, const Changes &changes)
{
    sim::Script script = step.script();
    script.method = sim::findMethod(method);
    script.step = sim::stepFor(*script.method, sim::StepSize::ofLength(h));
    for (const auto &[id, value] : changes)
        script.values.set(id, value);
    return script;
}

sim::State stateAfter(const sim::Script &script, std::int64_t frames)
{
    sim::Track track(script, 0);
    track.seek({frames, 0});
    return track.state();
}

double largestDistance(const sim::State &a, const sim::State &b)
{
    return (a.position - b.position).matrix().rowwise().norm().maxCoeff();
}

OrderRange observedOrders(const std::function<double(double)> &error, int first, int last)
{
    std::vector<double> logs;
    for (int n = first; n <= last; ++n)
        logs.push_back(std::log2(error(1.0 / (1 << n))));
    OrderRange range{1e9, -1e9};
    for (std::size_t i = 1; i < logs.size(); ++i) {
        range.min = std::min(range.min, logs[i - 1] - logs[i]);
        range.max = std::max(range.max, logs[i - 1] - logs[i]);
    }
    return range;
}

}
