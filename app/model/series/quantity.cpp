#include "app/model/series/quantity.h"

#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <array>
#include <limits>

namespace app {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Kind
{
    QuantityKind what;
    const char *id;
    About about;
};

constexpr std::array kinds = {
    Kind{QuantityKind::time, "time", About::run},
    Kind{QuantityKind::placeX, "x", About::oneBody},
    Kind{QuantityKind::placeY, "y", About::oneBody},
    Kind{QuantityKind::velocityX, "velocity_x", About::oneBody},
    Kind{QuantityKind::velocityY, "velocity_y", About::oneBody},
    Kind{QuantityKind::speed, "speed", About::oneBody},
    Kind{QuantityKind::accelerationX, "acceleration_x", About::oneBody},
    Kind{QuantityKind::accelerationY, "acceleration_y", About::oneBody},
    Kind{QuantityKind::acceleration, "acceleration", About::oneBody},
    Kind{QuantityKind::angle, "angle", About::oneBody},
    Kind{QuantityKind::spin, "spin", About::oneBody},
    Kind{QuantityKind::ownMotion, "own_motion", About::oneBody},
    Kind{QuantityKind::distance, "distance", About::twoBodies},
    Kind{QuantityKind::motion, "motion", About::run},
    Kind{QuantityKind::stored, "stored", About::run},
    Kind{QuantityKind::energy, "energy", About::run},
};

const Kind &kindOf(QuantityKind what)
{
    return *std::find_if(kinds.begin(), kinds.end(), [what](const Kind &kind) { return kind.what == what; });
}

bool isEnergy(QuantityKind what)
{
    return what == QuantityKind::ownMotion || what == QuantityKind::motion || what == QuantityKind::stored ||
           what == QuantityKind::energy;
}

bool isOfVelocity(QuantityKind what)
{
    return (what >= QuantityKind::velocityX && what <= QuantityKind::acceleration) ||
           what == QuantityKind::spin;
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

const std::vector<QuantityKind> &quantityKinds()
{
    static const std::vector<QuantityKind> all = [] {
        std::vector<QuantityKind> list;
        for (const Kind &kind : kinds)
            list.push_back(kind.what);
        return list;
    }();
    return all;
}

About aboutOf(QuantityKind what)
{
    return kindOf(what).about;
}

QString idOf(QuantityKind what)
{
    return QString::fromLatin1(kindOf(what).id);
}

std::optional<QuantityKind> quantityKindFrom(const QString &id)
{
    for (const Kind &kind : kinds) {
        if (id == QLatin1String(kind.id))
            return kind.what;
    }
    return std::nullopt;
}

bool pointsDown(QuantityKind what)
{
    return what == QuantityKind::placeY || what == QuantityKind::velocityY ||
           what == QuantityKind::accelerationY;
}

bool needsPreviousStep(QuantityKind what)
{
    return what >= QuantityKind::accelerationX && what <= QuantityKind::acceleration;
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
    const bool isAngle = quantity.what == QuantityKind::angle || quantity.what == QuantityKind::spin;
    const Eigen::ArrayXd &angles =
        quantity.what == QuantityKind::angle ? scene.start.angle : scene.start.spin;
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

double QuantityReader::valueOf(QuantityKind what, Ends ends, const Moment &moment) const
{
    const sim::State &now = moment.now;
    if (what == QuantityKind::time)
        return static_cast<double>(now.frame);
    if (isEnergy(what))
        return m_reader ? energyOf(what, ends.body, now) : none;
    if (ends.body < 0)
        return none;
    switch (what) {
    case QuantityKind::placeX:
        return now.positionOf(ends.body).x;
    case QuantityKind::placeY:
        return now.positionOf(ends.body).y;
    case QuantityKind::velocityX:
        return now.velocityOf(ends.body).x;
    case QuantityKind::velocityY:
        return now.velocityOf(ends.body).y;
    case QuantityKind::speed:
        return sim::length(now.velocityOf(ends.body));
    case QuantityKind::accelerationX:
        return change(moment, ends.body).x;
    case QuantityKind::accelerationY:
        return change(moment, ends.body).y;
    case QuantityKind::acceleration:
        return sim::length(change(moment, ends.body));
    case QuantityKind::angle:
        return angular(now.angle, ends.body);
    case QuantityKind::spin:
        return angular(now.spin, ends.body);
    case QuantityKind::distance:
        return ends.other < 0 ? none : sim::length(now.positionOf(ends.other) - now.positionOf(ends.body));
    default:
        return none;
    }
}

double QuantityReader::energyOf(QuantityKind what, int point, const sim::State &state) const
{
    switch (what) {
    case QuantityKind::ownMotion:
        return point < 0 ? none : m_reader->moving(state, point);
    case QuantityKind::motion:
        return m_reader->moving(state);
    case QuantityKind::stored:
        return m_reader->stored(state);
    default:
        return m_reader->read(state).total();
    }
}

}
