#include "sim/analysis/stability/modes/step_analysis.h"

#include "sim/analysis/stability/limit.h"
#include "sim/analysis/stability/modes/step_map.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

using Complex = std::complex<double>;

constexpr double relativeTolerance = 1e-6; ///< of the stiffest: eigenvalues closer than this count as equal
constexpr std::size_t maxAnalysedModes = 16;

/// Returns the larger root s of s^2 + c s = lambda: the growth rate of a mode of the motion itself, 1/frame.
double motionGrowthRateOf(Complex lambda, double c)
{
    if (std::isinf(c))
        return 0.0;
    return std::max(0.0, (0.5 * (std::sqrt(c * c + 4.0 * lambda) - c)).real());
}

Spectrum jacobianSpectrum(const LinearisedScene &linearised)
{
    const State &start = linearised.scene.start;
    std::vector<int> indexOfRow(static_cast<std::size_t>(2 * start.pointCount() + start.angle.rows()), -1);
    for (std::size_t i = 0; i < linearised.rows.size(); ++i)
        indexOfRow[static_cast<std::size_t>(linearised.rows[i])] = static_cast<int>(i);
    std::vector<Jacobian::Entry> entries;
    for (const EffectJacobian &effectJacobian : linearised.effectJacobians) {
        for (const Jacobian::Entry &entry : effectJacobian.entries) {
            const int row = indexOfRow[static_cast<std::size_t>(entry.row)];
            const int column = indexOfRow[static_cast<std::size_t>(entry.column)];
            if (row >= 0 && column >= 0)
                entries.push_back({row, column, entry.value});
        }
    }
    return {static_cast<int>(linearised.rows.size()), [&](const Eigen::VectorXd &in, Eigen::VectorXd &out) {
                out.setZero(in.size());
                for (const Jacobian::Entry &entry : entries)
                    out[entry.row] += entry.value * in[entry.column];
            }};
}

/// Analyses the modes of a scene one by one.
class ModalAnalysis : public StepAnalysis
{
public:
    ModalAnalysis(const LinearisedScene &linearised, const Method &method) : StepAnalysis(linearised, method)
    {
        // Of the negative real eigenvalues only the stiffest counts: it oscillates fastest, and all have the
        // same damping. A positive one grows in the motion itself.
        bool anyReal = false;
        for (const std::size_t index : m_modes) {
            const Complex lambda = eigenvalue(index);
            const bool isReal = lambda.imag() == 0.0;
            if (isReal && (anyReal || lambda.real() > 0.0))
                continue;
            anyReal = anyReal || isReal;
            if (m_analysed.size() < maxAnalysedModes)
                m_analysed.push_back(index);
        }
    }
    double growth(double h) const override
    {
        double largest = -INFINITY;
        for (const std::size_t index : m_analysed)
            largest = std::max(largest, growthOf(index, h));
        return largest;
    }
    double rounding() const override { return 1e-12; }
    double limit() const override
    {
        double smallest = INFINITY;
        for (const std::size_t index : m_analysed) {
            const auto grows = [&](double h) { return growthOf(index, h); };
            smallest = std::min(smallest,
                                findLimit(grows, std::sqrt(std::abs(eigenvalue(index))), rounding(), 1.08));
        }
        return smallest;
    }
    Mode dominantMode(double h) const override
    {
        if (m_analysed.empty())
            return {};
        const std::size_t index =
            *std::max_element(m_analysed.begin(), m_analysed.end(),
                              [&](std::size_t a, std::size_t b) { return growthOf(a, h) < growthOf(b, h); });
        return {m_jacobian.vector(index),
                modeSpectrum(m_method, eigenvalue(index), m_linearised.minRate(), h).values().front()};
    }

private:
    double growthOf(std::size_t index, double h) const
    {
        const double c = m_linearised.minRate();
        return std::log(modeSpectrum(m_method, eigenvalue(index), c, h).radius()) -
               h * motionGrowthRateOf(eigenvalue(index), c);
    }

    std::vector<std::size_t> m_analysed;
};

/// Analyses one step of the whole scene.
class WholeSceneAnalysis : public StepAnalysis
{
public:
    using StepAnalysis::StepAnalysis;
    double growth(double h) const override { return std::log(spectrum(h).radius()) - h * motionGrowthRate(); }
    /// Without damping, the position and velocity of a drifting point share one eigenvalue. Rounding moves
    /// such a pair by its square root.
    double rounding() const override { return 1e-6; }
    double limit() const override
    {
        return findLimit([&](double h) { return growth(h); }, std::sqrt(stiffest()), rounding(), 1.25);
    }
    Mode dominantMode(double h) const override
    {
        const Spectrum found = spectrum(h);
        const auto rows = static_cast<Eigen::Index>(m_linearised.rows.size());
        return {found.vector(0).head(rows), found.values().front()};
    }

private:
    Spectrum spectrum(double h) const
    {
        return StepMap(m_linearised, m_method, h, std::sqrt(stiffest())).spectrum();
    }
};

bool computesGroups(const Method &method)
{
    const std::vector<std::string> needs = method.requirements();
    return std::find(needs.begin(), needs.end(), "groups") != needs.end();
}

}

StepAnalysis::StepAnalysis(const LinearisedScene &linearised, const Method &method)
    : m_linearised(linearised), m_method(method), m_jacobian(jacobianSpectrum(linearised))
{
    const std::vector<Complex> &values = m_jacobian.values();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double tolerance = relativeTolerance * std::abs(values.front());
        const auto isCopy = [&](std::size_t other) {
            return std::abs(values[other] - values[i]) <= tolerance ||
                   std::abs(std::conj(values[other]) - values[i]) <= tolerance;
        };
        if (std::abs(values[i]) <= tolerance || std::any_of(m_modes.begin(), m_modes.end(), isCopy))
            continue;
        m_modes.push_back(i);
        m_motionGrowthRate =
            std::max(m_motionGrowthRate, motionGrowthRateOf(eigenvalue(i), linearised.minRate()));
    }
}

std::complex<double> StepAnalysis::eigenvalue(std::size_t index) const
{
    const Complex value = m_jacobian.values()[index];
    return std::abs(value.imag()) <= relativeTolerance * std::abs(value) ? Complex(value.real()) : value;
}

std::unique_ptr<StepAnalysis> stepAnalysisOf(const LinearisedScene &linearised, const Method &method)
{
    if (computesGroups(method) || !linearised.hasUniformRate())
        return std::make_unique<WholeSceneAnalysis>(linearised, method);
    return std::make_unique<ModalAnalysis>(linearised, method);
}

}
