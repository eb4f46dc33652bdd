#pragma once

#include "app/model/experiment/experiment.h"
#include "app/model/files/export.h"
#include "app/model/picture/view_cache.h"
#include "app/model/run/companion_run.h"
#include "app/model/series/plot_list.h"
#include "app/model/web/page_figure.h"
#include "app/model/web/page_listing.h"
#include "app/model/web/page_plots.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace app {

/// The colours of a page, by name: "scene", "ink".
using PageColors = std::vector<std::pair<QString, QString>>;

/// What the scene of a page shows at first, as in the window. The reader can switch most of it.
struct PageSwitches
{
    bool trails = true;
    bool velocities = false;
    bool onion = false;
    bool ghost = true;
    bool guides = true;
    bool unitCircle = true; ///< also the triangle of its arrow
    bool grid = true;
    bool eyes = true;
};

/// Another run of the same step, drawn as the ghost.
struct PageGhost
{
    QString name; ///< how it differs from the run
    std::shared_ptr<const sim::Script> script;
};

/// The settings of a web page that plays a run.
struct WebPagePlan
{
    Experiment experiment;
    QString out;                      ///< the file
    std::int64_t from = 0;            ///< the first frame
    std::int64_t to = 0;              ///< the last frame
    double rate = 30.0;               ///< frames per second; 30 is the speed of the window
    std::vector<PlotSpec> plots = {}; ///< which name their bodies
    PageColors light, dark;           ///< in light and in dark surroundings
    /// Empty: as the window shows the step first.
    std::optional<PageSwitches> switches = {};
    std::optional<PageGhost> ghost = {};
};

/// The file names of web pages end in this.
constexpr auto pageEnding = ".html";

/// A web page of a run. It is one file that needs no network; app/model/web/page has its parts.
class WebPage : public Export
{
public:
    /// The most positions of bodies on a page: more would take a browser seconds to read.
    static constexpr std::int64_t mostPlaces = 2'000'000;
    /// The most frames on a page.
    static constexpr std::int64_t mostPageFrames = 100'000;

    /// `library` must outlive this object.
    /// @throws UserError if the frames do not exist or do not fit on a page; sim::Error if scene and method do not fit
    WebPage(const WebPagePlan &plan, const LessonLibrary &library);

    /// @throws UserError also if the frames do not fit on a page
    bool goOn() override;
    std::int64_t frame() const override { return m_track.cursor().frame; }
    std::int64_t done() const override { return frame(); }
    std::int64_t total() const override { return m_plan.to + 1; }

private:
    /// Adds the frame at the cursor. `before` is the state one output step earlier, or null.
    void takeFrame(const sim::State *before);
    /// Adds the same frame of the companion. Returns whether it is computed.
    bool followCompanion();
    /// Adds the same frame of the ghost, from the first one that differs until the ghost's run ends.
    void followGhost(const Picture &picture);
    void finish();
    QByteArray data() const;
    void writeTexts(JsonWriter &json) const;
    void writeNotes(JsonWriter &json) const;
    void writeHand(JsonWriter &json, NumberColumns &columns) const;
    void writeSwitches(JsonWriter &json) const;
    void writeFigures(JsonWriter &json, NumberColumns &columns) const;
    void takeHand();
    Picture pictureOf(const sim::Track &track);
    /// Returns the method and the step of the run.
    QString runTitle() const;

    WebPagePlan m_plan;
    const LessonEntry &m_lesson;
    const lessons::Step &m_step;
    sim::Track m_track;
    ViewCache m_views;
    PageFigure m_figure;
    std::optional<CompanionRun> m_companion;
    PageFigure m_beside;
    bool m_isBehind = false; ///< the companion has not reached the cursor yet
    std::optional<sim::Track> m_ghost;
    PageFigure m_ghostFigure; ///< without overlays
    std::unique_ptr<PageListing> m_listing;
    PagePlots m_plots;
    std::vector<std::pair<std::int64_t, QString>>
        m_notes;                          ///< by index of the frame; each stays until the next one
    std::vector<double> m_handX, m_handY; ///< px, per frame: where the input holds a body; NaN if it does not
    std::int64_t m_count = 0;             ///< frames on the page
};

/// Returns the plots of a page where no window shows any: the one that suits the step.
std::vector<PlotSpec> plotsOfPage(const sim::Script &script);

}
