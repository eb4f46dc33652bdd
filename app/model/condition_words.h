#pragma once

#include <QString>

#include <vector>

namespace app {

/// A word of a condition.
struct ConditionWord
{
    enum class Kind {
        number,
        name, ///< "frame", "foot0.y"; and, or, not are names here
        text, ///< what stands in quotation marks
        sign, ///< "+", "<=", "(", and "and", "or", "not", however they are written
        end,
    };
    Kind kind = Kind::end;
    QString text;
    double number = 0.0;
    qsizetype place = 0; ///< of its first character, from 1
};

/// The words of `text`, an `end` last.
/// @throws Refusal for a character that no word begins with, a number that is none, a text that does not end
std::vector<ConditionWord> conditionWords(const QString &text);

}
