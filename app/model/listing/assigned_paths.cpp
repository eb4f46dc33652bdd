#include "app/model/listing/assigned_paths.h"

#include <algorithm>

namespace app {

namespace {

/// Returns whether token `i` is an `=` that sets a value.
bool setsValue(const listing::Tokens &tokens, std::size_t i)
{
    if (!tokens.is(i, "=") || tokens.touches(i, "=") || i == 0)
        return false;
    const bool isComparison =
        tokens.touches(i - 1, "=") && listing::isAnyOf(tokens[i - 1].text, {"=", "<", ">", "!"});
    return !isComparison;
}

/// Returns the index of the token that ends the statement or the part of a list at token `i`.
std::size_t endOfValue(const listing::Tokens &tokens, std::size_t i)
{
    while (i < tokens.size() && !tokens.is(i, ";") && !tokens.is(i, ",") && !listing::closes(tokens[i].text))
        i = tokens.behind(i);
    return std::min(i, tokens.size());
}

}

bool declaresVariable(const listing::Tokens &tokens, std::size_t i)
{
    if (!tokens.isWord(i + 1) || !listing::isAnyOf(tokens[i].text, {"double", "int", "bool", "Vec2", "Body"}))
        return false;
    return !tokens.is(i + 2, "(") || tokens.is(tokens.closing(i + 2) + 1, ";");
}

std::size_t beginOfPath(const listing::Tokens &tokens, std::size_t last)
{
    std::size_t at = last;
    while (true) {
        if (tokens.is(at, "]")) {
            std::size_t open = at;
            while (open > 0 && tokens.closing(open) != at)
                --open;
            if (tokens.closing(open) != at || open == 0)
                return at;
            at = open - 1;
            continue;
        }
        if (at >= 2 && tokens.is(at - 1, "."))
            at -= 2;
        else
            return at;
    }
}

std::string joinedPath(const listing::Tokens &tokens, std::size_t begin, std::size_t end)
{
    std::string path;
    for (std::size_t i = begin; i < end && i < tokens.size(); ++i)
        path += tokens[i].text;
    return path;
}

std::vector<Assignment> assignmentsIn(const listing::Tokens &tokens)
{
    std::vector<Assignment> all;
    const auto endsPath = [&](std::size_t i) { return tokens.isWord(i) || tokens.is(i, "]"); };
    const auto add = [&](std::size_t last, std::size_t value, bool isPlain) {
        const std::size_t begin = beginOfPath(tokens, last);
        if (tokens.isWord(begin))
            all.push_back({tokens[begin].line, joinedPath(tokens, begin, last + 1), begin, value,
                           endOfValue(tokens, value), isPlain, !tokens.isInBlock(begin)});
    };
    for (std::size_t i = 1; i < tokens.size(); ++i) {
        if (tokens.is(i, "(") && i >= 2 && declaresVariable(tokens, i - 2)) { // Vec2 centre(x, y);
            all.push_back({tokens[i - 1].line, std::string(tokens[i - 1].text), i - 1, i + 1,
                           tokens.closing(i), true, !tokens.isInBlock(i - 1)});
        } else if (setsValue(tokens, i)) {
            const bool isCompound =
                tokens.touches(i - 1, "=") && listing::isAnyOf(tokens[i - 1].text, {"+", "-", "*", "/", "%"});
            const std::size_t before = isCompound ? 2 : 1;
            if (i >= before && endsPath(i - before))
                add(i - before, i + 1, !isCompound);
        } else if ((tokens.is(i, "+") && tokens.touches(i, "+")) ||
                   (tokens.is(i, "-") && tokens.touches(i, "-"))) {
            if (endsPath(i - 1)) {
                add(i - 1, i + 2, false);
            } else if (tokens.isWord(i + 2)) { // ++i
                std::size_t last = i + 2;
                while (tokens.is(last + 1, ".") && tokens.isWord(last + 2))
                    last += 2;
                add(last, last + 1, false);
            }
            ++i;
        }
    }
    return all;
}

}
