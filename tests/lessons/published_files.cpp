#include "tests/lessons/published_files.h"

#include "sim/methods/methods.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

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

sim::Vec2 pair(const QJsonObject &object, const QString &first, const QString &second)
{
    return {object[first].toDouble(), object[second].toDouble()};
}

sim::Event readEvent(const QJsonObject &object)
{
    const std::int64_t frame = object[QStringLiteral("frame")].toInteger();
    const QString what = object[QStringLiteral("event")].toString();
    if (what == u"grab")
        return {frame, sim::Grab{object[QStringLiteral("body")].toString().toStdString()}};
    if (what == u"move")
        return {frame, sim::Move{pair(object, QStringLiteral("x"), QStringLiteral("y"))}};
    if (what == u"release")
        return {frame, sim::Release{}};
    throw std::runtime_error("unknown event " + what.toStdString());
}

sim::Script readScript(const QJsonObject &file, const lessons::Step &step)
{
    sim::Script script = step.script();
    script.method = sim::findMethod(file[QStringLiteral("method")].toString().toStdString());
    script.step = sim::StepSize::of(file[QStringLiteral("h")].toDouble());
    const QJsonObject parameters = file[QStringLiteral("parameters")].toObject();
    for (const QString &id : parameters.keys())
        script.values.set(id.toStdString(), parameters[id].toDouble());
    const QJsonObject bodies = file[QStringLiteral("bodies")].toObject();
    for (const QString &name : bodies.keys()) {
        const QJsonObject start = bodies[name].toObject();
        sim::BodyStart body{pair(start, QStringLiteral("x"), QStringLiteral("y")), {}};
        if (start.contains(QStringLiteral("vx")))
            body.v = pair(start, QStringLiteral("vx"), QStringLiteral("vy"));
        script.bodies[name.toStdString()] = body;
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
        if (cells.size() == 6)
            rows.push_back({cells[0].toLongLong(),
                            cells[1].toStdString(),
                            {cells[2].toDouble(), cells[3].toDouble()},
                            {cells[4].toDouble(), cells[5].toDouble()}});
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
        const int point = timeline.track().shown().scene.find(row.body);
        if (point < 0 || timeline.at().frame != row.frame)
            return std::numeric_limits<double>::infinity();
        largest = std::max({largest, difference(timeline.now().at(point), row.x),
                            difference(timeline.now().speed(point), row.v)});
    }
    return largest;
}

}
