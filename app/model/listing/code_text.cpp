#include "app/model/listing/code_text.h"

#include "app/model/listing/changed_lines.h"
#include "app/model/text/listing_text.h"

#include <QCoreApplication>

namespace app {

namespace {

struct CodeTextWords
{
    Q_DECLARE_TR_FUNCTIONS(CodeTextWords)
};

}

std::vector<CodeMistake> mistakesOf(const std::vector<listing::CompileError> &errors, const QString &text)
{
    const auto characters = [](const QByteArray &bytes) {
        return static_cast<int>(QString::fromUtf8(bytes).size());
    };
    std::vector<CodeMistake> mistakes;
    for (const listing::CompileError &error : errors) {
        const QByteArray line = text.section('\n', error.line - 1, error.line - 1).toUtf8();
        mistakes.push_back({error.line, characters(line.left(error.column - 1)) + 1,
                            std::max(1, characters(line.mid(error.column - 1, error.length))),
                            listingSentence(error.sentence)});
    }
    return mistakes;
}

QString firstNewLine(const QString &other, const QString &text)
{
    constexpr qsizetype longest = 40;
    const QStringList lines = text.split('\n');
    for (const int line : changedLines(other, text).changed) {
        const QString code = lines[line - 1].simplified();
        if (code.size() <= 1 || code.startsWith("//")) // a brace or a comment
            continue;
        if (code.size() <= longest)
            return code;
        const qsizetype space = code.lastIndexOf(' ', longest - 2); // room for the ellipsis
        return code.left(space > longest / 2 ? space : longest - 2) + QStringLiteral(" …");
    }
    return CodeTextWords::tr("other code");
}

}
