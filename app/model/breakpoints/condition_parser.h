#pragma once

#include "app/model/breakpoints/condition.h"
#include "app/model/breakpoints/condition_tokens.h"

#include <QCoreApplication>

#include <utility>
#include <vector>

namespace app {

/// A parser for conditions. From lowest to highest precedence: or, and, not, comparisons, + -, * /, a leading sign.
class ConditionParser
{
    Q_DECLARE_TR_FUNCTIONS(ConditionParserText)

public:
    using Program = std::vector<Condition::Operation>;

    /// @throws UserError as conditionWords()
    ConditionParser(const QString &text, const ConditionNames &names);

    /// Returns the operations in the order of evaluation.
    /// @throws UserError
    Program parse();
    /// Returns the operations of a number instead of a condition.
    /// @throws UserError
    Program parseNumber();

private:
    enum class Type { number, truth, phase, choice, text };
    /// A parsed part of the condition, with the operations that compute it.
    struct Part
    {
        Type type = Type::number;
        Program program;
        qsizetype place = 1;
        QString text;        ///< the source text; for `text` without quotation marks
        QStringList choices; ///< for `choice`
    };
    using Kind = Condition::Operation::Kind;

    using Signs = std::vector<std::pair<QString, Kind>>;

    Part whole(Type type);
    /// Parses parts of one type with `signs` between them, such as a + b - c. They are joined from left to right.
    Part chain(Part (ConditionParser::*part)(), const Signs &signs, Type type);
    Part either();
    Part both();
    Part negated();
    Part compared();
    Part sum();
    Part product();
    Part withSign();
    Part primary();
    Part named();
    /// Returns whether a word names a variable of the listing. A body of the same name takes precedence.
    bool isVariable(const ConditionToken &word) const;
    Part variable(const ConditionToken &word);
    Part bodyNumber(const ConditionToken &word);
    Part function(Kind kind);
    /// Parses distance(a, b) or speed(a).
    Part ofBodies(Kind kind);
    /// Parses still(a), held(a) or released(a), also without a name.
    Part aboutBody(Kind kind);
    int bodyAt(const QString &example) const;
    Part comparison(const ConditionToken &sign, Part left, Part right);
    Part phaseIs(const Part &text, bool equal);
    Part choiceIs(const Part &choice, const Part &text, Part whole, Kind kind);
    Part joined(Part left, Part right, Kind kind, Type type);
    void need(const Part &part, Type type) const;
    [[noreturn]] void refuseName(const ConditionToken &word) const;

    const ConditionToken &now() const { return m_words[m_at]; }
    bool isSign(const QString &text) const;
    /// Consumes the sign if it is the next token. Returns whether it was.
    bool take(const QString &text);
    void expectClose(qsizetype opened);

    const ConditionNames &m_names;
    std::vector<ConditionToken> m_words;
    std::size_t m_at = 0;
};

}
