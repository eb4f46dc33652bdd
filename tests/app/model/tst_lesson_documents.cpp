// Documents of lessons from a folder: the window reloads them when they change.

#include "app/model/catalog/lesson_documents.h"
#include "app/model/session/session.h"
#include "app/model/text/language.h"
#include "tests/app/support/files.h"
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

    /// Returns the text of an embedded document of the lesson two_body.
    static QByteArray embedded(const QString &name)
    {
        return tests::contentsOf(":/documents/two_body/" + name);
    }

    /// Saves a document like an editor: writes another file first, then renames it.
    void write(const QByteArray &text, const QString &name) const
    {
        QSaveFile file(folder.filePath("two_body/" + name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        QVERIFY(file.commit());
    }

    /// Saves the document of the step two_body/mutual with another title.
    void save(const QByteArray &title, const QString &name = "mutual.md") const
    {
        const QByteArray text = embedded(name);
        write(title + text.mid(text.indexOf('\n')), name);
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
    void changedDocumentIsReloadedAndTheRunStays();
    void mistakeIsReportedAndTheLastGoodTextStays();
    void theQuestionsOfALessonAreFollowed();
    void thePrerequisitesOfConceptsAreChecked();
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

void LessonDocumentsTest::changedDocumentIsReloadedAndTheRunStays()
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

void LessonDocumentsTest::mistakeIsReportedAndTheLastGoodTextStays()
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

void LessonDocumentsTest::theQuestionsOfALessonAreFollowed()
{
    DocumentFolder lessons;
    const QByteArray questions = DocumentFolder::embedded("recall.md");
    lessons.save("# One", "recall.md");
    LessonDocuments documents(lessons.library, lessons.folder.path());
    const lessons::Recall &recall = lessons.library.lesson("two_body")->recall;
    QCOMPARE(recall.title, QString("One"));
    const std::size_t count = recall.questions.size();
    QVERIFY(count >= 3);
    lessons.write(QByteArray(questions).replace("- until: ", "- until: tail.x > 0 and "), "recall.md");
    QTRY_VERIFY(documents.mistake().contains("two_body/recall.md, line "));
    QVERIFY2(documents.mistake().contains("tail"), qPrintable(documents.mistake()));
    QCOMPARE(recall.title, QString("One")); // the last good text stays
    lessons.write(questions, "recall.md");
    QTRY_VERIFY(documents.mistake().isEmpty());
    QVERIFY(recall.title != "One");
    QCOMPARE(recall.questions.size(), count);
}

void LessonDocumentsTest::thePrerequisitesOfConceptsAreChecked()
{
    DocumentFolder lessons;
    const QByteArray text = DocumentFolder::embedded("mutual.md");
    const QByteArray wrong =
        "## Concept: Too early {#too_early}\n\nRests on: gravity\n\nIt cannot be.\n\n## Why:";
    QByteArray broken = text;
    const qsizetype place = text.indexOf("## Why:");
    QVERIFY(place > 0);
    lessons.write(broken.replace(place, 7, wrong), "mutual.md");
    LessonDocuments documents(lessons.library, lessons.folder.path());
    const int line = static_cast<int>(text.left(place).count('\n')) + 1;
    QVERIFY2(documents.mistake().contains(QStringLiteral("mutual.md, line %1: ").arg(line)),
             qPrintable(documents.mistake()));
    QVERIFY(documents.mistake().contains("comes later"));
    lessons.write(text, "mutual.md");
    QTRY_VERIFY(documents.mistake().isEmpty());
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
