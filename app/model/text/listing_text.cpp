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

public:
    /// The sentences of app/listing, which knows no Qt, with %1 to %3 in place of names and numbers. The first one that
    /// matches counts. "an" before a type stands here as "a".
    static constexpr const char *patterns[] = {
        // names
        QT_TR_NOOP("Did you mean %1?"),
        QT_TR_NOOP("%1 is not a member of an array of bodies."),
        QT_TR_NOOP("%1 is not a member of the array of creatures."),
        QT_TR_NOOP("%1 is not a member of the array of sticks."),
        QT_TR_NOOP("%1 is not a member of the new targets."),
        QT_TR_NOOP("%1 is not a member of the keys."),
        QT_TR_NOOP("%1 is not a member of %2."),
        QT_TR_NOOP("It has %1."),
        QT_TR_NOOP("Choose one of them first, for example with [0]."),
        QT_TR_NOOP("There is no function %1."),
        QT_TR_NOOP("There is no type %1."),
        QT_TR_NOOP("The types are %1."),
        QT_TR_NOOP("The functions are %1."),
        QT_TR_NOOP("There is no %1: %2 is empty."),
        QT_TR_NOOP("There is no %1: the only one is %2."),
        QT_TR_NOOP("There is no %1: %2 goes from %3 to %4."),
        QT_TR_NOOP("There is no %1."),
        QT_TR_NOOP("This scene has %1, and the numbers %2."),
        QT_TR_NOOP("This scene has %1, and the number %2."),
        QT_TR_NOOP("This scene has the numbers %1."),
        QT_TR_NOOP("This scene has the number %1."),
        QT_TR_NOOP("This scene has %1."),
        QT_TR_NOOP("There already is %1 here."),
        QT_TR_NOOP("There already is %1 in this scene."),
        QT_TR_NOOP("Use another name."),
        QT_TR_NOOP("A new variable needs a type: %1, %2 or %3."),
        QT_TR_NOOP("This is an array of bodies."),
        // types and values
        QT_TR_NOOP("%1 does not take these values: %2."),
        QT_TR_NOOP("A %1 cannot be used as a %2."),
        QT_TR_NOOP("This sign does not work between a %1 and the other value."),
        QT_TR_NOOP("This sign does not work between a %1 and a %2."),
        QT_TR_NOOP("A Vec2 can be added to a Vec2, and multiplied or divided by a number."),
        QT_TR_NOOP("Use the position or the velocity of the body."),
        QT_TR_NOOP("%1 is a %2 here, not a function."),
        QT_TR_NOOP("This is not a function."),
        QT_TR_NOOP("%1 is not a function."),
        QT_TR_NOOP("Write it without '()'."),
        QT_TR_NOOP("To multiply, write '*'."),
        QT_TR_NOOP("Both values of a choice with ? need the same type."),
        QT_TR_NOOP("Write %1 for %2 beside a double."),
        QT_TR_NOOP("Between whole numbers, '/' drops the fraction: this is %1."),
        QT_TR_NOOP("Between whole numbers, '/' drops the fraction."),
        QT_TR_NOOP("An 'int' keeps no fraction, and this value may have one."),
        QT_TR_NOOP("Write %1, or round down with %2."),
        QT_TR_NOOP("A value is missing at the end of this line."),
        QT_TR_NOOP("A name is missing at the end of this line."),
        QT_TR_NOOP("%1 is missing at the end of this line."),
        QT_TR_NOOP("%1 is missing before %2."),
        QT_TR_NOOP("This %1 has no %2."),
        QT_TR_NOOP("A value is missing here."),
        QT_TR_NOOP("The name of a type is missing here: %1."),
        QT_TR_NOOP("A name is missing here."),
        QT_TR_NOOP("The name of a member is missing behind the dot."),
        QT_TR_NOOP("%1 is missing here."),
        QT_TR_NOOP("A Body cannot be replaced by another one."),
        QT_TR_NOOP("Set its position or its velocity."),
        QT_TR_NOOP("This cannot be changed."),
        QT_TR_NOOP("This is a parameter."),
        QT_TR_NOOP("Set it with its slider."),
        QT_TR_NOOP("A listing changes positions, velocities and its own variables."),
        QT_TR_NOOP("A %1 cannot be set as a whole."),
        QT_TR_NOOP("%1 has no value yet."),
        QT_TR_NOOP("Give it one: %1."),
        QT_TR_NOOP("A condition is true or false."),
        QT_TR_NOOP("%1 is a type and has no value."),
        QT_TR_NOOP("Use its x, its y or its length."),
        QT_TR_NOOP("This sign does not work with this value."),
        QT_TR_NOOP("Only an array has an index in '[...]'."),
        QT_TR_NOOP("This computes a value, and nothing keeps it."),
        QT_TR_NOOP("Compare this with something, for example with == or >."),
        QT_TR_NOOP("This function can end without 'return'."),
        QT_TR_NOOP("It has to return a value in every case."),
        QT_TR_NOOP("This function has to return a value."),
        QT_TR_NOOP("A 'void' function returns no value."),
        QT_TR_NOOP("The text ends too early: a '}' or a ')' is missing."),
        QT_TR_NOOP("A Body variable needs a body, for example %1."),
        QT_TR_NOOP("%1 cannot be remembered from frame to frame."),
        QT_TR_NOOP("Only numbers, bool and Vec2 can."),
        QT_TR_NOOP("The first value of %1 cannot be computed."),
        QT_TR_NOOP("Write the number itself, without %1."),
        // the language
        QT_TR_NOOP("The function 'void frame()' is missing."),
        QT_TR_NOOP("It runs once in every frame."),
        QT_TR_NOOP("A rule needs the function %1 or %2."),
        QT_TR_NOOP("The function %1 of a rule has the form %2."),
        QT_TR_NOOP("A rule remembers nothing, so %1 cannot be outside of a function."),
        QT_TR_NOOP("Move it into one."),
        QT_TR_NOOP("A listing cannot make arrays."),
        QT_TR_NOOP("Write a variable for each value."),
        QT_TR_NOOP("This is outside of any function."),
        QT_TR_NOOP("A function cannot be inside another function."),
        QT_TR_NOOP("Move it out."),
        QT_TR_NOOP("%1 works only in a loop."),
        QT_TR_NOOP("%1 does not belong here."),
        QT_TR_NOOP("Put it between the braces of a function."),
        QT_TR_NOOP("Look for a '}' too many above."),
        QT_TR_NOOP("A function begins with the type of its result, for example %1 or %2."),
        QT_TR_NOOP("A function is called without an object here: %1."),
        QT_TR_NOOP("This text cannot be compiled."),
        QT_TR_NOOP("Texts in quotes are not part of this language."),
        QT_TR_NOOP("It has numbers, bool and Vec2."),
        QT_TR_NOOP("This character is not part of this language."),
        QT_TR_NOOP("%1 is reserved and not part of this language."),
        QT_TR_NOOP("%1 is not part of this language."),
        QT_TR_NOOP("A Body variable already stands for the body itself."),
        QT_TR_NOOP("A loop is written %1."),
        QT_TR_NOOP("A comment begins with %1."),
        QT_TR_NOOP("A name begins with a letter."),
        QT_TR_NOOP("A name has only the letters a to z, digits and '_'."),
        QT_TR_NOOP("A listing cannot print: its values are shown beside its lines."),
        QT_TR_NOOP("A power is %1."),
        QT_TR_NOOP("Write a position or a velocity as %1."),
        QT_TR_NOOP("A condition needs brackets: %1."),
        QT_TR_NOOP("Leave out the ':'."),
        QT_TR_NOOP("The lines that belong to a condition go between '{' and '}'."),
        QT_TR_NOOP("This ';' ends %1, so that nothing belongs to it."),
        QT_TR_NOOP("Delete the ';'."),
        QT_TR_NOOP("Leave it out."),
        QT_TR_NOOP("Use %1."),
        QT_TR_NOOP("A number ends without 'f' here."),
        QT_TR_NOOP("A number has a point, not a comma: %1."),
        QT_TR_NOOP("'void' is only for functions, for example %1."),
        QT_TR_NOOP("%1 returns no value, so call it on its own: %2."),
        QT_TR_NOOP("'=' sets a value, and can be used once in a statement."),
        QT_TR_NOOP("To compare, write '=='."),
        QT_TR_NOOP("'==' compares and changes nothing."),
        QT_TR_NOOP("To set a value, write '='."),
        QT_TRANSLATE_NOOP("ListingText",
                          "Only a variable can be set: a name, with members or an index behind it."),
        QT_TR_NOOP("Compare two values at a time, for example %1."),
        QT_TR_NOOP("Write '*' between a number and a name: %1."),
        QT_TR_NOOP("Write '+=' to add to a value."),
        QT_TR_NOOP("Write '-=' to subtract from a value."),
        QT_TR_NOOP("Write '.' between a body and its member, for example %1."),
        QT_TR_NOOP("Write %1 to compare."),
        QT_TR_NOOP("Write %1 without a space in between."),
        QT_TR_NOOP("Write %1 with small letters."),
        QT_TR_NOOP("Write it as %1."),
        QT_TR_NOOP("Write %1."),
        // bounds
        QT_TR_NOOP("There are more than %1 'else' in this listing."),
        QT_TR_NOOP("There are more than %1 brackets inside one another."),
        QT_TR_NOOP("This statement is too long."),
        QT_TR_NOOP("Split it in two."),
        QT_TR_NOOP("The variables outside of functions take %1 bytes."),
        QT_TR_NOOP("This listing has %1 bytes."),
        QT_TR_NOOP("The most is %1."),
        // mistakes that stop a frame
        QT_TR_NOOP("This variable stands for no body."),
        QT_TR_NOOP("This divides by 0."),
        QT_TR_NOOP("The result is too large for a number."),
        QT_TR_NOOP("This loop still runs after %1 lines."),
        QT_TR_NOOP("It ends only when its condition becomes false."),
        QT_TR_NOOP("This still runs after %1 lines."),
        QT_TR_NOOP("A function calls itself too often."),
        QT_TR_NOOP("Functions call functions %1 times inside one another."),
        QT_TR_NOOP("Functions call functions too many times inside one another."),
        QT_TR_NOOP("A function that calls itself needs a case in which it does not."),
        QT_TR_NOOP("The position of %1 is not a finite number."),
        QT_TR_NOOP("The velocity of %1 is not a finite number."),
        QT_TR_NOOP("The angle or the spin of %1 is not a finite number."),
        QT_TR_NOOP("The gait of %1 is not a finite number."),
        QT_TR_NOOP("The force is not a finite number."),
        QT_TR_NOOP("%1 is not a finite number."),
        QT_TR_NOOP("Look for the root of a negative number, or for a number that grows in each frame."),
        QT_TR_NOOP("The interpreter stopped."),
    };
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
        for (const char *pattern : ListingText::patterns) {
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
