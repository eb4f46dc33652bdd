#pragma once

#include "app/model/json_document.h"

#include <QStringList>

#include <cstdint>

namespace app {

/// Reads the fields of a JSON object and refuses what is wrong, with file and line.
class JsonFields
{
public:
    /// `what` is how messages call the object. Both arguments must outlive this.
    /// @throws Refusal when `value` is not an object
    JsonFields(const QString &file, const JsonValue &value, const QString &what);

    const JsonValue::Object &all() const { return *m_members; }
    int line() const { return m_line; }
    /// The value called `name`, or null.
    const JsonValue *find(const QString &name) const;
    /// The value called `name`. @throws Refusal: missing; `possible` says what it can be
    const JsonValue &require(const QString &name, const QString &possible) const;
    /// @throws Refusal for a field that is not in `known`, listing those
    void refuseOthers(const QStringList &known) const;
    /// A number called `name`; required.
    double number(const QString &name) const;

private:
    QString m_file;
    QString m_what;
    const JsonValue::Object *m_members;
    int m_line;
};

/// @throws Refusal with file and line
[[noreturn]] void refuse(const QString &file, int line, const QString &why);

/// The value as a type. `name` is how messages call it. @throws Refusal for other types
double numberOf(const QString &file, const JsonValue &value, const QString &name);
bool truthOf(const QString &file, const JsonValue &value, const QString &name);
QString textOf(const QString &file, const JsonValue &value, const QString &name);
const JsonValue::List &listOf(const QString &file, const JsonValue &value, const QString &name);
/// A whole number. @throws Refusal also when it is outside `min` to `max`
std::int64_t wholeOf(const QString &file, const JsonValue &value, const QString &name, std::int64_t min,
                     std::int64_t max);
/// How messages write a value: short.
QString shortText(const JsonValue &value);

}
