#pragma once

#include "app/model/session/session.h"
#include "tests/app/code/listing_support.h"

#include <QFile>
#include <QStandardPaths>

#include <functional>

/// Shared by the suites of breakpoints.
namespace breakpoints_support {

using namespace listing_support;

/// The command that makes the session continue until it stops.
enum class Way { play, frames, runTo };

using Question = std::function<bool(const sim::Timeline &)>;

/// The line of `file` that has `part`.
inline CodePlace placeOf(const QString &file, const QString &part)
{
    QFile source(QStringLiteral(SOURCE_DIR "/") + file);
    if (!source.open(QIODevice::ReadOnly))
        return {};
    const QStringList lines = QString::fromUtf8(source.readAll()).split('\n');
    for (int i = 0; i < lines.size(); ++i) {
        if (lines[i].contains(part))
            return {file, i + 1};
    }
    return {};
}

inline const sim::Phase &nextPhase(const sim::Timeline &run)
{
    return run.track().nextInterval()->pipeline.phaseAt(run.cursor().phase);
}

/// The moments before `frames` at which a run of `script` is to stop, found by stepping from phase to phase. With
/// `edge`: only where `question` did not hold the phase before.
inline std::vector<sim::Cursor> search(const sim::Script &script, std::int64_t frames,
                                       const Question &question, bool edge)
{
    sim::Timeline run(script);
    std::vector<sim::Cursor> found;
    bool held = question(run);
    while (run.cursor().frame < frames) {
        run.nextPhase();
        const bool holds = question(run);
        if (holds && !(edge && held) && run.cursor().frame < frames)
            found.push_back(run.cursor());
        held = holds;
    }
    return found;
}

struct Fixture
{
    explicit Fixture(const QString &lesson = "gravity_walls", const QString &step = "gravity")
    {
        session.openStep(lesson, step);
        session.playback().setSpeed(4.0);
    }
    sim::Cursor at() const { return session.timeline().cursor(); }
    /// Goes on to the next stop, or some way beyond `frame`.
    void goOn(Way way, std::int64_t frame)
    {
        if (way == Way::play) {
            session.playback().play();
            QVERIFY(QTest::qWaitFor([&] { return !session.playback().isPlaying() || at().frame > frame; },
                                    20000));
            session.playback().pause();
        } else if (way == Way::runTo) {
            session.playback().runTo({frame + 1, 0});
            QVERIFY(QTest::qWaitFor([&] { return !session.playback().goal(); }, 20000));
        } else {
            do
                session.playback().frameForward();
            while (!session.playback().breakHit() && at().frame <= frame);
        }
    }
    /// Returns all stops up to `frame`. Each must have the bits of a straight run.
    std::vector<sim::Cursor> stops(Way way, std::int64_t frame)
    {
        std::vector<sim::Cursor> all;
        for (;;) {
            goOn(way, frame);
            if (!session.playback().breakHit() || at().frame > frame)
                return all;
            sim::Timeline straight(session.timeline().script());
            straight.seek(at());
            if (session.playback().breakHit()->at != at() ||
                !sim::sameBits(straight.state(), session.timeline().state()))
                return {};
            all.push_back(at());
        }
    }

    Session session{library()};
};

inline void everyWay()
{
    QTest::addColumn<Way>("way");
    QTest::newRow("playing") << Way::play;
    QTest::newRow("frame by frame") << Way::frames;
    QTest::newRow("running to a frame") << Way::runTo;
}

}

Q_DECLARE_METATYPE(breakpoints_support::Way)
