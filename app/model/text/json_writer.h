#pragma once

#include <QByteArray>
#include <QString>

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace app {

/// A writer of a JSON text in UTF-8. Values are written in the order of the calls, so an object keeps the order of
/// its fields.
class JsonWriter
{
public:
    /// The layout of the entries of an object or list.
    enum class Layout {
        lines,  ///< one entry per line
        oneLine ///< all entries on one line, and all that they contain
    };

    /// `indentation` is the number of spaces per level.
    explicit JsonWriter(unsigned indentation);
    ~JsonWriter();
    JsonWriter(const JsonWriter &) = delete;
    JsonWriter &operator=(const JsonWriter &) = delete;

    void beginObject(Layout layout = Layout::lines);
    void endObject();
    void beginList(Layout layout = Layout::lines);
    void endList();

    /// Writes the name of a field. Its value comes next.
    void name(const QString &fieldName);

    void value(const QString &text);
    void value(const std::string &text) { value(QString::fromStdString(text)); }
    void value(const char *text) { value(QString::fromUtf8(text)); }
    void value(bool truth);
    /// Writes the shortest number that reads back as exactly `number`. JSON has only finite numbers, so another number
    /// becomes null; see isFinite().
    void value(double number);
    void value(std::integral auto number) { whole(static_cast<std::int64_t>(number)); }
    void null();

    /// Writes a field with its value; a value that is missing becomes null.
    template <class Value>
    void field(const QString &fieldName, const Value &fieldValue)
    {
        name(fieldName);
        value(fieldValue);
    }
    template <class Value>
    void field(const QString &fieldName, const std::optional<Value> &fieldValue)
    {
        name(fieldName);
        fieldValue ? value(*fieldValue) : null();
    }
    /// Writes a field with a list of values.
    template <class Values>
    void list(const QString &fieldName, const Values &values, Layout layout = Layout::lines)
    {
        beginList(fieldName, layout);
        for (const auto &one : values)
            value(one);
        endList();
    }
    void beginObject(const QString &fieldName, Layout layout = Layout::lines);
    void beginList(const QString &fieldName, Layout layout = Layout::lines);

    /// Returns whether all numbers so far were finite.
    bool isFinite() const { return m_isFinite; }
    /// Returns the text so far. It is complete when every object and list has ended.
    QByteArray text() const;

private:
    struct Target;

    void whole(std::int64_t number);
    void begin(Layout layout);
    void end();

    std::unique_ptr<Target> m_target;
    bool m_isFinite = true;
};

}
