#pragma once

#include "app/model/session/session.h"
#include "lessons/api/view/creature_view.h"
#include "tests/app/model/effects_support.h"

#include <QSettings>
#include <QTemporaryDir>

/// Shared by the suites of branches: a lesson whose runs are known in closed form.
namespace branches_support {

/// A foot that falls freely, beside a body that stands still. Semi-implicit Euler at a frame a step: after n frames from
/// rest it fell g n (n + 1) / 2.
inline lessons::Step fallStep()
{
    lessons::Step step;
    step.id = "fall";
    step.title = "A fall";
    step.method = "semi_implicit_euler";
    step.parameters = {lessons::gravity(), lessons::stiffness()};
    step.scene = [](const sim::Values &values) {
        sim::Scene scene = scenes::pairOnHandle();
        scenes::add<sim::Gravity>(scene, values["gravity"]);
        return scene;
    };
    step.view = [](const sim::Scene &scene, const sim::Values &) { return lessons::creatureView(scene); };
    return step;
}

inline app::LessonLibrary library()
{
    app::LessonLibrary made;
    made.lessons.push_back({"fall", 1, "A fall", "The first.", {fallStep()}});
    made.lessons.push_back(
        {"legs", 2, "Legs", "The second.", {effects_support::tiedStep(), effects_support::puppetStep()}});
    return made;
}

struct World
{
    explicit World(const QString &step = "fall") { session.openStep(step == "fall" ? "fall" : "legs", step); }

    /// Plays on to frame `end`, goes back to `at`, and gives a parameter another value.
    void fork(std::int64_t end, std::int64_t at, const QString &parameter, double value)
    {
        session.playback().goTo({end, 0});
        session.playback().goTo({at, 0});
        session.editor().setParameter(parameter, value);
        session.editor().endGesture();
    }
    QStringList names() const
    {
        QStringList all;
        for (const app::Branch &branch : session.comparisons().branches().all())
            all << branch.name;
        return all;
    }
    int newest() const { return session.comparisons().branches().all().back().id; }
    /// Returns the state of the current run at a frame, computed from its script alone.
    sim::State straight(std::int64_t frame) const
    {
        sim::Track track(session.timeline().script(), 0);
        track.seek({frame, 0});
        return track.state();
    }
    sim::State at(std::int64_t frame)
    {
        session.playback().goTo({frame, 0});
        return session.timeline().state();
    }

    app::LessonLibrary lessons = library();
    app::Session session{lessons};
};

}
