// Looking at another moment of a run: what is shown there, and that nothing of the run changes by it.

#include "app/model/session.h"

#include <QSignalSpy>
#include <QtTest>

#include <functional>

using namespace app;

namespace {

constexpr std::int64_t computed = 60, stands = 40;

const LessonLibrary &library()
{
    static const LessonLibrary loaded = LessonLibrary::load({LESSON_DIR});
    return loaded;
}

/// A run of 60 frames in which a body was carried, left at frame 40.
struct Run
{
    Run(const QString &lesson, const QString &step)
    {
        session.openStep(lesson, step);
        session.goTo({10, 0});
        const QString body = session.selected();
        const Picture picture = session.picture();
        const sim::Vec2 at = picture.state.positionOf(picture.interval->scene.find(body.toStdString()));
        session.grab(body);
        session.moveHand(at + sim::Vec2{12.0, -7.0});
        session.frameForward();
        session.letGo();
        goTo(computed);
        goTo(stands);
    }
    void goTo(std::int64_t frame)
    {
        session.goTo({frame, 0});
        QVERIFY(QTest::qWaitFor([&] { return !session.goingTo(); }));
    }
    /// The state there, computed from the script alone.
    sim::State straight(sim::Cursor at) const
    {
        sim::Track track(session.timeline().script(), 0);
        track.seek(at);
        return track.state();
    }

    Session session{library()};
};

/// All that a glance must leave alone.
struct Stand
{
    explicit Stand(const Session &session)
        : script(session.timeline().script()), at(session.timeline().cursor()),
          now(session.timeline().state()), computed(session.timeline().computed()),
          kept(session.timeline().keyframeBytes()), deeds(session.deeds().count()),
          index(session.deeds().index()), branches(session.branches())
    {
    }
    bool isLike(const Stand &other) const
    {
        return script.input == other.script.input && script.values == other.script.values && at == other.at &&
               sim::sameBits(now, other.now) && computed == other.computed && kept == other.kept &&
               deeds == other.deeds && index == other.index &&
               branches.all().size() == other.branches.all().size();
    }

    sim::Script script;
    sim::Cursor at;
    sim::State now;
    std::int64_t computed;
    std::size_t kept;
    int deeds, index;
    Branches branches;
};

}

class TestGlance : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName("springstep-test");
        QCoreApplication::setApplicationName("glance");
        QVERIFY(!library().lessons.empty());
    }

    void aGlanceShowsTheBitsOfItsMomentAndLeavesTheRunAlone_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("step");
        for (const LessonEntry &lesson : library().lessons) {
            for (const std::size_t i : {std::size_t{0}, lesson.steps.size() - 1}) {
                const QString step = lesson.steps[i].id;
                QTest::addRow("%s/%s", qPrintable(lesson.id), qPrintable(step)) << lesson.id << step;
            }
        }
    }
    void aGlanceShowsTheBitsOfItsMomentAndLeavesTheRunAlone()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        Run run(lesson, step);
        const Stand before(run.session);
        QSignalSpy moved(&run.session, &Session::moved), changed(&run.session, &Session::runChanged);
        int shown = 0;
        for (const sim::Cursor at : {sim::Cursor{0, 0}, {11, 0}, {59, 0}, {60, 0}, {40, 1}, {12, 2}}) {
            run.session.glance(at);
            QCOMPARE(run.session.marked(), at);
            if (!run.session.isGlancing())
                continue; // too much to compute again in one go
            ++shown;
            QVERIFY(sim::sameBits(run.session.shown().state(), run.straight(at)));
            QVERIFY(Stand(run.session).isLike(before));
        }
        QVERIFY(shown > 0);
        run.session.endGlance();
        QVERIFY(!run.session.marked() && !run.session.isGlancing());
        QCOMPARE(&run.session.shown(), &run.session.timeline());
        QVERIFY(Stand(run.session).isLike(before) && run.session.branches() == before.branches);
        QCOMPARE(moved.size() + changed.size(), 0);
        run.goTo(80);
        QVERIFY(sim::sameBits(run.session.timeline().state(), run.straight(run.session.timeline().cursor())));
    }

    void whateverIsDoneIsDoneWhereTheRunStands_data()
    {
        QTest::addColumn<std::function<void(Session &)>>("deed");
        const auto row = [](const char *name, std::function<void(Session &)> deed) {
            QTest::newRow(name) << std::move(deed);
        };
        row("a step on", [](Session &s) { s.frameForward(); });
        row("a step back", [](Session &s) { s.frameBack(); });
        row("a phase", [](Session &s) { s.phaseForward(); });
        row("a phase back", [](Session &s) { s.phaseBack(); });
        row("a jump", [](Session &s) { s.goTo({20, 0}); });
        row("a parameter", [](Session &s) { s.setParameter("damp", 0.7); });
        row("a hand", [](Session &s) {
            s.grab("foot0");
            s.moveHand({100.0, 100.0});
            s.letGo();
        });
        row("a step size", [](Session &s) { s.setStepSize(0.5); });
        row("undo", [](Session &s) { s.undo(); });
        row("start afresh", [](Session &s) { s.startAfresh(); });
    }
    void whateverIsDoneIsDoneWhereTheRunStands()
    {
        QFETCH(std::function<void(Session &)>, deed);
        Run plain("multi_foot", "two_feet"), looked("multi_foot", "two_feet");
        looked.session.glance({7, 0});
        QVERIFY(looked.session.isGlancing());
        deed(plain.session);
        deed(looked.session);
        QVERIFY(!looked.session.isGlancing());
        QVERIFY(Stand(looked.session).isLike(Stand(plain.session)));
    }

    void whatIsDoneIsSaidOfTheRunAndNotOfTheLook()
    {
        Run run("multi_foot", "two_feet");
        run.session.glance({7, 0});
        bool wasThere = false;
        connect(&run.session, &Session::moved, this, [&] {
            wasThere = !run.session.isGlancing() && run.session.picture().state.frame == stands + 1;
        });
        run.session.frameForward();
        QVERIFY(wasThere);
    }

    void anotherStepHasNothingMarked()
    {
        Run run("multi_foot", "two_feet");
        run.session.glance({7, 0});
        run.session.openStep("single_spring", "drag");
        QVERIFY(!run.session.marked());
        QCOMPARE(&run.session.shown(), &run.session.timeline());
    }

    void whileTheRunPlaysAMomentIsOnlyMarked()
    {
        Run run("multi_foot", "two_feet");
        run.session.play();
        run.session.glance({7, 0});
        QCOMPARE(run.session.marked(), (sim::Cursor{7, 0}));
        QVERIFY(!run.session.isGlancing());
        QSignalSpy moved(&run.session, &Session::moved);
        QVERIFY(moved.wait());
        QCOMPARE(run.session.marked(), (sim::Cursor{7, 0})); // as long as the mouse is there
    }

    void aMomentThatTakesLongIsOnlyMarked()
    {
        Run run("multi_foot", "two_feet");
        run.goTo(0);
        run.session.setStepSize(1e-6);
        run.session.glance({0, 1}); // in a row of a million steps
        QVERIFY(run.session.marked());
        QVERIFY(!run.session.isGlancing());
    }

    void theMomentWhereTheRunStandsNeedsNoLook()
    {
        Run run("multi_foot", "two_feet");
        run.session.glance({7, 0});
        run.session.glance({stands, 0});
        QVERIFY(run.session.marked() && !run.session.isGlancing());
        QCOMPARE(&run.session.shown(), &run.session.timeline());
    }

    void theSameMomentAgainChangesNothing()
    {
        Run run("multi_foot", "two_feet");
        QSignalSpy changes(&run.session, &Session::glanceChanged);
        for (int i = 0; i < 5; ++i)
            run.session.glance({7, 0});
        QCOMPARE(changes.size(), 1);
        for (int i = 0; i < 5; ++i)
            run.session.mark({7, 0});
        QCOMPARE(changes.size(), 2);
        for (int i = 0; i < 5; ++i)
            run.session.endGlance();
        QCOMPARE(changes.size(), 3);
    }

    void afterTheLastFrameTheLastIsShown()
    {
        Run run("multi_foot", "two_feet");
        run.session.glance({5000, 0});
        QCOMPARE(run.session.marked(), (sim::Cursor{computed, 0}));
        QCOMPARE(run.session.timeline().computed(), computed);
        run.session.glance({-3, 0});
        QCOMPARE(run.session.shown().cursor(), (sim::Cursor{0, 0}));
    }

    void theOldRunIsShownAtTheSameMoment()
    {
        Run run("multi_foot", "two_feet");
        run.goTo(20);
        run.session.setParameter("k", 0.4);
        run.goTo(50);
        QVERIFY(run.session.ghost());
        run.session.glance({30, 0});
        QCOMPARE(run.session.ghost()->state.frame, 30);
        sim::Track old(*run.session.beside()->script, 0);
        old.seek({30, 0});
        QVERIFY(sim::sameBits(run.session.ghost()->state, old.state()));
        run.session.endGlance();
        QCOMPARE(run.session.ghost()->state.frame, 50);
    }
};

QTEST_MAIN(TestGlance)
#include "tst_glance.moc"
