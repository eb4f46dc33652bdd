#include "app/model/listing/vector_mark.h"

#include "app/listing/source_scan.h"
#include "app/model/catalog/lists.h"
#include "app/model/listing/assigned_paths.h"

#include <algorithm>

namespace app {

namespace {

using listing::Tokens;

/// What a calculation of Vec2 values describes.
struct Nature
{
    enum class Kind {
        number, ///< or anything else that is no Vec2
        place,
        difference,
    };
    Kind kind = Kind::number;
    std::optional<sim::Vec2> from; ///< where a difference begins, if that is known
};

bool isPlaceName(std::string_view name)
{
    static constexpr std::string_view places[] = {"position", "pointer", "target", "hand", "before"};
    return std::find(std::begin(places), std::end(places), name) != std::end(places);
}

/// Reads calculations of a listing as places and differences.
class NatureReader
{
public:
    /// Values are those after `index` lines, as the line at `scope` sees the names.
    NatureReader(const Tokens &tokens, const ListingFrame &frame, int index, int scope)
        : m_tokens(tokens), m_frame(frame), m_index(index), m_scope(scope)
    {
    }

    std::optional<listing::Value> valueOf(const std::string &path) const
    {
        return m_frame.valueOf(QString::fromStdString(path), m_index, m_scope);
    }

    /// Returns the nature of the path of the tokens `begin` to before `end`.
    Nature ofPath(std::size_t begin, std::size_t end, int depth = 0) const
    {
        const std::string path = joinedPath(m_tokens, begin, end);
        const std::optional<listing::Value> value = valueOf(path);
        if (!value || !std::holds_alternative<sim::Vec2>(*value))
            return {};
        const std::string_view last = m_tokens[end - 1].text;
        if (isPlaceName(last))
            return {Nature::Kind::place, {}};
        if (last == "velocity") {
            const std::optional<listing::Value> body =
                valueOf(joinedPath(m_tokens, begin, end - 1) + "position");
            const auto *place = body ? std::get_if<sim::Vec2>(&*body) : nullptr;
            return {Nature::Kind::difference, place ? std::optional(*place) : std::nullopt};
        }
        return end == begin + 1 ? ofVariable(begin, depth) : Nature{Nature::Kind::difference, {}};
    }

private:
    static constexpr int deepest = 8; ///< variables that are computed from variables

    /// Returns the nature of the variable at token `at`, from the calculation that sets it.
    Nature ofVariable(std::size_t at, int depth) const
    {
        const Nature unknown = {Nature::Kind::place, {}};
        if (depth > deepest)
            return unknown;
        const Assignment *found = nullptr;
        const std::vector<Assignment> all = assignmentsIn(m_tokens);
        for (const Assignment &one : all) {
            if (one.isPlain && one.path == m_tokens[at].text && (one.begin <= at || !found))
                found = &one;
        }
        if (!found)
            return unknown;
        const Nature nature = ofSum(found->value, found->end, depth + 1);
        return nature.kind == Nature::Kind::number ? unknown : nature;
    }

    /// Returns the nature of the calculation in the tokens `begin` to before `end`.
    Nature ofSum(std::size_t begin, std::size_t end, int depth) const
    {
        int places = 0;
        bool hasVector = false;
        std::optional<sim::Vec2> removed, from; // the place that is subtracted, and where a difference begins
        bool isAdded = true;
        for (std::size_t i = begin; i < end;) {
            std::size_t termEnd = i;
            while (termEnd < end && !(termEnd > i && isSign(termEnd) && !isFactorSign(termEnd - 1)))
                termEnd = after(termEnd);
            termEnd = std::min(termEnd, end);
            const Nature term = ofProduct(i, termEnd, depth);
            if (term.kind == Nature::Kind::place) {
                places += isAdded ? 1 : -1;
                if (!isAdded && !removed)
                    removed = placeOf(i, termEnd);
            } else if (term.kind == Nature::Kind::difference) {
                hasVector = true;
                if (!from)
                    from = term.from;
            }
            isAdded = !m_tokens.is(termEnd, "-");
            i = termEnd + 1;
        }
        if (places > 0)
            return {Nature::Kind::place, {}};
        if (removed)
            return {Nature::Kind::difference, removed};
        return hasVector || places < 0 ? Nature{Nature::Kind::difference, from} : Nature{};
    }

    /// Returns the nature of a term: that of its factor which is no number.
    Nature ofProduct(std::size_t begin, std::size_t end, int depth) const
    {
        for (std::size_t i = begin; i < end;) {
            std::size_t factorEnd = i;
            while (factorEnd < end && !m_tokens.is(factorEnd, "*") && !m_tokens.is(factorEnd, "/"))
                factorEnd = after(factorEnd);
            factorEnd = std::min(factorEnd, end);
            const Nature nature = ofFactor(i, factorEnd, depth);
            if (nature.kind != Nature::Kind::number)
                return nature;
            i = factorEnd + 1;
        }
        return {};
    }

    Nature ofFactor(std::size_t begin, std::size_t end, int depth) const
    {
        while (begin < end && isSign(begin))
            ++begin;
        if (begin >= end)
            return {};
        if (m_tokens.is(begin, "(") && m_tokens.closing(begin) + 1 == end)
            return ofSum(begin + 1, end - 1, depth);
        if (m_tokens.isWord(begin) && m_tokens.is(begin + 1, "(") && m_tokens.closing(begin + 1) + 1 == end)
            return ofCall(begin, end);
        return m_tokens.isWord(begin) ? ofPath(begin, end, depth) : Nature{};
    }

    /// Returns the nature of a call: a function of the listing may return a Vec2, which begins at its first body.
    Nature ofCall(std::size_t begin, std::size_t end) const
    {
        if (m_tokens.is(begin, "Vec2"))
            return {Nature::Kind::difference, {}};
        for (std::size_t i = 0; i + 2 < m_tokens.size(); ++i) {
            if (!m_tokens.is(i, "Vec2") || m_tokens[i + 1].text != m_tokens[begin].text ||
                !m_tokens.is(i + 2, "("))
                continue;
            std::size_t argument = begin + 2;
            while (argument < end && !m_tokens.is(argument, ",") && !m_tokens.is(argument, ")"))
                argument = after(argument);
            const auto place =
                valueOf(joinedPath(m_tokens, begin + 2, std::min(argument, end)) + ".position");
            const auto *at = place ? std::get_if<sim::Vec2>(&*place) : nullptr;
            return {Nature::Kind::difference, at ? std::optional(*at) : std::nullopt};
        }
        return {};
    }

    std::optional<sim::Vec2> placeOf(std::size_t begin, std::size_t end) const
    {
        const std::optional<listing::Value> value = valueOf(joinedPath(m_tokens, begin, end));
        const auto *place = value ? std::get_if<sim::Vec2>(&*value) : nullptr;
        return place ? std::optional(*place) : std::nullopt;
    }

    bool isSign(std::size_t i) const { return m_tokens.is(i, "+") || m_tokens.is(i, "-"); }
    bool isFactorSign(std::size_t i) const { return m_tokens.is(i, "*") || m_tokens.is(i, "/") || isSign(i); }
    /// Returns the index behind token `i`, or behind its closing bracket.
    std::size_t after(std::size_t i) const
    {
        return listing::opens(m_tokens[i].text) ? std::min(m_tokens.closing(i), m_tokens.size()) + 1 : i + 1;
    }

    const Tokens &m_tokens;
    const ListingFrame &m_frame;
    int m_index, m_scope;
};

/// Returns the line of the frame that shows the values for `line` of the text: its last run, or else the last line of
/// its function. -1 if the function has not run.
int scopeOf(const ListingFrame &frame, int index, int line, const std::string &function)
{
    int found = -1;
    for (int i = std::min(index, frame.count() - 1); i >= 0; --i) {
        if (frame.line(i).line == line)
            return i;
        if (found < 0 && frame.line(i).function == function)
            found = i;
    }
    return found;
}

int columnIn(const QString &text, int line, int byteColumn)
{
    const QByteArray bytes = text.section('\n', line - 1, line - 1).toUtf8();
    return static_cast<int>(QString::fromUtf8(bytes.left(byteColumn - 1)).size()) + 1;
}

/// Returns the place of the tokens `first` to `last`, which stand on one line.
TextRange rangeOf(const QString &text, const Tokens &tokens, std::size_t first, std::size_t last)
{
    const listing::Token &end = tokens[last];
    const int column = columnIn(text, tokens[first].line, tokens[first].column);
    const int behind = columnIn(text, end.line, end.column + static_cast<int>(end.text.size()));
    return {tokens[first].line, column, end.line == tokens[first].line ? behind - column : 1};
}

}

std::optional<VectorMark> vectorMarkAt(const QString &text, int line, int column, const ListingFrame &frame,
                                       int index)
{
    const listing::SourceScan scan(text.toStdString());
    const Tokens &tokens = scan.tokens();
    const QString before = text.section('\n', line - 1, line - 1).left(column - 1);
    const std::size_t offset = scan.offsetOf(line, static_cast<int>(before.toUtf8().size()) + 1);
    std::size_t at = 0;
    while (at < tokens.size() && !(offset >= tokens[at].offset && offset < tokens[at].end()))
        ++at;
    if (at == tokens.size() || !tokens.isWord(at) || tokens[at].line != line)
        return {};
    const listing::FunctionText *function = scan.functionAt(offset);
    const int scope = scopeOf(frame, index, line, function ? function->name : std::string());
    if (scope < 0)
        return {};
    const std::size_t begin = beginOfPath(tokens, at);
    const NatureReader reader(tokens, frame, index, scope);
    const std::string path = joinedPath(tokens, begin, at + 1);
    const std::optional<listing::Value> value = reader.valueOf(path);
    const auto *vector = value ? std::get_if<sim::Vec2>(&*value) : nullptr;
    if (!vector)
        return {};
    VectorMark mark;
    mark.name = QString::fromStdString(path);
    mark.range = rangeOf(text, tokens, begin, at);
    mark.to = *vector;
    const Nature nature = reader.ofPath(begin, at + 1);
    if (nature.kind == Nature::Kind::difference) {
        if (!nature.from)
            return {}; // nothing says where it begins
        mark.kind = VectorMark::Kind::difference;
        mark.from = *nature.from;
        mark.to = *nature.from + *vector;
    }
    return mark;
}

std::vector<TextRange> usesOf(const QString &text, const QString &body, const listing::Vocabulary &vocabulary,
                              const ListingFrame *frame, int index)
{
    const std::string name = body.toStdString();
    std::string array, number; // of its array
    for (const listing::Vocabulary::Array &one : vocabulary.arrays) {
        const std::string digits =
            name.starts_with(one.prefix) ? name.substr(one.prefix.size()) : std::string();
        if (!digits.empty() && digits.find_first_not_of("0123456789") == std::string::npos) {
            array = one.name;
            number = digits;
        }
    }
    const std::string cell = array.empty() ? name : array + "[" + number + "]";
    std::vector<std::string> variables; // that stand for it, in the function that runs
    std::string function;
    if (frame && index < frame->count()) {
        function = frame->line(index).function;
        for (const listing::Variable &one : frame->line(index).variables) {
            const auto *reference = std::get_if<listing::BodyReference>(&one.value);
            if (reference && reference->name == cell)
                variables.push_back(one.name);
        }
    }
    const listing::SourceScan scan(text.toStdString());
    const Tokens &tokens = scan.tokens();
    std::vector<TextRange> uses;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (!tokens.isWord(i) || (i > 0 && tokens.is(i - 1, ".")))
            continue;
        const std::string_view word = tokens[i].text;
        if (!array.empty() && word == array && tokens.is(i + 1, "[")) {
            const bool isOther = i + 2 < tokens.size() &&
                                 tokens[i + 2].kind == listing::Token::Kind::number &&
                                 tokens[i + 2].text != number;
            if (!isOther && tokens.closing(i + 1) < tokens.size())
                uses.push_back(rangeOf(text, tokens, i, tokens.closing(i + 1)));
            continue;
        }
        const listing::FunctionText *around = scan.functionAt(tokens[i].offset);
        const bool isVariable = contains(variables, word) && around && around->name == function;
        if (isVariable || (array.empty() && word == name))
            uses.push_back(rangeOf(text, tokens, i, i));
    }
    return uses;
}

}
