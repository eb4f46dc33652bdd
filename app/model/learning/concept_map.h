#pragma once

#include "app/model/catalog/lesson_library.h"

#include <QString>

#include <functional>
#include <vector>

namespace app {

/// A concept of the lessons, where it is taught, and what it rests on.
struct ConceptNode
{
    QString id;
    QString title;
    QString text;                          ///< Markdown, one sentence
    QString lesson;                        ///< id
    QString step;                          ///< id
    QString where;                         ///< "Single spring: A fixed centre"
    std::vector<std::size_t> restsOn = {}; ///< indices of nodes, all smaller than that of this one
    std::vector<std::size_t> carries = {}; ///< the nodes that rest on this one
};

/// How far a learner is with a concept.
enum class ConceptState {
    known, ///< its step is done
    next,  ///< all that it rests on is known
    later,
};

/// The concepts of all lessons, each after those that it rests on. Apart from that they have the order of the lessons.
class ConceptMap
{
public:
    /// Leaves out whatever checkConcepts() would report.
    explicit ConceptMap(const LessonLibrary &library);

    const std::vector<ConceptNode> &nodes() const { return m_nodes; }
    /// Returns the state of each node. `isDone` returns whether a step is done.
    std::vector<ConceptState>
    states(const std::function<bool(const QString &lesson, const QString &step)> &isDone) const;

private:
    std::vector<ConceptNode> m_nodes;
};

/// Checks that each concept has an id of its own, and rests only on concepts of its step or of earlier ones, without a cycle.
/// @throws lessons::DocumentError if not
void checkConcepts(const LessonLibrary &library);

}
