// The manual page and the help texts agree with the table of verbs.

#include "app/cli/verbs.h"
#include "app/model/text/language.h"
#include "tests/app/cli/program.h"
#include "tests/app/support/files.h"
#include "tests/suite.h"

#include <QMap>
#include <QRegularExpression>
#include <QTest>

using namespace program;

namespace {

/// Returns the source of a manual page: "springstep.1". Empty if there is none.
QString sourceOf(const QString &name)
{
    return QString::fromUtf8(tests::contentsOf(SOURCE_DIR "/app/man/" + name));
}

/// Returns the lines of a manual page that are the same in every language: its synopsis, the headings of its verbs, the
/// names of options, and where paragraphs and sections begin.
QStringList frameOf(const QString &page)
{
    QStringList lines = page.section("\n.SH ", 2, 2).split('\n').mid(1);
    bool isName = false; // the line after .TP names an option
    for (const QString &line : page.split('\n')) {
        if (line == ".TP" || line == ".PP" || line.startsWith(".SS ") || isName)
            lines << line;
        else if (line.startsWith(".SH "))
            lines << ".SH";
        isName = line == ".TP";
    }
    return lines;
}

/// Returns the manual page without the escapes and font macros of roff.
QString manualPage()
{
    QString text = sourceOf("springstep.1");
    text.replace("\\-", "-").remove('"');
    return text.replace(
        QRegularExpression("^\\.(B|I|BR|RB|BI|IB|RI|IR) ", QRegularExpression::MultilineOption), QString());
}

/// Returns the sections about verbs, by their headings: "trace FILE".
QMap<QString, QString> verbSections()
{
    const QString verbs = manualPage().section("\n.SH VERBS\n", 1).section("\n.SH ", 0, 0);
    QMap<QString, QString> sections;
    for (const QString &section :
         verbs.split(QRegularExpression("^\\.SS ", QRegularExpression::MultilineOption), Qt::SkipEmptyParts))
        sections[section.section('\n', 0, 0)] = section.section('\n', 1);
    return sections;
}

/// Returns the paragraphs of a section about options, by their names.
QMap<QString, QString> optionParagraphs(const QString &section)
{
    static const QRegularExpression name("^--([a-z]+)");
    QMap<QString, QString> paragraphs;
    for (const QString &paragraph : section.split(".TP\n").mid(1))
        paragraphs[name.match(paragraph).captured(1)] = paragraph.section('\n', 1);
    return paragraphs;
}

QString headingOf(const app::Verb &verb)
{
    QStringList words{verb.name};
    for (const app::Argument &argument : verb.arguments)
        words << argument.name;
    return words.join(' ');
}

QStringList optionNames(const app::Verb &verb)
{
    QStringList names;
    for (const app::Option &option : verb.options)
        names << option.name;
    names.sort();
    return names;
}

}

class ManPageTest : public QObject
{
    Q_OBJECT

private slots:
    void everyVerbHasASection()
    {
        QStringList headings;
        for (const app::Verb &verb : app::verbs()) {
            headings << headingOf(verb);
            QVERIFY2(manualPage().contains("\nspringstep " + verb.name + '\n'), qPrintable(verb.name));
        }
        headings.sort();
        QCOMPARE(QStringList(verbSections().keys()), headings);
    }

    void aSectionDescribesTheOptionsOfItsVerb_data() { eachVerb(); }
    void aSectionDescribesTheOptionsOfItsVerb()
    {
        const app::Verb &verb = thisVerb();
        const QMap<QString, QString> paragraphs = optionParagraphs(verbSections()[headingOf(verb)]);
        QCOMPARE(QStringList(paragraphs.keys()), optionNames(verb));
        for (const app::Option &option : verb.options)
            QVERIFY2(paragraphs[option.name].contains(option.defaultValue), qPrintable(option.name));
    }

    void theOverviewListsEveryOption_data() { eachVerb(); }
    void theOverviewListsEveryOption()
    {
        const app::Verb &verb = thisVerb();
        QString expected = headingOf(verb);
        for (const app::Option &option : verb.options)
            expected +=
                " [--" + option.name + (option.valueName.isEmpty() ? "" : " ") + option.valueName + ']';
        const Answer answer = springstep({"--help"});
        QCOMPARE(answer.code, 0);
        const QString help = answer.out.simplified();
        QVERIFY2(help.contains(' ' + expected + ' ' + verb.summary), qPrintable(answer.out));
        for (const QString &line : answer.out.split('\n'))
            QVERIFY2(line.size() < 80, qPrintable(line));
    }

    void aVerbsHelpExplainsItsArgumentsAndOptions_data() { eachVerb(); }
    void aVerbsHelpExplainsItsArgumentsAndOptions()
    {
        const app::Verb &verb = thisVerb();
        const Answer answer = springstep({verb.name, "--help"});
        QCOMPARE(answer.code, 0);
        const QString help = answer.out.simplified();
        QVERIFY2(help.startsWith("Usage: springstep " + verb.name + " [options]"), qPrintable(help));
        QVERIFY2(help.contains(verb.summary), qPrintable(help));
        for (const app::Argument &argument : verb.arguments)
            QVERIFY2(help.contains(argument.name + ' ' + argument.summary), qPrintable(argument.name));
        for (const app::Option &option : verb.options) {
            const QString value = option.valueName.isEmpty() ? QString() : " <" + option.valueName + '>';
            const QString summary = option.summary.chopped(1); // a default value follows before the full stop
            QVERIFY2(help.contains("--" + option.name + value + ' ' + summary), qPrintable(option.name));
            QVERIFY2(help.contains(option.defaultValue), qPrintable(option.name));
        }
    }

    void translationsDescribeTheSameOptions_data()
    {
        QTest::addColumn<QString>("name");
        for (const QString &code : app::Language::known()) {
            if (code != "en")
                QTest::newRow(qPrintable(code)) << "springstep." + code + ".1";
        }
    }
    void translationsDescribeTheSameOptions()
    {
        QFETCH(QString, name);
        const QString english = sourceOf("springstep.1"), translated = sourceOf(name);
        QCOMPARE(frameOf(translated), frameOf(english));
        QVERIFY(translated.section('\n', 1) != english.section('\n', 1));
    }

private:
    static void eachVerb()
    {
        QTest::addColumn<int>("verb");
        for (std::size_t i = 0; i < app::verbs().size(); ++i)
            QTest::newRow(qPrintable(app::verbs()[i].name)) << int(i);
    }
    static const app::Verb &thisVerb()
    {
        QFETCH(int, verb);
        return app::verbs()[std::size_t(verb)];
    }
};

SUITE(tst_man_page, ManPageTest)
#include "tst_man_page.moc"
