#include "app/model/analysis/representative_methods.h"

#include "app/model/catalog/lists.h"
#include "sim/pipeline/method.h"

#include <algorithm>

namespace app {

namespace {

/// Returns the most accurate row of each method, most accurate method first.
std::vector<const sim::AccuracyRow *> byExactness(const sim::Accuracy &accuracy)
{
    std::vector<const sim::AccuracyRow *> best;
    for (const sim::AccuracyRow &row : accuracy.rows) {
        if (row.outcome != sim::Outcome::measured)
            continue;
        const auto same = std::find_if(best.begin(), best.end(), [&](const sim::AccuracyRow *one) {
            return one->setup.method->id() == row.setup.method->id();
        });
        if (same == best.end())
            best.push_back(&row);
        else if (row.error < (*same)->error)
            *same = &row;
    }
    std::stable_sort(best.begin(), best.end(), [](const sim::AccuracyRow *a, const sim::AccuracyRow *b) {
        return a->error < b->error;
    });
    return best;
}

}

std::vector<std::string> representativeMethods(const sim::Accuracy &accuracy, const std::string &own,
                                               double target)
{
    std::vector<std::string> chosen = {own};
    std::set<int> orders;
    for (const sim::AccuracyRow &row : accuracy.rows) {
        if (row.setup.method->id() == own)
            orders.insert(row.setup.method->order());
    }
    const auto add = [&](const sim::Method &method) {
        const bool isNew = !contains(chosen, method.id());
        if (isNew && chosen.size() < mostRepresentative) {
            chosen.push_back(method.id());
            orders.insert(method.order());
        }
    };
    if (const sim::AccuracyRow *cheapest = accuracy.cheapest(target))
        add(*cheapest->setup.method);
    const std::vector<const sim::AccuracyRow *> exact = byExactness(accuracy);
    if (!exact.empty())
        add(*exact.front()->setup.method);
    for (const sim::AccuracyRow *row : exact) {
        if (orders.count(row->setup.method->order()) == 0)
            add(*row->setup.method);
    }
    for (const sim::AccuracyRow *row : exact)
        add(*row->setup.method);
    return chosen;
}

}
