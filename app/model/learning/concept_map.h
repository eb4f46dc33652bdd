#pragma once

#include "app/model/catalog/lesson_library.h"

#include <QString>

#include <functional>
#include <vector>

namespace app {

/// A concept, the step that teaches it, and the concepts that it rests on.
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

/// The concepts of all lessons in topological order. Otherwise they keep the order of the lessons.
class ConceptMap
{
public:
    /// Leaves out concepts and edges that checkConcepts() would refuse.
    explicit ConceptMap(const LessonLibrary &library);

    const std::vector<ConceptNode> &nodes() const { return m_nodes; }
    /// Returns the state of each node. `isDone` returns whether a step is done.
    std::vector<ConceptState>
    states(const std::function<bool(const QString &lesson, const QString &step)> &isDone) const;

private:
    std::vector<ConceptNode> m_nodes;
};

/// Checks that ids are unique, and that a concept rests only on concepts of its step or of earlier steps, without cycles.
/// @throws lessons::DocumentError if not
void checkConcepts(const LessonLibrary &library);

}
