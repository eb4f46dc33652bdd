// Words of the glossary are explained before texts use them, in every language.

#include "tests/lessons/support/documents.h"
#include "tests/suite.h"

#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using namespace support;

namespace {

/// A word of the glossary, and the step that explains it.
struct TaughtWord
{
    QString name;
    QStringList forms;
    std::size_t step = 0;
};

/// Returns the glossary words that occur in `text` in one of their forms. A form within a longer one does not count.
QStringList wordsIn(QString text, const std::vector<TaughtWord> &words)
{
    std::vector<std::pair<QString, QString>> forms;
    for (const TaughtWord &word : words) {
        for (const QString &form : word.forms)
            forms.emplace_back(form, word.name);
    }
    std::stable_sort(forms.begin(), forms.end(),
                     [](const auto &a, const auto &b) { return a.first.size() > b.first.size(); });
    QStringList found;
    for (const auto &[form, name] : forms) {
        const QRegularExpression whole("(?<![\\w])" + QRegularExpression::escape(form) + "(?![\\w])",
                                       QRegularExpression::CaseInsensitiveOption |
                                           QRegularExpression::UseUnicodePropertiesOption);
        if (text.contains(whole) && !found.contains(name))
            found << name;
        text.replace(whole, QStringLiteral("#"));
    }
    return found;
}

/// Words that a step uses before another one explains them. To be emptied as the texts are rewritten.
struct EarlyWord
{
    const char *language;
    const char *word;
    const char *usedIn; ///< the first step that uses it
    const char *reason;
};

const EarlyWord earlyWords[] = {
    {"en", "Coincident points", "walking_gait/bones", "“one place” means a single place there"},
    {"en", "Curve", "single_spring/drag", "predictions ask for the curve in a plot, not for a Bézier curve"},
    {"en", "Energy drift", "two_body/mutual", "the name of a row in the energy table"},
    {"en", "Stick", "walking_gait/ground", "the verb: feet stick to the ground"},
    {"en", "Energy", "swaying_tree/real_sway", "the tree shows energy before lesson 9 explains it"},
    {"en", "Stiff", "hard_cases/limit", "the limit is about stiff springs, which a later step explains"},
    {"de", "Bogen", "single_spring/drag", "“Kurve” is the curve in a plot there, as in English"},
    {"de", "Energiedrift", "two_body/mutual", "the name of a row in the energy table"},
    {"de", "Energie", "swaying_tree/real_sway", "the tree shows energy before lesson 9 explains it"},
    {"de", "Steif", "hard_cases/limit", "the limit is about stiff springs, which a later step explains"},
    {"es", "Deriva de energía", "two_body/mutual", "the name of a row in the energy table"},
    {"es", "Energía", "swaying_tree/real_sway", "the tree shows energy before lesson 9 explains it"},
    {"fr", "Dérive de l’énergie", "two_body/mutual", "the name of a row in the energy table"},
    {"fr", "Énergie", "swaying_tree/real_sway", "the tree shows energy before lesson 9 explains it"},
};

}

class WordOrderTest : public QObject
{
    Q_OBJECT

private slots:
    void wordsAreExplainedBeforeTheyAreUsed_data();
    void wordsAreExplainedBeforeTheyAreUsed();
};

void WordOrderTest::wordsAreExplainedBeforeTheyAreUsed_data()
{
    QTest::addColumn<QString>("language");
    for (const QString &code : documentLanguages())
        QTest::newRow(qPrintable(code)) << code;
}

void WordOrderTest::wordsAreExplainedBeforeTheyAreUsed()
{
    QFETCH(QString, language);
    QStringList names;
    std::vector<lessons::Document> documents;
    std::vector<TaughtWord> words;
    for (const LoadedLesson &lesson : allLessons()) {
        for (const lessons::Step &step : lesson.steps) {
            if (step.points == lessons::PointSource::scene)
                continue; // the sandbox can be opened at any time
            documents.push_back(documentOf(step.lesson, step.id, language));
            for (const lessons::Term &term : documents.back().explanation.terms)
                words.push_back({term.name, term.forms.split('|', Qt::SkipEmptyParts),
                                 static_cast<std::size_t>(names.size())});
            names << step.lesson + '/' + step.id;
        }
    }
    QStringList early;
    for (std::size_t i = 0; i < documents.size(); ++i) {
        QString text;
        for (const DocumentPlace &place : placesIn(documents[i])) {
            if (!place.where.startsWith("word "))
                text += '\n' + place.text;
        }
        text.remove(QRegularExpression("[*`]"));
        for (const QString &name : wordsIn(text, words)) {
            const auto word =
                std::find_if(words.begin(), words.end(), [&](const auto &one) { return one.name == name; });
            const QString line = name + " in ";
            const bool isKnown =
                early.filter(QRegularExpression("^" + QRegularExpression::escape(line))).isEmpty();
            if (word->step > i && isKnown)
                early << line + names[static_cast<qsizetype>(i)];
        }
    }
    QStringList allowed;
    for (const EarlyWord &one : earlyWords) {
        QVERIFY(*one.reason);
        if (language == one.language)
            allowed << QStringLiteral("%1 in %2").arg(one.word, one.usedIn);
    }
    std::sort(early.begin(), early.end());
    std::sort(allowed.begin(), allowed.end());
    QVERIFY2(early == allowed,
             qPrintable("\nUsed too early:\n" + early.join('\n') + "\nAllowed:\n" + allowed.join('\n')));
}

SUITE(tst_word_order, WordOrderTest)
#include "tst_word_order.moc"
