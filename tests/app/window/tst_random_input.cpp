// Random input to the whole window: it goes on, and the run is the same as that of its file. The seed and the number of
// inputs can be chosen: SPRINGSTEP_SEED=3260 SPRINGSTEP_RANDOM_INPUTS=600.

#include "tests/app/support/window_fixture.h"
#include "tests/app/window/random_input.h"

#include "app/model/experiment/experiment_line.h"
#include "app/model/run/same_run.h"
#include "tests/suite.h"

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

using namespace app;
using namespace tests;

class RandomInputTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { QSettings().clear(); }
    void runEqualsTheRunOfItsFile_data();
    void runEqualsTheRunOfItsFile();

private:
    QTemporaryDir m_folder;
};

void RandomInputTest::initTestCase()
{
    QVERIFY(m_folder.isValid());
    qputenv("HOME", m_folder.path().toUtf8()); // files that are saved by chance
    QDir::setCurrent(m_folder.path());
}

void RandomInputTest::runEqualsTheRunOfItsFile_data()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    QTest::addColumn<unsigned>("seed");
    const QStringList places{"single_spring/radial",
                             "multi_foot/any_number",
                             "gravity_walls/gravity",
                             "walking_gait/steering",
                             "swaying_tree/wind",
                             "rigid_constraint/ragdoll",
                             "codeling/squash_stretch",
                             "accuracy/",
                             "hard_cases/",
                             "sandbox/build"};
    const int given = qEnvironmentVariableIntValue("SPRINGSTEP_SEED");
    unsigned seed = given > 0 ? static_cast<unsigned>(given) : 1u;
    for (const QString &place : places) {
        QTest::addRow("%s, seed %u", qPrintable(place), seed)
            << place.section('/', 0, 0) << place.section('/', 1) << seed;
        ++seed;
    }
}

void RandomInputTest::runEqualsTheRunOfItsFile()
{
    QFETCH(QString, lesson);
    QFETCH(QString, step);
    QFETCH(unsigned, seed);
    WindowFixture fixture({.study = quickStudy});
    const LessonEntry *entry = fixture.library.lesson(lesson);
    QVERIFY(entry);
    fixture.session.openStep(lesson, step.isEmpty() ? entry->steps.front().id : step);
    RandomUser user(fixture.window, seed);
    const int given = qEnvironmentVariableIntValue("SPRINGSTEP_RANDOM_INPUTS");
    const int actions = given > 0 ? given : RANDOM_INPUTS;
    for (int i = 0; i < actions; ++i) {
        user.act();
        if (!fixture.window.isVisible())
            fixture.window.show(); // the input may close it
    }
    Session &session = fixture.session;
    session.playback().pause();
    session.input().release();
    session.input().releaseAll();
    QVERIFY2(QTest::qWaitFor([&] { return !session.playback().goal(); }, 60'000), qPrintable(user.last()));
    const sim::Timeline &timeline = session.timeline();
    QVERIFY2(timeline.state().position.allFinite() && timeline.state().velocity.allFinite(),
             qPrintable(user.last()));
    const Experiment there = session.experiment();
    const Experiment read = experimentFromLine(experimentLine(there, fixture.library), fixture.library);
    QVERIFY2(sameScript(read.script, there.script), qPrintable(user.last()));
    sim::Timeline again(read.script);
    again.seek(timeline.cursor());
    QCOMPARE(again.cursor(), timeline.cursor());
    QVERIFY2(sim::sameBits(again.state(), timeline.state()), qPrintable(user.last()));
}

SUITE(tst_random_input, RandomInputTest)
#include "tst_random_input.moc"
