#pragma once

#include <QByteArray>
#include <QString>

#include <variant>
#include <vector>

namespace app {

struct JsonMember;

/// A number of a JSON text.
struct JsonNumber
{
    double value = 0.0;
    bool exact = true; ///< false: a whole number beyond 2^53, where doubles leave some out
};

/// A value of a JSON text, with the line that it stands on (where it begins, for a list or an object).
struct JsonValue
{
    using List = std::vector<JsonValue>;
    using Object = std::vector<JsonMember>; ///< in the order of the text; no two have one name

    std::variant<std::nullptr_t, bool, JsonNumber, QString, List, Object> what;
    int line = 1;
};

/// A named value in a JSON object.
struct JsonMember
{
    QString name;
    JsonValue value;
};

constexpr std::size_t mostJsonValues =
    2 << 20; ///< of one text; two hours of dragging, and a bound of the memory

/// Whether parseJson() takes as many values as this JSON text has; it may have a few less than are counted.
bool hasFewEnoughValues(const QByteArray &text);

/// Reads a JSON text in UTF-8, with or without a byte order mark. `name` is how messages call it.
/// @throws Refusal: not JSON, a number that is too large, a name twice in one object, too deep or too much
JsonValue parseJson(const QByteArray &text, const QString &name);

}
