#include "app/model/quantity.h"

#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Kind
{
    Measured what;
    const char *id;
    About about;
};

constexpr std::array kinds = {
    Kind{Measured::time, "time", About::run},
    Kind{Measured::placeX, "x", About::oneBody},
    Kind{Measured::placeY, "y", About::oneBody},
    Kind{Measured::velocityX, "velocity_x", About::oneBody},
    Kind{Measured::velocityY, "velocity_y", About::oneBody},
    Kind{Measured::speed, "speed", About::oneBody},
    Kind{Measured::accelerationX, "acceleration_x", About::oneBody},
    Kind{Measured::accelerationY, "acceleration_y", About::oneBody},
    Kind{Measured::acceleration, "acceleration", About::oneBody},
    Kind{Measured::angle, "angle", About::oneBody},
    Kind{Measured::spin, "spin", About::oneBody},
    Kind{Measured::ownMotion, "own_motion", About::oneBody},
    Kind{Measured::distance, "distance", About::twoBodies},
    Kind{Measured::motion, "motion", About::run},
    Kind{Measured::stored, "stored", About::run},
    Kind{Measured::energy, "energy", About::run},
};

const Kind &kindOf(Measured what)
{
    return *std::find_if(kinds.begin(), kinds.end(), [what](const Kind &kind) { return kind.what == what; });
}

bool isEnergy(Measured what)
{
    return what == Measured::ownMotion || what == Measured::motion || what == Measured::stored ||
           what == Measured::energy;
}

bool isOfVelocity(Measured what)
{
    return (what >= Measured::velocityX && what <= Measured::acceleration) || what == Measured::spin;
}

sim::Vec2 change(const QuantityReader::Moment &moment, int point)
{
    if (!moment.before || moment.before->pointCount() != moment.now.pointCount())
        return {none, none};
    return (moment.now.velocityOf(point) - moment.before->velocityOf(point)) / moment.frames;
}

double angular(const Eigen::ArrayXd &values, int point)
{
    return point < values.rows() ? values[point] : none;
}

}

const std::vector<Measured> &allMeasured()
{
    static const std::vector<Measured> all = [] {
        std::vector<Measured> list;
        for (const Kind &kind : kinds)
            list.push_back(kind.what);
        return list;
    }();
    return all;
}

About aboutOf(Measured what)
{
    return kindOf(what).about;
}

QString idOf(Measured what)
{
    return QString::fromLatin1(kindOf(what).id);
}

std::optional<Measured> measuredFrom(const QString &id)
{
    for (const Kind &kind : kinds) {
        if (id == QLatin1String(kind.id))
            return kind.what;
    }
    return std::nullopt;
}

bool pointsDown(Measured what)
{
    return what == Measured::placeY || what == Measured::velocityY || what == Measured::accelerationY;
}

bool comparesRows(Measured what)
{
    return what >= Measured::accelerationX && what <= Measured::acceleration;
}

Quantity boundTo(const Quantity &quantity, const QString &selected)
{
    Quantity bound = quantity;
    if (aboutOf(quantity.what) != About::run && quantity.body.isEmpty())
        bound.body = selected;
    return bound;
}

std::optional<NoValue> whyNot(const Quantity &quantity, const sim::Scene &scene)
{
    const About about = aboutOf(quantity.what);
    const int body = about == About::run ? -1 : scene.find(quantity.body.toStdString());
    if (about != About::run && body < 0)
        return NoValue::noSuchBody;
    if (about == About::twoBodies && scene.find(quantity.other.toStdString()) < 0)
        return NoValue::noSuchBody;
    const bool isAngle = quantity.what == Measured::angle || quantity.what == Measured::spin;
    const Eigen::ArrayXd &angles = quantity.what == Measured::angle ? scene.start.angle : scene.start.spin;
    if (isAngle && angles.rows() == 0)
        return NoValue::noAngle;
    if (isOfVelocity(quantity.what) && !scene.movesByVelocity(body))
        return NoValue::noInertia;
    if (isEnergy(quantity.what) && sim::StoredEnergyReader::whyNot(scene))
        return NoValue::noEnergyHere;
    return std::nullopt;
}

QuantityReader::QuantityReader(std::vector<Quantity> quantities,
                               std::shared_ptr<const sim::ComposedInterval> interval)
    : m_quantities(std::move(quantities)), m_interval(std::move(interval))
{
    const sim::Scene &scene = m_interval->scene;
    for (const Quantity &quantity : m_quantities) {
        Ends ends;
        if (!whyNot(quantity, scene)) {
            ends.body = scene.find(quantity.body.toStdString());
            ends.other = scene.find(quantity.other.toStdString());
            if (isEnergy(quantity.what) && !m_reader)
                m_reader.emplace(scene);
        }
        m_ends.push_back(ends);
    }
}

void QuantityReader::read(const Moment &moment, std::span<double> into) const
{
    for (std::size_t i = 0; i < m_quantities.size(); ++i)
        into[i] = valueOf(m_quantities[i].what, m_ends[i], moment);
}

double QuantityReader::valueOf(Measured what, Ends ends, const Moment &moment) const
{
    const sim::State &now = moment.now;
    if (what == Measured::time)
        return static_cast<double>(now.frame);
    if (isEnergy(what))
        return m_reader ? energyOf(what, ends.body, now) : none;
    if (ends.body < 0)
        return none;
    switch (what) {
    case Measured::placeX:
        return now.positionOf(ends.body).x;
    case Measured::placeY:
        return now.positionOf(ends.body).y;
    case Measured::velocityX:
        return now.velocityOf(ends.body).x;
    case Measured::velocityY:
        return now.velocityOf(ends.body).y;
    case Measured::speed:
        return sim::length(now.velocityOf(ends.body));
    case Measured::accelerationX:
        return change(moment, ends.body).x;
    case Measured::accelerationY:
        return change(moment, ends.body).y;
    case Measured::acceleration:
        return sim::length(change(moment, ends.body));
    case Measured::angle:
        return angular(now.angle, ends.body);
    case Measured::spin:
        return angular(now.spin, ends.body);
    case Measured::distance:
        return ends.other < 0 ? none : sim::length(now.positionOf(ends.other) - now.positionOf(ends.body));
    default:
        return none;
    }
}

double QuantityReader::energyOf(Measured what, int point, const sim::State &state) const
{
    switch (what) {
    case Measured::ownMotion:
        return point < 0 ? none : m_reader->moving(state, point);
    case Measured::motion:
        return m_reader->moving(state);
    case Measured::stored:
        return m_reader->stored(state);
    default:
        return m_reader->read(state).total();
    }
}

}
