#include "app/listing/tokens.h"

#include <algorithm>
#include <charconv>

namespace listing {

namespace {

bool isWordStart(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

}

bool isAnyOf(std::string_view text, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), text) != words.end();
}

std::optional<int> wholeNumber(std::string_view text)
{
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool isWhole = error == std::errc() && end == text.data() + text.size();
    return isWhole ? std::optional(number) : std::nullopt;
}

bool opens(std::string_view text)
{
    return isAnyOf(text, {"(", "[", "{"});
}

bool closes(std::string_view text)
{
    return isAnyOf(text, {")", "]", "}"});
}

Tokens::Tokens(std::string_view text) : m_textSize(text.size())
{
    split(text);
    matchBrackets();
}

void Tokens::split(std::string_view text)
{
    int line = 1;
    std::size_t lineStart = 0;
    std::size_t i = 0;
    const auto add = [&](Token::Kind kind, std::size_t length) {
        m_all.push_back({kind, text.substr(i, length), i, line, static_cast<int>(i - lineStart) + 1});
        i += length;
    };
    while (i < text.size()) {
        const char c = text[i];
        if (c == '\n') {
            ++line;
            lineStart = ++i;
        } else if (c == ' ' || c == '\t' || c == '\r') {
            ++i;
        } else if (text.substr(i, 2) == "//") {
            i = std::min(text.find('\n', i), text.size());
        } else if (text.substr(i, 2) == "/*") {
            const std::size_t end = std::min(text.find("*/", i + 2), text.size());
            if (end == text.size())
                m_openComment = {Token::Kind::sign, text.substr(i, 2), i, line,
                                 static_cast<int>(i - lineStart) + 1};
            for (; i < end; ++i) {
                if (text[i] == '\n') {
                    ++line;
                    lineStart = i + 1;
                }
            }
            i = std::min(end + 2, text.size());
        } else if (isWordStart(c)) {
            std::size_t length = 1;
            while (i + length < text.size() && (isWordStart(text[i + length]) || isDigit(text[i + length])))
                ++length;
            add(Token::Kind::word, length);
        } else if (isDigit(c)) {
            std::size_t length = 1;
            while (i + length < text.size() &&
                   (isWordStart(text[i + length]) || isDigit(text[i + length]) || text[i + length] == '.'))
                ++length;
            add(Token::Kind::number, length);
        } else {
            std::size_t length = 1;
            if (static_cast<unsigned char>(c) >= 0x80) { // the whole character
                while (i + length < text.size() &&
                       (static_cast<unsigned char>(text[i + length]) & 0xC0) == 0x80)
                    ++length;
            }
            add(Token::Kind::sign, length);
        }
    }
}

void Tokens::matchBrackets()
{
    m_closing.assign(m_all.size(), m_all.size());
    std::vector<std::size_t> open;
    m_isInBlock.assign(m_all.size(), true);
    for (std::size_t i = 0; i < m_all.size(); ++i) {
        m_isInBlock[i] = open.empty() || is(open.back(), "{");
        if (opens(m_all[i].text)) {
            open.push_back(i);
        } else if (closes(m_all[i].text) && !open.empty()) {
            m_closing[open.back()] = i;
            open.pop_back();
        }
    }
}

}
