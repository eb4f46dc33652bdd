#include "tests/app/experiment/random_experiment.h"

#include "sim/run/script/script.h"
#include "tests/app/experiment/random_sheet.h"

#include "sim/base/error.h"
#include "sim/base/random.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/pipeline.h"

namespace random_experiments {

namespace {

/// Damages a text: cuts it off, or removes, doubles or changes bytes.
QByteArray damaged(QByteArray text, Draw &draw)
{
    for (int i = draw.below(3); i >= 0 && !text.isEmpty(); --i) {
        const int at = draw.below(int(text.size()));
        switch (draw.below(5)) {
        case 0:
            text.truncate(at);
            break;
        case 1:
            text.remove(at, 1 + draw.below(5));
            break;
        case 2:
            text[at] = char(draw.below(256));
            break;
        case 3:
            text.insert(at, text.mid(draw.below(int(text.size())), 40));
            break;
        default:
            text.insert(at, draw.of(extremes()));
        }
    }
    return text;
}

Known knownOf(const QString &lesson, const lessons::Step &step)
{
    Known known{lesson, &step, {}, {}, {}};
    sim::Script script = step.script();
    const sim::Scene scene = script.build(script.values);
    for (const std::string &name : scene.names)
        known.bodies.push_back(QString::fromStdString(name));
    for (const sim::EffectPtr &effect : scene.effects)
        known.effects.push_back(QString::fromStdString(effect->id()));
    for (const sim::MethodPtr &method : sim::allMethods()) {
        script.method = method;
        try {
            sim::compose(sim::sceneOf(script, script.values), *method, sim::stepFor(*method, script.step));
            known.methods.push_back(QString::fromStdString(method->id()));
        } catch (const sim::Error &) {
            // does not fit: not in the list
        }
    }
    return known;
}

}

double Draw::share()
{
    return sim::uniform(m_seed, m_trial, m_index++);
}

Experiments::Experiments(const app::LessonLibrary &library)
{
    for (const app::LessonEntry &lesson : library.lessons) {
        for (const lessons::Step &step : lesson.steps)
            m_steps.push_back(knownOf(lesson.id, step));
    }
    for (const sim::MethodPtr &method : sim::allMethods())
        m_methods.push_back(QString::fromStdString(method->id()));
}

QByteArray Experiments::text(Draw &draw) const
{
    const double kind = draw.share();
    const double wrong = kind < 0.7 ? 0.0 : kind < 0.9 ? 0.02 : 0.2;
    const QByteArray text = sheet(draw, draw.of(m_steps), m_methods, wrong);
    return draw.chance(0.05) ? damaged(text, draw) : text;
}

}
