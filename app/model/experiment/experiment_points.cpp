#include "app/model/experiment/experiment_points.h"

#include "app/model/experiment/json_fields.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>

namespace app {

namespace {

struct ExperimentPointsText
{
    Q_DECLARE_TR_FUNCTIONS(ExperimentPointsText)
};

QString nameOf(int point)
{
    return QStringLiteral("p%1").arg(point);
}

/// Returns the number in the name of a point, or -1.
int numberOfPoint(const QString &name)
{
    bool isNumber = false;
    const int number = name.mid(1).toInt(&isNumber);
    return isNumber && name == nameOf(number) ? number : -1;
}

int endOf(const QString &file, const JsonFields &link, const QString &name, int points)
{
    const JsonValue &value = link.require(name, ExperimentPointsText::tr("a point's name"));
    const QString given = textOf(file, value, name);
    const int point = numberOfPoint(given);
    if (point < 0 || point >= points)
        refuse(file, value.line,
               ExperimentPointsText::tr("there is no point %1 here; there is \"p0\" to %2.")
                   .arg(quoted(given), quoted(nameOf(points - 1))));
    return point;
}

}

int countPoints(const QString &file, const JsonValue &bodies)
{
    const JsonFields fields(file, bodies, quoted("bodies"));
    const int count = static_cast<int>(fields.all().size());
    if (count > mostPoints)
        refuse(
            file, fields.line(),
            ExperimentPointsText::tr("\"bodies\" has %1 points; the most is %2.").arg(count).arg(mostPoints));
    for (const auto &[name, value] : fields.all()) {
        const int point = numberOfPoint(name);
        if (point < 0)
            refuse(file, value.line,
                   ExperimentPointsText::tr(
                       "there is no body %1 here; the points are called \"p0\", \"p1\" and so on.")
                       .arg(quoted(name)));
        if (point >= count)
            refuse(file, value.line,
                   ExperimentPointsText::tr("the points have a gap: %1 of them are \"p0\" to %2, without %3.")
                       .arg(QString::number(count), quoted(nameOf(count - 1)), quoted(name)));
    }
    return count;
}

std::vector<sim::Stick> readSticks(const QString &file, const JsonValue &links, int points)
{
    const JsonValue::List &list = listOf(file, links, "links");
    if (list.size() > std::size_t(mostSticks))
        refuse(file, links.line,
               ExperimentPointsText::tr("\"links\" has %1 sticks; the most is %2.")
                   .arg(list.size())
                   .arg(mostSticks));
    std::vector<sim::Stick> sticks;
    for (const JsonValue &value : list) {
        const JsonFields link(file, value, ExperimentPointsText::tr("a link"));
        link.refuseOthers({"a", "b", "length", "share"});
        sim::Stick stick;
        stick.a = endOf(file, link, "a", points);
        stick.b = endOf(file, link, "b", points);
        if (stick.a == stick.b)
            refuse(file, link.line(),
                   ExperimentPointsText::tr("a link has %1 at both ends; give it two points.")
                       .arg(quoted(nameOf(stick.a))));
        stick.length = link.number("length", built::length);
        stick.share = link.number("share", built::share, 0.5);
        sticks.push_back(stick);
    }
    return sticks;
}

}
