#pragma once

#include "app/model/session/session.h"
#include "app/ui/actions/command_list.h"
#include "app/ui/actions/run_commands.h"
#include "app/ui/time/frame_counter.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"

#include <QApplication>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>
#include <QWidget>

/// A window with nothing but the transport bar and the timeline, on a session with one lesson of two steps: a foot
/// and a body on a spring, in `grouped` moved one after the other, `at_once` together.
struct TimeFixture
{
    app::Session session;
    app::Theme theme{app::Scheme::light};
    QWidget
        elsewhere; ///< has the keys of all commands, so that only those of bar and strip work in the window
    app::CommandList commands{elsewhere};
    app::RunCommands run{session, commands};
    QWidget window;
    app::TransportBar *bar;
    app::TimelineStrip *strip;

    explicit TimeFixture(const QString &step = "at_once", int width = 600);

    sim::Cursor at() const { return session.timeline().cursor(); }
    /// Waits until the session is where it was told to go.
    bool arrive() const;
    void goTo(std::int64_t frame, int phase = 0);
    QToolButton *button(const QString &name) const { return bar->findChild<QToolButton *>(name); }
    app::FrameCounter *counter() const { return bar->findChild<app::FrameCounter *>(); }
    QLineEdit *editor() const { return bar->findChild<QLineEdit *>("goToFrame"); }
    QPoint onTrack(std::int64_t frame) const { return {qRound(strip->axis().xOf(frame)), 25}; }
    /// Returns whether the state has the bits of a straight run to the cursor.
    bool isStraightRun() const;
};
