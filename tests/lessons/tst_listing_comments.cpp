// The comments of listings in every language of the window.

#include "tests/lessons/support/documents.h"
#include "tests/suite.h"

#include <QCoreApplication>
#include <QMap>
#include <QTest>
#include <QTranslator>

#include <memory>

using namespace support;

namespace {

constexpr qsizetype longestLine =
    100; ///< letters: the width of the code panel in a window that fills a screen

/// A language while it exists.
class Spoken
{
public:
    /// `language`: "en" has no translations.
    Spoken(const QString &lesson, const QString &language)
    {
        if (m_translator.load(QStringLiteral(":/i18n/%1_%2.qm").arg(lesson, language)))
            QCoreApplication::installTranslator(&m_translator);
    }
    ~Spoken() { QCoreApplication::removeTranslator(&m_translator); }

    QString comment(const QString &english) const
    {
        return m_translator.translate("listing", english.toUtf8().constData());
    }

private:
    QTranslator m_translator;
};

/// Returns a line without its comment.
QString codeOf(const QString &line)
{
    const qsizetype comment = line.indexOf(QStringLiteral("//"));
    return comment < 0 ? line : line.left(comment);
}

}

class ListingComments : public QObject
{
    Q_OBJECT

private slots:
    void everyCommentIsTranslated_data() { addRows(); }
    void everyCommentIsTranslated();
    void onlyCommentsDiffer_data() { addRows(); }
    void onlyCommentsDiffer();
    void listingOfAnotherLanguageIsShownInTheWindowsLanguage_data() { addRows(); }
    void listingOfAnotherLanguageIsShownInTheWindowsLanguage();
    void learnersTextIsNotTranslated();
    void lessonsAgreeOnTheirComments();

private:
    /// Adds a row for each lesson with listings and each language.
    static void addRows();
    static std::vector<lessons::Listing> listingsOf(const QString &lesson);
};

void ListingComments::addRows()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("language");
    for (const LoadedLesson &lesson : allLessons()) {
        if (listingsOf(idOf(lesson)).empty())
            continue;
        for (const QString &language : documentLanguages())
            QTest::addRow("%s.%s", qPrintable(idOf(lesson)), qPrintable(language))
                << idOf(lesson) << language;
    }
}

std::vector<lessons::Listing> ListingComments::listingsOf(const QString &lesson)
{
    std::vector<lessons::Listing> listings;
    for (const LoadedLesson &one : allLessons()) {
        for (const lessons::Step &step : one.steps) {
            if (idOf(one) == lesson && !step.listing.isEmpty())
                listings.push_back(lessons::readListing(lesson, step.id));
        }
    }
    return listings;
}

void ListingComments::everyCommentIsTranslated()
{
    QFETCH(QString, lesson);
    QFETCH(QString, language);
    if (language == u"en")
        return;
    const Spoken spoken(lesson, language);
    QStringList missing;
    for (const lessons::Listing &listing : listingsOf(lesson)) {
        for (const QString &comment : listing.comments) {
            if (spoken.comment(comment).trimmed().isEmpty() && !missing.contains(comment))
                missing << comment;
        }
    }
    QVERIFY2(missing.isEmpty(),
             qPrintable(QStringLiteral("%1_%2.ts lacks:\n%3").arg(lesson, language, missing.join('\n'))));
}

void ListingComments::onlyCommentsDiffer()
{
    QFETCH(QString, lesson);
    QFETCH(QString, language);
    const std::vector<lessons::Listing> english = listingsOf(lesson);
    const Spoken spoken(lesson, language);
    const std::vector<lessons::Listing> translated = listingsOf(lesson);
    for (std::size_t i = 0; i < english.size(); ++i) {
        QCOMPARE(translated[i].gaps, english[i].gaps);
        const QStringList was = english[i].text.split('\n'), is = translated[i].text.split('\n');
        QCOMPARE(is.size(), was.size());
        for (qsizetype line = 0; line < is.size(); ++line) {
            QCOMPARE(codeOf(is[line]), codeOf(was[line]));
            QVERIFY2(is[line].size() <= longestLine, qPrintable(is[line]));
        }
    }
}

void ListingComments::listingOfAnotherLanguageIsShownInTheWindowsLanguage()
{
    QFETCH(QString, lesson);
    QFETCH(QString, language);
    std::vector<std::vector<lessons::Listing>> ofFiles;
    for (const QString &other : documentLanguages()) {
        const Spoken spoken(lesson, other);
        ofFiles.push_back(listingsOf(lesson));
    }
    const Spoken spoken(lesson, language);
    const std::vector<lessons::Listing> shown = listingsOf(lesson);
    for (const std::vector<lessons::Listing> &ofFile : ofFiles) {
        for (std::size_t i = 0; i < shown.size(); ++i)
            QCOMPARE(shown[i].inLanguageOfWindow(ofFile[i].text), shown[i].text);
    }
}

void ListingComments::learnersTextIsNotTranslated()
{
    const QString lesson = QStringLiteral("single_spring");
    QString german;
    {
        const Spoken spoken(lesson, QStringLiteral("de"));
        german = lessons::readListing(lesson, QStringLiteral("drag")).text;
    }
    const lessons::Listing listing = lessons::readListing(lesson, QStringLiteral("drag"));
    QVERIFY(german != listing.text);
    const QString mine = QStringLiteral("\n// Mein Kommentar\nint n = 1; // eins\n/* // kein Ende */");
    QCOMPARE(listing.inLanguageOfWindow(german + mine), listing.text + mine);
    QCOMPARE(lessons::parseListing(german).inLanguageOfWindow(german), german); // of no lesson
}

void ListingComments::lessonsAgreeOnTheirComments()
{
    for (const QString &language : documentLanguages()) {
        QMap<QString, QString> all;
        for (const LoadedLesson &lesson : allLessons()) {
            const std::vector<lessons::Listing> listings = listingsOf(idOf(lesson)); // in English
            const Spoken spoken(idOf(lesson), language);
            for (const lessons::Listing &listing : listings) {
                for (const QString &comment : listing.comments) {
                    const QString said = spoken.comment(comment);
                    QCOMPARE(said, all.value(comment, said));
                    all.insert(comment, said);
                }
            }
        }
    }
}

SUITE(tst_listing_comments, ListingComments)
#include "tst_listing_comments.moc"
