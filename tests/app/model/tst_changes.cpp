// A session announces one change per edit, and the first frame that the edit affects.

#include "app/model/session/session.h"
#include "sim/scene/state.h"
#include "tests/app/support/session_fixture.h"
#include "tests/suite.h"

#include <QtTest>

#include <algorithm>
#include <functional>
#include <vector>

using namespace app;

namespace {

constexpr std::int64_t computedFrames = 40;

using Edit = std::function<void(Session &)>;

class ChangesTest : public QObject
{
    Q_OBJECT

private slots:
    void eachEditIsAnnouncedOnce_data();
    void eachEditIsAnnouncedOnce();
    void statesBeforeTheFirstChangedFrameKeepTheirBits_data() { eachEditIsAnnouncedOnce_data(); }
    void statesBeforeTheFirstChangedFrameKeepTheirBits();
    void messagesFollowTheChangeThatTheyDescribe();
    void listenerGetsOnlyTheKindsOfItsSubscription();
};

/// A run that stands at frame 20 of 40, with an edit at frame 10.
void prepare(Session &session)
{
    session.playback().goTo({10, 0});
    session.editor().setParameter("k", 0.3);
    session.playback().goTo({computedFrames, 0});
    session.playback().goTo({20, 0});
}

void ChangesTest::eachEditIsAnnouncedOnce_data()
{
    QTest::addColumn<Edit>("edit");
    QTest::addColumn<qint64>("firstFrame");
    const auto row = [](const char *name, qint64 firstFrame, Edit edit) {
        QTest::newRow(name) << std::move(edit) << firstFrame;
    };
    row("a parameter", 21, [](Session &s) { s.editor().setParameter("k", 0.5); });
    row("all parameters", 21, [](Session &s) { s.editor().resetParameters(); });
    row("a method", 0, [](Session &s) { s.editor().setMethod("rk4"); });
    row("a step size", 0, [](Session &s) { s.editor().setStepSize(0.5); });
    row("taking hold of a body", 21, [](Session &s) { s.input().grab("foot"); });
    row("undo of an edit in the past", 11, [](Session &s) { s.editor().undo(); });
    row("a frame forward", Change::noFrame, [](Session &s) { s.playback().frameForward(); });
    row("a frame back", Change::noFrame, [](Session &s) { s.playback().frameBack(); });
    row("a phase", Change::noFrame, [](Session &s) { s.playback().phaseForward(); });
    row("a jump", Change::noFrame, [](Session &s) { s.playback().goTo({3, 0}); });
    row("play", Change::noFrame, [](Session &s) { s.playback().play(); });
    row("another body", Change::noFrame, [](Session &s) { s.select("body"); });
    row("a preview", Change::noFrame, [](Session &s) { s.preview().show({5, 0}); });
    row("a restart", 0, [](Session &s) { s.editor().restart(); });
    row("another step", 0, [](Session &s) { s.openStep("one", "second"); });
    row("the step afresh", 0, [](Session &s) { s.editor().startAfresh(); });
}

void ChangesTest::eachEditIsAnnouncedOnce()
{
    QFETCH(Edit, edit);
    QFETCH(qint64, firstFrame);
    tests::SessionFixture fixture;
    Session &session = fixture.session;
    prepare(session);
    std::vector<Change> changes;
    connect(&session.changes(), &ChangeNotifier::changed, this,
            [&](const Change &change) { changes.push_back(change); });
    edit(session);
    QCOMPARE(changes.size(), std::size_t(1));
    QCOMPARE(changes.front().firstFrame, firstFrame);
}

void ChangesTest::statesBeforeTheFirstChangedFrameKeepTheirBits()
{
    QFETCH(Edit, edit);
    tests::SessionFixture fixture;
    Session &session = fixture.session;
    prepare(session);
    const QString step = session.step().id;
    const auto statesOf = [](const sim::Script &script) {
        sim::Track track(script, 0);
        std::vector<sim::State> states;
        for (std::int64_t frame = 0; frame <= computedFrames; ++frame)
            states.push_back(track.stateAt(frame));
        return states;
    };
    const std::vector<sim::State> before = statesOf(session.timeline().script());
    std::int64_t firstFrame = Change::noFrame;
    connect(&session.changes(), &ChangeNotifier::changed, this,
            [&](const Change &change) { firstFrame = std::min(firstFrame, change.firstFrame); });
    edit(session);
    if (session.step().id != step)
        return; // other states altogether
    const std::vector<sim::State> after = statesOf(session.timeline().script());
    for (std::int64_t frame = 0; frame < std::min(firstFrame, computedFrames + 1); ++frame)
        QVERIFY2(
            sim::sameBits(before[static_cast<std::size_t>(frame)], after[static_cast<std::size_t>(frame)]),
            qPrintable(QString::number(frame)));
}

void ChangesTest::messagesFollowTheChangeThatTheyDescribe()
{
    tests::SessionFixture fixture;
    prepare(fixture.session);
    QStringList heard;
    connect(&fixture.session.changes(), &ChangeNotifier::messageRequested, this, [&] { heard << "message"; });
    connect(&fixture.session.changes(), &ChangeNotifier::changed, this, [&] { heard << "change"; });
    fixture.session.editor().undo();
    QVERIFY(heard.size() >= 2);
    QCOMPARE(heard.front(), "change");
    QCOMPARE(heard.count("change"), 1);
}

void ChangesTest::listenerGetsOnlyTheKindsOfItsSubscription()
{
    tests::SessionFixture fixture;
    int selections = 0;
    fixture.session.onChange(ChangeKind::selection, this, [&] { ++selections; });
    fixture.session.editor().setParameter("k", 0.4);
    QCOMPARE(selections, 0);
    fixture.session.select("body");
    QCOMPARE(selections, 1);
}

}

SUITE(tst_changes, ChangesTest)
#include "tst_changes.moc"
