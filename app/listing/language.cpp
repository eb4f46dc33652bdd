#include "app/listing/language.h"

#include "app/listing/tokens.h"

#include <algorithm>
#include <array>

namespace listing {

namespace {

/// Words of the interpreter that listings leave out: they reserve memory, hide mistakes, or have no use here.
constexpr std::array<std::string_view, 35> leftOut = {
    "cast",   "catch",  "class",   "enum",      "float",  "funcdef",   "function", "import", "in",
    "inout",  "int8",   "int16",   "int32",     "int64",  "interface", "is",       "mixin",  "namespace",
    "null",   "out",    "private", "protected", "try",    "typedef",   "uint",     "uint8",  "uint16",
    "uint32", "uint64", "xor",     "super",     "switch", "case",      "default",  "struct"};

/// How functions and Vec2, the last one, are called.
constexpr std::array<std::string_view, 17> callForms = {
    "sin(angle)",         "cos(angle)",      "atan2(y, x)", "sqrt(x)",   "pow(x, y)",
    "hypot(x, y)",        "abs(x)",          "min(x, y)",   "max(x, y)", "clamp(x, 0, 1)",
    "floor(x)",           "remainder(x, y)", "random(i)",   "length(v)", "dot(v, w)",
    "direction(body, v)", "Vec2(x, y)"};

/// Returns the number of letters to insert, remove, replace or swap with a neighbour to turn `a` into `b`.
/// Source: Damerau, "A technique for computer detection and correction of spelling errors", 1964, in the form
/// without edits between swapped letters.
std::size_t spellingDistance(const std::string &a, const std::string &b)
{
    std::vector<std::vector<std::size_t>> rows(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                rows[i][j] = i + j;
                continue;
            }
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            rows[i][j] = std::min({rows[i - 1][j] + 1, rows[i][j - 1] + 1, rows[i - 1][j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                rows[i][j] = std::min(rows[i][j], rows[i - 2][j - 2] + 1);
        }
    }
    return rows[a.size()][b.size()];
}

}

bool isLeftOut(std::string_view word)
{
    const bool isOperatorMethod =
        word.size() > 2 && word.starts_with("op") && word[2] >= 'A' && word[2] <= 'Z';
    return isOperatorMethod || std::find(leftOut.begin(), leftOut.end(), word) != leftOut.end();
}

const std::vector<std::string> &keywords()
{
    static const std::vector<std::string> words = {
        "if",   "else",   "for", "while", "do",   "break", "continue", "return", "true", "false", "const",
        "void", "double", "int", "bool",  "auto", "and",   "or",       "not",    "Vec2", "Body"};
    return words;
}

const std::vector<std::string> &commonNames()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all = functionNames();
        all.insert(all.end(), {"hand", "pointer", "pointer_down", "pointer_known", "target", "new_targets",
                               "keys", "frame_number", "pi"});
        return all;
    }();
    return names;
}

std::vector<std::string> bodyNames(const Vocabulary &vocabulary)
{
    std::vector<std::string> names = vocabulary.bodies;
    for (const Vocabulary::Array &array : vocabulary.arrays)
        names.push_back(array.name);
    if (vocabulary.hasCreatures)
        names.push_back("creatures");
    if (vocabulary.hasSticks)
        names.push_back("sticks");
    return names;
}

std::vector<std::string> clockNames(const Vocabulary &vocabulary)
{
    std::vector<std::string> names;
    if (vocabulary.hasGait && !vocabulary.hasCreatures)
        names.insert(names.end(), {"gait", "gait_speed"});
    if (vocabulary.hasTree)
        names.insert(names.end(), {"gust", "gust_known"});
    if (vocabulary.hasGust)
        names.insert(names.end(), {"gust_front", "gust_tail"});
    return names;
}

std::vector<std::string> functionNames()
{
    std::vector<std::string> names;
    for (const std::string_view form : callForms)
        names.emplace_back(form.substr(0, form.find('(')));
    names.pop_back(); // Vec2
    return names;
}

std::string formOf(const std::string &function)
{
    for (const std::string_view form : callForms) {
        if (form.substr(0, form.find('(')) == function)
            return std::string(form);
    }
    return {};
}

bool isUsableName(const std::string &name)
{
    const Tokens tokens(name);
    if (!tokens.isWord(0) || tokens[0].text != name)
        return false;
    const auto has = [&](const std::vector<std::string> &words) {
        return std::find(words.begin(), words.end(), name) != words.end();
    };
    static const std::vector<std::string> own = {
        "frame",     "gait", "gait_speed", "creatures",  "Bodies",   "Creature",
        "Creatures", "Keys", "sticks",     "Stick",      "Sticks",   "Children",
        "Targets",   "gust", "gust_known", "gust_front", "gust_tail"};
    const bool isTaken = has(commonNames()) && name != "floor";
    return !has(keywords()) && !isTaken && !has(own) &&
           std::find(leftOut.begin(), leftOut.end(), std::string_view(name)) == leftOut.end();
}

std::vector<std::string> membersOf(const std::string &type, const Vocabulary &vocabulary)
{
    if (type == "Body") {
        std::vector<std::string> members = {"position", "velocity", "before", "held", "mass", "radius"};
        if (vocabulary.bodiesTurn)
            members.insert(members.end(), {"angle", "spin"});
        if (vocabulary.hasTree)
            members.insert(members.end(), {"number", "rest", "scale", "length", "inertia", "children"});
        return members;
    }
    if (type == "Vec2")
        return {"x", "y"};
    if (type == "Creature") {
        std::vector<std::string> members = {"body", "feet"};
        if (vocabulary.hasGait)
            members.insert(members.end(), {"gait", "gait_speed"});
        return members;
    }
    if (type == "Stick")
        return {"a", "b", "length", "share"};
    if (type == "Bodies" || type == "Creatures" || type == "Sticks" || type == "Children" ||
        type == "Targets")
        return {"count"};
    if (type == "Keys")
        return {"left", "right", "up", "down"};
    return {};
}

bool isSameButForCase(const std::string &a, const std::string &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return (x | 0x20) == (y | 0x20); });
}

std::string closestName(const std::string &word, const std::vector<std::string> &candidates)
{
    constexpr std::size_t fewLetters = 3; // shorter words are similar to too many others
    std::string closest, beginning;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string &candidate : candidates) {
        if (candidate == word || word.size() > 40 || candidate.size() > 40)
            continue;
        if (isSameButForCase(word, candidate))
            return candidate;
        if (std::min(word.size(), candidate.size()) < fewLetters)
            continue;
        const std::size_t distance = spellingDistance(word, candidate);
        if (distance < least && distance < candidate.size()) {
            least = distance;
            closest = candidate;
        }
        if (beginning.empty() && (candidate.starts_with(word) || word.starts_with(candidate)))
            beginning = candidate;
    }
    return closest.empty() ? beginning : closest;
}

std::string joined(const std::vector<std::string> &words)
{
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0)
            text += i + 1 == words.size() ? " and " : ", ";
        text += words[i];
    }
    return text;
}

}
