// The translation files are complete, and have the structure of the source texts.

#include "tests/lessons/support/translated_text.h"
#include "tests/suite.h"

#include <QDirIterator>
#include <QXmlStreamReader>
#include <QtTest>

using support::codeIn;
using support::foundIn;
using support::hasDecimalCommas;

namespace {

/// A text of a file of translations. Of one with a number in it, `translations` has a form for each plural.
struct Entry
{
    QString context;
    QString source;
    QStringList translations;
    bool finished = true;
};

QStringList formsIn(QXmlStreamReader &xml)
{
    QStringList forms;
    QString text;
    while (!xml.atEnd() && !(xml.isEndElement() && xml.name() == u"translation")) {
        xml.readNext();
        if (xml.isCharacters())
            text += xml.text();
        if (xml.isStartElement())
            text.clear();
        if (xml.isEndElement() && xml.name() == u"numerusform")
            forms << text;
    }
    return forms.isEmpty() ? QStringList(text) : forms;
}

std::vector<Entry> entriesOf(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    std::vector<Entry> entries;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        if (xml.name() == u"name") {
            context = xml.readElementText();
        } else if (xml.name() == u"source") {
            entries.push_back({context, xml.readElementText(), {}});
        } else if (xml.name() == u"translation") {
            entries.back().finished = xml.attributes().value("type").isEmpty();
            entries.back().translations = formsIn(xml);
        }
    }
    return entries;
}

QStringList withoutRepeats(QStringList list)
{
    list.removeDuplicates();
    return list;
}

}

class TranslationsTest : public QObject
{
    Q_OBJECT

private slots:
    void everyTextIsTranslated_data() { files(); }
    void everyTextIsTranslated()
    {
        eachForm([](const Entry &entry, const QString &form) { return entry.finished && !form.isEmpty(); });
    }

    void placeholdersAreThoseOfTheSource_data() { files(); }
    void placeholdersAreThoseOfTheSource()
    {
        eachForm([](const Entry &entry, const QString &form) {
            const QString places = "%(L?\\d+|n)";
            return withoutRepeats(foundIn(entry.source, places)) == withoutRepeats(foundIn(form, places));
        });
    }

    void markdownHasTheStructureOfTheSource_data() { files(); }
    void markdownHasTheStructureOfTheSource()
    {
        eachForm([](const Entry &entry, const QString &form) {
            const auto same = [&](const QString &pattern) {
                return foundIn(entry.source, pattern).size() == foundIn(form, pattern).size();
            };
            return same("\\*\\*") && same("(?m)^#+ ") && same("(?m)^[-*] ") && same("\n\n") &&
                   same("<[a-z/]+>");
        });
    }

    void codeIsNotTranslated_data() { files(); }
    void codeIsNotTranslated()
    {
        eachForm([](const Entry &entry, const QString &form) {
            return foundIn(entry.source, "`[^`]*`") == codeIn(form);
        });
    }

    void translationsKeepTheMnemonic_data() { files(); }
    void translationsKeepTheMnemonic()
    {
        eachForm([](const Entry &entry, const QString &form) {
            return foundIn(entry.source, "&\\w").size() == foundIn(form, "&\\w").size();
        });
    }

    void numbersHaveACommaInProse_data() { files("_??.ts"); }
    void numbersHaveACommaInProse()
    {
        // Sentences about files and the command line keep the decimal point, because files and commands require it.
        static const QStringList ofFiles = {"CommandLine", "ConditionTokensText", "ExperimentMethodText",
                                            "JsonDocumentText", "SentencesText"};
        eachForm([](const Entry &entry, const QString &form) {
            return ofFiles.contains(entry.context) || hasDecimalCommas(form);
        });
    }

private:
    void files(const QString &ending = ".ts")
    {
        QTest::addColumn<QString>("path");
        for (const char *folder : {"/app/translations", "/lessons"}) {
            QDirIterator at(SOURCE_DIR + QString(folder), {'*' + ending}, QDir::Files,
                            QDirIterator::Subdirectories);
            while (at.hasNext()) {
                const QString path = at.next();
                QTest::newRow(qPrintable(QFileInfo(path).fileName())) << path;
            }
        }
    }

    template <class Holds>
    void eachForm(Holds holds)
    {
        QFETCH(QString, path);
        const std::vector<Entry> entries = entriesOf(path);
        QVERIFY(!entries.empty());
        QStringList wrong;
        for (const Entry &entry : entries) {
            for (const QString &form : entry.translations) {
                if (!holds(entry, form))
                    wrong << entry.context + ": " + entry.source + "\n  -> " + form;
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable('\n' + wrong.join('\n')));
    }
};

SUITE(tst_translations, TranslationsTest)
#include "tst_translations.moc"
