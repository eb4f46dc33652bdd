#pragma once

#include "app/model/catalog/lesson_library.h"
#include "app/model/code/code_marks.h"
#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/pipeline.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "tests/sizes.h"

#include <QTest>

/// Shared by the suites of the shown code.
namespace listing_support {

using namespace app;

inline const LessonLibrary &library()
{
    static const LessonLibrary loaded = LessonLibrary::load({LESSON_DIR});
    return loaded;
}

inline const lessons::Step &stepOf(const QString &lesson, const QString &step)
{
    return *library().lesson(lesson)->step(step);
}

inline sim::Timeline runOf(const lessons::Step &step, const QString &method = "published")
{
    sim::Script script = step.script();
    script.method = sim::findMethod(method.toStdString());
    return sim::Timeline(std::move(script));
}

inline CodeListing listingOf(const lessons::Step &step, const sim::Timeline &run)
{
    return app::listingOf(step, run.track().interval(), *run.script().method);
}

/// Returns whether `method` can compute `step`. Methods with requirements refuse some steps.
inline bool fits(const lessons::Step &step, const sim::MethodPtr &method)
{
    sim::Script script = step.script();
    script.method = method;
    try {
        sim::compose(sim::sceneOf(script, script.values), *method, script.step);
        return true;
    } catch (const sim::Error &) {
        return false;
    }
}

/// A row for every step of every lesson with every method that can compute it; under the sanitizers for a quarter of them.
inline void everyStepAndMethod()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("method");
    int pair = 0;
    for (const LessonEntry &lesson : library().lessons) {
        for (const lessons::Step &step : lesson.steps) {
            for (const sim::MethodPtr &method : sim::allMethods()) {
                if (!fits(step, method) || pair++ % tests::sized(1, 4) != 0)
                    continue;
                const QString id = QString::fromStdString(method->id());
                QTest::addRow("%s/%s, %s", qPrintable(lesson.id), qPrintable(step.id), qPrintable(id))
                    << lesson.id << step.id << id;
            }
        }
    }
}

}
