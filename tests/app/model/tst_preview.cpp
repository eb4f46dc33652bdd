// A preview shows another moment of a run and changes nothing of the run.

#include "app/model/session/session.h"
#include "tests/suite.h"

#include <QSignalSpy>
#include <QtTest>

#include <functional>

using namespace app;

namespace {

constexpr std::int64_t lastFrame = 60, leftAtFrame = 40;

const LessonLibrary &installedLessons()
{
    static const LessonLibrary loaded = LessonLibrary::load({LESSON_DIR});
    return loaded;
}

/// A run of 60 frames in which a body was carried, left at frame 40.
struct DraggedRun
{
    DraggedRun(const QString &lesson, const QString &step)
    {
        session.openStep(lesson, step);
        session.playback().goTo({10, 0});
        const QString body = session.selected();
        const Picture picture = session.presentation().picture();
        const sim::Vec2 at = picture.state.positionOf(picture.interval->scene.find(body.toStdString()));
        session.input().grab(body);
        session.input().moveTo(at + sim::Vec2{12.0, -7.0});
        session.playback().frameForward();
        session.input().release();
        goTo(lastFrame);
        goTo(leftAtFrame);
    }
    void goTo(std::int64_t frame)
    {
        session.playback().goTo({frame, 0});
        QVERIFY(QTest::qWaitFor([&] { return !session.playback().goal(); }));
    }
    /// Returns the state at a cursor, computed from the script alone.
    sim::State straight(sim::Cursor at) const
    {
        sim::Track track(session.timeline().script(), 0);
        track.seek(at);
        return track.state();
    }

    Session session{installedLessons()};
};

/// Everything that a preview must not change.
struct SessionSnapshot
{
    explicit SessionSnapshot(const Session &session)
        : script(session.timeline().script()), at(session.timeline().cursor()),
          now(session.timeline().state()), computed(session.timeline().computed()),
          keyframeBytes(session.timeline().keyframeBytes()), edits(session.editor().undoStack().count()),
          index(session.editor().undoStack().index()), branches(session.comparisons().branches())
    {
    }
    bool isLike(const SessionSnapshot &other) const
    {
        return script.input == other.script.input && script.values == other.script.values && at == other.at &&
               sim::sameBits(now, other.now) && computed == other.computed &&
               keyframeBytes == other.keyframeBytes && edits == other.edits && index == other.index &&
               branches.all().size() == other.branches.all().size();
    }

    sim::Script script;
    sim::Cursor at;
    sim::State now;
    std::int64_t computed;
    std::size_t keyframeBytes;
    int edits, index;
    Branches branches;
};

}

class TestPreview : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(!installedLessons().lessons.empty()); }

    void aPreviewShowsTheBitsOfItsMomentAndLeavesTheRunAlone_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("step");
        for (const LessonEntry &lesson : installedLessons().lessons) {
            for (const std::size_t i : {std::size_t{0}, lesson.steps.size() - 1}) {
                const QString step = lesson.steps[i].id;
                QTest::addRow("%s/%s", qPrintable(lesson.id), qPrintable(step)) << lesson.id << step;
            }
        }
    }
    void aPreviewShowsTheBitsOfItsMomentAndLeavesTheRunAlone()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        DraggedRun run(lesson, step);
        const SessionSnapshot before(run.session);
        int changes = 0;
        run.session.onChange(ChangeKind::cursor | ChangeKind::run, this, [&] { ++changes; });
        int shown = 0;
        for (const sim::Cursor at : {sim::Cursor{0, 0}, {11, 0}, {59, 0}, {60, 0}, {40, 1}, {12, 2}}) {
            run.session.preview().show(at);
            QCOMPARE(run.session.preview().marked(), at);
            if (!run.session.preview().isActive())
                continue; // too much to compute again in one go
            ++shown;
            QVERIFY(sim::sameBits(run.session.preview().run().state(), run.straight(at)));
            QVERIFY(SessionSnapshot(run.session).isLike(before));
        }
        QVERIFY(shown > 0);
        run.session.preview().end();
        QVERIFY(!run.session.preview().marked() && !run.session.preview().isActive());
        QCOMPARE(&run.session.preview().run(), &run.session.timeline());
        QVERIFY(SessionSnapshot(run.session).isLike(before) &&
                run.session.comparisons().branches() == before.branches);
        QCOMPARE(changes, 0);
        run.goTo(80);
        QVERIFY(sim::sameBits(run.session.timeline().state(), run.straight(run.session.timeline().cursor())));
    }

    void editsApplyToTheRunAndNotToThePreview_data()
    {
        QTest::addColumn<std::function<void(Session &)>>("edit");
        const auto row = [](const char *name, std::function<void(Session &)> edit) {
            QTest::newRow(name) << std::move(edit);
        };
        row("a step on", [](Session &s) { s.playback().frameForward(); });
        row("a step back", [](Session &s) { s.playback().frameBack(); });
        row("a phase", [](Session &s) { s.playback().phaseForward(); });
        row("a phase back", [](Session &s) { s.playback().phaseBack(); });
        row("a jump", [](Session &s) { s.playback().goTo({20, 0}); });
        row("a parameter", [](Session &s) { s.editor().setParameter("damp", 0.7); });
        row("a hand", [](Session &s) {
            s.input().grab("foot0");
            s.input().moveTo({100.0, 100.0});
            s.input().release();
        });
        row("a step size", [](Session &s) { s.editor().setStepSize(0.5); });
        row("undo", [](Session &s) { s.editor().undo(); });
        row("start afresh", [](Session &s) { s.editor().startAfresh(); });
    }
    void editsApplyToTheRunAndNotToThePreview()
    {
        QFETCH(std::function<void(Session &)>, edit);
        DraggedRun plain("multi_foot", "two_feet"), previewed("multi_foot", "two_feet");
        previewed.session.preview().show({7, 0});
        QVERIFY(previewed.session.preview().isActive());
        edit(plain.session);
        edit(previewed.session);
        QVERIFY(!previewed.session.preview().isActive());
        QVERIFY(SessionSnapshot(previewed.session).isLike(SessionSnapshot(plain.session)));
    }

    void changesAreReportedForTheRunAndNotForThePreview()
    {
        DraggedRun run("multi_foot", "two_feet");
        run.session.preview().show({7, 0});
        bool wasThere = false;
        run.session.onChange(ChangeKind::cursor, this, [&] {
            wasThere = !run.session.preview().isActive() &&
                       run.session.presentation().picture().state.frame == leftAtFrame + 1;
        });
        run.session.playback().frameForward();
        QVERIFY(wasThere);
    }

    void anotherStepHasNothingMarked()
    {
        DraggedRun run("multi_foot", "two_feet");
        run.session.preview().show({7, 0});
        run.session.openStep("single_spring", "drag");
        QVERIFY(!run.session.preview().marked());
        QCOMPARE(&run.session.preview().run(), &run.session.timeline());
    }

    void whileTheRunPlaysAMomentIsOnlyMarked()
    {
        DraggedRun run("multi_foot", "two_feet");
        run.session.playback().play();
        run.session.preview().show({7, 0});
        QCOMPARE(run.session.preview().marked(), (sim::Cursor{7, 0}));
        QVERIFY(!run.session.preview().isActive());
        QSignalSpy changed(&run.session.changes(), &ChangeNotifier::changed);
        QVERIFY(changed.wait());
        QCOMPARE(run.session.preview().marked(), (sim::Cursor{7, 0})); // as long as the mouse is there
    }

    void aMomentThatTakesLongIsOnlyMarked()
    {
        DraggedRun run("multi_foot", "two_feet");
        run.goTo(0);
        run.session.editor().setStepSize(1e-6);
        run.session.preview().show({0, 1}); // in a row of a million steps
        QVERIFY(run.session.preview().marked());
        QVERIFY(!run.session.preview().isActive());
    }

    void theCurrentMomentNeedsNoPreview()
    {
        DraggedRun run("multi_foot", "two_feet");
        run.session.preview().show({7, 0});
        run.session.preview().show({leftAtFrame, 0});
        QVERIFY(run.session.preview().marked() && !run.session.preview().isActive());
        QCOMPARE(&run.session.preview().run(), &run.session.timeline());
    }

    void theSameMomentAgainChangesNothing()
    {
        DraggedRun run("multi_foot", "two_feet");
        QSignalSpy changes(&run.session.changes(), &ChangeNotifier::changed);
        for (int i = 0; i < 5; ++i)
            run.session.preview().show({7, 0});
        QCOMPARE(changes.size(), 1);
        for (int i = 0; i < 5; ++i)
            run.session.preview().mark({7, 0});
        QCOMPARE(changes.size(), 2);
        for (int i = 0; i < 5; ++i)
            run.session.preview().end();
        QCOMPARE(changes.size(), 3);
    }

    void afterTheLastFrameTheLastIsShown()
    {
        DraggedRun run("multi_foot", "two_feet");
        run.session.preview().show({5000, 0});
        QCOMPARE(run.session.preview().marked(), (sim::Cursor{lastFrame, 0}));
        QCOMPARE(run.session.timeline().computed(), lastFrame);
        run.session.preview().show({-3, 0});
        QCOMPARE(run.session.preview().run().cursor(), (sim::Cursor{0, 0}));
    }

    void theOldRunIsShownAtTheSameMoment()
    {
        DraggedRun run("multi_foot", "two_feet");
        run.goTo(20);
        run.session.editor().setParameter("k", 0.4);
        run.goTo(50);
        QVERIFY(run.session.presentation().comparison());
        run.session.preview().show({30, 0});
        QCOMPARE(run.session.presentation().comparison()->state.frame, 30);
        sim::Track old(*run.session.comparisons().shown()->script, 0);
        old.seek({30, 0});
        QVERIFY(sim::sameBits(run.session.presentation().comparison()->state, old.state()));
        run.session.preview().end();
        QCOMPARE(run.session.presentation().comparison()->state.frame, 50);
    }
};

SUITE(tst_preview, TestPreview)
#include "tst_preview.moc"
