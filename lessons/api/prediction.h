#pragma once

#include "sim/base/vec2.h"

#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace lessons {

/// A run as a document describes it: what differs from the run of the step, and when it ends.
struct RunSetup
{
    /// Where a body starts.
    struct Place
    {
        QString body;
        sim::Vec2 at; ///< px
    };
    /// A hand takes the body, moves it evenly to a place, and lets go. The first drag begins at frame 0, and each
    /// other one when the one before has ended.
    struct Drag
    {
        QString body;
        sim::Vec2 to; ///< px
        int frames = 1;
    };
    /// The pointer's button goes down in the scene at frame 0, and up after some frames.
    struct Press
    {
        sim::Vec2 at; ///< px
        int frames = 1;
    };
    static constexpr int mostFrames = 2000;

    QString step; ///< "lesson/step"; empty: the step of the document
    /// Parameters by id, and their values as written: a number, or the id of a choice.
    std::vector<std::pair<QString, QString>> values = {};
    QString method = {}; ///< id; empty: that of the step
    std::vector<Place> places = {};
    std::vector<Drag> drags = {};
    std::optional<Press> press = {};
    std::optional<sim::Vec2> click = {}; ///< where a new target is set at frame 0, px
    int frames = 0;                      ///< the run ends here at the latest; 0 if the document does not say
    QString until = {}; ///< it ends at the first frame from 1 on at which this condition holds; may be empty
    int line = 0;       ///< of its heading, from 1
};

/// What a prediction asks about its run.
struct Question
{
    enum class Kind {
        place,  ///< where a body is at the end
        number, ///< a number at the end, or how many frames the run takes
        curve,  ///< which of three curves shows a number against time
    };
    Kind kind = Kind::place;
    QString of = {}; ///< a body, "frames", or a number in the language of conditions: "distance(foot, body)"
    QString unit = {}; ///< of `number` and `curve`; may be empty

    /// Returns whether the answer is the number of frames until the run ends.
    bool asksFrames() const { return kind == Kind::number && of == u"frames"; }
};

/// A question about a run, which a learner answers before the run is played.
struct Prediction
{
    QString id; ///< made of a to z, 0 to 9 and _. No other prediction of the step has it.
    QString text;
    RunSetup run = {};
    Question question = {};
    /// For Question::Kind::curve: the two runs whose curves are wrong. Each has the values of `run`, and changes.
    std::vector<RunSetup> otherCurves = {};
    QString answer = {}; ///< Markdown, shown after the run
    int line = 0;        ///< of its heading, from 1
};

}
