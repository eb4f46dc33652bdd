#include "app/model/breakpoints/condition_parser.h"

#include "app/model/breakpoints/condition_names.h"
#include "app/model/text/quoting.h"

#include <QHash>

#include <algorithm>
#include <utility>

namespace app {

using namespace condition_names;

namespace {

using Kind = Condition::Operation::Kind;

const QHash<QString, Kind> &comparisons()
{
    static const QHash<QString, Kind> kinds = {{"<", Kind::less},    {"<=", Kind::lessOrEqual},
                                               {">", Kind::greater}, {">=", Kind::greaterOrEqual},
                                               {"==", Kind::equal},  {"!=", Kind::notEqual}};
    return kinds;
}

}

ConditionParser::ConditionParser(const QString &text, const ConditionNames &names) : m_names(names)
{
    if (text.size() > Condition::longest)
        refuse(Condition::longest + 1,
               tr("this is too long; use at most %1 characters.").arg(Condition::longest));
    m_words = conditionWords(text);
}

bool ConditionParser::isSign(const QString &text) const
{
    return now().kind == ConditionToken::Kind::sign && now().text == text;
}

bool ConditionParser::take(const QString &text)
{
    const bool is = isSign(text);
    m_at += is;
    return is;
}

void ConditionParser::need(const Part &part, Type type) const
{
    if (part.type == type)
        return;
    if (type == Type::truth && part.type == Type::number)
        refuse(part.place, tr("a number is neither true nor false; compare it, as in %1.")
                               .arg(part.text.isEmpty() ? QStringLiteral("… > 0") : part.text + " > 0"));
    switch (part.type) {
    case Type::truth:
        refuse(part.place, tr("this is true or false, not a number; join conditions with and, or."));
    case Type::phase:
        refuse(part.place, tr("a phase can only be compared with its name, as in phase == \"%1\".")
                               .arg(phasesOf(m_names.pipeline).value(0)));
    case Type::choice:
        refuse(part.place, tr("%1 is a choice; compare it with one of its values, as in %1 == \"%2\".")
                               .arg(part.text, part.choices.value(0)));
    case Type::text:
        refuse(
            part.place,
            tr("%1 is a text; only phase and choices can be compared with a text.").arg(quoted(part.text)));
    case Type::number:
        break;
    }
    refuse(part.place, tr("a number cannot be used here; write a condition such as x > 0."));
}

ConditionParser::Program ConditionParser::parse()
{
    return whole(Type::truth).program;
}

ConditionParser::Program ConditionParser::parseNumber()
{
    return whole(Type::number).program;
}

ConditionParser::Part ConditionParser::whole(Type type)
{
    if (now().kind == ConditionToken::Kind::end)
        refuse(1, tr("the condition is empty; write a comparison, as in %1.y > 380.")
                      .arg(bodiesOf(m_names.scene).value(0)));
    Part all = either();
    if (isSign(QStringLiteral(")")))
        refuse(now().place, tr("this parenthesis closes nothing; remove it."));
    if (now().kind != ConditionToken::Kind::end)
        refuse(now().place, tr("%1 cannot directly follow the text before it; put and, "
                               "or, or a sign such as + or < between them.")
                                .arg(quoted(now().text)));
    need(all, type);
    return all;
}

ConditionParser::Part ConditionParser::joined(Part left, Part right, Kind kind, Type type)
{
    left.program.insert(left.program.end(), right.program.begin(), right.program.end());
    left.program.push_back({kind});
    left.type = type;
    left.text.clear();
    return left;
}

ConditionParser::Part ConditionParser::chain(Part (ConditionParser::*part)(), const Signs &signs, Type type)
{
    Part left = (this->*part)();
    for (;;) {
        const auto sign =
            std::find_if(signs.begin(), signs.end(), [this](const auto &one) { return take(one.first); });
        if (sign == signs.end())
            return left;
        Part right = (this->*part)();
        need(left, type), need(right, type);
        left = joined(std::move(left), std::move(right), sign->second, type);
    }
}

ConditionParser::Part ConditionParser::either()
{
    return chain(&ConditionParser::both, {{"or", Kind::either}}, Type::truth);
}

ConditionParser::Part ConditionParser::both()
{
    return chain(&ConditionParser::negated, {{"and", Kind::both}}, Type::truth);
}

ConditionParser::Part ConditionParser::negated()
{
    if (!take(QStringLiteral("not")))
        return compared();
    Part part = negated();
    need(part, Type::truth);
    part.program.push_back({Kind::negate});
    return part;
}

ConditionParser::Part ConditionParser::compared()
{
    Part left = sum();
    const ConditionToken sign = now();
    if (sign.kind != ConditionToken::Kind::sign || !comparisons().contains(sign.text))
        return left;
    ++m_at;
    Part whole = comparison(sign, std::move(left), sum());
    if (now().kind == ConditionToken::Kind::sign && comparisons().contains(now().text))
        refuse(now().place, tr("a comparison has only two sides; join two comparisons with and."));
    return whole;
}

ConditionParser::Part ConditionParser::comparison(const ConditionToken &sign, Part left, Part right)
{
    const Kind kind = comparisons()[sign.text];
    const bool isEquality = kind == Kind::equal || kind == Kind::notEqual;
    if (right.type != Type::text && left.type == Type::text)
        std::swap(left, right);
    const bool named = left.type == Type::phase || left.type == Type::choice;
    if (named && right.type == Type::text) {
        if (!isEquality)
            refuse(sign.place, tr("names can only be equal or different; write == or !=."));
        return left.type == Type::phase ? phaseIs(right, kind == Kind::equal)
                                        : choiceIs(left, right, left, kind);
    }
    need(left, Type::number), need(right, Type::number);
    return joined(std::move(left), std::move(right), kind, Type::truth);
}

ConditionParser::Part ConditionParser::sum()
{
    return chain(&ConditionParser::product, {{"+", Kind::add}, {"-", Kind::subtract}}, Type::number);
}

ConditionParser::Part ConditionParser::product()
{
    return chain(&ConditionParser::withSign, {{"*", Kind::multiply}, {"/", Kind::divide}}, Type::number);
}

ConditionParser::Part ConditionParser::withSign()
{
    const qsizetype place = now().place;
    if (take(QStringLiteral("+")) || !take(QStringLiteral("-")))
        return primary();
    Part part = withSign();
    need(part, Type::number);
    part.program.push_back({Kind::minus});
    part.place = place;
    part.text.clear();
    return part;
}

void ConditionParser::expectClose(qsizetype opened)
{
    if (take(QStringLiteral(")")))
        return;
    if (now().kind == ConditionToken::Kind::end)
        refuse(opened, tr("this parenthesis is not closed; close it with )."));
    if (isSign(QStringLiteral(",")))
        refuse(now().place, tr("a comma can only be between two bodies, as in distance(%1, %2); write "
                               "numbers with a point.")
                                .arg(bodiesOf(m_names.scene).value(0), bodiesOf(m_names.scene).value(1)));
    refuse(now().place, tr("%1 cannot be here; a sign or ) is missing before it.").arg(quoted(now().text)));
}

ConditionParser::Part ConditionParser::primary()
{
    const ConditionToken word = now();
    switch (word.kind) {
    case ConditionToken::Kind::number:
        ++m_at;
        return {Type::number, {{Kind::number, word.number}}, word.place, word.text, {}};
    case ConditionToken::Kind::text:
        ++m_at;
        return {Type::text, {}, word.place, word.text, {}};
    case ConditionToken::Kind::name:
        return named();
    case ConditionToken::Kind::end:
        refuse(word.place, tr("something is missing at the end; add a number or a name."));
    case ConditionToken::Kind::sign:
        break;
    }
    if (word.text != u"(")
        refuse(word.place, tr("a number or a name is missing before %1; add it.").arg(quoted(word.text)));
    ++m_at;
    Part inside = either();
    expectClose(word.place);
    inside.text.clear();
    return inside;
}

ConditionParser::Part ConditionParser::function(Kind kind)
{
    const ConditionToken word = m_words[m_at++];
    const qsizetype opened = now().place;
    if (!take(QStringLiteral("(")))
        refuse(opened, tr("%1 needs parentheses around its number, as in %1(%2.vy).")
                           .arg(word.text, bodiesOf(m_names.scene).value(0)));
    Part inside = either();
    need(inside, Type::number);
    expectClose(opened);
    inside.program.push_back({kind});
    inside.place = word.place;
    inside.text.clear();
    return inside;
}

}
