#pragma once

#include "app/model/condition.h"
#include "app/model/condition_words.h"

namespace app {

/// Reads a condition: or, and, not, comparisons, + -, * /, a sign before, in this order, the last binding most.
class ConditionParser
{
public:
    using Program = std::vector<Condition::Operation>;

    /// @throws Refusal as conditionWords()
    ConditionParser(const QString &text, const ConditionNames &names);

    /// The operations in the order in which they are done.
    /// @throws Refusal
    Program parse();

private:
    enum class Type { number, truth, phase, choice, text };
    /// What has been read, with what it comes to.
    struct Part
    {
        Type type = Type::number;
        Program program;
        qsizetype place = 1;
        QString text;        ///< what stands there, for `text` without quotation marks
        QStringList choices; ///< for `choice`
    };
    using Kind = Condition::Operation::Kind;

    Part either();
    Part both();
    Part negated();
    Part compared();
    Part sum();
    Part product();
    Part withSign();
    Part primary();
    Part named();
    Part bodyNumber(const ConditionWord &word);
    Part function(Kind kind);
    Part comparison(const ConditionWord &sign, Part left, Part right);
    Part phaseIs(const Part &text, bool equal);
    Part choiceIs(const Part &choice, const Part &text, Part whole, Kind kind);
    Part joined(Part left, Part right, Kind kind, Type type);
    void need(const Part &part, Type type) const;
    [[noreturn]] void refuseName(const ConditionWord &word) const;

    const ConditionWord &now() const { return m_words[m_at]; }
    bool isSign(const QString &text) const;
    /// Takes the sign, if it is the next word.
    bool take(const QString &text);
    void expectClose(qsizetype opened);

    const ConditionNames &m_names;
    std::vector<ConditionWord> m_words;
    std::size_t m_at = 0;
};

}
