#pragma once

#include <QString>

#include <vector>

namespace lessons {

/// A glossary entry for a word that a step teaches.
struct Term
{
    QString name; ///< as the glossary lists it
    /// The forms in which texts use the word, separated by "|". They match upper and lower case. If empty,
    /// the glossary lists the word but texts do not link to it.
    QString forms;
    QString text; ///< Markdown, one to three sentences in plain words
};

/// A question about the mathematics of a step. The answer stays folded until a learner opens it.
struct Why
{
    QString question;
    QString answer; ///< Markdown; a formula is a separate paragraph in backticks, at most 33 characters
};

/// The texts of a step besides its narration.
struct Explanation
{
    /// One sentence for the summary of the lesson: what a learner knows after the step. May be empty.
    QString learnt = {};
    std::vector<Term> terms = {}; ///< terms that the step teaches
    std::vector<Why> whys = {};
};

}
