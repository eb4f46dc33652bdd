#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

namespace listing {

/// A word, number or sign of a listing.
struct Token
{
    enum class Kind { word, number, sign };
    Kind kind = Kind::sign;
    std::string_view text;  ///< part of the scanned text
    std::size_t offset = 0; ///< bytes from the start of the text
    int line = 1;           ///< from 1
    int column = 1;         ///< from 1, in bytes
    std::size_t end() const { return offset + text.size(); }
};

/// Returns whether `text` is one of `words`.
bool isAnyOf(std::string_view text, std::initializer_list<std::string_view> words);
/// Returns a short whole number; nothing for any other text.
std::optional<int> wholeNumber(std::string_view text);
/// Returns whether `text` is an opening bracket.
bool opens(std::string_view text);
/// Returns whether `text` is a closing bracket.
bool closes(std::string_view text);

/// The tokens of a listing, without its comments, and the brackets that match. Indices beyond the last token are
/// allowed everywhere: there is no token.
class Tokens
{
public:
    /// Splits any text, also one that does not compile. `text` must outlive this object.
    explicit Tokens(std::string_view text);

    std::size_t size() const { return m_all.size(); }
    bool empty() const { return m_all.empty(); }
    const Token &operator[](std::size_t i) const { return m_all[i]; }
    auto begin() const { return m_all.begin(); }
    auto end() const { return m_all.end(); }

    bool is(std::size_t i, std::string_view text) const { return i < size() && m_all[i].text == text; }
    bool isWord(std::size_t i) const { return i < size() && m_all[i].kind == Token::Kind::word; }
    /// Returns whether token `i + 1` is `text` and follows token `i` without a space.
    bool touches(std::size_t i, std::string_view text) const
    {
        return is(i + 1, text) && m_all[i + 1].offset == m_all[i].end();
    }
    /// Returns the index of the bracket that closes the one at token `i`, or the number of tokens.
    std::size_t closing(std::size_t i) const { return i < size() ? m_closing[i] : size(); }
    /// Returns the index after token `i`, or after the brackets that it opens.
    std::size_t behind(std::size_t i) const { return opens(m_all[i].text) ? m_closing[i] + 1 : i + 1; }
    /// Returns whether brackets and a block follow token `i`: it is the name of a function that is defined there.
    bool isHead(std::size_t i) const { return is(i + 1, "(") && is(closing(i + 1) + 1, "{"); }
    /// Returns whether the innermost bracket around token `i` is a brace, or there is none.
    bool isInBlock(std::size_t i) const { return m_isInBlock[i]; }
    /// Returns the sign of a comment that never ends, if there is one.
    const std::optional<Token> &openComment() const { return m_openComment; }
    /// Returns the byte at which token `i` begins, or the length of the text.
    std::size_t beginOf(std::size_t i) const { return i < size() ? m_all[i].offset : m_textSize; }
    /// Returns the byte after token `i`, or the length of the text.
    std::size_t endOf(std::size_t i) const { return i < size() ? m_all[i].end() : m_textSize; }

private:
    void split(std::string_view text);
    void matchBrackets();

    std::size_t m_textSize;
    std::vector<Token> m_all;
    std::vector<std::size_t> m_closing;
    std::vector<bool> m_isInBlock;
    std::optional<Token> m_openComment;
};

}
