// The manual page and the help texts agree with the table of verbs.

#include "app/cli/verbs.h"
#include "tests/app/cli/program.h"
#include "tests/suite.h"

#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QTest>

using namespace program;

namespace {

/// Returns the manual page without the escapes and font macros of roff.
QString manualPage()
{
    QFile file(SOURCE_DIR "/app/springstep.1");
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString text = QString::fromUtf8(file.readAll());
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
