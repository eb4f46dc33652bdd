// Every lesson step gives the same bits with and without sleeping.

#include "tests/lessons/support/support.h"

#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/run/track.h"
#include "tests/hash.h"
#include "tests/suite.h"

#include <QTest>

namespace {

constexpr int maxPointsOfLongRuns = 500; ///< larger scenes run for fewer frames

/// Returns a hash of all output steps of a run. Sets `slept` if the run slept at any of them.
std::uint64_t hashOf(const sim::Script &script, std::int64_t length, sim::Sleeping sleeping, bool &slept)
{
    sim::Track track(script, 0, sleeping);
    std::uint64_t hash = tests::emptyHash;
    for (std::int64_t frame = 0; frame <= length; frame += track.framesPerOutput()) {
        track.seek({frame, 0});
        hash = tests::updatedHash(hash, track.state());
        slept = slept || track.sleep();
    }
    return hash;
}

}

class SleepingLessons : public QObject
{
    Q_OBJECT

    static constexpr std::int64_t frames = 1000;

private slots:
    void sleepingChangesNoBits_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("step");
        QTest::addColumn<QString>("method");
        for (const QString &lesson : support::lessonIds()) {
            for (const lessons::Step &step : support::loadLesson(lesson).steps) {
                for (const QString &method :
                     {step.method, QStringLiteral("semi_implicit_euler"), QStringLiteral("dormand_prince")}) {
                    const QString name = lesson + '/' + step.id + ' ' + method;
                    if (method != step.method || method == QStringLiteral("published"))
                        QTest::newRow(qPrintable(name)) << lesson << step.id << method;
                }
            }
        }
    }
    void sleepingChangesNoBits()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        const support::LoadedLesson loaded = support::loadLesson(lesson);
        sim::Script script = support::scriptOf(loaded.step(step), method.toStdString());
        const sim::Scene scene = sim::sceneOf(script, script.values);
        if (script.input.empty()) { // a drag, and a late grab that wakes the run
            const std::string &body = scene.names.back();
            const sim::Vec2 target = scene.start.positionOf(scene.find(body)) + sim::Vec2{60.0, -40.0};
            script.input = {
                {5, sim::Grab{body}}, {6, sim::Move{target}}, {25, sim::Release{}}, {700, sim::Grab{body}}};
        }
        const std::int64_t length = scene.start.pointCount() > maxPointsOfLongRuns ? frames / 20 : frames;
        try {
            bool slept = false, sleptWhenForbidden = false;
            const std::uint64_t hashWithSleep = hashOf(script, length, sim::Sleeping::allowed, slept);
            QCOMPARE(hashWithSleep, hashOf(script, length, sim::Sleeping::never, sleptWhenForbidden));
            QVERIFY(!sleptWhenForbidden);
            m_sleepingRuns += slept;
        } catch (const sim::Error &) {
            QSKIP("this method cannot compute this step");
        }
    }

    void someRunsSleep() { QVERIFY(m_sleepingRuns >= 10); }

private:
    int m_sleepingRuns = 0;
};

SUITE(tst_sleeping_lessons, SleepingLessons)
#include "tst_sleeping_lessons.moc"
