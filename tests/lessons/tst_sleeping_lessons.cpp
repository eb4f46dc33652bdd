// Each step of each lesson, with sleep and without: the same bits.

#include "tests/lessons/support.h"

#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/run/track.h"

#include <QTest>

using namespace sim;

namespace {

constexpr std::int64_t frames = 1000;
constexpr int manyPoints = 500; ///< scenes with more are looked at for a shorter time

/// FNV-1a over all bits of a state.
/// Source: RFC 9923 (draft-eastlake-fnv), the 64-bit variant.
std::uint64_t hashed(const State &state, std::uint64_t hash)
{
    visitBytes(state, [&](const void *data, std::size_t bytes) {
        const auto *byte = static_cast<const unsigned char *>(data);
        for (std::size_t i = 0; i < bytes; ++i)
            hash = (hash ^ byte[i]) * 0x100000001b3u;
    });
    return hash;
}

std::uint64_t hashOf(const Script &script, std::int64_t length, Sleeping sleeping, bool &slept)
{
    Track track(script, 0, sleeping);
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (std::int64_t frame = 0; frame <= length; frame += track.framesPerOutput()) {
        track.seek({frame, 0});
        hash = hashed(track.state(), hash);
        slept = slept || track.sleep();
    }
    return hash;
}

}

class TestSleepingLessons : public QObject
{
    Q_OBJECT

private slots:
    void asleepAndAwakeAreTheSameRun_data()
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
    void asleepAndAwakeAreTheSameRun()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        QFETCH(QString, method);
        const support::LoadedLesson loaded = support::loadLesson(lesson);
        Script script = support::scriptOf(loaded.step(step), method.toStdString());
        const Scene scene = sceneOf(script, script.values);
        if (script.input.empty()) { // a hand comes, and lets go again
            const std::string &body = scene.names.back();
            const Vec2 there = scene.start.positionOf(scene.find(body)) + Vec2{60.0, -40.0};
            script.input = {{5, Grab{body}}, {6, Move{there}}, {25, Release{}}, {700, Grab{body}}};
        }
        const std::int64_t length = scene.start.pointCount() > manyPoints ? frames / 20 : frames;
        try {
            bool slept = false, wakerSlept = false;
            const std::uint64_t asleep = hashOf(script, length, Sleeping::allowed, slept);
            QCOMPARE(asleep, hashOf(script, length, Sleeping::never, wakerSlept));
            QVERIFY(!wakerSlept);
            m_slept += slept;
        } catch (const Error &) {
            QSKIP("this method cannot compute it");
        }
    }

    void someOfThemDidSleep() { QVERIFY(m_slept >= 10); }

private:
    int m_slept = 0;
};

QTEST_APPLESS_MAIN(TestSleepingLessons)
#include "tst_sleeping_lessons.moc"
