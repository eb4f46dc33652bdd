#include "app/model/learning/concept_map.h"

#include "app/model/catalog/lists.h"
#include "app/model/text/phrases.h"
#include "lessons/api/text/document.h"

#include <QCoreApplication>
#include <QHash>

#include <algorithm>

namespace app {

namespace {

struct ConceptMapText
{
    Q_DECLARE_TR_FUNCTIONS(ConceptMapText)
};

/// A concept, and the number of its step, counted over all lessons.
struct TaughtConcept
{
    const LessonEntry *lesson = nullptr;
    const lessons::Step *step = nullptr;
    const lessons::Concept *content = nullptr;
    std::size_t number = 0;
};

std::vector<TaughtConcept> conceptsOf(const LessonLibrary &library)
{
    std::vector<TaughtConcept> all;
    std::size_t number = 0;
    for (std::size_t i = 0; i < library.entries(); ++i) {
        const LessonEntry &lesson = library.entry(i);
        for (const lessons::Step &step : lesson.steps) {
            for (const lessons::Concept &one : step.explanation.concepts)
                all.push_back({&lesson, &step, &one, number});
            ++number;
        }
    }
    return all;
}

/// Returns the index of the first concept with each id.
QHash<QString, std::size_t> indicesOf(const std::vector<TaughtConcept> &all)
{
    QHash<QString, std::size_t> indices;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!indices.contains(all[i].content->id))
            indices.insert(all[i].content->id, i);
    }
    return indices;
}

[[noreturn]] void reject(const lessons::Concept &one, const QString &why)
{
    throw lessons::DocumentError(one.file, one.line, why);
}

/// A topological order of the concepts: each comes after its prerequisites.
struct ConceptOrder
{
    std::vector<std::size_t> indices;
    std::vector<std::size_t> inCycles; ///< concepts that stand before one that they rest on
};

/// Returns the concepts that one rests on, as far as they are there and not taught later.
std::vector<std::size_t> earlierOnes(const TaughtConcept &one, const std::vector<TaughtConcept> &all,
                                     const QHash<QString, std::size_t> &indices)
{
    std::vector<std::size_t> found;
    for (const QString &id : one.content->restsOn) {
        const auto at = indices.find(id);
        if (at != indices.end() && all[*at].number <= one.number && all[*at].content != one.content &&
            !contains(found, *at))
            found.push_back(*at);
    }
    return found;
}

ConceptOrder orderOf(const std::vector<TaughtConcept> &all, const QHash<QString, std::size_t> &indices)
{
    ConceptOrder order;
    std::vector<bool> isPlaced(all.size(), false);
    const auto isReady = [&](std::size_t i) {
        const std::vector<std::size_t> earlier = earlierOnes(all[i], all, indices);
        return std::all_of(earlier.begin(), earlier.end(), [&](std::size_t one) { return isPlaced[one]; });
    };
    const auto isWaiting = [&](std::size_t i) { return !isPlaced[i] && indices[all[i].content->id] == i; };
    for (;;) {
        std::size_t first = all.size(), ready = all.size();
        for (std::size_t i = 0; i < all.size() && ready == all.size(); ++i) {
            if (!isWaiting(i))
                continue;
            first = std::min(first, i);
            if (isReady(i))
                ready = i;
        }
        if (first == all.size())
            return order;
        if (ready == all.size())
            order.inCycles.push_back(first);
        const std::size_t placed = ready < all.size() ? ready : first;
        order.indices.push_back(placed);
        isPlaced[placed] = true;
    }
}

}

ConceptMap::ConceptMap(const LessonLibrary &library)
{
    const std::vector<TaughtConcept> all = conceptsOf(library);
    const QHash<QString, std::size_t> indices = indicesOf(all);
    const ConceptOrder order = orderOf(all, indices);
    std::vector<std::size_t> placeOf(all.size(), all.size()); // in the order; behind all: not there
    for (std::size_t place = 0; place < order.indices.size(); ++place) {
        const std::size_t index = order.indices[place];
        const TaughtConcept &one = all[index];
        ConceptNode node{.id = one.content->id,
                         .title = one.content->title,
                         .text = one.content->text,
                         .lesson = one.lesson->id,
                         .step = one.step->id,
                         .where = labelled(one.lesson->title, one.step->title)};
        for (const std::size_t earlier : earlierOnes(one, all, indices)) {
            if (placeOf[earlier] >= place)
                continue; // a cycle
            node.restsOn.push_back(placeOf[earlier]);
            m_nodes[placeOf[earlier]].carries.push_back(place);
        }
        placeOf[index] = place;
        m_nodes.push_back(std::move(node));
    }
}

std::vector<ConceptState>
ConceptMap::states(const std::function<bool(const QString &lesson, const QString &step)> &isDone) const
{
    std::vector<ConceptState> states;
    for (const ConceptNode &node : m_nodes) {
        const bool canFollow = std::all_of(node.restsOn.begin(), node.restsOn.end(), [&](std::size_t one) {
            return states[one] == ConceptState::known;
        });
        if (isDone(node.lesson, node.step))
            states.push_back(ConceptState::known);
        else
            states.push_back(canFollow ? ConceptState::next : ConceptState::later);
    }
    return states;
}

void checkConcepts(const LessonLibrary &library)
{
    const std::vector<TaughtConcept> all = conceptsOf(library);
    const QHash<QString, std::size_t> indices = indicesOf(all);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const lessons::Concept &one = *all[i].content;
        if (indices[one.id] != i)
            reject(one, ConceptMapText::tr("the id “%1” is that of a concept in %2, too. Choose another one.")
                            .arg(one.id, all[indices[one.id]].content->file));
        for (const QString &id : one.restsOn) {
            const auto at = indices.find(id);
            if (at == indices.end())
                reject(one, ConceptMapText::tr("the concept “%1” rests on “%2”, which no step explains. Use "
                                               "the id of a concept, or remove it.")
                                .arg(one.id, id));
            if (all[*at].number > all[i].number)
                reject(one,
                       ConceptMapText::tr("the concept “%1” rests on “%2”, which comes later, in %3. Move "
                                          "one of them, or remove the id.")
                           .arg(one.id, id, all[*at].content->file));
        }
        if (one.restsOn.contains(one.id))
            reject(one, ConceptMapText::tr("the concept “%1” rests on itself. Remove its id from “Rests on”.")
                            .arg(one.id));
    }
    const ConceptOrder order = orderOf(all, indices);
    if (!order.inCycles.empty())
        reject(
            *all[order.inCycles.front()].content,
            ConceptMapText::tr("the concept “%1” rests on one that rests on it. Remove one of the two ids.")
                .arg(all[order.inCycles.front()].content->id));
}

}
