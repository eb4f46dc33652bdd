#include "tests/app/experiment/random_trial.h"

#include "app/model/code/code_values.h"
#include "app/model/experiment/experiment.h"
#include "app/model/picture/overlays.h"
#include "app/model/text/numbers.h"
#include "app/model/text/sentences.h"
#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <map>

namespace random_experiments {

namespace {

constexpr std::int64_t mostRows = 300;
constexpr std::int64_t mostWork = 150'000; ///< phases times points that a run may be

/// An error of the program that a trial has found.
struct Fault
{
    QString what;
};

void require(bool holds, const QString &what)
{
    if (!holds)
        throw Fault{what};
}

/// Checks that an error is one line that says where, and is a sentence.
void checkError(const QString &sentence, const QByteArray &text)
{
    static const QRegularExpression form(QStringLiteral("^x\\.json: line (\\d+): \\S.*\\.$"));
    const QRegularExpressionMatch match = form.match(sentence);
    require(match.hasMatch(), "no sentence with its place: " + sentence);
    require(!sentence.contains('\n') && !sentence.contains('\r'), "more than a line: " + sentence);
    require(match.captured(1).toInt() <= text.count('\n') + 1, "no such line: " + sentence);
    require(!sentence.contains("do not fit together"), "nobody has words for this: " + sentence);
    require(sentence.size() < 1000, "too long: " + sentence);
}

void checkFinite(double number, const QString &what)
{
    require(std::isfinite(number), what + " is not finite");
}

/// Checks all numbers of a state, and everything that `trace` writes of it.
void checkState(const sim::State &state)
{
    const QString where = QStringLiteral(" at frame %1").arg(state.frame);
    const auto all = [&where](const auto &numbers, const char *what) {
        require(numbers.isFinite().all(), what + where + " is not finite");
    };
    all(state.position, "a place");
    all(state.velocity, "a velocity");
    all(state.acceleration, "an acceleration");
    all(state.angle, "an angle");
    all(state.spin, "a spin");
    all(state.gait, "a gait");
    all(state.gaitSpeed, "a gait's speed");
    checkFinite(state.gustExtent.front + state.gustExtent.tail, "a gale" + where);
    checkFinite(state.input.target.x, "a target" + where);
    checkFinite(state.hold.hand.x, "a hand" + where);
}

void checkStop(const sim::Stop &stop, std::int64_t at)
{
    const QString sentence = app::sentenceFor(stop);
    require(stop.frame == at, "stopped at another frame than the last good one: " + sentence);
    require(sentence.startsWith(QStringLiteral("Stopped at frame %1").arg(stop.frame)) &&
                sentence.endsWith('.'),
            "no reason: " + sentence);
    require(!stop.body.empty(), "nothing is named that failed: " + sentence);
}

/// A run, and the work that it may still be.
class Run
{
public:
    Run(const app::Experiment &experiment, const lessons::Step &step, Draw &draw)
        : m_experiment(experiment), m_step(step), m_draw(draw),
          m_track(experiment.script, draw.of(std::vector<std::size_t>{0, 50'000, 1'000'000}))
    {
        const bool solves = !experiment.script.method->requirements().empty();
        m_cost = solves ? 30 : 1;
    }

    Outcome::End all()
    {
        forth();
        back();
        shown();
        if (m_left > mostWork / 2)
            edited();
        return m_track.stop() ? Outcome::End::stopped : Outcome::End::ran;
    }

private:
    bool goes(sim::Cursor target)
    {
        return m_track.seek(target, [this] {
            m_left -= m_cost * (5 + m_track.state().pointCount());
            return m_left > 0;
        });
    }

    void forth()
    {
        checkState(m_track.state());
        m_seen[0] = m_track.state();
        const std::int64_t row = m_track.framesPerOutput();
        const std::int64_t last = std::min(m_experiment.frames, mostRows * row);
        for (std::int64_t frame = row; frame <= last; frame += row) {
            if (!goes({frame, 0}) || m_track.stop())
                break;
            checkState(m_track.state());
            if (m_draw.chance(0.05))
                m_seen[frame] = m_track.state();
        }
        if (m_track.stop())
            checkStop(*m_track.stop(), m_track.cursor().frame);
    }

    /// To moments that were there before, also inside a row: the same numbers again.
    void back()
    {
        m_left += mostWork / 4;
        for (int i = 0; i < 3; ++i) {
            const auto seen = std::next(m_seen.begin(), m_draw.below(int(m_seen.size())));
            if (!goes({seen->first, m_draw.below(7)}))
                return;
            if (m_track.cursor().phase == 0)
                checkState(m_track.state());
            if (!goes({seen->first, 0}))
                return;
            require(sim::sameBits(m_track.state(), seen->second),
                    QStringLiteral("frame %1 is another the second time").arg(seen->first));
        }
    }

    /// Checks the overlays of the picture and the texts beside it.
    void shown()
    {
        const sim::ComposedInterval &interval = m_track.interval();
        const sim::State &state = m_track.state();
        const lessons::View view = m_step.view(interval.scene, interval.values);
        require(int(view.bodies.size()) == state.pointCount(), "some bodies have no look");
        for (const lessons::Overlay &overlay : app::overlaysOf(m_step, m_track, interval, state)) {
            for (const double number : {overlay.a.x, overlay.a.y, overlay.b.x, overlay.b.y, overlay.size})
                checkFinite(number, "a guide");
        }
        for (int i = 0; i < state.pointCount(); ++i)
            checkFinite(app::shownLength(state.velocityOf(i)), "a speed as it is shown");
        checkValues(interval.scene.names[std::size_t(m_draw.below(state.pointCount()))]);
        for (const lessons::Measure &measure : m_step.measures) {
            if (measure.of)
                measure.of(interval.scene, state, nullptr, interval.values);
        }
    }

    /// Checks the values on the lines of the code.
    void checkValues(const std::string &body)
    {
        if (m_left <= 0)
            return;
        for (const sim::PhaseExplanation &moment : m_track.explainPhases(body)) {
            for (const sim::LiveValue &live : moment.live) {
                const QString shown = app::shownValue(live.value);
                require(!shown.contains("nan") && !shown.contains("inf"),
                        QString::fromStdString(live.name) + " is shown as " + shown);
            }
        }
    }

    /// Edits the run like a learner.
    void edited()
    {
        sim::Timeline line(m_experiment.script, 200'000);
        const std::int64_t middle = m_seen.rbegin()->first / 2;
        line.seek({middle, 0});
        line.nextPhase();
        line.previousPhase();
        line.previousOutputStep();
        line.nextOutputStep();
        checkState(line.state());
        const sim::Scene &scene = line.track().interval().scene;
        line.applyInput(sim::Grab{scene.names[std::size_t(m_draw.below(int(scene.names.size())))]});
        line.applyInput(sim::Move{{m_draw.real(-1e9, 1e9), m_draw.real(0.0, 400.0)}});
        line.nextOutputStep();
        line.applyInput(sim::Release{});
        if (!m_step.parameters.empty()) {
            const lessons::Parameter &parameter = m_draw.of(m_step.parameters);
            if (!parameter.isInteger && parameter.choices.isEmpty())
                set(line, parameter);
        }
        for (int i = 0; i < 5; ++i) {
            line.nextOutputStep();
            checkState(line.state());
        }
        if (line.stop())
            checkStop(*line.stop(), line.cursor().frame);
        for (const lessons::Try &one : m_step.tries)
            one.isDone(line);
        line.dropComparison();
        line.seek({0, 0});
        checkState(line.state());
    }

    void set(sim::Timeline &line, const lessons::Parameter &parameter)
    {
        try {
            line.setParameter(parameter.id.toStdString(), m_draw.real(parameter.min, parameter.max));
        } catch (const sim::Error &error) {
            const QString sentence = app::sentenceFor(error);
            require(!sentence.contains("do not fit together"), "nobody has words for this: " + sentence);
        }
    }

    const app::Experiment &m_experiment;
    const lessons::Step &m_step;
    Draw &m_draw;
    sim::Track m_track;
    std::int64_t m_left = mostWork;
    std::int64_t m_cost = 1;
    std::map<std::int64_t, sim::State> m_seen; ///< states by frame
};

/// Checks that the written file is read as the same experiment, and written unchanged again.
void checkWritten(const app::Experiment &first, const app::LessonLibrary &library)
{
    const QByteArray written = app::experimentText(first, library);
    try {
        const app::Experiment second = app::parseExperiment(written, "x.json", library);
        const sim::Script &a = first.script, &b = second.script;
        require(a.values == b.values && a.bodies == b.bodies && a.effectsOff == b.effectsOff &&
                    a.input == b.input && a.step == b.step && a.method->id() == b.method->id() &&
                    first.frames == second.frames && first.lesson == second.lesson &&
                    first.step == second.step,
                "written and read again it is another: " + written);
        require(app::experimentText(second, library) == written, "written again it is another");
    } catch (const app::UserError &error) {
        throw Fault{"what it writes it refuses: " + error.sentence() + '\n' + written};
    }
}

void go(const QByteArray &text, const app::LessonLibrary &library, Draw &draw, Outcome &outcome)
{
    app::Experiment experiment;
    try {
        experiment = app::parseExperiment(text, "x.json", library);
    } catch (const app::UserError &error) {
        checkError(error.sentence(), text);
        return;
    }
    outcome.lesson = experiment.lesson;
    outcome.method = QString::fromStdString(experiment.script.method->id());
    checkWritten(experiment, library);
    const lessons::Step *step = library.lesson(experiment.lesson)->step(experiment.step);
    outcome.end = Run(experiment, *step, draw).all();
}

}

Outcome tried(const QByteArray &text, const app::LessonLibrary &library, Draw &draw)
{
    Outcome outcome;
    try {
        go(text, library, draw, outcome);
    } catch (const Fault &fault) {
        outcome.fault = fault.what;
    } catch (const std::exception &error) {
        outcome.fault = QStringLiteral("thrown: ") + error.what();
    }
    return outcome;
}

}
