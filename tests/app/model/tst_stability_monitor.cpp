// The stability monitor of a session: readings, remedies, maps and texts, for the installed lessons.

#include "app/model/experiment/experiment.h"
#include "app/model/session/session.h"
#include "app/model/text/stability_text.h"

#include "sim/methods/methods.h"
#include "sim/run/track.h"
#include "tests/app/support/waiting.h"
#include "tests/suite.h"

#include <QSignalSpy>
#include <QTextDocumentFragment>
#include <QtTest>

#include <cmath>

using namespace app;

namespace {

struct MonitoredRun
{
    LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Session session{library};
    StabilityMonitor monitor{session.run(), session.editor(), session.preview()};

    explicit MonitoredRun(const char *lesson = "two_body", const char *step = "mutual")
    {
        session.openStep(lesson, step);
    }
    /// Waits until the reading matches the session.
    const StabilityReading &settled()
    {
        // Readings are computed in the event loop.
        if (!QTest::qWaitFor([&] { return monitor.reading() && monitor.isCurrent(); }, 20'000))
            qFatal("no reading");
        return *monitor.reading();
    }
    const sim::GrowthMap &mapped()
    {
        const auto whole = std::size_t(StabilityMonitor::columns) * StabilityMonitor::rows;
        if (!QTest::qWaitFor(
                [&] {
                    return !monitor.isMapping() && monitor.map() && monitor.map()->growth.size() == whole;
                },
                60'000))
            qFatal("no map");
        return *monitor.map();
    }
    QString plainVerdict()
    {
        return QTextDocumentFragment::fromHtml(stabilityVerdict(settled())).toPlainText();
    }
};

}

class StabilityMonitorTest : public QObject
{
    Q_OBJECT

private slots:
    void theReadingFollowsTheSession();
    void framesComputedLaterChangeNoReading();
    void manyQuickChangesGiveFewReadingsAndTheLastIsRight();
    void nothingIsReadWhileNothingChanges();
    void remediesAreComputedOnlyWhileTheyAreShown();
    void adoptedRemedyMakesTheRunStable_data();
    void adoptedRemedyMakesTheRunStable();
    void wordsSayWhatBoundsTheStep_data();
    void wordsSayWhatBoundsTheStep();
    void remedyDescribesItsOutcome();
    void verdictExplainsStableStepsThatAreLongerThanUnstableOnes();
    void theLimitOfARuleWithVelocitiesIsUnknown();
    void jumpsAreNamed();
    void mapShowsGrowthWhereThePairDrifts_data();
    void mapShowsGrowthWhereThePairDrifts();
    void theMapEndsWhenItIsNoLongerRequested();
    void thereIsNoMapWithoutStiffnessOrLimit();
    void earlierSettingsStayOnTheMap();
    void everyStepOfEveryLessonHasAReading();
};

void StabilityMonitorTest::theReadingFollowsTheSession()
{
    MonitoredRun fixture;
    // The pair drifts off where k h^2 = 2 (damp^-h - 1): a little past one frame at k = 0.2, damp = 0.9.
    const sim::Stability &first = fixture.settled().stability;
    QVERIFY(first.share() > 0.88 && first.share() < 0.91);
    QVERIFY(first.holds());
    fixture.session.editor().setParameter("k", 0.3);
    QVERIFY(!fixture.settled().stability.holds());
    QCOMPARE(nearnessOf(fixture.settled().stability), Nearness::past);
    fixture.session.editor().setStepSize(0.25);
    QVERIFY(fixture.settled().stability.holds());
    QCOMPARE(fixture.settled().stability.h, 0.25);
    fixture.session.editor().setStepSize(1.0);
    fixture.session.editor().setMethod("semi_implicit_euler");
    QCOMPARE(nearnessOf(fixture.settled().stability), Nearness::far);
}

/// The row to come has more points than the moment itself.
void StabilityMonitorTest::framesComputedLaterChangeNoReading()
{
    MonitoredRun pending("walking_gait", "company"), computed("walking_gait", "company");
    const auto go = [](MonitoredRun &fixture, std::int64_t frame) {
        fixture.session.playback().goTo({frame, 0});
        QTRY_VERIFY(!fixture.session.playback().goal());
    };
    for (MonitoredRun *one : {&pending, &computed}) {
        go(*one, 20);
        one->session.editor().setParameter("creatures", 5);
    }
    go(computed, 30);
    go(computed, 20);
    const StabilityReading &a = pending.settled(), &b = computed.settled();
    QVERIFY(b.interval->scene.start.pointCount() > computed.session.timeline().state().pointCount());
    QCOMPARE(b.interval->scene.start.pointCount(), a.interval->scene.start.pointCount());
    QCOMPARE(b.stability.stiffness, a.stability.stiffness);
    QCOMPARE(b.stability.limit, a.stability.limit);
}

void StabilityMonitorTest::manyQuickChangesGiveFewReadingsAndTheLastIsRight()
{
    MonitoredRun fixture;
    fixture.settled();
    const QSignalSpy readings(&fixture.monitor, &StabilityMonitor::changed);
    for (int i = 1; i <= 300; ++i) {
        fixture.session.editor().setParameter("k", 0.001 * i);
        QCoreApplication::processEvents();
    }
    QVERIFY(!fixture.settled().stability.holds()); // 0.3
    QVERIFY2(readings.count() > 0 && readings.count() < 150, qPrintable(QString::number(readings.count())));
}

void StabilityMonitorTest::nothingIsReadWhileNothingChanges()
{
    MonitoredRun fixture;
    fixture.settled();
    const QSignalSpy readings(&fixture.monitor, &StabilityMonitor::changed);
    tests::settle();
    QVERIFY(fixture.monitor.isCurrent()); // neither a timer nor a thread is active
    QCOMPARE(readings.count(), 0);
    fixture.session.playback().frameForward();
    fixture.settled();
    QCOMPARE(readings.count(), 1);
}

void StabilityMonitorTest::remediesAreComputedOnlyWhileTheyAreShown()
{
    MonitoredRun fixture;
    fixture.session.editor().setParameter("k", 0.3);
    QVERIFY(fixture.settled().remedies.empty());
    fixture.monitor.setDetailed(true);
    QVERIFY(!fixture.settled().remedies.empty());
}

void StabilityMonitorTest::adoptedRemedyMakesTheRunStable_data()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("method");
    QTest::addRow("pair, published") << "two_body"
                                     << "mutual"
                                     << "published";
    QTest::addRow("pair, explicit Euler") << "two_body"
                                          << "mutual"
                                          << "explicit_euler";
    QTest::addRow("feet, published") << "multi_foot"
                                     << "any_number"
                                     << "published";
    QTest::addRow("one spring, midpoint") << "single_spring"
                                          << "fixed_centre"
                                          << "midpoint";
}

void StabilityMonitorTest::adoptedRemedyMakesTheRunStable()
{
    QFETCH(QString, lesson);
    QFETCH(QString, step);
    QFETCH(QString, method);
    const auto begin = [&](MonitoredRun &fixture) {
        fixture.session.editor().setMethod(method);
        fixture.session.editor().setParameter("k", method == "midpoint" ? 1.0 : 0.4);
        fixture.monitor.setDetailed(true);
        return fixture.settled().remedies;
    };
    MonitoredRun asked(qPrintable(lesson), qPrintable(step));
    const std::vector<sim::Remedy> remedies = begin(asked);
    QVERIFY(!asked.settled().stability.holds());
    QVERIFY(remedies.size() >= 3);
    for (const sim::Remedy &one : remedies) {
        MonitoredRun fixture(qPrintable(lesson), qPrintable(step));
        begin(fixture);
        fixture.monitor.adopt(one);
        const sim::Stability &found = fixture.settled().stability;
        if (one.kind == sim::Remedy::Kind::unlimitedMethod) {
            QVERIFY(found.bound == sim::Bound::none || found.bound == sim::Bound::tolerance);
            continue;
        }
        QVERIFY2(found.holds(), qPrintable(remedyTitle(one)));
        QVERIFY(std::abs(found.share() - one.share) < 1e-3);
    }
}

void StabilityMonitorTest::wordsSayWhatBoundsTheStep_data()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("damp");
    QTest::addColumn<QString>("gauge");
    QTest::addColumn<QStringList>("verdict");
    const auto row = [](const char *name, const char *method, double k, double damp, const char *gauge,
                        const QStringList &verdict) {
        QTest::addRow("%s", name) << "two_body"
                                  << "mutual" << method << k << damp << gauge << verdict;
    };
    row("near", "published", 0.2, 0.9, "89\u2009% of the limit",
        {"Steps up to 1.1 frames are stable", "The spring foot – body sets the limit", "drifts off"});
    row("past", "published", 0.3, 0.9, "137\u2009% of the limit",
        {"Small disturbances grow by 3.9 % a frame", "Steps up to 0.73 frames are stable"});
    row("far", "semi_implicit_euler", 0.2, 0.9, "29\u2009% of the limit",
        {"Steps up to 3.5 frames are stable", "swings to the other side at each step"});
    row("just past", "semi_implicit_euler", 2.003, 1.0, "100.1\u2009% of the limit",
        {"Small disturbances grow by", "Steps up to 0.999 frames are stable"});
    row("just below", "semi_implicit_euler", 1.995, 1.0, "99.9\u2009% of the limit",
        {"Steps up to 1.001 frames are stable here"});
    row("at every step", "explicit_euler", 0.2, 1.0, "no stable step",
        {"No step is stable", "They also grow with any shorter step"});
    row("far past", "published", 50.0, 0.9, "237 × the limit", {"times a frame"});
    row("stable by damping", "semi_implicit_euler", 0.2, 0.2, "stable by damping", {"Every step is stable"});
    row("without a limit", "backward_euler", 0.2, 0.9, "no limit", {"Backward Euler has no such limit"});
    row("with a tolerance", "dormand_prince", 0.2, 0.9, "by its tolerance", {"keeps its own steps", "px"});
    row("without springs", "published", 0.0, 0.9, "no springs act", {"The other effects have no stiffness"});
    QTest::addRow("to a place") << "single_spring"
                                << "fixed_centre"
                                << "semi_implicit_euler" << 0.2 << 0.9 << "19\u2009% of the limit"
                                << QStringList{"The spring of foot sets the limit"};
}

void StabilityMonitorTest::remedyDescribesItsOutcome()
{
    const sim::MethodPtr euler = sim::findMethod("semi_implicit_euler");
    const auto outcome = [&](sim::Remedy::Kind kind, double share) {
        return remedyOutcome(sim::Remedy::of(kind, euler, sim::StepSize::ofLength(1.0), share));
    };
    QCOMPARE(outcome(sim::Remedy::Kind::moreDamping, 0.88), QString("then at 88\u2009% of the limit"));
    QCOMPARE(outcome(sim::Remedy::Kind::moreDamping, 0.0),
             QString("every step is then stable, because of the damping"));
    QCOMPARE(outcome(sim::Remedy::Kind::unlimitedMethod, 0.0), QString("has no such limit"));
}

void StabilityMonitorTest::wordsSayWhatBoundsTheStep()
{
    QFETCH(QString, lesson);
    QFETCH(QString, step);
    QFETCH(QString, method);
    QFETCH(double, k);
    QFETCH(double, damp);
    QFETCH(QString, gauge);
    QFETCH(QStringList, verdict);
    MonitoredRun fixture(qPrintable(lesson), qPrintable(step));
    fixture.session.editor().setMethod(method);
    fixture.session.editor().setParameter("k", k);
    fixture.session.editor().setParameter("damp", damp);
    QCOMPARE(gaugeWords(fixture.settled()), gauge);
    const QString said = fixture.plainVerdict(); // rich text turns thin spaces into spaces
    for (const QString &part : verdict)
        QVERIFY2(said.contains(part), qPrintable(said));
}

void StabilityMonitorTest::verdictExplainsStableStepsThatAreLongerThanUnstableOnes()
{
    StabilityReading reading;
    reading.method = sim::findMethod("explicit_euler");
    reading.stability.bound = sim::Bound::stiffness;
    reading.stability.stiffness = 0.2;
    reading.stability.growth = 1.0;
    reading.stability.h = 1e-6;
    QVERIFY(stabilityVerdict(reading).contains("too slow to notice"));
    reading.stability.h = 100.0;
    QVERIFY(stabilityVerdict(reading).contains("This one is, because of the damping"));
    reading.stability.limit = 2.5;
    QVERIFY(stabilityVerdict(reading).contains("but still stable"));
    QVERIFY(growthWords(INFINITY).contains("more than a million"));
}

void StabilityMonitorTest::theLimitOfARuleWithVelocitiesIsUnknown()
{
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    for (const char *name : {"flock", "whirlpool"}) {
        const Experiment example =
            readExperiment(QStringLiteral(":/examples/sandbox/%1.json").arg(name), library);
        sim::Track track(example.script, std::size_t{1} << 20);
        track.seek({10, 0});
        const StabilityReading reading = readStability(example.script, track.intervalPtr(), track.state());
        QCOMPARE(reading.stability.bound, sim::Bound::velocity);
        QCOMPARE(gaugeWords(reading), QString("unknown here"));
        QVERIFY(nearnessOf(reading.stability) == Nearness::none);
        QVERIFY(stabilityVerdict(reading).contains("depends on velocities"));
        QVERIFY(!stabilityVerdict(reading).contains("No step is stable"));
    }
}

void StabilityMonitorTest::jumpsAreNamed()
{
    MonitoredRun walls("gravity_walls", "gravity");
    QVERIFY2(leftOutWords(walls.settled()).contains("walls"), qPrintable(leftOutWords(walls.settled())));
    QVERIFY(!leftOutWords(walls.settled()).contains("smaller steps"));
    MonitoredRun sticks("rigid_constraint", "list");
    QCOMPARE(sticks.settled().stability.bound, sim::Bound::noSprings);
    QVERIFY(leftOutWords(sticks.settled()).contains("sticks"));
    QVERIFY(leftOutWords(sticks.settled()).contains("smaller steps"));
    MonitoredRun free;
    QVERIFY(leftOutWords(free.settled()).isEmpty());
}

void StabilityMonitorTest::mapShowsGrowthWhereThePairDrifts_data()
{
    QTest::addColumn<MapPlane>("plane");
    QTest::addRow("step") << MapPlane::step;
    QTest::addRow("damping") << MapPlane::damping;
}

void StabilityMonitorTest::mapShowsGrowthWhereThePairDrifts()
{
    QFETCH(MapPlane, plane);
    MonitoredRun fixture;
    QVERIFY(fixture.monitor.canMap(plane));
    fixture.monitor.requestMap(plane);
    const sim::GrowthMap map = fixture.mapped();
    int holding = 0, drifting = 0;
    for (std::size_t row = 0; row < map.y.values.size(); row += 8) {
        for (std::size_t column = 0; column < map.x.values.size(); column += 8) {
            const double k = map.x.values[column], up = map.y.values[row];
            const bool isStep = plane == MapPlane::step;
            const double h = isStep ? up : 1.0, damp = isStep ? 0.9 : up;
            // The closed form is for the drift of the pair. The other mode of the pair may grow as well.
            const bool drifts = k * h * h > 2.0 * (std::pow(damp, -h) - 1.0);
            QVERIFY2(!drifts || map.at(column, row) > 1.0, qPrintable(QString("k %1, up %2").arg(k).arg(up)));
            drifting += drifts;
            holding += map.at(column, row) <= 1.0;
        }
    }
    QVERIFY(holding > 5 && drifting > 5);
}

void StabilityMonitorTest::theMapEndsWhenItIsNoLongerRequested()
{
    MonitoredRun fixture;
    fixture.monitor.requestMap(MapPlane::step);
    fixture.mapped();
    fixture.monitor.requestMap(std::nullopt);
    QVERIFY(!fixture.monitor.map());
    fixture.session.editor().setParameter("damp", 0.5);
    fixture.settled();
    QVERIFY(!fixture.monitor.isMapping()); // none is due either
    QVERIFY(!fixture.monitor.map());
}

void StabilityMonitorTest::thereIsNoMapWithoutStiffnessOrLimit()
{
    MonitoredRun fixture;
    QVERIFY(fixture.monitor.canMap(MapPlane::step));
    fixture.session.editor().setMethod("backward_euler");
    QVERIFY(!fixture.monitor.canMap(MapPlane::step));
    MonitoredRun sticks("rigid_constraint", "list");
    QVERIFY(!sticks.monitor.canMap(MapPlane::step));
    sticks.monitor.requestMap(MapPlane::step);
    QVERIFY(!sticks.monitor.isMapping());
}

void StabilityMonitorTest::earlierSettingsStayOnTheMap()
{
    MonitoredRun fixture;
    fixture.session.editor().setParameter("k", 0.3);
    fixture.session.editor().setParameter("damp", 0.8);
    fixture.session.editor().setStepSize(0.5);
    const std::vector<TriedSpot> expected = {
        {0.2, 0.9, 1.0}, {0.3, 0.9, 1.0}, {0.3, 0.8, 1.0}, {0.3, 0.8, 0.5}};
    QVERIFY(fixture.monitor.tried() == expected);
    fixture.session.openStep("multi_foot", "two_feet");
    QCOMPARE(fixture.monitor.tried().size(), std::size_t(1));
}

void StabilityMonitorTest::everyStepOfEveryLessonHasAReading()
{
    MonitoredRun fixture;
    for (const LessonEntry &lesson : fixture.library.lessons) {
        for (const lessons::Step &step : lesson.steps) {
            fixture.session.openStep(lesson.id, step.id);
            const StabilityReading &reading = fixture.settled();
            const QString name = lesson.id + '/' + step.id;
            QVERIFY2(reading.stability.bound != sim::Bound::unknown, qPrintable(name));
            QVERIFY2(!gaugeWords(reading).isEmpty() && !stabilityVerdict(reading).isEmpty(),
                     qPrintable(name));
        }
    }
}

SUITE(tst_stability_monitor, StabilityMonitorTest)
#include "tst_stability_monitor.moc"
