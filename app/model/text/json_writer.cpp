#include "app/model/text/json_writer.h"

#include "app/model/text/quoting.h"

#include <rapidjson/prettywriter.h>

#include <cmath>

namespace app {

struct JsonWriter::Target
{
    /// An output stream for RapidJSON that can put all entries of an object on one line. RapidJSON writes a line break
    /// before each entry and before the closing bracket, and never within a text.
    class LineStream
    {
    public:
        using Ch = char;

        void Put(char c) { m_text += c == '\n' && isOneLine ? ' ' : c; }
        void Flush() {}

        const QByteArray &text() const { return m_text; }

        bool isOneLine = false;

    private:
        QByteArray m_text;
    };

    explicit Target(unsigned spaces) : indentation(spaces) { writer.SetIndent(' ', spaces); }

    const unsigned indentation;
    LineStream stream;
    rapidjson::PrettyWriter<LineStream> writer{stream};
    int levelsOnOneLine = 0; ///< open objects and lists that are on one line
};

JsonWriter::JsonWriter(unsigned indentation) : m_target(std::make_unique<Target>(indentation)) {}

JsonWriter::~JsonWriter() = default;

void JsonWriter::begin(Layout layout)
{
    if (m_target->levelsOnOneLine == 0 && layout == Layout::lines)
        return;
    ++m_target->levelsOnOneLine;
    m_target->stream.isOneLine = true;
    m_target->writer.SetIndent(' ', 0).SetFormatOptions(rapidjson::kFormatSingleLineArray);
}

void JsonWriter::end()
{
    if (m_target->levelsOnOneLine == 0 || --m_target->levelsOnOneLine > 0)
        return;
    m_target->stream.isOneLine = false;
    m_target->writer.SetIndent(' ', m_target->indentation).SetFormatOptions(rapidjson::kFormatDefault);
}

void JsonWriter::beginObject(Layout layout)
{
    m_target->writer.StartObject();
    begin(layout);
}

void JsonWriter::endObject()
{
    m_target->writer.EndObject();
    end();
}

void JsonWriter::beginList(Layout layout)
{
    m_target->writer.StartArray();
    begin(layout);
}

void JsonWriter::endList()
{
    m_target->writer.EndArray();
    end();
}

void JsonWriter::name(const QString &fieldName)
{
    const QByteArray utf8 = fieldName.toUtf8();
    m_target->writer.Key(utf8.constData(), rapidjson::SizeType(utf8.size()));
}

void JsonWriter::value(const QString &text)
{
    const QByteArray utf8 = text.toUtf8();
    m_target->writer.String(utf8.constData(), rapidjson::SizeType(utf8.size()));
}

void JsonWriter::value(bool truth)
{
    m_target->writer.Bool(truth);
}

void JsonWriter::value(double number)
{
    m_isFinite = m_isFinite && std::isfinite(number);
    if (!std::isfinite(number))
        return null();
    // RapidJSON would write 1.0 for 1, and Qt 0 for -0.
    const bool isNegativeZero = number == 0.0 && std::signbit(number);
    const QByteArray digits = isNegativeZero ? QByteArray("-0.0") : exactNumber(number).toLatin1();
    m_target->writer.RawValue(digits.constData(), std::size_t(digits.size()), rapidjson::kNumberType);
}

void JsonWriter::whole(std::int64_t number)
{
    m_target->writer.Int64(number);
}

void JsonWriter::null()
{
    m_target->writer.Null();
}

void JsonWriter::beginObject(const QString &fieldName, Layout layout)
{
    name(fieldName);
    beginObject(layout);
}

void JsonWriter::beginList(const QString &fieldName, Layout layout)
{
    name(fieldName);
    beginList(layout);
}

QByteArray JsonWriter::text() const
{
    return m_target->stream.text();
}

}
