#pragma once

#include "app/model/catalog/lesson_library.h"

#include <QByteArray>
#include <QStringList>

#include <cstdint>
#include <vector>

namespace random_experiments {

/// Numbers that depend on a seed and a number of a trial alone, so that one trial can be drawn again by itself.
class Draw
{
public:
    Draw(std::uint64_t seed, std::uint64_t trial) : m_seed(seed), m_trial(static_cast<std::int64_t>(trial)) {}

    /// In [0, 1).
    double share();
    double real(double low, double high) { return low + (high - low) * share(); }
    /// 0 to n - 1.
    int below(int n) { return static_cast<int>(share() * n); }
    bool chance(double part) { return share() < part; }
    template <class List>
    const auto &of(const List &list)
    {
        return list[static_cast<typename List::size_type>(below(static_cast<int>(list.size())))];
    }

private:
    std::uint64_t m_seed;
    std::int64_t m_trial;
    std::int64_t m_index = 0;
};

/// The unchanged properties of a step, from which random experiments are drawn.
struct Known
{
    QString lesson;
    const lessons::Step *step = nullptr;
    QStringList bodies;
    QStringList effects;
    QStringList methods; ///< those that can compute it
};

/// Experiment files at random: any lesson, step and method, numbers in their ranges, at their ends and past them,
/// input of every kind, and what is no experiment at all.
class Experiments
{
public:
    /// `library` must outlive this.
    explicit Experiments(const app::LessonLibrary &library);

    /// The text of a file. The same draws give the same text.
    QByteArray text(Draw &draw) const;
    const std::vector<Known> &steps() const { return m_steps; }

private:
    std::vector<Known> m_steps;
    QStringList m_methods;
};

}
