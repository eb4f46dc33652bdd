#include "app/listing/common_slips.h"

#include "app/listing/language.h"
#include "app/listing/language_rules.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace listing {

namespace {

using Slip = std::optional<CompileError>;

const char *const loopForm = "A loop is written 'for (int i = 0; i < 5; i++)'.";
const char *const vectorForm = "Write a position or a velocity as 'Vec2(x, y)'.";
const char *const memberForm = "Write '.' between a body and its member, for example 'body.position'.";

/// Returns the mistake that the ';' at token `i` leaves a head such as `if (...)` without its lines.
Slip emptyBody(const Tokens &tokens, std::size_t i, std::string_view head)
{
    return errorAt(tokens[i],
                   "This ';' ends " + quoted(head) + ", so that nothing belongs to it. Delete the ';'.");
}

/// Returns whether the brackets that token `i` opens have `text` directly inside.
bool hasInside(const Tokens &tokens, std::size_t i, std::string_view text)
{
    for (std::size_t inner = i + 1; inner < tokens.closing(i); inner = tokens.behind(inner)) {
        if (tokens.is(inner, text))
            return true;
    }
    return false;
}

/// Returns the first bracket without a partner. A brace that is never closed is not one: the text may end too early.
Slip unpairedBracket(const Tokens &tokens)
{
    std::vector<std::size_t> open;
    const auto partnerOf = [](std::string_view bracket) -> std::string_view {
        static constexpr std::string_view brackets = "()[]{}";
        return brackets.substr(brackets.find(bracket) ^ 1, 1);
    };
    const auto unpaired = [&](std::size_t i) {
        return errorAt(tokens[i], "This " + quoted(tokens[i].text) + " has no " +
                                      quoted(partnerOf(tokens[i].text)) + ".");
    };
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view sign = tokens[i].text;
        const bool isInBrackets = !open.empty() && !tokens.is(open.back(), "{");
        const bool isForHead = isInBrackets && open.back() > 0 && tokens.is(open.back() - 1, "for");
        if (isInBrackets && (sign == "{" || sign == "}" || (sign == ";" && !isForHead)))
            return unpaired(open.back());
        if (opens(sign)) {
            open.push_back(i);
        } else if (closes(sign)) {
            if (open.empty() || !tokens.is(open.back(), partnerOf(sign)))
                return unpaired(i);
            open.pop_back();
        }
    }
    if (!open.empty() && !tokens.is(open.back(), "{"))
        return unpaired(open.back());
    return {};
}

/// Returns the mistake that an array is declared: "array<double> a", "double[] a" or "double a[5]".
Slip newArray(const Tokens &tokens)
{
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const bool isType = isPrimitive(tokens[i].text) || isAnyOf(tokens[i].text, {"Vec2", "Body"});
        const bool isArray =
            (isType && (tokens.is(i + 1, "[") || (tokens.isWord(i + 1) && tokens.is(i + 2, "[")))) ||
            (tokens.is(i, "array") && tokens.is(i + 1, "<") && tokens.isWord(i + 2) && tokens.is(i + 3, ">"));
        if (isArray)
            return errorAt(tokens[i], "A listing cannot make arrays. Write a variable for each value.");
    }
    return {};
}

/// Returns the digits with which a number begins before a name, for example "2" of "2k". Empty if no name follows.
std::string_view factorOf(std::string_view number)
{
    const std::size_t letter = number.find_first_not_of("0123456789.");
    const bool hasOtherBase = letter == 1 && number.front() == '0'; // such as 0x1F
    if (letter == std::string_view::npos || hasOtherBase)
        return {};
    const std::string_view behind = number.substr(letter);
    const bool isExponent = isAnyOf(behind.substr(0, 1), {"e", "E"}) &&
                            behind.find_first_not_of("0123456789", 1) == std::string_view::npos;
    return isExponent ? std::string_view() : number.substr(0, letter);
}

Slip numberSlip(const Tokens &tokens, std::size_t i)
{
    const Token &number = tokens[i];
    const std::string text(number.text);
    const auto product = [&](const std::string &factor, const std::string &name) {
        return errorAt(number,
                       "Write '*' between a number and a name: " + quoted(factor + " * " + name) + ".");
    };
    if (const std::string factor(factorOf(number.text)); !factor.empty()) {
        const bool isName =
            i > 0 && (isPrimitive(tokens[i - 1].text) || isAnyOf(tokens[i - 1].text, {"Vec2", "Body"}));
        return isName ? errorAt(number, "A name begins with a letter.")
                      : product(factor, text.substr(factor.size()));
    }
    if (tokens.isWord(i + 1) && tokens[i + 1].line == number.line &&
        !isAnyOf(tokens[i + 1].text, {"and", "or", "else"}))
        return product(text, std::string(tokens[i + 1].text));
    if (tokens.is(i + 1, "/") && wholeNumber(text) && tokens.isWord(i + 2) && tokens.is(i + 3, ".") &&
        tokens.is(i + 4, "count"))
        return errorAt(tokens[i + 1],
                       "Between whole numbers, '/' drops the fraction. Write " +
                           quoted(text + ".0 / " + std::string(tokens[i + 2].text) + ".count") + ".");
    if (i + 2 >= tokens.size() || tokens[i + 2].kind != Token::Kind::number)
        return {};
    const std::string next(tokens[i + 2].text);
    if (tokens.isInBlock(i) && tokens.touches(i, ",") && tokens[i + 2].offset == tokens[i + 1].end()) {
        Slip found = errorAt(number, "A number has a point, not a comma: " + quoted(text + "." + next) + ".");
        found->length = static_cast<int>(tokens[i + 2].end() - number.offset);
        return found;
    }
    const std::optional<int> a = wholeNumber(number.text), b = wholeNumber(tokens[i + 2].text);
    if (tokens.is(i + 1, "/") && a && b && *b != 0 && *a % *b != 0)
        return errorAt(tokens[i + 1], "Between whole numbers, '/' drops the fraction: this is " +
                                          std::to_string(*a / *b) + ". Write " +
                                          quoted(text + ".0 / " + next) + ".");
    return {};
}

/// Returns whether the statement around token `i` neither sets nor returns a value before it.
bool beginsWithoutEffect(const Tokens &tokens, std::size_t i)
{
    while (i-- > 0) {
        if (!tokens.isInBlock(i))
            continue;
        const std::string_view text = tokens[i].text;
        if (isAnyOf(text, {";", "{", "}"}))
            return true;
        if (isAnyOf(text, {"=", "return", "?", "while"}))
            return false;
    }
    return false;
}

Slip equalsSlip(const Tokens &tokens, std::size_t i)
{
    if (tokens.touches(i, "=") && tokens.isInBlock(i) && beginsWithoutEffect(tokens, i) &&
        tokens[i - 1].end() <= tokens[i].offset && !isAnyOf(tokens[i - 1].text, {"!", "<", ">", "="}))
        return errorAt(tokens[i], "'==' compares and changes nothing. To set a value, write '='.");
    if (tokens.touches(i, "+") && !tokens.touches(i + 1, "+"))
        return errorAt(tokens[i], "Write '+=' to add to a value.");
    if (tokens.touches(i, "-") && i + 2 < tokens.size() && tokens[i + 2].offset > tokens[i + 1].end())
        return errorAt(tokens[i], "Write '-=' to subtract from a value.");
    for (const char *const sign : {">", "<"}) {
        if (tokens.touches(i, sign))
            return errorAt(tokens[i], "Write " + quoted(std::string(sign) + "=") + " to compare.");
    }
    return {};
}

Slip signSlip(const Tokens &tokens, std::size_t i)
{
    const std::string sign(tokens[i].text);
    if (sign == "=")
        return equalsSlip(tokens, i);
    if (sign == "(" && i > 0 && !closes(tokens[i - 1].text) && hasInside(tokens, i, ",") &&
        (!tokens.isWord(i - 1) || tokens.is(i - 1, "return")))
        return errorAt(tokens[i], vectorForm);
    if ((sign == "[" || sign == "{") && i > 0 && (tokens.is(i - 1, "=") || tokens.is(i - 1, "return")) &&
        hasInside(tokens, i, ","))
        return errorAt(tokens[i], vectorForm);
    if (sign == "]" && tokens.isWord(i + 1) && tokens[i + 1].line == tokens[i].line &&
        !isAnyOf(tokens[i + 1].text, {"and", "or", "else"}))
        return errorAt(tokens[i + 1], "'.' is missing before " + quoted(tokens[i + 1].text) + ".");
    if (sign == "," && i > 1 && tokens.isInBlock(i) && tokens.is(i - 2, ".") &&
        isAnyOf(tokens[i - 1].text, {"position", "velocity", "before"}) &&
        (tokens.is(i + 1, "x") || tokens.is(i + 1, "y")))
        return errorAt(tokens[i], memberForm);
    if (sign == "<" && tokens.touches(i, ">"))
        return errorAt(tokens[i], "Write '!=' to compare.");
    if (isAnyOf(sign, {"+", "-", "*", "/"}) && tokens.is(i + 1, "=") && !tokens.touches(i, "=") &&
        !tokens.touches(i + 1, "="))
        return errorAt(tokens[i], "Write " + quoted(sign + "=") + " without a space in between.");
    if (sign == "-" && tokens.touches(i, ">"))
        return errorAt(tokens[i], memberForm);
    return {};
}

Slip conditionSlip(const Tokens &tokens, std::size_t i)
{
    const std::string word(tokens[i].text);
    if (!tokens.is(i + 1, "("))
        return errorAt(tokens[i], "A condition needs brackets: " + quoted(word + " (...)") + ".");
    const std::size_t behind = tokens.closing(i + 1) + 1;
    if (tokens.is(behind, ":"))
        return errorAt(tokens[behind],
                       "Leave out the ':'. The lines that belong to a condition go between '{' and '}'.");
    if (tokens.is(behind, "then"))
        return errorAt(tokens[behind], "'then' is not part of this language. Leave it out.");
    if (word == "if" && tokens.is(behind, ";"))
        return emptyBody(tokens, behind, word);
    return {};
}

std::string lowerCase(std::string_view word)
{
    std::string lower(word);
    for (char &letter : lower)
        letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    return lower;
}

/// Returns a mistake at a word such as `if` or `for`.
Slip keywordSlip(const Tokens &tokens, std::size_t i)
{
    const std::string word(tokens[i].text);
    if (const std::string lower = lowerCase(word);
        lower != word && isAnyOf(lower, {"if", "else", "for", "while", "return"}))
        return errorAt(tokens[i], "Write " + quoted(lower) + " with small letters.");
    if (isAnyOf(word, {"elif", "elseif", "elsif"}))
        return errorAt(tokens[i], quoted(word) + " is not part of this language. Use 'else if'.");
    if (word == "new" && tokens.isWord(i + 1))
        return errorAt(tokens[i], "'new' is not part of this language. Leave it out.");
    if (word == "for") {
        const bool isOverValues = hasInside(tokens, i + 1, ":") && !hasInside(tokens, i + 1, "?");
        const bool isWhole = tokens.is(i + 1, "(") && hasInside(tokens, i + 1, ";");
        if (!isWhole || isOverValues)
            return errorAt(tokens[i], loopForm);
        const std::size_t behind = tokens.closing(i + 1) + 1;
        return tokens.is(behind, ";") ? emptyBody(tokens, behind, word) : Slip();
    }
    if (isAnyOf(word, {"if", "while"}))
        return conditionSlip(tokens, i);
    if (word == "else" && i > 0 && !isAnyOf(tokens[i - 1].text, {";", "{", "}"}))
        return errorAt(tokens[i], "';' is missing before 'else'.");
    return {};
}

/// Returns whether a value ends with token `i`, so that no word can follow.
bool endsValue(const Tokens &tokens, std::size_t i)
{
    const Token &token = tokens[i];
    if (token.kind == Token::Kind::number || token.text == "]")
        return true;
    if (token.kind == Token::Kind::word)
        return !isPrimitive(token.text) &&
               !isAnyOf(token.text,
                        {"if", "else", "for", "while", "do", "return", "break", "continue", "const", "void",
                         "auto", "and", "or", "not", "Vec2", "Body", "Creature", "Stick"});
    if (token.text != ")")
        return false;
    for (std::size_t open = i; open-- > 0;) {
        if (tokens.closing(open) != i)
            continue;
        const bool isHead = open > 0 && isAnyOf(tokens[open - 1].text, {"if", "for", "while"});
        const bool isFunction = open > 1 && tokens.isWord(open - 1) && tokens.isWord(open - 2) &&
                                tokens[open - 2].text != "return";
        return !isHead && !isFunction;
    }
    return false;
}

/// Returns the mistake that no ';' stands at the end of the line of token `i`. The next statement would look like a part
/// of this one.
Slip lineEndSlip(const Tokens &tokens, std::size_t i)
{
    const bool isBetweenLines = tokens.isWord(i + 1) && tokens[i + 1].line > tokens[i].line;
    if (!isBetweenLines || !tokens.isInBlock(i + 1) || isAnyOf(tokens[i + 1].text, {"and", "or", "else"}) ||
        !endsValue(tokens, i))
        return {};
    return errorAt(tokens[i], "';' is missing at the end of this line.");
}

/// Returns a mistake in the statement that begins at token `i`, outside of all functions.
Slip slipOutside(const Tokens &tokens, std::size_t i)
{
    if (!tokens.isWord(i))
        return {};
    const std::string_view word = tokens[i].text;
    const bool isControl = isAnyOf(word, {"if", "else", "for", "while", "do", "return", "break", "continue"});
    const bool isDefinition = isAnyOf(word, {"def", "func", "fn"}) && tokens.isWord(i + 1);
    if (isDefinition || (!isControl && tokens.isHead(i)))
        return errorAt(tokens[i],
                       "A function begins with the type of its result, for example 'void' or 'Vec2'.");
    if (!isControl && tokens.isWord(i + 1)) { // a declaration
        const std::size_t behind = tokens.is(i + 2, "(") ? tokens.closing(i + 2) + 1 : tokens.size();
        const bool isCutOff = tokens.is(behind, ";") && tokens.is(behind + 1, "{");
        return isCutOff ? emptyBody(tokens, behind, tokens[i + 1].text) : Slip();
    }
    return errorAt(tokens[i], std::string("This is outside of any function. ") +
                                  (i == 0 ? "Put it between the braces of a function."
                                          : "Look for a '}' too many above."));
}

Slip slipOutside(const Tokens &tokens)
{
    for (std::size_t i = 0; i < tokens.size();) {
        if (Slip found = slipOutside(tokens, i))
            return found;
        while (i < tokens.size() && !tokens.is(i, ";") && !tokens.is(i, "{"))
            i = tokens.behind(i);
        i = tokens.is(i, "{") ? tokens.closing(i) + 1 : i + 1;
    }
    return {};
}

/// Returns the index of the token that ends the calculation which begins at token `i`.
std::size_t endOfCalculation(const Tokens &tokens, std::size_t i)
{
    while (i < tokens.size() && !isAnyOf(tokens[i].text, {";", ","}) && !closes(tokens[i].text))
        i = tokens.behind(i);
    return std::min(i, tokens.size());
}

/// Returns whether the word at token `i` is a whole number, or a part of the path to one.
bool isWholeWord(const Tokens &tokens, std::size_t i)
{
    if (tokens.is(i + 1, ".") || tokens.is(i + 1, "["))
        return true; // the last member decides
    if (tokens.is(i - 1, "."))
        return isAnyOf(tokens[i].text, {"count", "number"});
    if (tokens.is(i + 1, "("))
        return isAnyOf(tokens[i].text, {"abs", "min", "max", "clamp"});
    for (std::size_t other = 0; other < tokens.size(); ++other) {
        if (tokens.is(other, "int") && tokens.is(other + 1, tokens[i].text))
            return true;
    }
    return tokens.is(i, "frame_number");
}

/// Returns whether token `i` leaves a calculation with whole numbers one without a fraction.
bool isWhole(const Tokens &tokens, std::size_t i)
{
    const std::string_view text = tokens[i].text;
    switch (tokens[i].kind) {
    case Token::Kind::number:
        return text.find_first_not_of("0123456789") == std::string_view::npos;
    case Token::Kind::sign:
        return isAnyOf(text, {"+", "-", "*", "%", "(", ")", "[", "]", ",", "."});
    case Token::Kind::word:
        break;
    }
    return isWholeWord(tokens, i);
}

Slip slipAt(const Tokens &tokens, std::size_t i)
{
    if (Slip found = lineEndSlip(tokens, i))
        return found;
    switch (tokens[i].kind) {
    case Token::Kind::number:
        return numberSlip(tokens, i);
    case Token::Kind::sign:
        return signSlip(tokens, i);
    case Token::Kind::word:
        break;
    }
    const bool isMemberCall = i > 0 && tokens.is(i - 1, ".") && tokens.is(i + 1, "(");
    if (isMemberCall && isAnyOf(tokens[i].text, {"position", "velocity", "before", "held", "mass", "radius",
                                                 "angle", "spin", "x", "y", "count"}))
        return errorAt(tokens[i], quoted(tokens[i].text) + " is not a function. Write it without '()'.");
    if (isMemberCall)
        return errorAt(tokens[i], "A function is called without an object here: " +
                                      quoted(std::string(tokens[i].text) + "(...)") + ".");
    return keywordSlip(tokens, i);
}

}

std::optional<CompileError> commonSlip(const Tokens &tokens)
{
    if (tokens.openComment())
        return errorAt(*tokens.openComment(), "This '/*' has no '*/'.");
    if (Slip found = newArray(tokens))
        return found;
    if (Slip found = slipOutside(tokens))
        return found;
    if (Slip found = unpairedBracket(tokens))
        return found;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (Slip found = slipAt(tokens, i))
            return found;
    }
    return {};
}

std::optional<CompileError> unusedValue(const Tokens &tokens)
{
    const std::vector<std::string> functions = functionNames();
    std::size_t begin = 0;
    bool mayMatter =
        false; // whether the statement sets, declares or steers something, or calls the listing's functions
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view text = tokens[i].text;
        const bool ends = text == ";" && tokens.isInBlock(i);
        if (ends && i > begin && !mayMatter)
            return errorAt(tokens[begin],
                           "This computes a value, and nothing keeps it. To set a value, write '='.");
        if (ends || text == "{" || text == "}") {
            begin = i + 1;
            mayMatter = false;
            continue;
        }
        const bool isCall = tokens.isWord(i) && tokens.is(i + 1, "(") && text != "Vec2" &&
                            std::find(functions.begin(), functions.end(), text) == functions.end();
        const bool isCount = (text == "+" || text == "-") && tokens.touches(i, text); // ++ or --
        const bool isControl = isAnyOf(text, {"else", "do", "return", "break", "continue"});
        mayMatter = mayMatter || isCall || isCount || isControl || text == "=" ||
                    (tokens.isWord(i) && tokens.isWord(i + 1));
    }
    return {};
}

bool setsFraction(const Tokens &tokens, std::size_t i)
{
    if (i == 0 || !(tokens.is(i - 1, "=") || tokens.is(i - 1, "return")))
        return false;
    const std::size_t end = endOfCalculation(tokens, i);
    while (i < end) {
        if (tokens.is(i, "floor") && tokens.is(i + 1, "(")) {
            i = tokens.closing(i + 1) + 1;
            continue;
        }
        if (!isWhole(tokens, i))
            return true;
        ++i;
    }
    return false;
}

}
