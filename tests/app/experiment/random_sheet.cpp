#include "tests/app/experiment/random_sheet.h"

#include "sim/methods/methods.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace random_experiments {

namespace {

const std::vector<QByteArray> noNumbers = {"null",  "true",   "\"1\"", "[]",   "{}", "NaN",  "-Infinity",
                                           "1e999", "-1e999", "01",    "0x10", "1.", "\"\"", ""};

constexpr double infinite = std::numeric_limits<double>::infinity();

QByteArray text(double number)
{
    return QByteArray::number(number, 'g', 17);
}

QByteArray quoted(const QString &text)
{
    return '"' + text.toUtf8() + '"';
}

/// The text of one random experiment while it is written.
class Sheet
{
public:
    /// `wrong` is the share of values that are drawn out of their range.
    Sheet(Draw &draw, const Known &known, const QStringList &methods, double wrong)
        : m_draw(draw), m_known(known), m_methods(methods), m_wrong(wrong)
    {
    }

    QByteArray write()
    {
        field("format", errs() ? "\"springstep-experiment/2\"" : "\"springstep-experiment/1\"");
        field("lesson", quoted(errs() ? QStringLiteral("nowhere") : m_known.lesson));
        field("step", quoted(errs() ? QStringLiteral("drag") : m_known.step->id));
        method();
        if (m_draw.chance(0.8))
            field("frames", whole(1, 400));
        if (m_draw.chance(0.3))
            field("seed", whole(0, 1e6));
        parameters();
        bodies();
        links();
        effects();
        input();
        if (errs())
            field("colour", "3");
        return '{' + m_fields.join(",\n") + '}';
    }

private:
    bool errs() { return m_draw.chance(m_wrong); }

    void field(const char *name, const QByteArray &value)
    {
        m_fields.push_back('"' + QByteArray(name) + "\": " + value);
    }

    /// Returns a number from `low` to `high`, often one of the two; or a value out of this range, or not a number.
    QByteArray number(double low, double high)
    {
        if (errs()) {
            const QByteArray past[] = {text(std::nextafter(high, infinite)),
                                       text(std::nextafter(low, -infinite)),
                                       text(high + 1.0),
                                       text(low - 1.0),
                                       m_draw.of(extremes()),
                                       m_draw.of(noNumbers)};
            return past[m_draw.below(6)];
        }
        const double reach = high - low;
        const double inside[] = {low, high, low + reach * std::pow(10.0, m_draw.real(-9.0, 0.0)),
                                 m_draw.real(low, high), m_draw.real(low, high)};
        return text(inside[m_draw.below(5)]);
    }

    QByteArray whole(double low, double high)
    {
        return errs() ? number(low, high) : text(std::floor(m_draw.real(low, high + 1.0)));
    }

    /// Returns one component of a position or a velocity: any number.
    QByteArray coordinate()
    {
        if (m_draw.chance(0.1))
            return m_draw.of(extremes());
        return m_draw.chance(0.2) ? QByteArray("200") : number(-100.0, 700.0);
    }

    QByteArray place() { return "\"x\": " + coordinate() + ", \"y\": " + coordinate(); }

    QByteArray value(const lessons::Parameter &parameter)
    {
        if (!parameter.choices.isEmpty())
            return errs() ? m_draw.of(noNumbers) : quoted(m_draw.of(parameter.choices));
        // Counts decide how much work a frame is: mostly few.
        if (parameter.isInteger) {
            const double most = parameter.scale == lessons::Scale::logarithmic ? 1000.0 : parameter.max;
            return whole(parameter.min, m_draw.chance(0.05) ? most : std::min(most, parameter.min + 12));
        }
        return m_draw.chance(0.5) ? number(parameter.sliderMin, parameter.sliderMax)
                                  : number(parameter.min, parameter.max);
    }

    void method()
    {
        const auto all = sim::allMethods();
        std::string id = m_known.step->method.toStdString();
        if (m_draw.chance(0.7)) {
            const bool any = m_known.methods.isEmpty() || errs();
            const QString drawn = m_draw.of(any ? m_methods : m_known.methods);
            id = drawn.toStdString();
            field("method", quoted(errs() ? QStringLiteral("magic") : drawn));
        }
        const bool adaptive = sim::findMethod(id)->stepping() == sim::Stepping::adaptive;
        if (m_draw.chance(0.5) || errs()) {
            static const std::vector<QByteArray> steps = {"1", "0.5", "0.25", "0.1", "0.3333333333333333",
                                                          "2", "7",   "100",  "1",   "0.000001"};
            if (adaptive != errs())
                field("tolerance", errs() ? number(1e-13, 100.0) : text(std::pow(10.0, m_draw.real(-13, 2))));
            else
                field("h", errs() ? number(1e-6, 100.0) : m_draw.of(steps));
        }
    }

    void parameters()
    {
        QByteArrayList entries;
        for (const lessons::Parameter &parameter : m_known.step->parameters) {
            if (m_draw.chance(0.35))
                entries.push_back(quoted(parameter.id) + ": " + value(parameter));
        }
        if (errs())
            entries.push_back("\"gravitas\": 1");
        if (!entries.isEmpty())
            field("parameters", '{' + entries.join(", ") + '}');
    }

    bool takesPoints() const { return m_known.step->points == lessons::PointSource::file; }

    void bodies()
    {
        if (!m_draw.chance(0.4))
            return;
        QStringList names = m_known.bodies;
        if (takesPoints()) {
            names.clear();
            m_points = m_draw.chance(0.03) ? 2 + m_draw.below(200) : 2 + m_draw.below(8);
            for (int i = 0; i < m_points; ++i)
                names.push_back(QStringLiteral("p%1").arg(errs() ? i + 1 : i));
        }
        QByteArrayList entries;
        for (const QString &name : names) {
            if (entries.size() >= 200 || (!takesPoints() && !m_draw.chance(0.4)))
                continue;
            const QByteArray vx = m_draw.chance(0.4) ? ", \"vx\": " + coordinate() : QByteArray();
            const QByteArray vy = m_draw.chance(0.4) ? ", \"vy\": " + coordinate() : QByteArray();
            entries.push_back(quoted(errs() ? QStringLiteral("tail9") : name) + ": {" + place() + vx + vy +
                              '}');
        }
        field("bodies", '{' + entries.join(",\n ") + '}');
    }

    void links()
    {
        const bool wanted = takesPoints() && m_draw.chance(0.7);
        if (!wanted && !errs())
            return;
        const int points = m_points > 0 ? m_points : std::max(2, int(m_known.bodies.size()));
        QByteArrayList entries;
        for (int i = m_draw.below(2 * std::min(points, 30)); i > 0; --i) {
            const int a = m_draw.below(points);
            const int b = errs() ? a : (a + 1 + m_draw.below(points - 1)) % points;
            entries.push_back("{\"a\": \"p" + QByteArray::number(a) + "\", \"b\": \"p" +
                              QByteArray::number(b) + "\", \"length\": " + number(0.0, 1e6) +
                              (m_draw.chance(0.5) ? ", \"share\": " + number(0.0, 1.0) : QByteArray()) + '}');
        }
        field("links", '[' + entries.join(",\n ") + ']');
    }

    void effects()
    {
        if (m_known.effects.isEmpty() || !m_draw.chance(0.2))
            return;
        QByteArrayList ids;
        for (const QString &id : m_known.effects) {
            if (m_draw.chance(0.3))
                ids.push_back(quoted(id));
        }
        if (errs())
            ids.push_back("\"magnet\"");
        field("effects", '[' + ids.join(", ") + ']');
    }

    QByteArray dragEvents()
    {
        const bool points = m_points > 0;
        if (!m_holds || m_draw.chance(0.1)) {
            m_holds = !errs();
            QString body = points                     ? QStringLiteral("p%1").arg(m_draw.below(m_points))
                           : m_known.bodies.isEmpty() ? QStringLiteral("body")
                                                      : m_draw.of(m_known.bodies);
            return "\"grab\", \"body\": " + quoted(errs() ? QStringLiteral("nobody") : body);
        }
        if (m_draw.chance(0.7))
            return "\"move\", " + place();
        m_holds = errs();
        return "\"release\"";
    }

    QByteArray happening()
    {
        const auto may = [this](lessons::Interaction what) { return m_known.step->accepts(what) || errs(); };
        const auto truth = [this] { return m_draw.chance(0.5) ? "true" : "false"; };
        switch (m_draw.below(7)) {
        case 0:
            if (may(lessons::Interaction::pointer))
                return "\"pointer\", " + place() + ", \"down\": " + truth();
            break;
        case 1:
            if (may(lessons::Interaction::target))
                return "\"target\", " + place();
            break;
        case 2:
            if (may(lessons::Interaction::gust))
                return "\"gust\", \"degrees\": " + coordinate();
            break;
        case 3:
            if (may(lessons::Interaction::keys))
                return QByteArray("\"key\", \"key\": \"") + m_draw.of(std::vector<QByteArray>{"left", "up"}) +
                       "\", \"down\": " + truth();
            break;
        case 4:
            if (!m_known.step->parameters.empty()) {
                const lessons::Parameter &parameter = m_draw.of(m_known.step->parameters);
                return "\"set\", \"parameter\": " + quoted(parameter.id) + ", \"value\": " + value(parameter);
            }
            break;
        default:
            break;
        }
        return may(lessons::Interaction::drag) ? dragEvents() : QByteArray();
    }

    void input()
    {
        if (!m_draw.chance(0.7))
            return;
        QByteArrayList entries;
        double frame = 0.0;
        for (int i = m_draw.below(12); i > 0; --i) {
            frame += std::floor(std::pow(m_draw.real(0.0, 4.0), 3.0));
            const QByteArray what = happening();
            if (!what.isEmpty())
                entries.push_back("{\"frame\": " + (errs() ? number(0.0, 300.0) : text(frame)) +
                                  ", \"event\": " + what + '}');
        }
        field("input", '[' + entries.join(",\n ") + ']');
    }

    Draw &m_draw;
    const Known &m_known;
    const QStringList &m_methods;
    double m_wrong;
    int m_points = 0; ///< that the file gives; 0: the step's own
    bool m_holds = false;
    QByteArrayList m_fields;
};

}

const std::vector<QByteArray> &extremes()
{
    static const std::vector<QByteArray> all = {"0",     "-0",     "5e-324", "1e-300", "1e-9",
                                                "-1e6",  "1e9",    "-1e12",  "1e100",  "-1e154",
                                                "1e200", "-1e300", "1.7e308"};
    return all;
}

QByteArray sheet(Draw &draw, const Known &known, const QStringList &methods, double wrong)
{
    return Sheet(draw, known, methods, wrong).write();
}

}
