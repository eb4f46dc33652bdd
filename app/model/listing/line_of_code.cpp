#include "app/model/listing/line_of_code.h"

#include "app/listing/tokens.h"

#include <string>
#include <vector>

namespace app {

namespace {

/// Returns whether each token is the last one before a statement that an `if`, a loop or an `else` runs.
std::vector<bool> headEnds(const listing::Tokens &tokens)
{
    std::vector<bool> ends(tokens.size() + 1, false); // one more, for a bracket that is not closed
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens.is(i, "if") || tokens.is(i, "for") || tokens.is(i, "while"))
            ends[tokens.closing(i + 1)] = true;
        else if (tokens.is(i, "else") || tokens.is(i, "do"))
            ends[i] = true;
    }
    return ends;
}

}

int lineOfCodeFrom(const QString &text, int line)
{
    const std::string source = text.toStdString();
    const listing::Tokens tokens(source);
    const std::vector<bool> endsHead = headEnds(tokens);
    int depth = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens.is(i, "{")) {
            ++depth;
        } else if (tokens.is(i, "}")) {
            if (--depth == 0 && tokens[i].line >= line) // the end of a function runs, too
                return tokens[i].line;
        } else if (depth > 0 && tokens[i].line >= line && !tokens.is(i, "else")) {
            const bool isBehindStatement = (tokens.is(i - 1, ";") && tokens.isInBlock(i)) ||
                                           tokens.is(i - 1, "{") || tokens.is(i - 1, "}");
            if (endsHead[i - 1] || isBehindStatement)
                return tokens[i].line;
        }
    }
    return 0;
}

int lineOfOpenBrace(const QString &text, int line)
{
    if (line <= 1)
        return 0;
    const std::string above = text.section('\n', 0, line - 2).toStdString();
    const listing::Tokens tokens(above);
    for (std::size_t i = tokens.size(); i-- > 0;) {
        if (tokens.is(i, "{") && tokens.closing(i) == tokens.size())
            return tokens[i].line;
    }
    return 0;
}

bool endsWithHead(const QString &code)
{
    const std::string source = code.toStdString();
    const listing::Tokens tokens(source);
    return tokens.size() > 0 && headEnds(tokens)[tokens.size() - 1];
}

}
