#include "app/model/text/listing_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <vector>

namespace app {

namespace {

struct ListingText
{
    Q_DECLARE_TR_FUNCTIONS(ListingText)
};

/// The sentences of app/listing, which knows no Qt, with %1 to %3 in place of names and numbers. The first one that
/// matches counts. "an" before a type stands here as "a".
constexpr const char *patterns[] = {
    // names
    QT_TRANSLATE_NOOP("ListingText", "Did you mean %1?"),
    QT_TRANSLATE_NOOP("ListingText", "%1 is not a member of an array of bodies."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is not a member of the array of creatures."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is not a member of the array of sticks."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is not a member of the new targets."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is not a member of the keys."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is not a member of %2."),
    QT_TRANSLATE_NOOP("ListingText", "It has %1."),
    QT_TRANSLATE_NOOP("ListingText", "Choose one of them first, for example with [0]."),
    QT_TRANSLATE_NOOP("ListingText", "There is no function %1."),
    QT_TRANSLATE_NOOP("ListingText", "There is no type %1."),
    QT_TRANSLATE_NOOP("ListingText", "The types are %1."),
    QT_TRANSLATE_NOOP("ListingText", "The functions are %1."),
    QT_TRANSLATE_NOOP("ListingText", "There is no %1: %2 is empty."),
    QT_TRANSLATE_NOOP("ListingText", "There is no %1: the only one is %2."),
    QT_TRANSLATE_NOOP("ListingText", "There is no %1: %2 goes from %3 to %4."),
    QT_TRANSLATE_NOOP("ListingText", "There is no %1."),
    QT_TRANSLATE_NOOP("ListingText", "This scene has %1, and the numbers %2."),
    QT_TRANSLATE_NOOP("ListingText", "This scene has %1, and the number %2."),
    QT_TRANSLATE_NOOP("ListingText", "This scene has the numbers %1."),
    QT_TRANSLATE_NOOP("ListingText", "This scene has the number %1."),
    QT_TRANSLATE_NOOP("ListingText", "This scene has %1."),
    QT_TRANSLATE_NOOP("ListingText", "There already is %1 here."),
    QT_TRANSLATE_NOOP("ListingText", "There already is %1 in this scene."),
    QT_TRANSLATE_NOOP("ListingText", "Use another name."),
    QT_TRANSLATE_NOOP("ListingText", "A new variable needs a type: %1, %2 or %3."),
    QT_TRANSLATE_NOOP("ListingText", "This is an array of bodies."),
    // types and values
    QT_TRANSLATE_NOOP("ListingText", "%1 does not take these values: %2."),
    QT_TRANSLATE_NOOP("ListingText", "A %1 cannot be used as a %2."),
    QT_TRANSLATE_NOOP("ListingText", "This sign does not work between a %1 and the other value."),
    QT_TRANSLATE_NOOP("ListingText", "This sign does not work between a %1 and a %2."),
    QT_TRANSLATE_NOOP("ListingText", "A Vec2 can be added to a Vec2, and multiplied or divided by a number."),
    QT_TRANSLATE_NOOP("ListingText", "Use the position or the velocity of the body."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is a %2 here, not a function."),
    QT_TRANSLATE_NOOP("ListingText", "This is not a function."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is not a function."),
    QT_TRANSLATE_NOOP("ListingText", "Write it without '()'."),
    QT_TRANSLATE_NOOP("ListingText", "To multiply, write '*'."),
    QT_TRANSLATE_NOOP("ListingText", "Both values of a choice with ? need the same type."),
    QT_TRANSLATE_NOOP("ListingText", "Write %1 for %2 beside a double."),
    QT_TRANSLATE_NOOP("ListingText", "Between whole numbers, '/' drops the fraction: this is %1."),
    QT_TRANSLATE_NOOP("ListingText", "Between whole numbers, '/' drops the fraction."),
    QT_TRANSLATE_NOOP("ListingText", "An 'int' keeps no fraction, and this value may have one."),
    QT_TRANSLATE_NOOP("ListingText", "Write %1, or round down with %2."),
    QT_TRANSLATE_NOOP("ListingText", "A value is missing at the end of this line."),
    QT_TRANSLATE_NOOP("ListingText", "A name is missing at the end of this line."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is missing at the end of this line."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is missing before %2."),
    QT_TRANSLATE_NOOP("ListingText", "This %1 has no %2."),
    QT_TRANSLATE_NOOP("ListingText", "A value is missing here."),
    QT_TRANSLATE_NOOP("ListingText", "The name of a type is missing here: %1."),
    QT_TRANSLATE_NOOP("ListingText", "A name is missing here."),
    QT_TRANSLATE_NOOP("ListingText", "The name of a member is missing behind the dot."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is missing here."),
    QT_TRANSLATE_NOOP("ListingText", "A Body cannot be replaced by another one."),
    QT_TRANSLATE_NOOP("ListingText", "Set its position or its velocity."),
    QT_TRANSLATE_NOOP("ListingText", "This cannot be changed."),
    QT_TRANSLATE_NOOP("ListingText", "This is a parameter."),
    QT_TRANSLATE_NOOP("ListingText", "Set it with its slider."),
    QT_TRANSLATE_NOOP("ListingText", "A listing changes positions, velocities and its own variables."),
    QT_TRANSLATE_NOOP("ListingText", "A %1 cannot be set as a whole."),
    QT_TRANSLATE_NOOP("ListingText", "%1 has no value yet."),
    QT_TRANSLATE_NOOP("ListingText", "Give it one: %1."),
    QT_TRANSLATE_NOOP("ListingText", "A condition is true or false."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is a type and has no value."),
    QT_TRANSLATE_NOOP("ListingText", "Use its x, its y or its length."),
    QT_TRANSLATE_NOOP("ListingText", "This sign does not work with this value."),
    QT_TRANSLATE_NOOP("ListingText", "Only an array has an index in '[...]'."),
    QT_TRANSLATE_NOOP("ListingText", "This computes a value, and nothing keeps it."),
    QT_TRANSLATE_NOOP("ListingText", "Compare this with something, for example with == or >."),
    QT_TRANSLATE_NOOP("ListingText", "This function can end without 'return'."),
    QT_TRANSLATE_NOOP("ListingText", "It has to return a value in every case."),
    QT_TRANSLATE_NOOP("ListingText", "This function has to return a value."),
    QT_TRANSLATE_NOOP("ListingText", "A 'void' function returns no value."),
    QT_TRANSLATE_NOOP("ListingText", "The text ends too early: a '}' or a ')' is missing."),
    QT_TRANSLATE_NOOP("ListingText", "A Body variable needs a body, for example %1."),
    QT_TRANSLATE_NOOP("ListingText", "%1 cannot be remembered from frame to frame."),
    QT_TRANSLATE_NOOP("ListingText", "Only numbers, bool and Vec2 can."),
    QT_TRANSLATE_NOOP("ListingText", "The first value of %1 cannot be computed."),
    QT_TRANSLATE_NOOP("ListingText", "Write the number itself, without %1."),
    // the language
    QT_TRANSLATE_NOOP("ListingText", "The function 'void frame()' is missing."),
    QT_TRANSLATE_NOOP("ListingText", "It runs once in every frame."),
    QT_TRANSLATE_NOOP("ListingText", "A rule needs the function %1 or %2."),
    QT_TRANSLATE_NOOP("ListingText", "The function %1 of a rule has the form %2."),
    QT_TRANSLATE_NOOP("ListingText", "A rule remembers nothing, so %1 cannot stand outside of a function."),
    QT_TRANSLATE_NOOP("ListingText", "Move it into one."),
    QT_TRANSLATE_NOOP("ListingText", "A listing cannot make arrays."),
    QT_TRANSLATE_NOOP("ListingText", "Write a variable for each value."),
    QT_TRANSLATE_NOOP("ListingText", "This stands outside of a function."),
    QT_TRANSLATE_NOOP("ListingText", "No function stands inside another one."),
    QT_TRANSLATE_NOOP("ListingText", "Move it out."),
    QT_TRANSLATE_NOOP("ListingText", "%1 stands only in a loop."),
    QT_TRANSLATE_NOOP("ListingText", "%1 does not belong here."),
    QT_TRANSLATE_NOOP("ListingText", "Put it between the braces of a function."),
    QT_TRANSLATE_NOOP("ListingText", "Look for a '}' too many above."),
    QT_TRANSLATE_NOOP("ListingText", "A function begins with the type of its result, for example %1 or %2."),
    QT_TRANSLATE_NOOP("ListingText", "A function stands alone here: %1."),
    QT_TRANSLATE_NOOP("ListingText", "This text cannot be compiled."),
    QT_TRANSLATE_NOOP("ListingText", "Texts in quotes are not part of this language."),
    QT_TRANSLATE_NOOP("ListingText", "It has numbers, bool and Vec2."),
    QT_TRANSLATE_NOOP("ListingText", "This character is not part of this language."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is reserved and not part of this language."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is not part of this language."),
    QT_TRANSLATE_NOOP("ListingText", "A Body variable already stands for the body itself."),
    QT_TRANSLATE_NOOP("ListingText", "A loop is written %1."),
    QT_TRANSLATE_NOOP("ListingText", "A comment begins with %1."),
    QT_TRANSLATE_NOOP("ListingText", "A name begins with a letter."),
    QT_TRANSLATE_NOOP("ListingText", "A name has only the letters a to z, digits and '_'."),
    QT_TRANSLATE_NOOP("ListingText", "A listing prints nothing: its values stand beside its lines."),
    QT_TRANSLATE_NOOP("ListingText", "A power is %1."),
    QT_TRANSLATE_NOOP("ListingText", "A place or a velocity is written %1."),
    QT_TRANSLATE_NOOP("ListingText", "A condition stands in brackets: %1."),
    QT_TRANSLATE_NOOP("ListingText", "No ':' stands here."),
    QT_TRANSLATE_NOOP("ListingText", "The lines that belong to a condition stand between '{' and '}'."),
    QT_TRANSLATE_NOOP("ListingText", "This ';' ends %1, so that nothing belongs to it."),
    QT_TRANSLATE_NOOP("ListingText", "Delete the ';'."),
    QT_TRANSLATE_NOOP("ListingText", "Leave it out."),
    QT_TRANSLATE_NOOP("ListingText", "Use %1."),
    QT_TRANSLATE_NOOP("ListingText", "A number ends without 'f' here."),
    QT_TRANSLATE_NOOP("ListingText", "A number has a point, not a comma: %1."),
    QT_TRANSLATE_NOOP("ListingText", "'void' stands only before a function, for example %1."),
    QT_TRANSLATE_NOOP("ListingText", "%1 has no value, so it stands alone: %2."),
    QT_TRANSLATE_NOOP("ListingText", "'=' sets a value, and stands once in a statement."),
    QT_TRANSLATE_NOOP("ListingText", "To compare, write '=='."),
    QT_TRANSLATE_NOOP("ListingText", "'==' compares and changes nothing."),
    QT_TRANSLATE_NOOP("ListingText", "To set a value, write '='."),
    QT_TRANSLATE_NOOP("ListingText",
                      "Only a variable can be set: a name, with members or an index behind it."),
    QT_TRANSLATE_NOOP("ListingText", "Compare two values at a time, for example %1."),
    QT_TRANSLATE_NOOP("ListingText", "Write '*' between a number and a name: %1."),
    QT_TRANSLATE_NOOP("ListingText", "Write '+=' to add to a value."),
    QT_TRANSLATE_NOOP("ListingText", "Write '-=' to subtract from a value."),
    QT_TRANSLATE_NOOP("ListingText", "Write '.' between a body and its member, for example %1."),
    QT_TRANSLATE_NOOP("ListingText", "Write %1 to compare."),
    QT_TRANSLATE_NOOP("ListingText", "Write %1 without a space in between."),
    QT_TRANSLATE_NOOP("ListingText", "Write %1 with small letters."),
    QT_TRANSLATE_NOOP("ListingText", "Write it as %1."),
    QT_TRANSLATE_NOOP("ListingText", "Write %1."),
    // bounds
    QT_TRANSLATE_NOOP("ListingText", "There are more than %1 'else' in this listing."),
    QT_TRANSLATE_NOOP("ListingText", "There are more than %1 brackets inside one another."),
    QT_TRANSLATE_NOOP("ListingText", "This statement is too long."),
    QT_TRANSLATE_NOOP("ListingText", "Split it in two."),
    QT_TRANSLATE_NOOP("ListingText", "The variables outside of functions take %1 bytes."),
    QT_TRANSLATE_NOOP("ListingText", "This listing has %1 bytes."),
    QT_TRANSLATE_NOOP("ListingText", "The most is %1."),
    // mistakes that stop a frame
    QT_TRANSLATE_NOOP("ListingText", "This variable stands for no body."),
    QT_TRANSLATE_NOOP("ListingText", "This divides by 0."),
    QT_TRANSLATE_NOOP("ListingText", "The result is too large for a number."),
    QT_TRANSLATE_NOOP("ListingText", "This loop still runs after %1 lines."),
    QT_TRANSLATE_NOOP("ListingText", "It ends only when its condition becomes false."),
    QT_TRANSLATE_NOOP("ListingText", "This still runs after %1 lines."),
    QT_TRANSLATE_NOOP("ListingText", "A function calls itself too often."),
    QT_TRANSLATE_NOOP("ListingText", "Functions call functions %1 times inside one another."),
    QT_TRANSLATE_NOOP("ListingText", "Functions call functions too many times inside one another."),
    QT_TRANSLATE_NOOP("ListingText", "A function that calls itself needs a case in which it does not."),
    QT_TRANSLATE_NOOP("ListingText", "The position of %1 is not a finite number."),
    QT_TRANSLATE_NOOP("ListingText", "The velocity of %1 is not a finite number."),
    QT_TRANSLATE_NOOP("ListingText", "The angle or the spin of %1 is not a finite number."),
    QT_TRANSLATE_NOOP("ListingText", "The gait of %1 is not a finite number."),
    QT_TRANSLATE_NOOP("ListingText", "The force is not a finite number."),
    QT_TRANSLATE_NOOP("ListingText", "%1 is not a finite number."),
    QT_TRANSLATE_NOOP("ListingText", "The interpreter stopped."),
};

/// A pattern as an expression that finds its gaps.
struct Matcher
{
    const char *source;
    QRegularExpression expression;
};

const std::vector<Matcher> &matchers()
{
    static const std::vector<Matcher> all = [] {
        std::vector<Matcher> made;
        static const QRegularExpression gap(QStringLiteral("\\\\%\\d"));
        for (const char *pattern : patterns) {
            const QString escaped = QRegularExpression::escape(QString::fromUtf8(pattern));
            made.push_back({pattern, QRegularExpression('^' + QString(escaped).replace(gap, "(.+?)") + '$')});
        }
        return made;
    }();
    return all;
}

/// Returns a list such as "body and feet" or "',' or ';'" in the learner's language. Other texts stay.
QString translatedList(QString gap)
{
    static const QRegularExpression names(QStringLiteral("^\\w+(, \\w+)* and \\w+$"));
    static const QRegularExpression signs(QStringLiteral("^'[^']+'(, '[^']+')* or '[^']+'$"));
    if (names.match(gap).hasMatch())
        gap.replace(QStringLiteral(" and "), ListingText::tr(" and ", "in a list"));
    else if (signs.match(gap).hasMatch())
        gap.replace(QStringLiteral(" or "), ListingText::tr(" or ", "in a list"));
    return gap;
}

QString translatedSentence(const QString &sentence)
{
    static const QRegularExpression article(QStringLiteral("\\b([Aa])n (?=int\\b)"));
    const QString plain = QString(sentence).replace(article, QStringLiteral("\\1 "));
    for (const Matcher &one : matchers()) {
        const QRegularExpressionMatch match = one.expression.match(plain);
        if (!match.hasMatch())
            continue;
        QString translated = ListingText::tr(one.source);
        if (translated == QLatin1String(one.source))
            return sentence;
        for (int i = 1; i <= match.lastCapturedIndex(); ++i)
            translated.replace(QStringLiteral("%%1").arg(i), translatedList(match.captured(i)));
        return translated;
    }
    return sentence; // a rare message of the interpreter
}

}

QString listingSentence(const std::string &text)
{
    static const QRegularExpression ends(QStringLiteral("(?<=[.?]) (?=[A-Z'])"));
    QStringList sentences = QString::fromStdString(text).split(ends);
    for (QString &sentence : sentences)
        sentence = translatedSentence(sentence);
    return sentences.join(' ');
}

}
