#include "app/model/listing/listing_names.h"

#include "app/listing/language.h"
#include "app/listing/source_scan.h"
#include "app/model/listing/assigned_paths.h"

#include <algorithm>

namespace app {

namespace {

using listing::Tokens;

bool contains(const std::vector<std::string> &names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Returns the type of the path that ends with token `last`: "Body", "Bodies", "Vec2"... Empty if it is not known.
std::string typeOf(const Tokens &tokens, std::size_t last, const listing::Vocabulary &vocabulary)
{
    const std::size_t begin = beginOfPath(tokens, last);
    const std::string_view root = tokens[begin].text, word = tokens[last].text;
    if (word == "position" || word == "velocity" || word == "before")
        return "Vec2";
    if (last != begin && word == "children")
        return "Children";
    if (last != begin && word == "feet")
        return "Bodies";
    if (last != begin && (word == "body" || word == "a" || word == "b"))
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
    if (root == "pointer" || root == "target" || root == "hand")
        return "Vec2";
    std::string type;
    for (std::size_t i = 0; i < last; ++i) { // the last declaration before it
        const bool isType =
            tokens.is(i, "Vec2") || tokens.is(i, "Body") || tokens.is(i, "Creature") || tokens.is(i, "Stick");
        if (isType && tokens.is(i + 1, root))
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
        append(vocabulary.bodies);
        append(vocabulary.parameters);
        append(listing::keywords());
        append(listing::commonNames());
        for (const listing::Vocabulary::Array &array : vocabulary.arrays)
            names.push_back(array.name);
        if (vocabulary.hasGait && !vocabulary.hasCreatures)
            append({"gait", "gait_speed"});
        if (vocabulary.hasTree)
            append({"gust", "gust_known"});
        if (vocabulary.hasGust)
            append({"gust_front", "gust_tail"});
        if (vocabulary.hasCreatures)
            append({"creatures", "Creature"});
        if (vocabulary.hasSticks)
            append({"sticks", "Stick"});
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
