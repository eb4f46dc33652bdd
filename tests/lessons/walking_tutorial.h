#pragma once

#include "lessons/api/step.h"
#include "tests/lessons/tutorial.h"

#include <QMetaType>

#include <random>
#include <string>
#include <vector>

namespace support {

/// Creatures II, written down a second time straight from the printed code, with nothing of sim in it: feet in
/// order, then the body, whose angle goes on last. Changed from print only in how a hand holds (the rule of the
/// experiment file), and in what the lesson adds: `bounce`, ice, any number of feet.
class WalkingTutorial
{
public:
    /// Which step's code.
    enum class Kind {
        bones,      ///< steps 1 to 5; the body is a handle, as in the next two
        below,      ///< steps 6 and 7
        swing,      ///< steps 8 and 9
        bodyPulled, ///< step 10
        ground,     ///< step 11
    };
    struct Foot : Clip
    {
        double angle = 0.0; ///< rad
    };

    Kind kind = Kind::ground;
    double k = 0.1, damp = 0.9, leg = 50.0, drop = 50.0, speed = 0.05, grav = 0.5, ground = 400.0,
           bounce = 0.0;
    bool ice = false;
    std::vector<Foot> feet;
    Clip body;
    std::vector<sim::Event> input; ///< grab, move and release, by frame

    /// Computes one frame.
    void enterFrame();
    /// The feet, then the body.
    std::vector<Clip> clips() const;

private:
    void handle(const sim::Event &event);
    Clip *clipCalled(const std::string &name);
    void drag();
    void footMove(Foot &foot);
    void bodyMove();
    bool held(const Clip &clip) const { return &clip == m_held; }

    int m_frame = 0;
    double m_bodyAngle = 0.0;
    Clip *m_held = nullptr;
    double m_handX = 0.0, m_handY = 0.0;
};

/// A walking tutorial with random numbers, `feet` feet and the body at random places with random velocities, and a
/// hand that drags and throws one after the other.
WalkingTutorial randomWalk(WalkingTutorial::Kind kind, int feet, std::mt19937 &random);

/// The largest difference of a position or a velocity between the step and the tutorial, over `frames` frames.
double largestDifference(const lessons::Step &step, const WalkingTutorial &tutorial, int frames);

/// An experiment for both a step and the WalkingTutorial.
struct Walk
{
    const char *step = nullptr;
    WalkingTutorial tutorial;
};

}

Q_DECLARE_METATYPE(support::Walk)
