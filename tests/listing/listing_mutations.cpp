#include "tests/listing/listing_mutations.h"

#include <QString>
#include <QStringList>

#include <algorithm>
#include <array>
#include <string_view>

namespace listing_support {

namespace {

/// A text that a mutation inserts.
const QStringList pieces =
    QString::fromLatin1(
        "sticks[i].a|Stick s;|branches[0].children[i]|direction(body, feet[i])|new_targets[0]|"
        "random(1, 2)|before|{|}|(|)|;|@|&in|[]|double|Vec2|Body|for|while|if|return|class|funcdef|const|"
        "null|cast<Body>|is|0x|1e308|-|*|%|/|<<|?|:|::|namespace|import|interface|mixin|auto|private|"
        "enum|typedef|operator|opCall|this|super|array|string|try|catch|feet[i]|body|body = body|Body b;|"
        "Body b = body;|int f(){return f();}|1/0|1%0|\"x\"|'c'|~|^^|&&|get_x|set|property|shared|"
        "external|abstract|final|feet.count|creatures[i]|Creature c;|me.body|while (true)|do|"
        "switch (1) {|case 1:|default:|**|random(-1)|double g = 1;|break;|continue;|bodies[i]|other|"
        "me.position|time|Vec2 force(Body me)|return Vec2(1, 2);")
        .split('|');

/// Changes a text that is not empty once.
void mutateOnce(std::string &text, std::mt19937 &random)
{
    const auto below = [&](std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
    };
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    /// Returns the position and the length of a random word of the text.
    const auto randomWord = [&] {
        std::size_t at = below(text.size());
        while (at < text.size() && !isLetter(text[at]))
            ++at;
        std::size_t first = at;
        while (first > 0 && first <= text.size() && isLetter(text[first - 1]))
            --first;
        while (at < text.size() && isLetter(text[at]))
            ++at;
        return std::pair(first, at - first);
    };
    const std::size_t at = below(text.size());
    switch (below(8)) {
    case 0:
        text[at] = static_cast<char>(below(256));
        break;
    case 1:
        text.erase(at, 1 + below(12));
        break;
    case 2:
        text.insert(at, " " + pieces[qsizetype(below(std::size_t(pieces.size())))].toStdString() + " ");
        break;
    case 3:
        text.insert(at, text.substr(below(text.size()), below(40)));
        break;
    case 4: { // a line twice, or not at all
        const std::size_t first = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
        const std::size_t end = std::min(text.find('\n', first), text.size() - 1) + 1;
        if (below(2) == 0)
            text.insert(first, text.substr(first, end - first));
        else
            text.erase(first, end - first);
        break;
    }
    case 5: { // another sign
        static constexpr std::string_view signs = "+-*/%<>=!&|^";
        const std::size_t sign = text.find_first_of(signs, at);
        if (sign != std::string::npos)
            text[sign] = signs[below(signs.size())];
        break;
    }
    case 6: { // another number
        static constexpr std::array<const char *, 10> numbers = {
            "0", "1", "-1", "2", "7", "1e308", "1e-308", "2147483647", "0.5", "100"};
        const std::size_t digit = text.find_first_of("0123456789", at);
        if (digit != std::string::npos)
            text.replace(digit, 1, numbers[below(numbers.size())]);
        break;
    }
    default: { // a word of the listing in the place of another one
        const auto [from, length] = randomWord();
        const std::string word = text.substr(std::min(from, text.size()), length);
        const auto [to, replaced] = randomWord();
        text.replace(std::min(to, text.size()), replaced, word);
    }
    }
}

}

std::string mutated(std::string text, std::mt19937 &random)
{
    const auto isHeads = [&] { return std::bernoulli_distribution()(random); };
    int mutations = 1;
    while (mutations < 4 && isHeads())
        ++mutations;
    for (int i = 0; i < mutations; ++i) {
        if (text.empty())
            text = " ";
        mutateOnce(text, random);
    }
    return text;
}

}
