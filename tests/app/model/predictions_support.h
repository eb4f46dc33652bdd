#pragma once

#include "app/model/catalog/lesson_library.h"

#include <vector>

/// Shared by the suites of predictions: three predictions about lesson 1 whose runs are known.
namespace predictions_support {

using Asked = lessons::Question::Kind;

/// The foot is dragged 100 px to the right in 10 frames and released. Nothing pulls it.
inline lessons::Prediction throwOfFoot()
{
    lessons::Prediction one{"throw", "Where does it stop?"};
    one.run.values = {{"damp", "0.9"}};
    one.run.places = {{"foot", {100.0, 200.0}}};
    one.run.drags = {{"foot", {200.0, 200.0}, 10}};
    one.run.frames = 120;
    one.run.until = "frame > 11 and speed(foot) < 0.05";
    one.question = {Asked::place, "foot", "px"};
    one.answer = "It glides.";
    return one;
}

/// The foot is pulled to a cross at 270, 200. How many frames pass until it is on the other side?
inline lessons::Prediction pastTheCross()
{
    lessons::Prediction one{"past", "After how many frames?"};
    one.run.values = {{"k", "0.05"}, {"damp", "0.9"}};
    one.run.places = {{"foot", {510.0, 200.0}}};
    one.run.frames = 100;
    one.run.until = "foot.x < 270";
    one.question = {Asked::number, "frames", {}};
    one.answer = "So many.";
    return one;
}

/// Which curve shows the x of the foot on its way to the cross?
inline lessons::Prediction curveToCross()
{
    lessons::Prediction one{"which", "Which curve?"};
    one.run.values = {{"k", "0.05"}, {"damp", "0.9"}};
    one.run.places = {{"foot", {510.0, 200.0}}};
    one.run.frames = 60;
    one.question = {Asked::curve, "foot.x", "px"};
    one.otherCurves = {one.run, one.run};
    one.otherCurves[0].values = {{"k", "0.2"}, {"damp", "0.9"}};
    one.otherCurves[1].values = {{"k", "0.05"}, {"damp", "0.3"}};
    one.answer = "The slow one.";
    return one;
}

/// Returns the x of the foot at each frame, computed by the two lines of the published program.
inline std::vector<double> publishedX(double x, double k, double damp, int frames)
{
    std::vector<double> all{x};
    double velocity = 0.0;
    for (int i = 0; i < frames; ++i) {
        velocity = (velocity + k * (270.0 - x)) * damp;
        x += velocity;
        all.push_back(x);
    }
    return all;
}

/// Returns the program's lessons, with these predictions in the first steps of lesson 1.
inline app::LessonLibrary predictedLessons()
{
    app::LessonLibrary library = app::LessonLibrary::load({LESSON_DIR});
    for (lessons::Step &step : library.lessons[0].steps) {
        step.predictions.clear();
        if (step.id == u"drag")
            step.predictions = {throwOfFoot()};
        if (step.id == u"fixed_centre")
            step.predictions = {pastTheCross(), curveToCross()};
    }
    return library;
}

}
