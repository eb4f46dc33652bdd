#include "tests/lessons/support/published_files.h"

#include "sim/methods/methods.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace support {

namespace {

const QString folder = QStringLiteral(TEST_DATA "/published/");

QByteArray contents(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        throw std::runtime_error("cannot read " + path.toStdString());
    return file.readAll();
}

sim::Vec2 vec2(const QJsonObject &object, const QString &first, const QString &second)
{
    return {object[first].toDouble(), object[second].toDouble()};
}

/// Returns the number of a point from its name: 3 for "p3".
int pointNumber(const QJsonValue &name)
{
    return name.toString().mid(1).toInt();
}

sim::Event readEvent(const QJsonObject &object)
{
    const std::int64_t frame = object[QStringLiteral("frame")].toInteger();
    const QString what = object[QStringLiteral("event")].toString();
    if (what == u"grab")
        return {frame, sim::Grab{object[QStringLiteral("body")].toString().toStdString()}};
    if (what == u"move")
        return {frame, sim::Move{vec2(object, QStringLiteral("x"), QStringLiteral("y"))}};
    if (what == u"release")
        return {frame, sim::Release{}};
    if (what == u"pointer")
        return {frame, sim::Pointer{vec2(object, QStringLiteral("x"), QStringLiteral("y")),
                                    object[QStringLiteral("down")].toBool()}};
    if (what == u"target")
        return {frame, sim::Target{vec2(object, QStringLiteral("x"), QStringLiteral("y"))}};
    if (what == u"gust")
        return {frame, sim::Gust{object[QStringLiteral("degrees")].toDouble()}};
    throw std::runtime_error("unknown event " + what.toStdString());
}

sim::Script readScript(const QJsonObject &file, const lessons::Step &step)
{
    sim::Script script = step.script();
    script.method = sim::findMethod(file[QStringLiteral("method")].toString().toStdString());
    script.step = sim::StepSize::ofLength(file[QStringLiteral("h")].toDouble());
    const QJsonObject parameters = file[QStringLiteral("parameters")].toObject();
    for (const QString &id : parameters.keys()) {
        const lessons::Parameter *parameter = step.parameter(id);
        const QJsonValue value = parameters[id];
        if (!parameter)
            throw std::runtime_error("unknown parameter " + id.toStdString());
        script.values.set(id.toStdString(), value.isString()
                                                ? double(parameter->choices.indexOf(value.toString()))
                                                : value.toDouble());
    }
    const QJsonObject bodies = file[QStringLiteral("bodies")].toObject();
    for (const QString &name : bodies.keys()) {
        const QJsonObject start = bodies[name].toObject();
        sim::BodyStart body{vec2(start, QStringLiteral("x"), QStringLiteral("y")), {}};
        if (start.contains(QStringLiteral("vx")))
            body.v = vec2(start, QStringLiteral("vx"), QStringLiteral("vy"));
        script.bodies[name.toStdString()] = body;
    }
    if (step.points == lessons::PointSource::file && !bodies.isEmpty())
        script.values.points = static_cast<int>(bodies.size());
    if (file.contains(QStringLiteral("links"))) {
        script.values.sticks.emplace();
        for (const QJsonValue &value : file[QStringLiteral("links")].toArray()) {
            const QJsonObject link = value.toObject();
            script.values.sticks->push_back(
                {pointNumber(link[QStringLiteral("a")]), pointNumber(link[QStringLiteral("b")]),
                 link[QStringLiteral("length")].toDouble(), link[QStringLiteral("share")].toDouble()});
        }
    }
    for (const QJsonValue &event : file[QStringLiteral("input")].toArray())
        script.input.push_back(readEvent(event.toObject()));
    return script;
}

std::vector<PublishedRow> readRows(const QByteArray &csv)
{
    std::vector<PublishedRow> rows;
    QList<QByteArray> lines = csv.split('\n');
    lines.removeFirst(); // the column names
    for (const QByteArray &line : lines) {
        const QList<QByteArray> cells = line.trimmed().split(',');
        if (cells.size() < 4)
            continue;
        PublishedRow row{cells[0].toLongLong(),
                         cells[1].toStdString(),
                         {cells[2].toDouble(), cells[3].toDouble()},
                         {},
                         {}};
        if (cells.size() == 6)
            row.v = {cells[4].toDouble(), cells[5].toDouble()};
        if (cells.size() == 5)
            row.angle = cells[4].toDouble();
        rows.push_back(row);
    }
    return rows;
}

double difference(sim::Vec2 a, sim::Vec2 b)
{
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}

}

QStringList publishedNames(const QString &lesson)
{
    QStringList names;
    for (const QFileInfo &file :
         QDir(folder).entryInfoList({lesson + QStringLiteral("-*.json")}, QDir::Files, QDir::Name))
        names << file.completeBaseName();
    return names;
}

PublishedRun readPublished(const QString &name, const LoadedLesson &lesson)
{
    const QJsonObject file =
        QJsonDocument::fromJson(contents(folder + name + QStringLiteral(".json"))).object();
    const QString step = file[QStringLiteral("step")].toString();
    return {step, readScript(file, lesson.step(step)),
            readRows(contents(folder + name + QStringLiteral(".csv")))};
}

double largestDifference(const PublishedRun &run)
{
    if (run.rows.empty())
        return std::numeric_limits<double>::infinity();
    sim::Timeline timeline(run.script);
    double largest = 0.0;
    for (const PublishedRow &row : run.rows) {
        timeline.seek({row.frame, 0});
        const int point = timeline.track().interval().scene.find(row.body);
        if (point < 0 || timeline.cursor().frame != row.frame)
            return std::numeric_limits<double>::infinity();
        const sim::State &now = timeline.state();
        largest = std::max(largest, difference(now.positionOf(point), row.x));
        if (row.v)
            largest = std::max(largest, difference(now.velocityOf(point), *row.v));
        if (row.angle)
            largest = std::max(largest, std::abs(now.angle[point] - *row.angle));
    }
    return largest;
}

void addPublishedRows(const QString &lesson)
{
    QTest::addColumn<QString>("name");
    for (const QString &name : publishedNames(lesson))
        QTest::addRow("%s", qPrintable(name)) << name;
}

void checkPublished(const LoadedLesson &lesson)
{
    QFETCH(QString, name);
    QVERIFY(largestDifference(readPublished(name, lesson)) <= 1e-9);
}

}
