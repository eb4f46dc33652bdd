#pragma once

#include <QString>
#include <QStringList>

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

/// Something in the scene or among the parameters that a formula speaks of. Names are those of bodies, of parameters and
/// of places: see placeNamed().
struct Highlight
{
    enum class Kind {
        thing,    ///< the body, place or parameter `a`
        arrow,    ///< the arrow from `a` to `b`
        xSide,    ///< its part along the x axis, which begins at `a`
        ySide,    ///< its part along the y axis, which ends at `b`
        velocity, ///< of the body `a`
        circle,   ///< around `a`, with the parameter `b` as its radius
    };
    Kind kind = Kind::thing;
    QString a = {};
    QString b = {};
    friend bool operator==(const Highlight &, const Highlight &) = default;
};

/// A formula of an answer that highlights something.
struct Formula
{
    QString text; ///< without backticks and braces
    std::vector<Highlight> highlights = {};
    int line = 0; ///< of the document, from 1
};

/// A question about the mathematics of a step. The answer stays folded until a learner opens it.
struct Why
{
    QString question;
    QString answer; ///< Markdown; a formula is a separate paragraph in backticks, at most 33 characters
    std::vector<Formula> formulas = {}; ///< those of `answer` that highlight something, in order
};

/// An idea that a step teaches, for the map of concepts.
struct Concept
{
    static constexpr qsizetype longestTitle = 22; ///< characters

    QString id; ///< made of a to z, 0 to 9 and _. No other concept of any lesson has it.
    QString title;
    QString text = {};        ///< Markdown, one sentence
    QStringList restsOn = {}; ///< ids of concepts of this step or of earlier ones
    QString file = {};        ///< the name that errors show
    int line = 0;             ///< of its heading, from 1
};

/// The texts of a step besides its narration.
struct Explanation
{
    /// One sentence for the summary of the lesson: what a learner knows after the step. May be empty.
    QString learnt = {};
    std::vector<Term> terms = {}; ///< terms that the step teaches
    std::vector<Concept> concepts = {};
    std::vector<Why> whys = {};
};

}
