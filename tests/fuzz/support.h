#pragma once

#include "app/model/experiment.h"

#include <cstdio>
#include <cstdlib>

/// What the fuzzers share. A fault ends the program, which is how libFuzzer hears of it.
namespace fuzz {

inline const app::LessonLibrary &library()
{
    static const app::LessonLibrary all = app::LessonLibrary::load({LESSON_DIR});
    return all;
}

[[noreturn]] inline void fail(const char *what, const QString &text)
{
    std::fprintf(stderr, "%s: %s\n", what, text.toUtf8().constData());
    std::abort();
}

/// A refusal is one line of bounded length that ends as a sentence, whatever is in the input.
inline void check(const app::Refusal &refusal)
{
    constexpr qsizetype longest = 1200;
    const QString sentence = refusal.sentence();
    if (!sentence.endsWith('.') || sentence.size() > longest || app::escaped(sentence) != sentence)
        fail("Not a sentence", sentence);
}

/// An experiment that was read is written, and read again as the same.
inline void check(const app::Experiment &experiment)
{
    QByteArray text;
    try {
        text = app::experimentText(experiment, library());
    } catch (const app::Refusal &refusal) {
        check(refusal);
        return;
    }
    try {
        const app::Experiment again = app::parseExperiment(text, "again", library());
        if (app::experimentText(again, library()) != text)
            fail("Written otherwise the second time", QString::fromUtf8(text));
    } catch (const app::Refusal &refusal) {
        fail("Written and then refused", refusal.sentence() + '\n' + QString::fromUtf8(text));
    }
}

}
