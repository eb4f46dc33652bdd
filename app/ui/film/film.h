#pragma once

#include "app/model/film_file.h"
#include "app/model/motion_area.h"
#include "app/model/palette.h"
#include "app/ui/scene/scene_view.h"

namespace app {

/// A film that is to be made of a run: a picture of each of its frames.
struct FilmPlan
{
    Experiment experiment;
    QString out;                    ///< the file, or the pattern of several; see filmKind()
    QSize size{640, 480};           ///< of a picture
    Scheme scheme = Scheme::light;  ///< its colours
    std::optional<Extras> extras{}; ///< what is shown besides the creature; empty: what the step shows
    std::int64_t from = 0;          ///< the first frame
    std::int64_t to = 0;            ///< the last frame
    double rate = 30.0;             ///< frames a second; at 30 as fast as the window plays
};

/// Makes a film piece by piece, on a session of its own, so that whoever waits can do other things between two
/// pieces: paint the window, show how far it is, or give up.
class Film
{
public:
    /// @throws Refusal: no film's name, no such frames, or too many pictures a second for a GIF
    Film(const FilmPlan &plan, const LessonLibrary &library);

    /// Does a piece of the work, at most a picture; the event loop has to run between two. False: all is done, and
    /// the film is there. @throws Refusal: it cannot be written
    bool goOn();
    /// How much is done, of total().
    std::int64_t done() const { return m_done; }
    std::int64_t total() const { return m_total; }
    /// The frame that it has come to.
    std::int64_t frame() const;
    /// Why the film ends before the frame that was asked for.
    const std::optional<sim::Stop> &stop() const { return m_stop; }

private:
    /// Measures how far the bodies go in the film, and then shows all of that.
    void frameSpan();
    /// The view as it is. @throws std::bad_alloc
    QImage picture();
    void lookAtColors();
    bool shoot();
    std::int64_t sampleFrame(int number) const;
    void begin();

    FilmPlan m_plan;
    LessonLibrary m_library; ///< with nothing but the step
    Session m_session;
    Theme m_theme;
    SceneView m_view;
    std::optional<MotionArea> m_motion; ///< while it measures
    int m_samples = 0;                  ///< pictures that are looked at for their colours first
    int m_sampled = 0;
    ColorCount m_colors;
    std::unique_ptr<FilmFile> m_file; ///< from when the colours are known
    std::int64_t m_done = 0;
    std::int64_t m_total = 0;
    std::optional<sim::Stop> m_stop;
};

}
