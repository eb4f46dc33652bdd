#pragma once

#include "sim/analysis/energy/stored_energy.h"
#include "sim/run/script/composed_intervals.h"

#include <QString>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// What can be measured of a run at any moment.
enum class Measured {
    time,          ///< frames
    placeX,        ///< px, to the right
    placeY,        ///< px, down
    velocityX,     ///< px/frame
    velocityY,     ///< px/frame, down
    speed,         ///< px/frame
    accelerationX, ///< px/frame^2: by how much the velocity changed in the frame before
    accelerationY, ///< the same, down
    acceleration,  ///< how large that is
    angle,         ///< degrees, clockwise from the x axis
    spin,          ///< degrees/frame
    ownMotion,     ///< kinetic energy of one body
    distance,      ///< px, to another body
    motion,        ///< kinetic energy of everything together: see sim::StoredEnergy, as for the next two
    stored,        ///< what springs hold and what lies high
    energy,        ///< both
};

/// What a quantity is about.
enum class About { run, oneBody, twoBodies };

/// A number that can be read off the states of a run.
struct Quantity
{
    Measured what = Measured::time;
    QString body = {};  ///< whose; empty: of the selected one
    QString other = {}; ///< of a distance, the other end
    friend bool operator==(const Quantity &, const Quantity &) = default;
};

/// All there are, in the order in which menus list them.
const std::vector<Measured> &allMeasured();
About aboutOf(Measured what);
/// How settings name it: lower case with underscores.
QString idOf(Measured what);
std::optional<Measured> measuredFrom(const QString &id);
/// Whether it grows downwards in the picture, so that the vertical axis of a plot does, too.
bool pointsDown(Measured what);
/// Whether it takes the state before, too.
bool comparesRows(Measured what);
/// The same quantity of the body called `selected`, where it does not name one.
Quantity boundTo(const Quantity &quantity, const QString &selected);

/// Why a quantity cannot be read off a scene.
enum class NoValue {
    noSuchBody,  ///< there is nothing of that name
    noInertia,   ///< the body has no velocity: something else puts it where it goes
    noAngle,     ///< nothing in the scene has an angle
    noEnergyHere ///< see sim::StoredEnergyReader::whyNot()
};
/// `quantity` must name its bodies.
std::optional<NoValue> whyNot(const Quantity &quantity, const sim::Scene &scene);

/// Reads some quantities off the states of one scene.
class QuantityReader
{
public:
    QuantityReader() = default;
    /// `quantities` must name their bodies.
    QuantityReader(std::vector<Quantity> quantities, std::shared_ptr<const sim::ComposedInterval> interval);

    const sim::ComposedInterval *segment() const { return m_interval.get(); }
    /// A moment of a run.
    struct Moment
    {
        const sim::State &now;
        const sim::State *before = nullptr; ///< where accelerations count from; null where there is none
        double frames = 1.0;                ///< from there to now
    };
    /// Writes one number a quantity; NaN where there is none.
    void read(const Moment &moment, std::span<double> into) const;

private:
    /// The numbers of the points that a quantity is about; -1 for what is not in the scene.
    struct Ends
    {
        int body = -1;
        int other = -1;
    };
    double valueOf(Measured what, Ends ends, const Moment &moment) const;
    double energyOf(Measured what, int point, const sim::State &state) const;

    std::vector<Quantity> m_quantities;
    std::vector<Ends> m_ends;
    std::shared_ptr<const sim::ComposedInterval> m_interval;
    std::optional<sim::StoredEnergyReader> m_reader; ///< set if an energy is read and the scene has one
};

}
