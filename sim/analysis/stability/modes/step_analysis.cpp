#include "sim/analysis/stability/modes/step_analysis.h"

#include "sim/analysis/stability/limit.h"
#include "sim/analysis/stability/modes/step_map.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

using Complex = std::complex<double>;

constexpr double nearness = 1e-6; ///< of the stiffest: values nearer to each other than this are one
constexpr std::size_t mostProbed = 16;

/// The larger root s of s^2 + c s = lambda: how fast a swing of the motion itself grows, in 1/frame.
double ownRateOf(Complex lambda, double c)
{
    if (std::isinf(c))
        return 0.0;
    return std::max(0.0, (0.5 * (std::sqrt(c * c + 4.0 * lambda) - c)).real());
}

Spectrum slopesOf(const LinearisedScene &linearised)
{
    const State &start = linearised.scene.start;
    std::vector<int> place(static_cast<std::size_t>(2 * start.pointCount() + start.angle.rows()), -1);
    for (std::size_t i = 0; i < linearised.rows.size(); ++i)
        place[static_cast<std::size_t>(linearised.rows[i])] = static_cast<int>(i);
    std::vector<Jacobian::Entry> entries;
    for (const LinearPart &part : linearised.parts) {
        for (const Jacobian::Entry &one : part.entries) {
            const int row = place[static_cast<std::size_t>(one.row)];
            const int column = place[static_cast<std::size_t>(one.column)];
            if (row >= 0 && column >= 0)
                entries.push_back({row, column, one.value});
        }
    }
    return {static_cast<int>(linearised.rows.size()), [&](const Eigen::VectorXd &in, Eigen::VectorXd &out) {
                out.setZero(in.size());
                for (const Jacobian::Entry &one : entries)
                    out[one.row] += one.value * in[one.column];
            }};
}

/// The swings of a scene, one by one.
class ModalAnalysis : public StepAnalysis
{
public:
    ModalAnalysis(const LinearisedScene &linearised, const Method &method) : StepAnalysis(linearised, method)
    {
        // Of real ones the stiffest decides: it swings fastest, and all are slowed alike. What pushes apart grows in
        // the motion itself.
        bool anyReal = false;
        for (const std::size_t index : m_swings) {
            const Complex lambda = swing(index);
            const bool isReal = lambda.imag() == 0.0;
            if (isReal && (anyReal || lambda.real() > 0.0))
                continue;
            anyReal = anyReal || isReal;
            if (m_probed.size() < mostProbed)
                m_probed.push_back(index);
        }
    }
    double growth(double h) const override
    {
        double most = -INFINITY;
        for (const std::size_t index : m_probed)
            most = std::max(most, growthOf(index, h));
        return most;
    }
    double rounding() const override { return 1e-12; }
    double limit() const override
    {
        double least = INFINITY;
        for (const std::size_t index : m_probed) {
            const auto grows = [&](double h) { return growthOf(index, h); };
            least = std::min(least, findLimit(grows, std::sqrt(std::abs(swing(index))), rounding(), 1.08));
        }
        return least;
    }
    Mode dominantMode(double h) const override
    {
        if (m_probed.empty())
            return {};
        const std::size_t index =
            *std::max_element(m_probed.begin(), m_probed.end(),
                              [&](std::size_t a, std::size_t b) { return growthOf(a, h) < growthOf(b, h); });
        return {m_slopes.vector(index),
                modeSpectrum(m_method, swing(index), m_linearised.leastRate(), h).values().front()};
    }

private:
    double growthOf(std::size_t index, double h) const
    {
        const double c = m_linearised.leastRate();
        return std::log(modeSpectrum(m_method, swing(index), c, h).radius()) - h * ownRateOf(swing(index), c);
    }

    std::vector<std::size_t> m_probed;
};

/// One step of all of it.
class WholeSceneAnalysis : public StepAnalysis
{
public:
    using StepAnalysis::StepAnalysis;
    double growth(double h) const override { return std::log(spectrum(h).radius()) - h * ownRate(); }
    /// Where nothing slows a drift, its place and its velocity share one eigenvalue, and rounding moves such a pair by the
    /// root of its own size.
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

bool takesGroups(const Method &method)
{
    const std::vector<std::string> needs = method.requirements();
    return std::find(needs.begin(), needs.end(), "groups") != needs.end();
}

}

StepAnalysis::StepAnalysis(const LinearisedScene &linearised, const Method &method)
    : m_linearised(linearised), m_method(method), m_slopes(slopesOf(linearised))
{
    const std::vector<Complex> &values = m_slopes.values();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double near = nearness * std::abs(values.front());
        const auto isCopy = [&](std::size_t other) {
            return std::abs(values[other] - values[i]) <= near ||
                   std::abs(std::conj(values[other]) - values[i]) <= near;
        };
        if (std::abs(values[i]) <= near || std::any_of(m_swings.begin(), m_swings.end(), isCopy))
            continue;
        m_swings.push_back(i);
        m_ownRate = std::max(m_ownRate, ownRateOf(swing(i), linearised.leastRate()));
    }
}

std::complex<double> StepAnalysis::swing(std::size_t index) const
{
    const Complex value = m_slopes.values()[index];
    return std::abs(value.imag()) <= nearness * std::abs(value) ? Complex(value.real()) : value;
}

std::unique_ptr<StepAnalysis> stepAnalysisOf(const LinearisedScene &linearised, const Method &method)
{
    if (takesGroups(method) || !linearised.sameRate())
        return std::make_unique<WholeSceneAnalysis>(linearised, method);
    return std::make_unique<ModalAnalysis>(linearised, method);
}

}
