#include "app/model/experiment/json_document.h"

#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"

#include <QCoreApplication>
#include <QSet>

#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>

namespace app {

namespace {

constexpr std::size_t deepest = 16;      ///< far more than an experiment needs
constexpr std::size_t mostShared = 4096; ///< number of different texts that are stored once

/// An allocator for RapidJSON, which does not check whether an allocation succeeded.
class Memory
{
public:
    void *Malloc(std::size_t size) { return size > 0 ? given(std::malloc(size)) : nullptr; }
    void *Realloc(void *old, std::size_t, std::size_t size)
    {
        if (size > 0)
            return given(std::realloc(old, size));
        std::free(old);
        return nullptr;
    }
    static void Free(void *memory) { std::free(memory); }

private:
    static void *given(void *memory) { return memory ? memory : throw std::bad_alloc(); }
};

/// A handler that builds the tree while RapidJSON's reader goes through the text once, without recursion.
class Builder
{
    Q_DECLARE_TR_FUNCTIONS(JsonDocumentText)

public:
    using Ch = char;

    Builder(const QByteArray &text, const rapidjson::MemoryStream &stream) : m_text(text), m_stream(stream) {}

    bool Null() { return add({nullptr, line()}); }
    bool Bool(bool value) { return add({value, line()}); }
    bool String(const char *text, rapidjson::SizeType length, bool)
    {
        return add({shared(text, length), line()});
    }
    bool RawNumber(const char *text, rapidjson::SizeType length, bool)
    {
        const QByteArray digits = QByteArray::fromRawData(text, qsizetype(length));
        const double value = digits.toDouble();
        if (!std::isfinite(value))
            return refuse(tr("%1 is too large for a number; the largest is %2.")
                              .arg(quoted(QString::fromLatin1(digits)), "1.8e308"));
        bool isWhole = false;
        const qint64 whole = std::max(digits.toLongLong(&isWhole), -mostExact - 1);
        return add({JsonNumber{value, !isWhole || std::abs(whole) <= mostExact}, line()});
    }
    bool Key(const char *text, rapidjson::SizeType length, bool)
    {
        auto &members = std::get<JsonValue::Object>(m_open.back()->what);
        members.push_back({shared(text, length), {nullptr, line()}});
        return true;
    }
    bool StartObject() { return open({JsonValue::Object{}, line()}); }
    bool StartArray() { return open({JsonValue::List{}, line()}); }
    bool EndArray(rapidjson::SizeType) { return close(); }
    bool EndObject(rapidjson::SizeType)
    {
        const auto &members = std::get<JsonValue::Object>(m_open.back()->what);
        if (const JsonMember *twice = findTwice(members)) {
            m_errorLine = twice->value.line;
            return refuse(tr("%1 is given twice; keep one of them.").arg(quoted(twice->name)));
        }
        return close();
    }
    // Numbers arrive as text, in RawNumber().
    bool Int(int) { return false; }
    bool Uint(unsigned) { return false; }
    bool Int64(std::int64_t) { return false; }
    bool Uint64(std::uint64_t) { return false; }
    bool Double(double) { return false; }

    JsonValue takeRoot() { return std::move(m_root); }
    const QString &error() const { return m_error; }
    /// Returns the reader's current line, or the line of the error.
    int line()
    {
        if (m_errorLine > 0)
            return m_errorLine;
        const auto end = std::min(m_text.size(), qsizetype(m_stream.Tell()));
        m_line += int(std::count(m_text.begin() + m_counted, m_text.begin() + end, '\n'));
        m_counted = end;
        return m_line;
    }

private:
    static constexpr qint64 mostExact = qint64{1}
                                        << 53; ///< up to this number, every whole number is an exact double

    static const JsonMember *findTwice(const JsonValue::Object &members)
    {
        std::vector<const JsonMember *> sorted;
        for (const JsonMember &member : members)
            sorted.push_back(&member);
        std::stable_sort(sorted.begin(), sorted.end(),
                         [](const JsonMember *a, const JsonMember *b) { return a->name < b->name; });
        const auto same = [](const JsonMember *a, const JsonMember *b) { return a->name == b->name; };
        const auto found = std::adjacent_find(sorted.begin(), sorted.end(), same);
        return found == sorted.end() ? nullptr : *std::next(found);
    }

    /// Returns the text as a string. Events repeat the same few texts, so equal strings share their memory.
    QString shared(const char *text, rapidjson::SizeType length)
    {
        const QString string = QString::fromUtf8(text, qsizetype(length));
        if (m_texts.size() >= qsizetype(mostShared))
            return m_texts.contains(string) ? *m_texts.constFind(string) : string;
        return *m_texts.insert(string);
    }

    bool refuse(const QString &why)
    {
        m_error = why;
        return false;
    }

    /// Stores a value in its place and returns a pointer to it. An open list's last item does not move while it is
    /// open, so pointers to it stay valid.
    JsonValue *place(JsonValue value)
    {
        JsonValue *slot = &m_root;
        if (!m_open.empty()) {
            if (auto *list = std::get_if<JsonValue::List>(&m_open.back()->what))
                slot = &list->emplace_back();
            else
                slot = &std::get<JsonValue::Object>(m_open.back()->what).back().value;
        }
        *slot = std::move(value);
        return slot;
    }

    bool add(JsonValue value)
    {
        place(std::move(value));
        return count();
    }

    bool open(JsonValue value)
    {
        if (m_open.size() == deepest)
            return refuse(
                tr("lists and objects are nested more than %1 deep here; an experiment needs only 3 levels.")
                    .arg(deepest));
        m_open.push_back(place(std::move(value)));
        return count();
    }

    bool count()
    {
        if (++m_values <= mostJsonValues)
            return true;
        return refuse(
            tr("here begins one value too many; an experiment has at most %1 values.").arg(mostJsonValues));
    }

    bool close()
    {
        m_open.pop_back();
        return true;
    }

    const QByteArray &m_text;
    const rapidjson::MemoryStream &m_stream;
    JsonValue m_root;
    std::vector<JsonValue *> m_open;
    QSet<QString> m_texts;
    std::size_t m_values = 0;
    qsizetype m_counted = 0;
    int m_line = 1;
    int m_errorLine = 0;
    QString m_error;
};

QString whatIsWrong(rapidjson::ParseErrorCode code)
{
    switch (code) {
    case rapidjson::kParseErrorDocumentRootNotSingular:
        return Builder::tr("there is text after the end; remove everything after the closing bracket.");
    case rapidjson::kParseErrorObjectMissName:
        return Builder::tr("a name in double quotes is expected here.");
    case rapidjson::kParseErrorObjectMissColon:
        return Builder::tr("a colon is expected here, between a name and its value.");
    case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
        return Builder::tr("a comma or a closing } is expected here.");
    case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
        return Builder::tr("a comma or a closing ] is expected here.");
    case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
    case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
    case rapidjson::kParseErrorStringEscapeInvalid:
    case rapidjson::kParseErrorStringMissQuotationMark:
        return Builder::tr("a text in double quotes is not valid; it must end on its own line, and "
                           "only \" \\ / b f n r t u may follow a \\.");
    case rapidjson::kParseErrorStringInvalidEncoding:
        return Builder::tr("a text has bytes that are not UTF-8; save the file as UTF-8.");
    case rapidjson::kParseErrorNumberTooBig:
        return Builder::tr("a number is too large; the largest is %1.").arg("1.8e308");
    case rapidjson::kParseErrorNumberMissFraction:
    case rapidjson::kParseErrorNumberMissExponent:
        return Builder::tr("a number is not complete; write it as 0.5 or 5e-1.");
    default:
        return Builder::tr(
            "this is not JSON; a value is a number, a \"text\", true, false, null, a [list] or an "
            "{object}.");
    }
}

/// Returns whether a list or an object ends at `at`, right after a comma.
bool endsAfterComma(const QByteArray &text, qsizetype at)
{
    if (at >= text.size() || (text[at] != ']' && text[at] != '}'))
        return false;
    const QByteArray before = text.left(at).trimmed();
    return before.endsWith(',');
}

}

bool hasFewEnoughValues(const QByteArray &text)
{
    // Each value except the first follows a comma, or begins a list or an object.
    const auto begin =
        std::count_if(text.begin(), text.end(), [](char c) { return c == ',' || c == '[' || c == '{'; });
    return std::size_t(begin) < mostJsonValues;
}

JsonValue parseJson(const QByteArray &text, const QString &name)
{
    const QString file = shownPath(name);
    const qsizetype start = text.startsWith("\xEF\xBB\xBF") ? 3 : 0;
    if (text.startsWith("PK\x03\x04"))
        throw UserError(Builder::tr("%1: this is a zip. The window opens a zipped lesson if its name ends in "
                                    ".springstep-lesson.")
                            .arg(file));
    if (const qsizetype zero = text.indexOf('\0'); zero >= 0)
        throw UserError(
            Builder::tr("%1: line %2: there is a zero byte; an experiment is JSON text in UTF-8.")
                .arg(file, QString::number(1 + std::count(text.begin(), text.begin() + zero, '\n'))));
    const auto body = QByteArray::fromRawData(text.constData() + start, text.size() - start);
    if (std::all_of(body.begin(), body.end(), [](char c) { return QChar::isSpace(uchar(c)); }))
        throw UserError(Builder::tr("%1: line 1: the file is empty; it must begin with {.").arg(file));

    rapidjson::MemoryStream stream(body.constData(), std::size_t(body.size()));
    Builder builder(body, stream);
    Memory memory;
    rapidjson::GenericReader<rapidjson::UTF8<>, rapidjson::UTF8<>, Memory> reader(&memory);
    constexpr unsigned flags = rapidjson::kParseIterativeFlag | rapidjson::kParseNumbersAsStringsFlag |
                               rapidjson::kParseValidateEncodingFlag;
    const rapidjson::ParseResult result = reader.Parse<flags>(stream, builder);
    if (!result.IsError())
        return builder.takeRoot();
    QString why = builder.error();
    if (why.isEmpty() && endsAfterComma(body, qsizetype(result.Offset())))
        why = Builder::tr("nothing follows the last comma before this %1; remove the comma.")
                  .arg(QLatin1Char(body[qsizetype(result.Offset())]));
    if (why.isEmpty())
        why = stream.Tell() >= std::size_t(body.size())
                  ? Builder::tr("the file ends here too early; the rest of it is missing.")
                  : whatIsWrong(result.Code());
    throw UserError(Builder::tr("%1: line %2: %3").arg(file, QString::number(builder.line()), why));
}

}
