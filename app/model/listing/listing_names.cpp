#include "app/model/listing/listing_names.h"

#include "app/listing/language.h"
#include "app/listing/source_scan.h"
#include "app/model/catalog/lists.h"
#include "app/model/listing/assigned_paths.h"

#include <algorithm>

namespace app {

namespace {

using listing::Tokens;

/// Returns the type of the path that ends with token `last`: "Body", "Bodies", "Vec2"... Empty if it is not known.
std::string typeOf(const Tokens &tokens, std::size_t last, const listing::Vocabulary &vocabulary)
{
    const std::size_t begin = beginOfPath(tokens, last);
    const std::string_view root = tokens[begin].text, word = tokens[last].text;
    if (listing::isAnyOf(word, {"position", "velocity", "before"}))
        return "Vec2";
    if (last != begin && word == "children")
        return "Children";
    if (last != begin && word == "feet")
        return "Bodies";
    if (last != begin && listing::isAnyOf(word, {"body", "a", "b"}))
        return "Body";
    const bool isArray = std::any_of(vocabulary.arrays.begin(), vocabulary.arrays.end(),
                                     [&](const auto &one) { return one.name == root; });
    if (tokens.is(last, "]")) {
        if (root == "new_targets")
            return "Vec2";
        const bool isRoot = tokens.closing(begin + 1) == last;
        if (isRoot && root == "creatures")
            return "Creature";
        return isRoot && root == "sticks" ? "Stick" : "Body";
    }
    if (last != begin)
        return {};
    if (isArray)
        return "Bodies";
    if (root == "creatures")
        return "Creatures";
    if (root == "sticks")
        return "Sticks";
    if (root == "new_targets")
        return "Targets";
    if (contains(vocabulary.bodies, root))
        return "Body";
    if (root == "keys")
        return "Keys";
    if (listing::isAnyOf(root, {"pointer", "target", "hand"}))
        return "Vec2";
    std::string type;
    for (std::size_t i = 0; i < last; ++i) { // the last declaration before it
        if (listing::isAnyOf(tokens[i].text, {"Vec2", "Body", "Creature", "Stick"}) && tokens.is(i + 1, root))
            type = tokens[i].text;
    }
    return type;
}

}

QStringList completionsAt(const QString &text, int line, int column, const listing::Vocabulary &vocabulary)
{
    const QString before = text.section('\n', line - 1, line - 1).left(column - 1);
    if (before.contains(QStringLiteral("//")))
        return {};
    qsizetype wordBegin = before.size();
    while (wordBegin > 0 && (before[wordBegin - 1].isLetterOrNumber() || before[wordBegin - 1] == '_'))
        --wordBegin;
    const QString word = before.mid(wordBegin);
    const bool isMember = wordBegin > 0 && before[wordBegin - 1] == '.';
    if (word.isEmpty() ? !isMember : word.front().isDigit())
        return {};
    std::vector<std::string> names;
    if (isMember) {
        const QString above = line > 1 ? text.section('\n', 0, line - 2) + '\n' : QString();
        const std::string code = (above + before.left(wordBegin - 1)).toStdString();
        const Tokens tokens(code);
        if (tokens.empty() || !(tokens.isWord(tokens.size() - 1) || tokens.is(tokens.size() - 1, "]")))
            return {};
        names = listing::membersOf(typeOf(tokens, tokens.size() - 1, vocabulary), vocabulary);
    } else {
        const listing::SourceScan scan(text.toStdString());
        names = scan.declaredNames();
        const auto append = [&](const std::vector<std::string> &more) {
            names.insert(names.end(), more.begin(), more.end());
        };
        append(listing::bodyNames(vocabulary));
        append(listing::clockNames(vocabulary));
        append(vocabulary.parameters);
        append(listing::keywords());
        append(listing::commonNames());
        if (vocabulary.hasCreatures)
            append({"Creature"});
        if (vocabulary.hasSticks)
            append({"Stick"});
    }
    QStringList completions;
    for (const std::string &name : names) {
        const QString one = QString::fromStdString(name);
        if (one.startsWith(word) && one != word)
            completions << one;
    }
    completions.sort();
    completions.removeDuplicates();
    return completions;
}

std::vector<TextRange> usesOfParameters(const QString &text, const QStringList &parameters)
{
    const QByteArray bytes = text.toUtf8();
    const QList<QByteArray> lines = bytes.split('\n');
    const listing::SourceScan scan(bytes.toStdString());
    const Tokens &tokens = scan.tokens();
    std::vector<TextRange> uses;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const listing::Token &token = tokens[i];
        const bool isAlone = tokens.isWord(i) && !(i > 0 && tokens.is(i - 1, ".")) && !tokens.is(i + 1, "(");
        const QString word = QString::fromUtf8(token.text.data(), static_cast<qsizetype>(token.text.size()));
        if (!isAlone || !parameters.contains(word) || scan.declares(token.text, token.offset))
            continue;
        const QString before = QString::fromUtf8(lines[token.line - 1].left(token.column - 1));
        uses.push_back({token.line, static_cast<int>(before.size()) + 1, static_cast<int>(word.size())});
    }
    return uses;
}

}
