#include "app/listing/language_rules.h"

#include "app/listing/language.h"
#include "app/listing/limits.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace listing {

namespace {

using Violation = std::optional<CompileError>;

/// Returns a sentence that says what to write in place of a word that listings leave out.
std::string insteadOf(std::string_view word)
{
    if (isAnyOf(word, {"switch", "case", "default"}))
        return "Use 'if'.";
    if (word == "float")
        return "Use 'double'.";
    if (word.starts_with("int") || word.starts_with("uint"))
        return word == "interface" ? "Use another name." : "Use 'int'.";
    if (word == "function")
        return "Use 'void'.";
    if (word == "in")
        return "A loop is written 'for (int i = 0; i < 5; i++)'.";
    return "Use another name.";
}

/// Returns a sentence that says what to write in place of a sign that listings leave out, or an empty string. The texts
/// of the lessons have many of these signs, so that they come with formulas that are pasted.
std::string insteadOfSign(std::string_view sign)
{
    constexpr std::array<std::array<std::string_view, 2>, 20> sentences = {{
        {"#", " A comment begins with '//'."},
        {"^", " A power is 'pow(a, b)'."},
        {"²", " A power is 'pow(a, b)'."},
        {"³", " A power is 'pow(a, b)'."},
        {"√", " Write 'sqrt(x)'."},
        {"×", " To multiply, write '*'."},
        {"·", " To multiply, write '*'."},
        {"⋅", " To multiply, write '*'."},
        {"÷", " Write '/'."},
        {"−", " Write '-'."},
        {"–", " Write '-'."},
        {"π", " Write 'pi'."},
        {"½", " Write '0.5'."},
        {"≤", " Write '<='."},
        {"≥", " Write '>='."},
        {"≠", " Write '!='."},
        {"；", " Write ';'."},
        {"，", " Write ','."},
        {"（", " Write '('."},
        {"）", " Write ')'."},
    }};
    for (const auto &[known, sentence] : sentences) {
        if (sign == known)
            return std::string(sentence);
    }
    const bool isLetter = sign.size() == 2 && sign[0] >= '\xC3' && sign[0] <= '\xD4';
    return isLetter ? " A name has only the letters a to z, digits and '_'." : "";
}

Violation boundsViolation(const Tokens &tokens)
{
    int depth = 0, parentheses = 0, elses = 0, length = 0;
    for (const Token &token : tokens) {
        const char first = token.text.front();
        if (first == '"' || first == '\'')
            return errorAt(token,
                           "Texts in quotes are not part of this language. It has numbers, bool and Vec2.");
        if (first == '@')
            return errorAt(
                token,
                "'@' is not part of this language. A Body variable already stands for the body itself.");
        if (token.kind == Token::Kind::sign &&
            (static_cast<unsigned char>(first) >= 0x7F || static_cast<unsigned char>(first) < 0x20 ||
             first == '#' || first == '$' || first == '`' || first == '\\'))
            return errorAt(token, static_cast<unsigned char>(first) < 0x20 || first == 0x7F
                                      ? std::string("This character is not part of this language.")
                                      : quoted(token.text) + " is not part of this language." +
                                            insteadOfSign(token.text));
        if (token.kind == Token::Kind::word && isLeftOut(token.text))
            return errorAt(token, quoted(token.text) + " is reserved and not part of this language. " +
                                      insteadOf(token.text));
        if (token.kind == Token::Kind::number && token.text.find_first_of("fF") != std::string_view::npos &&
            !token.text.starts_with("0x"))
            return errorAt(token, "A number ends without 'f' here.");
        if (token.text == "else" && ++elses > maxElses)
            return errorAt(token,
                           "There are more than " + std::to_string(maxElses) + " 'else' in this listing.");
        if (opens(token.text) && ++depth > maxNesting)
            return errorAt(token, "There are more than " + std::to_string(maxNesting) +
                                      " brackets inside one another.");
        if (closes(token.text))
            --depth;
        if (token.text == "(")
            ++parentheses;
        if (token.text == ")")
            parentheses = std::max(0, parentheses - 1);
        ++length;
        if (token.text == "{" || token.text == "}" || (token.text == ";" && parentheses == 0))
            length = 0;
        if (length > maxStatementTokens)
            return errorAt(token, "This statement is too long. Split it in two.");
    }
    return {};
}

Violation signViolation(const Tokens &tokens)
{
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view sign = tokens[i].text;
        const auto isPair = [&](std::size_t first) { return tokens.touches(first, tokens[first].text); };
        if (sign == "^" || sign == "~")
            return errorAt(tokens[i], quoted(sign) + " is not part of this language." + insteadOfSign(sign));
        if ((sign == "<" || sign == ">") && isPair(i))
            return errorAt(tokens[i],
                           quoted(std::string(sign) + std::string(sign)) + " is not part of this language." +
                               (i > 0 && tokens.is(i - 1, "cout")
                                    ? " A listing cannot print: its values are shown beside its lines."
                                    : ""));
        if (sign != "&" && sign != "|")
            continue;
        if (!isPair(i))
            return errorAt(tokens[i], quoted(sign) + " is not part of this language. Did you mean " +
                                          quoted(std::string(2, sign.front())) + "?");
        ++i;
    }
    return {};
}

Violation callViolation(const Tokens &tokens)
{
    std::vector<std::string_view> withoutValue;
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
        if (tokens.is(i, "void") && tokens.isWord(i + 1) && tokens.is(i + 2, "("))
            withoutValue.push_back(tokens[i + 1].text);
    }
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const bool isDeclared = i > 0 && tokens.is(i - 1, "void");
        if (tokens.is(i, "void") && !(tokens.isWord(i + 1) && tokens.is(i + 2, "(")))
            return errorAt(tokens[i], "'void' is only for functions, for example 'void frame()'.");
        const std::string_view name = tokens[i].text;
        if (isPrimitive(name) && tokens.is(i + 1, "(") &&
            std::none_of(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                         tokens.begin() + static_cast<std::ptrdiff_t>(tokens.closing(i + 1)),
                         [](const Token &token) { return token.kind == Token::Kind::word; }))
            return errorAt(tokens[i], "Write the number itself, without '" + std::string(name) + "(...)'.");
        if (isDeclared || std::find(withoutValue.begin(), withoutValue.end(), name) == withoutValue.end())
            continue;
        const bool beginsStatement = i > 0 && isAnyOf(tokens[i - 1].text, {";", "{", "}", ")", "else", "do"});
        if (!beginsStatement || !tokens.is(i + 1, "(") || !tokens.is(tokens.closing(i + 1) + 1, ";"))
            return errorAt(tokens[i], quoted(name) + " returns no value, so call it on its own: '" +
                                          std::string(name) + "(...);'.");
    }
    return {};
}

/// Returns whether a variable stands before the assignment at token `i`.
bool followsVariable(const Tokens &tokens, std::size_t i)
{
    std::size_t at = i;
    while (at > 0 && tokens[at - 1].text.find_first_of("+-*/%") == 0) // += and the like
        --at;
    if (at == 0 || !(tokens.isWord(at - 1) || tokens.is(at - 1, "]")))
        return false;
    while (at > 0) {
        const std::string_view before = tokens[at - 1].text;
        if (before == "]") {
            std::size_t open = at - 1; // index of the bracket that this one closes
            while (open > 0 && tokens.closing(open) != at - 1)
                --open;
            at = open;
        } else if (tokens.isWord(at - 1) || before == ".") {
            --at;
        } else {
            return isAnyOf(before, {";", "{", "}", ")", "(", ","});
        }
    }
    return true;
}

Violation assignmentViolation(const Tokens &tokens)
{
    std::vector<bool> isForHead; // per open bracket
    bool isSet = false;          // whether the current statement has an assignment
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view sign = tokens[i].text;
        if (opens(sign)) {
            isForHead.push_back(i > 0 && sign == "(" && tokens.is(i - 1, "for"));
            isSet = isSet && sign != "{";
        } else if (closes(sign) && !isForHead.empty()) {
            isSet = isSet && sign != "}" && !isForHead.back();
            isForHead.pop_back();
        }
        const bool isInside = !tokens.isInBlock(i) && !isForHead.empty() && !isForHead.back();
        if (sign == ";" || (sign == "," && !isInside))
            isSet = false;
        if (sign != "=")
            continue;
        if (tokens.touches(i, "=")) { // ==
            ++i;
            continue;
        }
        if (i > 0 && isAnyOf(tokens[i - 1].text, {"<", ">", "!"}) && tokens.touches(i - 1, "="))
            continue; // a comparison
        if (isInside || isSet)
            return errorAt(tokens[i],
                           "'=' sets a value, and can be used once in a statement. To compare, write '=='.");
        if (!followsVariable(tokens, i))
            return errorAt(tokens[i],
                           "Only a variable can be set: a name, with members or an index behind it.");
        isSet = true;
    }
    return {};
}

Violation comparisonViolation(const Tokens &tokens)
{
    std::vector<bool> compares = {false}; // per open bracket: whether its current part has a comparison
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view sign = tokens[i].text;
        const bool isTwoSigns = tokens.touches(i, "=");
        if (opens(sign)) {
            compares.push_back(false);
        } else if (closes(sign) && compares.size() > 1) {
            compares.pop_back();
        } else if (sign == "<" || sign == ">" || ((sign == "=" || sign == "!") && isTwoSigns)) {
            if (compares.back())
                return errorAt(tokens[i], "Compare two values at a time, for example 'a < b && b < c'.");
            compares.back() = true;
            i += isTwoSigns ? 1 : 0;
        } else if (isAnyOf(sign, {";", ",", "?", ":", "&", "|", "and", "or", "=", "return"})) {
            compares.back() = false;
        }
        if (sign == "}")
            compares.back() = false;
    }
    return {};
}

}

CompileError errorAt(const Token &token, std::string sentence)
{
    return {token.line, token.column, static_cast<int>(token.text.size()), std::move(sentence)};
}

std::string quoted(std::string_view text)
{
    return "'" + std::string(text) + "'";
}

bool isPrimitive(std::string_view word)
{
    return word == "double" || word == "int" || word == "bool";
}

std::optional<CompileError> outsideLanguage(const Tokens &tokens)
{
    const Violation bounds = boundsViolation(tokens);
    return bounds ? bounds : signViolation(tokens);
}

std::optional<CompileError> brokenRule(const Tokens &tokens)
{
    for (const auto rule : {callViolation, assignmentViolation, comparisonViolation}) {
        if (const Violation found = rule(tokens))
            return found;
    }
    return {};
}

}
