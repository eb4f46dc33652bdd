// Whatever is pressed, dragged and typed in the window, it goes on, and its run is the one that its file tells. By hand with
// other seeds, and more deeds in each place: SPRINGSTEP_SEED=3260 SPRINGSTEP_HAND_DEEDS=600.

#include "quick_bench.h"
#include "random_hand.h"

#include "app/model/experiment_line.h"
#include "app/model/same_run.h"

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

using namespace app;

class AnyHandTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { QSettings().clear(); }
    void theRunIsTheOneThatItsFileTells_data();
    void theRunIsTheOneThatItsFileTells();

private:
    QTemporaryDir m_folder;
};

void AnyHandTest::initTestCase()
{
    QVERIFY(m_folder.isValid());
    qputenv("HOME", m_folder.path().toUtf8()); // files that are saved by chance
    QDir::setCurrent(m_folder.path());
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
}

void AnyHandTest::theRunIsTheOneThatItsFileTells_data()
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

void AnyHandTest::theRunIsTheOneThatItsFileTells()
{
    QFETCH(QString, lesson);
    QFETCH(QString, step);
    QFETCH(unsigned, seed);
    quick_bench::Bench bench;
    const LessonEntry *entry = bench.library.lesson(lesson);
    QVERIFY(entry);
    bench.session.openStep(lesson, step.isEmpty() ? entry->steps.front().id : step);
    RandomHand hand(bench.window, seed);
    const int given = qEnvironmentVariableIntValue("SPRINGSTEP_HAND_DEEDS");
    const int deeds = given > 0 ? given : HAND_DEEDS;
    for (int i = 0; i < deeds; ++i) {
        hand.act();
        if (!bench.window.isVisible())
            bench.window.show(); // it was closed, which is a learner's right
    }
    Session &session = bench.session;
    session.pause();
    session.letGo();
    session.letUp();
    QVERIFY2(QTest::qWaitFor([&] { return !session.goingTo(); }, 60'000), qPrintable(hand.last()));
    const sim::Timeline &timeline = session.timeline();
    QVERIFY2(timeline.state().position.allFinite() && timeline.state().velocity.allFinite(),
             qPrintable(hand.last()));
    const Experiment there = session.experiment();
    const Experiment read = experimentFromLine(experimentLine(there, bench.library), bench.library);
    QVERIFY2(sameScript(read.script, there.script), qPrintable(hand.last()));
    sim::Timeline again(read.script);
    again.seek(timeline.cursor());
    QCOMPARE(again.cursor(), timeline.cursor());
    QVERIFY2(sim::sameBits(again.state(), timeline.state()), qPrintable(hand.last()));
}

QTEST_MAIN(AnyHandTest)
#include "tst_any_hand.moc"
