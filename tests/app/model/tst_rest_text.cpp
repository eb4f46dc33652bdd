// The panel's sentence about rest: whether a scene is at rest, and what prevents it.

#include "app/model/experiment/experiment.h"
#include "app/model/session/session.h"
#include "app/model/text/rest_text.h"
#include "tests/suite.h"

#include <QTest>

using namespace app;

class RestWordsTest : public QObject
{
    Q_OBJECT

private slots:
    void sentenceSaysWhyASceneCannotRest_data();
    void sentenceSaysWhyASceneCannotRest();
    void aSceneThatRestsSaysSo();
};

void RestWordsTest::sentenceSaysWhyASceneCannotRest_data()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("method");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("springs") << "two_body"
                             << "mutual"
                             << "published"
                             << "Bodies at rest cost nothing until you touch them.";
    QTest::newRow("random turbulence")
        << "swaying_tree"
        << "turbulence" << QString() << "Nothing can rest now, because “wind” changes over time.";
    QTest::newRow("an adaptive method")
        << "two_body"
        << "mutual"
        << "dormand_prince"
        << "With a method that chooses its own steps, bodies at rest cost as much as moving ones.";
}

void RestWordsTest::sentenceSaysWhyASceneCannotRest()
{
    QFETCH(const QString, lesson);
    QFETCH(const QString, step);
    QFETCH(const QString, method);
    QFETCH(const QString, sentence);
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Session session(library);
    session.openStep(lesson, step);
    if (!method.isEmpty())
        session.editor().setMethod(method);
    session.input().setPointer({100.0, 200.0}, true); // the wind blows, where there is one
    session.playback().frameForward();
    QCOMPARE(restSentence(session.timeline().track()), sentence);
}

void RestWordsTest::aSceneThatRestsSaysSo()
{
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Session session(library);
    session.openStep("single_spring", "fixed_centre");
    const QString awake = restSentence(session.timeline().track());
    QVERIFY(!awake.contains("Everything is at rest"));
    session.playback().goTo({40'000, 0}); // damping 0.9 has taken all motion away long before
    QTRY_VERIFY_WITH_TIMEOUT(!session.playback().goal(), 60'000);
    QVERIFY(restSentence(session.timeline().track()).contains("Everything is at rest"));
    session.input().grab("foot");
    session.input().moveTo({10.0, 20.0});
    session.input().release();
    session.playback().frameForward();
    QCOMPARE(restSentence(session.timeline().track()), awake);
}

SUITE(tst_rest_text, RestWordsTest)
#include "tst_rest_text.moc"
