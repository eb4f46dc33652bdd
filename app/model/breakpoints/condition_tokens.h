#pragma once

#include <QString>

#include <vector>

namespace app {

/// A token of a condition.
struct ConditionToken
{
    enum class Kind {
        number,
        name, ///< "frame", "foot0.y"
        text, ///< the text between quotation marks
        sign, ///< "+", "<=", "(", and "and", "or", "not" in any spelling
        end,
    };
    Kind kind = Kind::end;
    QString text;
    double number = 0.0;
    qsizetype place = 0; ///< position of its first character, from 1
};

/// Returns the tokens of `text`, with `end` as the last one.
/// @throws UserError for an unknown character, a malformed number, or a text without a closing quotation mark
std::vector<ConditionToken> conditionWords(const QString &text);

}
