#include "app/listing/compile_sentences.h"

#include "app/listing/language.h"
#include "app/listing/language_rules.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace listing {

namespace {

/// What stands in a message in place of each gap of its pattern.
using Gaps = std::vector<std::string>;

/// Returns the gaps of `message`, if it matches `pattern`: a text in which each `*` stands for anything.
std::optional<Gaps> gapsOf(std::string_view message, std::string_view pattern)
{
    Gaps gaps;
    std::size_t star = pattern.find('*');
    if (message.substr(0, star) != pattern.substr(0, star))
        return {};
    while (star != std::string_view::npos) {
        message.remove_prefix(star);
        pattern.remove_prefix(star + 1);
        star = pattern.find('*');
        const std::string_view next = pattern.substr(0, star);
        const std::size_t end = next.empty() ? message.size() : message.find(next);
        if (end == std::string_view::npos)
            return {};
        gaps.emplace_back(message.substr(0, end));
        message.remove_prefix(end);
        star = star == std::string_view::npos ? star : next.size();
    }
    return gaps;
}

/// Returns a type or a call as listings write it: without `const`, `&` and `@`.
std::string plainType(std::string type)
{
    for (const std::string_view part : {"const ", "@const", "const", "&", "@"}) {
        for (std::size_t at = type.find(part); at != std::string::npos; at = type.find(part, at))
            type.erase(at, part.size());
    }
    return type;
}

constexpr const char *arrayAsOne =
    "This is an array of bodies. Choose one of them first, for example with [0].";
constexpr const char *usesOfBodies = " Use the position or the velocity of the body.";
constexpr const char *valueAsCondition =
    "A condition is true or false. Compare this with something, for example with == or >.";

/// Returns "a double" or "an int".
std::string withArticle(const std::string &article, const std::string &type)
{
    const std::string plain = plainType(type);
    const bool startsWithVowel =
        !plain.empty() && std::string("aeiou").find(plain.front()) != std::string::npos;
    return article + (startsWithVowel ? "n " : " ") + plain;
}

/// Returns " Did you mean ...?", or an empty string.
std::string hintFor(const std::string &word, const std::vector<std::string> &candidates)
{
    const std::string closest = closestName(word, candidates);
    return closest.empty() ? std::string() : " Did you mean " + quoted(closest) + "?";
}

bool has(const std::vector<std::string> &names, const std::string &name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> typeNames(const Vocabulary &vocabulary)
{
    std::vector<std::string> names = {"double", "int", "bool", "Vec2", "Body"};
    if (vocabulary.hasCreatures)
        names.push_back("Creature");
    if (vocabulary.hasSticks)
        names.push_back("Stick");
    return names;
}

std::vector<std::string> allNames(const MarkedPlace &place)
{
    std::vector<std::string> names = bodyNames(place.vocabulary);
    const auto append = [&](const std::vector<std::string> &more) {
        names.insert(names.end(), more.begin(), more.end());
    };
    append(place.vocabulary.parameters);
    append(place.declared);
    append(commonNames());
    append(clockNames(place.vocabulary));
    return names;
}

/// Returns " This scene has body and feet, and the numbers damp and k."
std::string contentsOf(const Vocabulary &vocabulary)
{
    const std::vector<std::string> bodies = bodyNames(vocabulary);
    if (bodies.empty() && vocabulary.parameters.empty())
        return {};
    std::string sentence = " This scene has " + joined(bodies);
    if (!bodies.empty() && !vocabulary.parameters.empty())
        sentence += ", and ";
    if (!vocabulary.parameters.empty())
        sentence += (vocabulary.parameters.size() == 1 ? "the number " : "the numbers ") +
                    joined(vocabulary.parameters);
    return sentence + ".";
}

std::string noMember(const Gaps &gaps, const MarkedPlace &place)
{
    const std::string word = gaps[0], type = plainType(gaps[1]);
    const std::vector<std::string> members = membersOf(type, place.vocabulary);
    const std::string kind = type == "Bodies" || type == "Children" ? "an array of bodies"
                             : type == "Creatures"                  ? "the array of creatures"
                             : type == "Sticks"                     ? "the array of sticks"
                             : type == "Targets"                    ? "the new targets"
                             : type == "Keys"                       ? "the keys"
                                                                    : type;
    const std::string sentence = quoted(word) + " is not a member of " + kind + ".";
    if (type == "Body" && has({"x", "y"}, word))
        return sentence + " Did you mean " + quoted("position." + word) + "?";
    if (const std::string closest = hintFor(word, members); !closest.empty())
        return sentence + closest;
    const std::vector<std::string> ofElement = type == "Bodies" || type == "Children"
                                                   ? membersOf("Body", place.vocabulary)
                                               : type == "Creatures" ? membersOf("Creature", place.vocabulary)
                                               : type == "Sticks"    ? membersOf("Stick", place.vocabulary)
                                                                     : std::vector<std::string>();
    if (has(ofElement, word) || !closestName(word, ofElement).empty())
        return sentence + " Choose one of them first, for example with [0].";
    return members.empty() ? sentence : sentence + " It has " + joined(members) + ".";
}

/// Returns " Write 'body.position'." if `word` is a member of bodies, or an empty string.
std::string hintForMember(const std::string &word, const MarkedPlace &place)
{
    const Vocabulary &vocabulary = place.vocabulary;
    if (!has(membersOf("Body", vocabulary), word))
        return {};
    const std::string body = has(place.declared, "me")    ? "me"
                             : !vocabulary.bodies.empty() ? vocabulary.bodies.front()
                             : !vocabulary.arrays.empty() ? vocabulary.arrays.front().name + "[0]"
                                                          : std::string();
    return body.empty() ? body : " Write " + quoted(body + "." + word) + ".";
}

std::string noName(const Gaps &gaps, const MarkedPlace &place)
{
    const std::string &word = gaps[0];
    const std::string sentence = "There is no " + quoted(word) + ".";
    if (has({"print", "println", "printf", "cout", "console", "log"}, word))
        return sentence + " A listing cannot print: its values are shown beside its lines.";
    if (const std::string hint = hintForMember(word, place); !hint.empty())
        return sentence + hint;
    if (const std::string hint = hintFor(word, allNames(place)); !hint.empty())
        return sentence + hint;
    for (const std::string &keyword : keywords()) {
        if (isSameButForCase(word, keyword))
            return sentence + " Did you mean " + quoted(keyword) + "?";
    }
    if (place.next == "(")
        return "There is no function " + quoted(word) + ". The functions are " + joined(functionNames()) +
               ".";
    if (place.next == "=")
        return sentence + " A new variable needs a type: " + quoted("double " + word) + ", " +
               quoted("int " + word) + " or " + quoted("Vec2 " + word) + ".";
    return sentence + contentsOf(place.vocabulary);
}

std::string wrongValues(const Gaps &gaps, const MarkedPlace &place)
{
    const std::string &call = gaps[0];
    if (call.find("::") < call.find('(')) // in brackets behind an array
        return call.starts_with("Bodies") || call.starts_with("Children")
                   ? arrayAsOne
                   : "Choose one of them first, for example with [0].";
    const std::string name = call.substr(0, call.find('('));
    const std::vector<std::string> names = allNames(place);
    if (!has(names, name) && name != "Vec2")
        return "There is no function " + quoted(name) + "." + hintFor(name, names);
    const std::string form = place.word == name && !place.form.empty() ? place.form : formOf(name);
    return quoted(name) + " does not take these values: " + quoted(plainType(call)) + "." +
           (form.empty() ? "" : " Write it as " + quoted(form) + ".");
}

std::string noType(const Gaps &gaps, const MarkedPlace &place)
{
    const std::vector<std::string> types = typeNames(place.vocabulary);
    std::vector<std::string> candidates = types;
    candidates.push_back("void");
    const std::string closest = hintFor(gaps[0], candidates);
    return "There is no type " + quoted(gaps[0]) + "." +
           (closest.empty() ? " The types are " + joined(types) + "." : closest);
}

std::string wrongType(const Gaps &gaps, const MarkedPlace &)
{
    const std::string from = plainType(gaps[0]), to = plainType(gaps[1]);
    if (from == "Bodies")
        return arrayAsOne;
    const auto isNumber = [](const std::string &type) { return type == "double" || type == "int"; };
    return withArticle("A", from) + " cannot be used as " + withArticle("a", to) + "." +
           (to == "Vec2" && isNumber(from)   ? " Write a position or a velocity as 'Vec2(x, y)'."
            : to == "Vec2" && from == "Body" ? usesOfBodies
            : from == "Vec2" && isNumber(to) ? " Use its x, its y or its length."
            : to == "bool" && isNumber(from) ? " Write 'true' or 'false'."
                                             : "");
}

std::string typeAsValue(const Gaps &gaps, const MarkedPlace &place)
{
    const Vocabulary &vocabulary = place.vocabulary;
    const bool isBody = gaps[0] == "Body" && !vocabulary.bodies.empty();
    return quoted(gaps[0]) + " is a type and has no value." +
           (isBody ? " Write " + quoted(vocabulary.bodies.front()) + "." : "");
}

const std::string usesOfVectors = " A Vec2 can be added to a Vec2, and multiplied or divided by a number.";

std::string wrongOperands(const Gaps &gaps, const MarkedPlace &)
{
    const std::string sentence =
        "This sign does not work between " + withArticle("a", gaps[0]) + " and " + withArticle("a", gaps[1]);
    const auto isAny = [&](const char *type) {
        return plainType(gaps[0]) == type || plainType(gaps[1]) == type;
    };
    return sentence + "." + (isAny("Body") ? usesOfBodies : isAny("Vec2") ? usesOfVectors : "");
}

std::string wrongOperand(const Gaps &gaps, const MarkedPlace &)
{
    if (has(functionNames(), plainType(gaps[0])))
        return "Write it as " + quoted(formOf(plainType(gaps[0]))) + ".";
    return "This sign does not work between " + withArticle("a", gaps[0]) + " and the other value." +
           usesOfVectors;
}

std::string noSign(const Gaps &gaps, const MarkedPlace &place)
{
    if (gaps[0].starts_with("'Vec2'"))
        return wrongOperand({"Vec2"}, place);
    return place.word == "!" ? valueAsCondition : "This sign does not work with this value.";
}

std::string missing(const Gaps &gaps, const MarkedPlace &place)
{
    const std::string &what = gaps[0];
    const std::string where = place.isAtLineEnd ? " at the end of this line." : " here.";
    if (what.starts_with("expression value"))
        return "A value is missing" + where;
    if (what.starts_with("data type"))
        return "The name of a type is missing here: double, int, bool, Vec2 or Body.";
    if (what.starts_with("identifier"))
        return "A name is missing" + where;
    if (what.starts_with("method or property"))
        return "The name of a member is missing behind the dot.";
    return (place.isAtLineEnd && what.ends_with("';'") ? "';'" : what) + " is missing" + where;
}

std::string nameTwice(const Gaps &gaps, const MarkedPlace &)
{
    return "There already is " + quoted(gaps[0]) + " here. Use another name.";
}

std::string functionTwice(const Gaps &, const MarkedPlace &place)
{
    return nameTwice({place.next}, place);
}

std::string nameOfScene(const Gaps &gaps, const MarkedPlace &)
{
    return "There already is " + quoted(gaps[0]) + " in this scene. Use another name.";
}

std::string noChange(const Gaps &, const MarkedPlace &place)
{
    const std::vector<Vocabulary::Array> &arrays = place.vocabulary.arrays;
    const bool isArray = std::any_of(arrays.begin(), arrays.end(), [&](const Vocabulary::Array &array) {
        return array.name == place.word;
    });
    if (has(place.vocabulary.bodies, place.word) || isArray)
        return "A Body cannot be replaced by another one. Set its position or its velocity.";
    if (!place.isMember && has(place.vocabulary.parameters, place.word))
        return "This is a parameter. Set it with its slider.";
    return "This cannot be changed. A listing changes positions, velocities and its own variables.";
}

std::string noReplacement(const Gaps &gaps, const MarkedPlace &)
{
    if (plainType(gaps[0]) == "Body")
        return "A Body cannot be replaced by another one. Set its position or its velocity.";
    return withArticle("A", gaps[0]) + " cannot be set as a whole.";
}

std::string noValue(const Gaps &gaps, const MarkedPlace &)
{
    return quoted(gaps[0]) + " has no value yet.";
}

std::string unexpected(const Gaps &gaps, const MarkedPlace &)
{
    return quoted(gaps[0]) + " does not belong here.";
}

std::string noFunction(const Gaps &gaps, const MarkedPlace &)
{
    return quoted(gaps[0]) + " is " + withArticle("a", gaps[1]) +
           " here, not a function. To multiply, write '*'.";
}

std::string droppedFraction(const Gaps &, const MarkedPlace &place)
{
    const bool canRound =
        !has(place.vocabulary.parameters, "floor"); // the place of a floor hides the function
    return std::string("An 'int' keeps no fraction, and this value may have one. Write 'double'") +
           (canRound ? ", or round down with 'floor(...)'." : ".");
}

/// A message of the interpreter, with `*` in place of names, and its sentence.
struct Rule
{
    const char *pattern;
    std::string (*sentence)(const Gaps &gaps, const MarkedPlace &place) = nullptr;
    const char *fixed = ""; ///< the sentence, if it has no names
};

constexpr Rule changeRules[] = {
    {"Reference is read-only*", noChange},
    {"Expression is not an l-value*", noChange},
    {"Not a valid lvalue*", noChange},
    {"Not a valid reference*", noChange},
};

constexpr Rule fractionRules[] = {
    {"Float value truncated*", droppedFraction},
    {"Implicit conversion of value is not exact*", droppedFraction},
};

constexpr Rule rules[] = {
    {"'*' is not a member of '*'", noMember},
    {"No matching symbol '*'", noName},
    {"No matching signatures to '*'", wrongValues},
    {"Identifier '*' is not a data type*", noType},
    {"Expression doesn't form a function call. '*' evaluates to the non-function type '*'*", noFunction},
    {"Can't implicitly convert from '*' to '*'.", wrongType},
    {"No conversion from '*' to math type*", wrongOperand},
    {"No conversion from '*' to '*'*", wrongType},
    {"No matching operator that takes the types '*' and '*' found", wrongOperands},
    {"No appropriate opAssign method found in '*'*", noReplacement},
    {"'*' is already declared*", nameTwice},
    {"Name conflict. '*' *", nameOfScene},
    {"Variable '*' hides another variable of same name*", nameTwice},
    {"'*' is not initialized*", noValue},
    {"Expected *", missing},
    {"Expression must be of boolean type*", nullptr, valueAsCondition},
    {"Illegal operation on *", noSign},
    {"Function 'op*' not found*", noSign},
    {"Expression '*' is a data type*", typeAsValue},
    {"A function with the same name and parameters already exists*", functionTwice},
    {"Divide by zero*", nullptr, "This divides by 0."},
    {"Invalid 'break'*", nullptr, "'break' works only in a loop."},
    {"Invalid 'continue'*", nullptr, "'continue' works only in a loop."},
    {"Expression doesn't evaluate to a function*", nullptr,
     "This is not a function. To multiply, write '*'."},
    {"Type '*' doesn't support the indexing operator*", nullptr, "Only an array has an index in '[...]'."},
    {"Unexpected token '*'*", unexpected},
    {"Can't find unambiguous implicit conversion to make both expressions have the same type*", nullptr,
     "Both values of a choice with ? need the same type. Write '1.0' for '1' beside a double."},
    {"Can't return value when return type is 'void'*", nullptr,
     "A 'void' function returns no value. Write 'return;'."},
    {"Must return a value*", nullptr, "This function has to return a value."},
    {"Not all paths return a value*", nullptr,
     "This function can end without 'return'. It has to return a value in every case."},
    {"Unexpected end of file*", nullptr, "The text ends too early: a '}' or a ')' is missing."},
    {"No default constructor for object of type 'Body'*", nullptr,
     "A Body variable needs a body, for example 'Body first = feet[0];'."},
    {"Non-terminated string*", nullptr, "Texts in quotes are not part of this language."},
};

bool matchesAny(const std::string &message, std::span<const Rule> some)
{
    return std::any_of(some.begin(), some.end(),
                       [&](const Rule &rule) { return gapsOf(message, rule.pattern).has_value(); });
}

}

bool isAboutChange(const std::string &message)
{
    return matchesAny(message, changeRules);
}

bool isAboutFraction(const std::string &message)
{
    return matchesAny(message, fractionRules);
}

bool isAboutGap(const std::string &message)
{
    return message.starts_with("Expected ");
}

std::string plainSentence(const std::string &message, const MarkedPlace &place)
{
    if (isAboutChange(message))
        return noChange({}, place);
    if (isAboutFraction(message))
        return droppedFraction({}, place);
    for (const Rule &rule : rules) {
        if (const std::optional<Gaps> gaps = gapsOf(message, rule.pattern))
            return rule.sentence ? rule.sentence(*gaps, place) : rule.fixed;
    }
    const bool ends = message.ends_with('.') || message.ends_with('?');
    return ends ? message : message + ".";
}

}
