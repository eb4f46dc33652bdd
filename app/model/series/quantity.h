#pragma once

#include "sim/analysis/energy/stored_energy.h"
#include "sim/run/script/composed_intervals.h"

#include <QString>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// A kind of number that can be measured at any moment of a run.
enum class QuantityKind {
    time,          ///< frames
    placeX,        ///< px, to the right
    placeY,        ///< px, down
    velocityX,     ///< px/frame
    velocityY,     ///< px/frame, down
    speed,         ///< px/frame
    accelerationX, ///< px/frame^2: change of the velocity over the previous frame
    accelerationY, ///< the same, down
    acceleration,  ///< magnitude of the acceleration
    angle,         ///< degrees, clockwise from the x axis
    spin,          ///< degrees/frame
    ownMotion,     ///< kinetic energy of one body
    distance,      ///< px, to another body
    motion,        ///< kinetic energy of all bodies: see sim::StoredEnergy, as for the next two
    stored,        ///< energy stored in springs and by height
    energy,        ///< sum of `motion` and `stored`
};

/// The objects that a quantity describes.
enum class About { run, oneBody, twoBodies };

/// A number that can be read from the states of a run.
struct Quantity
{
    QuantityKind what = QuantityKind::time;
    QString body = {};  ///< name of the body; empty: the selected one
    QString other = {}; ///< for a distance, the other end
    friend bool operator==(const Quantity &, const Quantity &) = default;
};

/// Returns all kinds, in the order of the menus.
const std::vector<QuantityKind> &quantityKinds();
About aboutOf(QuantityKind what);
/// Returns the name used in settings: lower case with underscores.
QString idOf(QuantityKind what);
std::optional<QuantityKind> quantityKindFrom(const QString &id);
/// Returns whether the quantity grows downwards on screen. The vertical axis of its plot then points down, too.
bool pointsDown(QuantityKind what);
/// Returns whether the quantity also needs the previous state.
bool needsPreviousStep(QuantityKind what);
/// Returns the quantity with the body `selected` if it does not name one.
Quantity boundTo(const Quantity &quantity, const QString &selected);

/// The reason why a quantity cannot be read in a scene.
enum class NoValue {
    noSuchBody,  ///< no body has that name
    noInertia,   ///< the body has no velocity: its position is set from outside
    noAngle,     ///< nothing in the scene has an angle
    noEnergyHere ///< see sim::StoredEnergyReader::whyNot()
};
/// Returns why `quantity` cannot be read in `scene`; empty if it can. It must name its bodies.
std::optional<NoValue> whyNot(const Quantity &quantity, const sim::Scene &scene);

/// Reads quantities from the states of one scene.
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
        const sim::State *before =
            nullptr;         ///< state from which accelerations are computed; null if there is none
        double frames = 1.0; ///< frames from `before` to `now`
    };
    /// Writes one number per quantity. NaN marks missing values.
    void read(const Moment &moment, std::span<double> into) const;

private:
    /// The point indices of a quantity's bodies; -1 for a body that is not in the scene.
    struct Ends
    {
        int body = -1;
        int other = -1;
    };
    double valueOf(QuantityKind what, Ends ends, const Moment &moment) const;
    double energyOf(QuantityKind what, int point, const sim::State &state) const;

    std::vector<Quantity> m_quantities;
    std::vector<Ends> m_ends;
    std::shared_ptr<const sim::ComposedInterval> m_interval;
    std::optional<sim::StoredEnergyReader> m_reader; ///< set if an energy is read and the scene has one
};

}
