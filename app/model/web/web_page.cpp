#include "app/model/web/web_page.h"

#include "app/model/files/whole_file.h"
#include "app/model/picture/overlays.h"
#include "app/model/run/run_program.h"
#include "app/model/text/json_writer.h"
#include "app/model/text/sentences.h"
#include "app/model/text/step_text.h"
#include "app/model/web/page_file.h"
#include "app/model/web/page_words.h"
#include "sim/run/script/composed_interval.h"

#include <QElapsedTimer>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

struct WebPageText
{
    Q_DECLARE_TR_FUNCTIONS(WebPageText)
};

constexpr qint64 pieceMilliseconds = 15;
constexpr std::size_t keyframeMemory = std::size_t{1} << 20; ///< bytes: the run is never sought back

/// @throws UserError if there are too many frames
void checkFrames(std::int64_t frames, std::int64_t points)
{
    const std::int64_t most =
        std::min(WebPage::mostPageFrames, WebPage::mostPlaces / std::max<std::int64_t>(1, points));
    if (frames > most)
        throw UserError(
            WebPageText::tr(
                "A web page has room for %1 frames of this scene, and this would be %2. Choose fewer frames.")
                .arg(most)
                .arg(frames));
}

/// @throws UserError
WebPagePlan checkedPlan(WebPagePlan plan)
{
    if (plan.to < plan.from)
        throw UserError(WebPageText::tr("The last frame, %1, comes before the first, %2. Swap them.")
                            .arg(plan.to)
                            .arg(plan.from));
    return plan;
}

/// Returns the plots that can be drawn of `scene`.
std::vector<PlotSpec> withValues(const std::vector<PlotSpec> &plots, const sim::Scene &scene)
{
    std::vector<PlotSpec> all;
    for (const PlotSpec &plot : plots) {
        if (!whyNot(plot.up, scene) && (plot.isAgainstTime() || !whyNot(plot.across, scene)))
            all.push_back(plot);
    }
    return all;
}

/// Returns what the window shows of a step that is opened for the first time.
PageSwitches firstSwitches(const lessons::View &view)
{
    PageSwitches switches;
    switches.velocities = view.showsVelocities;
    switches.onion = view.showsOnionSkins;
    return switches;
}

bool differ(const sim::State &a, const sim::State &b)
{
    constexpr double least = 1e-9; // px
    return a.pointCount() != b.pointCount() || ((a.position - b.position).abs() > least).any();
}

}

std::vector<PlotSpec> plotsOfPage(const sim::Script &script)
{
    const sim::Scene scene = sim::sceneOf(script, script.values);
    if (scene.names.empty())
        return {};
    return {pinned(firstPlot(script), QString::fromStdString(scene.names.front()))};
}

WebPage::WebPage(const WebPagePlan &plan, const LessonLibrary &library)
    : m_plan(checkedPlan(plan)), m_lesson(*library.lesson(plan.experiment.lesson)),
      m_step(*m_lesson.step(plan.experiment.step)), m_track(plan.experiment.script, keyframeMemory),
      m_listing(PageListing::of(m_step, plan.experiment.script)),
      m_plots(withValues(plan.plots, m_track.interval().scene))
{
    checkFrames((plan.to - plan.from) / m_track.framesPerOutput() + 1, m_track.state().pointCount());
    if (m_step.companion)
        m_companion.emplace(*m_step.companion);
    m_isBehind = m_companion.has_value();
    if (m_plan.ghost)
        m_ghost.emplace(*m_plan.ghost->script, keyframeMemory);
    if (!m_plan.switches)
        m_plan.switches = firstSwitches(*pictureOf(m_track).view);
    if (m_plan.from == 0)
        takeFrame(nullptr);
}

Picture WebPage::pictureOf(const sim::Track &track)
{
    Picture picture;
    picture.interval = track.intervalPtr();
    picture.state = track.state();
    picture.view = m_views.of(m_step, track.script(), picture.interval);
    picture.overlays = overlaysOf(m_step, track, *picture.interval, picture.state);
    return picture;
}

void WebPage::takeFrame(const sim::State *before)
{
    const Picture picture = pictureOf(m_track);
    m_figure.add(picture);
    m_figure.addVelocities(picture.state, m_track.framesPerOutput());
    followGhost(picture);
    if (m_figure.places() + m_ghostFigure.places() > mostPlaces)
        throw UserError(
            WebPageText::tr("The bodies of %1 frames do not fit on a web page. Choose fewer frames.")
                .arg(m_count + 1));
    m_plots.add(picture.interval, picture.state, before, m_track.framesPerOutput());
    if (m_listing)
        before ? m_listing->add(m_track, *before) : m_listing->addEmpty();
    takeHand();
    const QString note = m_step.note ? m_step.note(m_track) : QString();
    if (m_notes.empty() ? !note.isEmpty() : m_notes.back().second != note)
        m_notes.emplace_back(m_count, note);
    ++m_count;
    m_isBehind = m_companion.has_value();
}

void WebPage::takeHand()
{
    const sim::State &state = m_track.state();
    std::optional<sim::Vec2> hand;
    if (state.hold.point >= 0)
        hand = state.positionOf(state.hold.point);
    else if (state.input.pointerDown)
        hand = state.input.pointer;
    m_handX.push_back(hand ? hand->x : std::numeric_limits<double>::quiet_NaN());
    m_handY.push_back(hand ? hand->y : std::numeric_limits<double>::quiet_NaN());
}

bool WebPage::followCompanion()
{
    if (!m_companion->follow(m_plan.experiment.script, frame()))
        return false;
    m_isBehind = false;
    if (m_companion->track() && m_count > 0)
        m_beside.add(pictureOf(*m_companion->track()));
    return true;
}

void WebPage::followGhost(const Picture &picture)
{
    if (!m_ghost || (m_ghost->stop() && m_ghost->cursor().frame < frame()))
        return;
    Picture ghost = pictureOf(*m_ghost);
    ghost.overlays.clear();
    if (m_ghostFigure.isEmpty() && !differ(ghost.state, picture.state))
        m_ghostFigure.addNone();
    else
        m_ghostFigure.add(ghost);
}

bool WebPage::goOn()
{
    QElapsedTimer clock;
    clock.start();
    const int every = m_track.framesPerOutput();
    do {
        if (m_isBehind && !followCompanion())
            return true;
        const std::int64_t next = frame() + every;
        if (next > m_plan.to) {
            finish();
            return false;
        }
        const sim::State before = m_track.state();
        m_track.seek({next, 0});
        if (m_ghost)
            m_ghost->seek({next, 0});
        if (frame() < next) {
            m_endsEarly = endSentence(m_track);
            finish();
            return false;
        }
        if (next >= m_plan.from)
            takeFrame(&before);
    } while (clock.elapsed() < pieceMilliseconds);
    return true;
}

void WebPage::finish()
{
    if (m_count == 0)
        throw UserError(
            WebPageText::tr("The run does not reach frame %1: it stops at frame %2. Begin the page earlier.")
                .arg(m_plan.from)
                .arg(frame()));
    const QString title = QStringLiteral("%1 – %2").arg(m_step.title, m_lesson.title);
    writeWholeFile(m_plan.out,
                   pageText({title, lessons::documentLanguage(), m_plan.light, m_plan.dark, data()}));
}

QString WebPage::runTitle() const
{
    const sim::Script &script = m_plan.experiment.script;
    return QStringLiteral("%1, %2").arg(phrase(script.method->title()), stepTitle(script.step));
}

void WebPage::writeTexts(JsonWriter &json) const
{
    json.field("lesson", m_lesson.title);
    json.field("title", m_step.title);
    json.field("text", m_step.narration);
    json.field("run", m_plan.experiment.branches.own().name);
    json.field("method", runTitle());
    json.field("end", m_endsEarly);
    json.beginObject("words");
    for (const auto &[name, text] : pageWords())
        json.field(name, text);
    json.endObject();
}

void WebPage::writeNotes(JsonWriter &json) const
{
    json.beginList("notes");
    for (const auto &[at, note] : m_notes) {
        json.beginObject(JsonWriter::Layout::oneLine);
        json.field("at", at);
        json.field("text", note);
        json.endObject();
    }
    json.endList();
}

void WebPage::writeHand(JsonWriter &json, NumberColumns &columns) const
{
    if (std::all_of(m_handX.begin(), m_handX.end(), [](double x) { return std::isnan(x); }))
        return;
    json.field("handX", columns.addShort(m_handX));
    json.field("handY", columns.addShort(m_handY));
}

void WebPage::writeSwitches(JsonWriter &json) const
{
    const PageSwitches &switches = *m_plan.switches;
    json.beginObject("shows");
    json.field("trails", switches.trails);
    json.field("velocities", switches.velocities);
    json.field("onion", switches.onion);
    json.field("ghost", switches.ghost);
    json.field("guides", switches.guides);
    json.field("unitCircle", switches.unitCircle);
    json.field("grid", switches.grid);
    json.field("eyes", switches.eyes);
    json.endObject();
}

void WebPage::writeFigures(JsonWriter &json, NumberColumns &columns) const
{
    const auto write = [&](const PageFigure &figure, const QString &name, sim::Vec2 shift) {
        json.field("name", name);
        json.field("shiftX", shift.x);
        json.field("shiftY", shift.y);
        figure.write(json, columns);
        json.endObject();
    };
    const bool hasBeside = m_companion && m_companion->track();
    json.beginList("figures");
    json.beginObject();
    write(m_figure, hasBeside ? runTitle() : QString(), {});
    if (hasBeside) {
        json.beginObject();
        write(m_beside, m_step.companion->caption, m_step.companion->offset);
    }
    json.endList();
    if (m_ghostFigure.isEmpty())
        return;
    json.beginObject("ghost");
    write(m_ghostFigure, m_plan.ghost->name, {});
}

QByteArray WebPage::data() const
{
    JsonWriter json(0);
    NumberColumns columns;
    const int every = m_track.framesPerOutput();
    json.beginObject();
    json.field("format", "springstep-page/1");
    json.field("decimal", QString(QLocale().decimalPoint()));
    writeTexts(json);
    writeNotes(json);
    writeSwitches(json);
    json.field("rate", m_plan.rate);
    json.field("first", (m_plan.from + every - 1) / every * every);
    json.field("every", every);
    json.field("count", m_count);
    writeFigures(json, columns);
    if (m_listing)
        m_listing->write(json);
    m_plots.write(json, columns);
    writeHand(json, columns);
    json.endObject();
    return packed(json.text(), columns.bytes());
}

}
