#pragma once

#include "app/model/session/picture.h"
#include "app/model/web/number_columns.h"

#include <vector>

namespace app {

class JsonWriter;

/// All pictures of one run that a web page shows.
class PageFigure
{
public:
    /// Positions are rounded to multiples of 2^-positionBits px, so that the error is below 5e-7 px.
    static constexpr int positionBits = 20;

    /// Scenes with more points have no velocities: the window draws no arrows there, either.
    static constexpr int mostWithVelocities = 600;

    /// Adds the picture of the next frame.
    void add(const Picture &picture);
    /// Adds the velocities of the frame that was added last; `frames` after the one before. All frames have them, or none.
    void addVelocities(const sim::State &state, int frames);
    /// Adds a frame without a picture, which is possible before the first picture.
    void addNone() { ++m_count; }
    bool isEmpty() const { return m_parts.empty(); }
    /// Returns how many pairs of numbers there are: bodies and overlays in each frame.
    std::int64_t places() const { return m_places; }
    /// Writes the parts of the run, and its numbers into `columns`.
    void write(JsonWriter &json, NumberColumns &columns) const;

private:
    using Column = std::vector<double>;

    /// Frames in a row that have the same shapes of overlays.
    struct Drawings
    {
        std::size_t first = 0; ///< counted in the part
        std::vector<lessons::Overlay::Shape> shapes;
        std::vector<QString> labels; ///< each once
        std::vector<Column> numbers; ///< per overlay: label, a.x, a.y, b.x, b.y, size
    };
    /// Frames in a row that show the same scene.
    struct Part
    {
        std::size_t first = 0;
        std::size_t count = 0;
        std::shared_ptr<const sim::ComposedInterval> interval;
        std::shared_ptr<const lessons::View> view;
        QByteArray viewText; ///< of writeView()
        std::vector<Column> x, y;
        std::vector<Column> angle; ///< only of a tree
        /// px/frame: each velocity minus the distance covered in the frame. Empty if the page shows no velocities.
        std::vector<Column> restX, restY;
        std::vector<Drawings> drawings;
    };

    Part &partFor(const Picture &picture);
    static void addDrawings(Part &part, const std::vector<lessons::Overlay> &overlays);
    static void writePart(JsonWriter &json, NumberColumns &columns, const Part &part);

    std::vector<Part> m_parts;
    std::size_t m_count = 0;
    std::int64_t m_places = 0;
};

}
