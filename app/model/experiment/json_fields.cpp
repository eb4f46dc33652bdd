#include "app/model/experiment/json_fields.h"

#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct JsonFieldsText
{
    Q_DECLARE_TR_FUNCTIONS(JsonFieldsText)
};

/// @throws UserError: the value has the wrong type
[[noreturn]] void refuseType(const QString &file, const JsonValue &value, const QString &name,
                             const QString &expected)
{
    refuse(file, value.line,
           JsonFieldsText::tr("%1 is %2; it must be %3.").arg(quoted(name), shortText(value), expected));
}

}

void refuse(const QString &file, int line, const QString &why)
{
    throw UserError(JsonFieldsText::tr("%1: line %2: %3").arg(shownPath(file), QString::number(line), why));
}

QString shortText(const JsonValue &value)
{
    if (const bool *yes = std::get_if<bool>(&value.what))
        return *yes ? QStringLiteral("true") : QStringLiteral("false");
    if (const JsonNumber *number = std::get_if<JsonNumber>(&value.what))
        return exactNumber(number->value);
    if (const QString *text = std::get_if<QString>(&value.what))
        return JsonFieldsText::tr("the text %1").arg(quoted(*text));
    if (std::holds_alternative<JsonValue::List>(value.what))
        return JsonFieldsText::tr("a list");
    if (std::holds_alternative<JsonValue::Object>(value.what))
        return JsonFieldsText::tr("an object");
    return QStringLiteral("null");
}

double numberOf(const QString &file, const JsonValue &value, const QString &name)
{
    if (const JsonNumber *number = std::get_if<JsonNumber>(&value.what))
        return number->value;
    refuseType(file, value, name, JsonFieldsText::tr("a number"));
}

bool truthOf(const QString &file, const JsonValue &value, const QString &name)
{
    if (const bool *yes = std::get_if<bool>(&value.what))
        return *yes;
    refuseType(file, value, name, JsonFieldsText::tr("true or false"));
}

QString textOf(const QString &file, const JsonValue &value, const QString &name)
{
    if (const QString *text = std::get_if<QString>(&value.what))
        return *text;
    refuseType(file, value, name, JsonFieldsText::tr("a text in double quotes"));
}

const JsonValue::List &listOf(const QString &file, const JsonValue &value, const QString &name)
{
    if (const JsonValue::List *list = std::get_if<JsonValue::List>(&value.what))
        return *list;
    refuseType(file, value, name, JsonFieldsText::tr("a list in [ ]"));
}

std::int64_t wholeOf(const QString &file, const JsonValue &value, const QString &name, std::int64_t min,
                     std::int64_t max)
{
    const double number = numberOf(file, value, name);
    const bool isExact = std::get<JsonNumber>(value.what).exact;
    if (!isExact || number != std::floor(number) || number < double(min) || number > double(max))
        refuse(file, value.line,
               JsonFieldsText::tr("%1 is %2; it can be a whole number from %3 to %4.")
                   .arg(quoted(name), isExact ? exactNumber(number) : JsonFieldsText::tr("beyond 2^53"),
                        QString::number(min), QString::number(max)));
    return std::int64_t(number);
}

JsonFields::JsonFields(const QString &file, const JsonValue &value, const QString &what)
    : m_file(file), m_what(what), m_members(std::get_if<JsonValue::Object>(&value.what)), m_line(value.line)
{
    if (!m_members)
        app::refuse(file, value.line,
                    JsonFieldsText::tr("%1 is %2; it must be an object in { }.").arg(what, shortText(value)));
}

const JsonValue *JsonFields::find(const QString &name) const
{
    for (const JsonMember &member : *m_members) {
        if (member.name == name)
            return &member.value;
    }
    return nullptr;
}

const JsonValue &JsonFields::require(const QString &name, const QString &possible) const
{
    if (const JsonValue *value = find(name))
        return *value;
    app::refuse(
        m_file, m_line,
        JsonFieldsText::tr("%1 has no %2; add it. It must be %3.").arg(m_what, quoted(name), possible));
}

void JsonFields::refuseOthers(const QStringList &known) const
{
    for (const JsonMember &member : *m_members) {
        if (!known.contains(member.name))
            app::refuse(m_file, member.value.line,
                        JsonFieldsText::tr("%1 has no field %2; there is %3.")
                            .arg(m_what, quoted(member.name), quotedList(known, member.name)));
    }
}

void JsonFields::refuse(const QString &name, const QString &why) const
{
    const JsonValue *value = find(name);
    app::refuse(m_file, value ? value->line : m_line, why);
}

double JsonFields::number(const QString &name) const
{
    return numberOf(m_file, require(name, JsonFieldsText::tr("a number")), name);
}

double JsonFields::number(const QString &name, Span span, std::optional<double> defaultValue) const
{
    if (defaultValue && !find(name))
        return *defaultValue;
    const double found = number(name);
    if (!span.holds(found))
        refuse(name,
               JsonFieldsText::tr("%1 is %2; it can be %3 to %4.")
                   .arg(quoted(name), exactNumber(found), exactNumber(span.min), exactNumber(span.max)));
    return found;
}

std::int64_t JsonFields::integer(const QString &name, std::int64_t min, std::int64_t max,
                                 std::int64_t defaultValue) const
{
    const JsonValue *value = find(name);
    return value ? wholeOf(m_file, *value, name, min, max) : defaultValue;
}

bool JsonFields::boolean(const QString &name, std::optional<bool> defaultValue) const
{
    return defaultValue && !find(name)
               ? *defaultValue
               : truthOf(m_file, require(name, JsonFieldsText::tr("true or false")), name);
}

QString JsonFields::text(const QString &name, const QString &possible) const
{
    return textOf(m_file, require(name, possible), name);
}

QString JsonFields::optionalText(const QString &name) const
{
    return find(name) ? text(name, {}) : QString();
}

}
