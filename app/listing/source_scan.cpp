#include "app/listing/source_scan.h"

#include "app/listing/common_slips.h"
#include "app/listing/language_rules.h"
#include "app/listing/limits.h"

#include <algorithm>

namespace listing {

namespace {

bool isType(std::string_view word)
{
    return isPrimitive(word) || isAnyOf(word, {"Vec2", "Body", "Creature", "Stick", "auto"});
}

}

SourceScan::SourceScan(std::string text)
    : m_text(std::move(text)), m_tokens(m_text.size() > maxTextBytes ? std::string_view() : m_text)
{
    m_lineStarts.push_back(0);
    if (m_text.size() > maxTextBytes) {
        m_error = CompileError{1, 1, 1,
                               "This listing has " + std::to_string(m_text.size()) + " bytes. The most is " +
                                   std::to_string(maxTextBytes) + "."};
        return;
    }
    for (std::size_t i = 0; i < m_text.size(); ++i) {
        if (m_text[i] == '\n')
            m_lineStarts.push_back(i + 1);
    }
    m_error = outsideLanguage(m_tokens);
    if (m_error) // its brackets may be nested too deeply to parse
        return;
    parse();
    for (const auto rule : {commonSlip, brokenRule}) {
        if (!m_error)
            m_error = rule(m_tokens);
    }
    closeBraces();
}

void SourceScan::closeBraces()
{
    const auto countOf = [&](std::string_view text) {
        return std::count_if(m_tokens.begin(), m_tokens.end(),
                             [&](const Token &token) { return token.text == text; });
    };
    auto missing = countOf("{") - countOf("}");
    std::vector<std::size_t> open;
    const bool isBalanced = missing == 0;
    const auto closeBefore = [&](std::size_t i) {
        if (!m_unclosed)
            m_unclosed = errorAt(m_tokens[open.back()], "This '{' has no '}'.");
        m_missingBraces.push_back(m_tokens[i - 1].end());
        open.pop_back();
        --missing;
    };
    std::vector<int> indents; // of the lines with the open braces
    int indent = 1;
    for (std::size_t i = 0; i < m_tokens.size(); ++i) {
        const bool beginsLine = i == 0 || m_tokens[i - 1].line < m_tokens[i].line;
        if (beginsLine)
            indent = m_tokens[i].column;
        indents.resize(open.size());
        const bool beginsFunction = (m_tokens.is(i, "void") || isType(m_tokens[i].text)) &&
                                    m_tokens.isWord(i + 1) && m_tokens.isHead(i + 1);
        if (beginsFunction && isBalanced && !open.empty() && indents.back() < m_tokens[i].column)
            return fail(m_tokens[i], "A function cannot be inside another function. Move it out.");
        while (beginsFunction && !open.empty()) // no function stands inside another one
            closeBefore(i);
        if (m_tokens.is(i, "{")) {
            open.push_back(i);
            indents.push_back(indent);
        } else if (m_tokens.is(i, "}") && !open.empty()) {
            // A brace further to the left than the line of its partner belongs to one before.
            while (beginsLine && missing > 0 && open.size() > 1 && indents[open.size() - 1] > indent)
                closeBefore(i);
            open.pop_back();
        }
    }
    while (!open.empty())
        closeBefore(m_tokens.size());
    if (missing < 0 && !m_error) // there is a '}' too many elsewhere
        m_error = m_unclosed;
}

void SourceScan::fail(const Token &token, std::string sentence)
{
    if (!m_error)
        m_error = errorAt(token, std::move(sentence));
}

void SourceScan::parse()
{
    std::size_t i = 0;
    while (i < m_tokens.size()) {
        std::size_t name = i;
        if (m_tokens.is(name, "const"))
            ++name;
        const bool isFunction =
            m_tokens.isWord(name) && m_tokens.isWord(name + 1) && m_tokens.isHead(name + 1);
        if (!isFunction) {
            const std::size_t end = afterStatement(i);
            m_into = &m_globals;
            declarations(i, end, m_text.size());
            i = std::max(end, i + 1);
            continue;
        }
        const std::size_t close = m_tokens.closing(name + 2), body = close + 1, last = m_tokens.closing(body);
        m_functions.push_back(
            {std::string(m_tokens[name + 1].text), {m_tokens[name].offset, m_tokens.endOf(last)}, {}});
        m_into = &m_functions.back().declarations;
        parameters(name + 3, close, m_tokens.endOf(last));
        statement(body, m_tokens.endOf(last));
        i = std::max(last + 1, i + 1);
    }
}

void SourceScan::parameters(std::size_t i, std::size_t end, std::size_t scopeEnd)
{
    for (; i < end; ++i) {
        const bool isLast = i + 1 == end || m_tokens.is(i + 1, ",");
        if (m_tokens.isWord(i) && isLast && i > 0 && (m_tokens.isWord(i - 1) || m_tokens.is(i - 1, "&")))
            m_into->push_back(
                {std::string(m_tokens[i].text), m_tokens[i].offset, {m_tokens.endOf(i), scopeEnd}});
    }
}

std::size_t SourceScan::afterStatement(std::size_t i) const
{
    if (m_tokens.is(i, "{"))
        return m_tokens.closing(i) + 1;
    if (m_tokens.is(i, "for") || m_tokens.is(i, "while"))
        return m_tokens.is(i + 1, "(") ? afterStatement(m_tokens.closing(i + 1) + 1) : i + 1;
    if (m_tokens.is(i, "do")) {
        const std::size_t tail = afterStatement(i + 1);
        return m_tokens.is(tail, "while") && m_tokens.is(tail + 1, "(") ? m_tokens.closing(tail + 1) + 2
                                                                        : tail;
    }
    if (m_tokens.is(i, "if") && !m_tokens.is(i + 1, "("))
        return i + 1;
    if (m_tokens.is(i, "if")) {
        std::size_t next = i;
        while (m_tokens.is(next, "if") && m_tokens.is(next + 1, "(")) { // an else-if chain without recursion
            next = afterStatement(m_tokens.closing(next + 1) + 1);
            if (!m_tokens.is(next, "else"))
                return next;
            ++next;
        }
        return afterStatement(next);
    }
    while (i < m_tokens.size() && !m_tokens.is(i, ";") && !m_tokens.is(i, "}"))
        i = m_tokens.behind(i);
    return std::min(m_tokens.is(i, "}") ? i : i + 1, m_tokens.size());
}

void SourceScan::statement(std::size_t i, std::size_t blockEnd)
{
    const std::size_t end = afterStatement(i);
    const std::size_t endByte = end > 0 ? m_tokens.endOf(std::min(end, m_tokens.size()) - 1) : m_text.size();
    const auto addLoop = [&](Extent head, Extent body) {
        m_loops.push_back({m_tokens[i].line, head, body, {m_tokens[i].offset, endByte}});
    };
    if (m_tokens.is(i, "{")) {
        const std::size_t close = m_tokens.closing(i);
        for (std::size_t inner = i + 1; inner < close; inner = std::max(afterStatement(inner), inner + 1))
            statement(inner, m_tokens.endOf(close));
    } else if (m_tokens.is(i, "for") || m_tokens.is(i, "while")) {
        if (!m_tokens.is(i + 1, "("))
            return;
        const std::size_t close = m_tokens.closing(i + 1), body = m_tokens.beginOf(close + 1);
        addLoop({m_tokens[i].offset, body}, {body, endByte});
        if (m_tokens.is(i, "for"))
            declarations(i + 2, close, endByte);
        statement(close + 1, endByte);
    } else if (m_tokens.is(i, "do")) {
        const std::size_t tail = m_tokens.beginOf(afterStatement(i + 1));
        addLoop({tail, endByte}, {m_tokens.beginOf(i + 1), tail});
        statement(i + 1, blockEnd);
    } else if (m_tokens.is(i, "if")) {
        while (m_tokens.is(i, "if") && m_tokens.is(i + 1, "(")) { // an else-if chain without recursion
            const std::size_t lines = m_tokens.closing(i + 1) + 1;
            statement(lines, blockEnd);
            i = afterStatement(lines);
            if (!m_tokens.is(i, "else"))
                return;
            ++i;
        }
        if (!m_tokens.is(i, "if"))
            statement(i, blockEnd);
    } else {
        declarations(i, end, blockEnd);
    }
}

void SourceScan::declarations(std::size_t i, std::size_t end, std::size_t scopeEnd)
{
    if (m_tokens.is(i, "const"))
        ++i;
    if (!m_tokens.isWord(i) || !isType(m_tokens[i].text) || !m_tokens.isWord(i + 1))
        return;
    const std::string_view type = m_tokens[i].text;
    ++i;
    while (m_tokens.isWord(i) && i < end) {
        const Token &name = m_tokens[i];
        if ((m_tokens.is(i + 1, ";") || m_tokens.is(i + 1, ",")) && (isPrimitive(type) || type == "auto"))
            return fail(name, quoted(name.text) + " has no value yet. Give it one: '" + std::string(type) +
                                  " " + std::string(name.text) +
                                  (type == "bool" ? " = false;'." : " = 0;'."));
        std::size_t next = i + 1;
        while (next < end && !m_tokens.is(next, ",") && !m_tokens.is(next, ";"))
            next = m_tokens.behind(next);
        m_into->push_back({std::string(name.text), name.offset, {m_tokens.beginOf(next), scopeEnd}});
        if (!m_tokens.is(next, ","))
            return;
        i = next + 1;
    }
}

std::string SourceScan::compiledText() const
{
    std::string text = m_text;
    for (std::size_t i = 0; i + 1 < m_tokens.size(); ++i) {
        const std::string_view type = m_tokens[i + 1].text;
        if (m_tokens.is(i, "const") && isType(type) && !isPrimitive(type))
            text.replace(m_tokens[i].offset, m_tokens[i].text.size(), m_tokens[i].text.size(), ' ');
    }
    for (auto at = m_missingBraces.rbegin(); at != m_missingBraces.rend(); ++at)
        text.insert(*at, 1, '}');
    return text;
}

std::vector<std::string> SourceScan::declaredNames() const
{
    std::vector<std::string> names;
    const auto add = [&](const std::vector<Declaration> &declared) {
        for (const Declaration &declaration : declared)
            names.push_back(declaration.name);
    };
    add(m_globals);
    for (const FunctionText &function : m_functions) {
        names.push_back(function.name);
        add(function.declarations);
    }
    return names;
}

std::string SourceScan::formOf(std::string_view function) const
{
    for (std::size_t i = 1; i < m_tokens.size(); ++i) {
        if (m_tokens.is(i, function) && m_tokens.isWord(i - 1) && m_tokens.isHead(i))
            return m_text.substr(m_tokens[i].offset,
                                 m_tokens.endOf(m_tokens.closing(i + 1)) - m_tokens[i].offset);
    }
    return {};
}

bool SourceScan::declares(std::string_view name, std::size_t offset) const
{
    const auto isIt = [&](const Declaration &one) {
        return one.name == name && (one.offset == offset || one.scope.contains(offset));
    };
    const FunctionText *function = functionAt(offset);
    return std::any_of(m_globals.begin(), m_globals.end(), isIt) ||
           (function && std::any_of(function->declarations.begin(), function->declarations.end(), isIt));
}

bool SourceScan::uses(std::string_view name) const
{
    return std::any_of(m_tokens.begin(), m_tokens.end(),
                       [&](const Token &token) { return token.text == name; });
}

const FunctionText *SourceScan::functionAt(std::size_t offset) const
{
    const auto found =
        std::find_if(m_functions.begin(), m_functions.end(),
                     [&](const FunctionText &function) { return function.extent.contains(offset); });
    return found == m_functions.end() ? nullptr : &*found;
}

std::size_t SourceScan::offsetOf(int line, int column) const
{
    if (line < 1)
        return 0;
    if (static_cast<std::size_t>(line) > m_lineStarts.size())
        return m_text.size();
    const std::size_t start = m_lineStarts[static_cast<std::size_t>(line) - 1];
    return std::min(m_text.size(), start + static_cast<std::size_t>(std::max(0, column - 1)));
}

int SourceScan::lineOf(std::size_t offset) const
{
    return static_cast<int>(std::upper_bound(m_lineStarts.begin(), m_lineStarts.end(), offset) -
                            m_lineStarts.begin());
}

int SourceScan::lengthAt(int line, int column) const
{
    const std::size_t offset = offsetOf(line, column);
    for (const Token &token : m_tokens) {
        if (offset >= token.offset && offset < token.end())
            return static_cast<int>(token.end() - offset);
    }
    return 1;
}

}
