#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace lessons {

/// A place in a listing that a learner can be asked to write.
struct Gap
{
    QString id;
    int firstLine = 1; ///< in Listing::text, from 1
    int lineCount = 0; ///< at least 1
    friend bool operator==(const Gap &, const Gap &) = default;
};

/// A wrong way to write the code of a task that learners often choose.
struct NearMiss
{
    QString code;     ///< in place of the gap `gap`, without indentation
    QString sentence; ///< what it does instead, one or two sentences
    QString gap = {}; ///< empty: that of the task
};

/// A task to write a part of a listing. It is judged by its effect: the run has to agree with that of the listing.
struct CodeTask
{
    /// The id of a gap of the step's listing, or "frame": the whole listing.
    QString id;
    QString title;     ///< a few words: "the pull of the spring"
    QString text;      ///< Markdown, one or two short sentences
    QString comment;   ///< the comment in the empty place, one or more lines, without `//`
    QStringList hints; ///< Markdown, three; each tells more than the one before
    std::vector<NearMiss> nearMisses = {};

    /// Returns whether the learner starts from the empty page.
    bool isWholeFrame() const;
};

/// The program of a frame that a step shows, and its gaps.
struct Listing
{
    QString text; ///< empty if the step has none; otherwise it ends with a line break
    std::vector<Gap> gaps = {};
    QString lesson = {}; ///< the folder of the lesson whose translations have the comments; may be empty
    QStringList comments = {}; ///< those of the file, in English and without `//`; empty without a lesson

    bool isEmpty() const { return text.isEmpty(); }
    /// Returns the gap with this id. Null if there is none.
    const Gap *gap(const QString &id) const;
    /// Returns the code of a gap, without indentation; for "frame" the whole text. Empty if there is no such gap.
    QString solution(const QString &id) const;
    /// Returns the text with `code` in place of a gap, and as far indented. For "frame" returns `code`. An unknown
    /// gap returns the text.
    QString with(const QString &id, const QString &code) const;
    /// Returns the text with which a task begins: a comment in place of its gap, or an empty function `frame`, with an
    /// empty line where the learner writes.
    QString emptied(const CodeTask &task) const;
    /// Returns the line of emptied() where the learner writes, from 1. It has nothing but its indentation. 0 if there is
    /// no such gap.
    int lineToWrite(const CodeTask &task) const;
    /// Returns `code`, which a learner has made of this listing, with the comments of the listing in the language of the window.
    /// She may have written it in another language. Her own comments stay, and so do all lines and their numbers.
    QString inLanguageOfWindow(const QString &code) const;
};

/// Separates the text of a listing from its gaps. In `source` a line `//> id` stands before each gap and a line `//<`
/// after it. The text has neither.
/// @throws std::runtime_error if a gap is empty, has no end, begins inside another, or has the id of another
Listing parseListing(const QString &source);

/// Returns the listing `:/listings/LESSON/STEP.code` of the resources, with comments in the language of the window, from the
/// lesson's translations (context "listing"). Empty if there is none.
/// @throws std::runtime_error as parseListing()
Listing readListing(const QString &lesson, const QString &step);

}
