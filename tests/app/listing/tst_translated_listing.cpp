// A learner's code that was written in one language of the window and is opened in another.

#include "app/model/experiment/experiment.h"
#include "app/model/listing/changed_lines.h"
#include "app/model/listing/learner_code.h"
#include "app/model/run/run_program.h"
#include "app/model/text/language.h"
#include "tests/app/listing/code_session.h"
#include "tests/suite.h"

#include <QTest>

using namespace app;
using code_session::Opened;

namespace {

/// A session in a language.
struct SpokenSession
{
    explicit SpokenSession(const QString &code) : language(code)
    {
        session.openStep("single_spring", "drag");
    }

    Language language;
    LessonLibrary library = LessonLibrary::load({LESSON_DIR}, &language);
    Session session{library};
};

/// Returns the file of a run in which the learner has changed the listing by `change`, in a window of another language.
template <class Change>
QByteArray writtenIn(const QString &language, Change change)
{
    SpokenSession world(language);
    const QString text = world.session.code().text();
    world.session.code().write(change(text));
    return experimentText(world.session.experiment(), world.library);
}

QString slower(const QString &text)
{
    return Opened::with(text, "*= damp", "*= 0.5");
}

}

class TranslatedListingTest : public QObject
{
    Q_OBJECT

private slots:
    void commentsAreThoseOfTheWindow();
    void onlyChangedLinesAreMarked_data() { addPairs(); }
    void onlyChangedLinesAreMarked();
    void aChangeTakenBackIsUntouched_data() { addPairs(); }
    void aChangeTakenBackIsUntouched();
    void aDraftIsTranslatedToo_data() { addPairs(); }
    void aDraftIsTranslatedToo();

private:
    static void addPairs()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::newRow("German in English") << "de"
                                           << "en";
        QTest::newRow("English in German") << "en"
                                           << "de";
        QTest::newRow("Spanish in French") << "es"
                                           << "fr";
    }
};

void TranslatedListingTest::commentsAreThoseOfTheWindow()
{
    QStringList texts;
    for (const char *code : {"en", "de", "es", "fr"}) {
        const SpokenSession world(code);
        const QString text = world.session.code().text();
        QVERIFY(!texts.contains(text));
        QVERIFY(!world.session.code().isChanged());
        texts << text;
    }
    QVERIFY(texts[0].contains("// It moves with your hand."));
    QVERIFY(texts[1].contains(QStringLiteral("// Er geht mit deiner Hand mit.")));
}

void TranslatedListingTest::onlyChangedLinesAreMarked()
{
    QFETCH(QString, from);
    QFETCH(QString, to);
    const QByteArray file = writtenIn(from, slower);
    SpokenSession world(to);
    world.session.open(parseExperiment(file, "x.json", world.library));
    const LearnerCode &code = world.session.code();
    QCOMPARE(code.text(), slower(code.original()));
    QVERIFY(code.isChanged() && code.isRunning());
    const ChangedLines lines = changedLines(code.original(), code.text());
    QCOMPARE(lines.changed.size(), std::size_t{1});
    QVERIFY(lines.removedBefore.empty());
    world.session.code().reset();
    QVERIFY(!code.isChanged());
}

void TranslatedListingTest::aChangeTakenBackIsUntouched()
{
    QFETCH(QString, from);
    QFETCH(QString, to);
    const QByteArray file = writtenIn(from, slower).replace("*= 0.5", "*= damp");
    QVERIFY(file.contains("\"code\""));
    SpokenSession world(to);
    world.session.open(parseExperiment(file, "x.json", world.library));
    QVERIFY(!world.session.code().isChanged());
}

void TranslatedListingTest::aDraftIsTranslatedToo()
{
    QFETCH(QString, from);
    QFETCH(QString, to);
    const QString broken = QStringLiteral("// mine\nvoid broken(");
    const QByteArray file = writtenIn(from, [&](const QString &text) { return text + broken; });
    SpokenSession world(to);
    world.session.open(parseExperiment(file, "x.json", world.library));
    QCOMPARE(world.session.code().text(), world.session.code().original() + broken);
    QVERIFY(world.session.code().draft());
}

SUITE(tst_translated_listing, TranslatedListingTest)
#include "tst_translated_listing.moc"
