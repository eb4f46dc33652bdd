#pragma once

#include "app/model/experiment/json_document.h"
#include "app/model/sandbox/blueprint_limits.h"

#include <QStringList>

#include <cstdint>
#include <optional>

namespace app {

/// A reader of a JSON object's fields that reports errors with file and line.
class JsonFields
{
public:
    /// `what` is the object's name in messages. `file` and `value` must outlive this object.
    /// @throws UserError: `value` is not an object
    JsonFields(const QString &file, const JsonValue &value, const QString &what);

    const JsonValue::Object &all() const { return *m_members; }
    int line() const { return m_line; }
    /// Returns the value called `name`, or null.
    const JsonValue *find(const QString &name) const;
    /// Returns the value called `name`. `possible` describes the valid values in messages.
    /// @throws UserError: the field is missing
    const JsonValue &require(const QString &name, const QString &possible) const;
    /// @throws UserError: a field is not in `known`; the message lists `known`
    void refuseOthers(const QStringList &known) const;
    /// Refuses the field `name`; if it is missing, the object.
    [[noreturn]] void refuse(const QString &name, const QString &why) const;

    // Each of these returns the value of the field `name`, and throws a UserError if the field has another type, lies outside
    // its bounds, or is missing although there is no `defaultValue`.

    double number(const QString &name) const;
    double number(const QString &name, Span span, std::optional<double> defaultValue = {}) const;
    std::int64_t integer(const QString &name, std::int64_t min, std::int64_t max,
                         std::int64_t defaultValue) const;
    bool boolean(const QString &name, std::optional<bool> defaultValue = {}) const;
    /// `possible` as for require().
    QString text(const QString &name, const QString &possible) const;
    QString optionalText(const QString &name) const;

private:
    QString m_file;
    QString m_what;
    const JsonValue::Object *m_members;
    int m_line;
};

/// @throws UserError: always, with file and line
[[noreturn]] void refuse(const QString &file, int line, const QString &why);

/// Returns the value as the given type. `name` is its name in messages.
/// @throws UserError: the value has another type
double numberOf(const QString &file, const JsonValue &value, const QString &name);
bool truthOf(const QString &file, const JsonValue &value, const QString &name);
QString textOf(const QString &file, const JsonValue &value, const QString &name);
const JsonValue::List &listOf(const QString &file, const JsonValue &value, const QString &name);
/// Returns the value as a whole number.
/// @throws UserError: not a whole number, or outside `min` to `max`
std::int64_t wholeOf(const QString &file, const JsonValue &value, const QString &name, std::int64_t min,
                     std::int64_t max);
/// Returns a short text for a value in messages.
QString shortText(const JsonValue &value);

}
