#pragma once

#include "sim/run/script/script.h"

#include <optional>
#include <string>
#include <vector>

namespace support {

/// A movie clip of the tutorials.
struct Clip
{
    double x = 0.0, y = 0.0;   ///< px
    double vx = 0.0, vy = 0.0; ///< px/frame
    double width = 10.0;       ///< px
};

/// The dragging of both tutorials, by the rule of experiment files. A dragged clip stays where the pointer is.
class DraggedClips
{
public:
    std::vector<sim::Event> input; ///< grab, move and release, by frame

protected:
    DraggedClips() = default;
    DraggedClips(const DraggedClips &) = default;
    DraggedClips &operator=(const DraggedClips &) = default;
    virtual ~DraggedClips() = default;

    /// Returns the clip of a body: "body", "foot", "foot2".
    virtual Clip *findClip(const std::string &name) = 0;
    /// Begins a frame: takes its input.
    void takeInput();
    /// Moves the held clip to the pointer. If the clip keeps a velocity, it is this displacement.
    void moveHeld(bool keepsVelocity);
    const Clip *held() const { return m_held; }

private:
    void handle(const sim::Event &event);

    int m_frame = 0;
    Clip *m_held = nullptr;
    double m_dragX = 0.0, m_dragY = 0.0;
};

/// Creatures I, transcribed from the printed code without any code of sim. It moves the feet in order, then
/// the body, and serves as the reference for the lessons. Two things differ from print: bodies are dragged by
/// the rule of experiment files, and `left` is the x of the left wall.
class Tutorial : public DraggedClips
{
public:
    enum class Kind {
        fixedCentre, ///< step 4
        movingBody,  ///< step 5; the body is a handle, as in the next two
        offset,      ///< step 6
        radial,      ///< step 7
        mutual,      ///< steps 9 to 19, with any number of feet
    };

    Kind kind = Kind::mutual;
    double k = 0.2, damp = 0.9, radius = 50.0, offset = 50.0, centreX = 270.0, centreY = 200.0;
    double gravity = 0.0, left = 20.0, right = 520.0, floor = 380.0, bounce = 1.0;
    bool hasWalls = false;
    std::vector<Clip> feet;
    Clip body;

    /// Computes one frame.
    void enterFrame();
    /// Returns the feet, then the body if there is one.
    std::vector<Clip> clips() const;

private:
    Clip *findClip(const std::string &name) override;
    void footSpring(Clip &foot);
    void bodySpring();
    void springTo(Clip &clip, double targetX, double targetY) const;
    void springAround(Clip &clip, const Clip &other) const;
    void dampAndMove(Clip &clip) const;
};

}
