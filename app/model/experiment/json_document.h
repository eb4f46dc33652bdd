#pragma once

#include <QByteArray>
#include <QString>

#include <variant>
#include <vector>

namespace app {

struct JsonMember;

/// A number in a JSON text.
struct JsonNumber
{
    double value = 0.0;
    bool exact = true; ///< false for a whole number beyond 2^53, where a double may not be exact
};

/// A value in a JSON text with its line. For a list or an object, the line is where it begins.
struct JsonValue
{
    using List = std::vector<JsonValue>;
    using Object = std::vector<JsonMember>; ///< in the order of the text; names are unique

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
    2 << 20; ///< in one text: enough for two hours of dragging; limits the memory

/// Returns whether parseJson() accepts as many values as this JSON text has. The count may be slightly too high.
bool hasFewEnoughValues(const QByteArray &text);

/// Reads a JSON text in UTF-8, with or without a byte order mark. `name` is its name in messages.
/// @throws UserError: not JSON, a number that is too large, a name twice in one object, too deep or too many values
JsonValue parseJson(const QByteArray &text, const QString &name);

}
