#pragma once

#include "lessons/api/step.h"
#include "tests/lessons/support/tutorial.h"

#include <QMetaType>

#include <random>
#include <string>
#include <vector>

namespace support {

/// Creatures II, transcribed from the printed code without any code of sim. It moves the feet in order, then
/// the body, and advances the gait angle last. Two things differ from print: bodies are dragged by the rule
/// of experiment files, and the additions of the lesson are there (`bounce`, ice, any number of feet).
class WalkingTutorial : public DraggedClips
{
public:
    /// The tutorial steps whose code runs.
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

    /// Computes one frame.
    void enterFrame();
    /// Returns the feet, then the body.
    std::vector<Clip> clips() const;

private:
    Clip *findClip(const std::string &name) override;
    void moveFoot(Foot &foot);
    void moveBody();
    bool isHeld(const Clip &clip) const { return &clip == held(); }

    double m_bodyAngle = 0.0;
};

/// Returns a walking tutorial with random parameters, `feet` feet and a body. They start with random
/// positions and velocities. Its input drags and throws random ones of them.
WalkingTutorial randomWalk(WalkingTutorial::Kind kind, int feet, std::mt19937 &random);

/// Returns the largest difference in any position or velocity between step and tutorial, over `frames`
/// frames.
double largestDifference(const lessons::Step &step, const WalkingTutorial &tutorial, int frames);

/// An experiment that both a lesson step and the WalkingTutorial compute.
struct Walk
{
    const char *step = nullptr;
    WalkingTutorial tutorial;
};

}

Q_DECLARE_METATYPE(support::Walk)
