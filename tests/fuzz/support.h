#pragma once

#include "app/model/experiment/experiment.h"

#include <cstdio>
#include <cstdlib>

/// Shared by the fuzzers. They report a failure to libFuzzer by aborting the program.
namespace fuzz {

/// Returns the lessons of the release build.
inline const app::LessonLibrary &library()
{
    static const app::LessonLibrary all = app::LessonLibrary::load({LESSON_DIR});
    return all;
}

/// Prints `what` and `text`, and aborts.
[[noreturn]] inline void fail(const char *what, const QString &text)
{
    std::fprintf(stderr, "%s: %s\n", what, text.toUtf8().constData());
    std::abort();
}

/// Checks that a user error is a single line of bounded length that ends like a sentence, for any input.
inline void check(const app::UserError &error)
{
    constexpr qsizetype longest = 1200;
    const QString sentence = error.sentence();
    const bool isEnded = sentence.endsWith('.') || sentence.endsWith('?'); // "did you mean 'foot'?"
    if (!isEnded || sentence.size() > longest || app::escaped(sentence) != sentence)
        fail("Not a sentence", sentence);
}

/// Checks that an experiment is the same after writing and reading.
inline void check(const app::Experiment &experiment)
{
    QByteArray text;
    try {
        text = app::experimentText(experiment, library());
    } catch (const app::UserError &error) {
        check(error);
        return;
    }
    try {
        const app::Experiment again = app::parseExperiment(text, "again", library());
        if (app::experimentText(again, library()) != text)
            fail("Written otherwise the second time", QString::fromUtf8(text));
    } catch (const app::UserError &error) {
        fail("Written and then refused", error.sentence() + '\n' + QString::fromUtf8(text));
    }
}

}
