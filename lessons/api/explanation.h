#pragma once

#include <QString>

#include <vector>

namespace lessons {

/// A word that a step teaches, for the glossary.
struct Term
{
    QString name; ///< as the glossary lists it
    /// How it stands in texts, each form once, separated by "|"; a capital letter in a text does not matter. Empty: it
    /// is only listed.
    QString forms;
    QString text; ///< Markdown, one to three sentences in the learner's words
};

/// A question about the mathematics of a step, and its answer, which stays folded until a learner asks.
struct Why
{
    QString question;
    QString answer; ///< Markdown; a formula is a paragraph of its own, in backticks, of at most 33 letters
};

/// What a step tells besides its narration.
struct Explanation
{
    /// What a learner knows afterwards: one sentence, for the summary of the lesson; may be empty.
    QString learnt = {};
    std::vector<Term> terms = {}; ///< that are taught here
    std::vector<Why> whys = {};
};

}
