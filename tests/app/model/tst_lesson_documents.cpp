// Documents of lessons from a folder: the window follows them as they are written.

#include "app/model/catalog/lesson_documents.h"
#include "app/model/session/session.h"
#include "app/model/text/language.h"
#include "tests/suite.h"

#include <QDir>
#include <QSaveFile>
#include <QTemporaryDir>
#include <QTest>

using namespace app;

namespace {

/// A folder with documents, and a library that shows them.
struct DocumentFolder
{
    QTemporaryDir folder;
    LessonLibrary library;

    explicit DocumentFolder(Language *language = nullptr)
        : library(LessonLibrary::load({LESSON_DIR}, language))
    {
        QDir(folder.path()).mkpath("two_body");
    }

    /// Saves the document of the step two_body/mutual with another title, as an editor does: in another file first.
    void save(const QByteArray &title, const QString &name = "mutual.md") const
    {
        QFile embedded(":/documents/two_body/" + name);
        QVERIFY(embedded.open(QIODevice::ReadOnly));
        const QByteArray text = embedded.readAll();
        QSaveFile file(folder.filePath("two_body/" + name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(title + text.mid(text.indexOf('\n')));
        QVERIFY(file.commit());
    }

    const lessons::Step &step() const { return *library.lesson("two_body")->step("mutual"); }
};

}

class LessonDocumentsTest : public QObject
{
    Q_OBJECT

private slots:
    void aDocumentInTheFolderReplacesTheEmbeddedOne();
    void theLanguageOfTheWindowIsShown();
    void aChangeIsFollowedAndTheRunStays();
    void aMistakeIsToldAndTheLastGoodTextStays();
    void withoutAFolderNothingChanges();
};

void LessonDocumentsTest::aDocumentInTheFolderReplacesTheEmbeddedOne()
{
    DocumentFolder lessons;
    lessons.save("# Another title");
    const std::size_t tries = lessons.step().tries.size();
    const LessonDocuments documents(lessons.library, lessons.folder.path());
    QCOMPARE(lessons.step().title, QString("Another title"));
    QCOMPARE(lessons.step().tries.size(), tries);
    QVERIFY(documents.mistake().isEmpty());
}

void LessonDocumentsTest::theLanguageOfTheWindowIsShown()
{
    Language german("de");
    DocumentFolder lessons(&german);
    lessons.save("# English");
    lessons.save("# Deutsch", "mutual.de.md");
    const LessonDocuments documents(lessons.library, lessons.folder.path());
    QCOMPARE(lessons.step().title, QString("Deutsch"));
}

void LessonDocumentsTest::aChangeIsFollowedAndTheRunStays()
{
    DocumentFolder lessons;
    lessons.save("# One");
    LessonDocuments documents(lessons.library, lessons.folder.path());
    Session session(lessons.library);
    session.openStep("two_body", "mutual");
    session.playback().goTo({7, 0});
    QTRY_COMPARE(session.timeline().cursor().frame, std::int64_t{7});
    connect(&documents, &LessonDocuments::changed, &session, &Session::announceTexts);
    QString shown;
    session.onChange(ChangeKind::texts, this, [&] { shown = session.step().title; });
    for (const char *title : {"Two", "Three"}) { // a file that was replaced is still watched
        lessons.save(QByteArray("# ") + title);
        QTRY_COMPARE(shown, QString(title));
    }
    QCOMPARE(session.timeline().cursor().frame, std::int64_t{7});
}

void LessonDocumentsTest::aMistakeIsToldAndTheLastGoodTextStays()
{
    DocumentFolder lessons;
    lessons.save("# One");
    LessonDocuments documents(lessons.library, lessons.folder.path());
    QString told;
    connect(&documents, &LessonDocuments::mistakeChanged, this,
            [&](const QString &sentence) { told = sentence; });
    lessons.save("One");
    QTRY_VERIFY(told.contains("mutual.md, line 1: the title is missing."));
    QCOMPARE(documents.mistake(), told);
    QCOMPARE(lessons.step().title, QString("One"));
    lessons.save("# Two");
    QTRY_VERIFY(told.isEmpty());
    QCOMPARE(lessons.step().title, QString("Two"));
}

void LessonDocumentsTest::withoutAFolderNothingChanges()
{
    DocumentFolder lessons;
    lessons.save("# Another title");
    const QString title = lessons.step().title;
    for (const QString &folder : {QString(), lessons.folder.filePath("none")}) {
        const LessonDocuments documents(lessons.library, folder);
        QVERIFY(documents.mistake().isEmpty());
        QCOMPARE(lessons.step().title, title);
    }
}

SUITE(tst_lesson_documents, LessonDocumentsTest)
#include "tst_lesson_documents.moc"
