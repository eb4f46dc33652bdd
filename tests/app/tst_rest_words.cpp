// What the panel says a scene costs at rest, and that it is so.

#include "app/model/experiment.h"
#include "app/model/rest_words.h"
#include "app/model/session.h"

#include <QTest>

using namespace app;

class RestWordsTest : public QObject
{
    Q_OBJECT

private slots:
    void theSentenceTellsWhatKeepsASceneAwake_data();
    void theSentenceTellsWhatKeepsASceneAwake();
    void aSceneThatRestsSaysSo();
};

void RestWordsTest::theSentenceTellsWhatKeepsASceneAwake_data()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("method");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("springs") << "two_body"
                             << "mutual"
                             << "published"
                             << "What comes to rest costs nothing until it is touched.";
    QTest::newRow("random turbulence")
        << "swaying_tree"
        << "turbulence" << QString() << "Nothing rests now: “wind” changes with the time.";
    QTest::newRow("an adaptive method")
        << "two_body"
        << "mutual"
        << "dormand_prince"
        << "With a method that chooses its own steps, what rests costs as much as what moves.";
}

void RestWordsTest::theSentenceTellsWhatKeepsASceneAwake()
{
    QFETCH(const QString, lesson);
    QFETCH(const QString, step);
    QFETCH(const QString, method);
    QFETCH(const QString, sentence);
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Session session(library);
    session.openStep(lesson, step);
    if (!method.isEmpty())
        session.setMethod(method);
    session.point({100.0, 200.0}, true); // the wind blows, where there is one
    session.frameForward();
    QCOMPARE(restSentence(session.timeline().track()), sentence);
}

void RestWordsTest::aSceneThatRestsSaysSo()
{
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Session session(library);
    session.openStep("single_spring", "fixed_centre");
    const QString awake = restSentence(session.timeline().track());
    QVERIFY(!awake.contains("Everything rests"));
    session.goTo({40'000, 0}); // damping 0.9 has taken all motion away long before
    QTRY_VERIFY_WITH_TIMEOUT(!session.goingTo(), 60'000);
    QVERIFY(restSentence(session.timeline().track()).contains("Everything rests"));
    session.grab("foot");
    session.moveHand({10.0, 20.0});
    session.letGo();
    session.frameForward();
    QCOMPARE(restSentence(session.timeline().track()), awake);
}

QTEST_GUILESS_MAIN(RestWordsTest)
#include "tst_rest_words.moc"
