#pragma once

#include "app/model/files/export.h"
#include "app/model/film/film_file.h"
#include "app/model/film/palette.h"
#include "app/model/picture/motion_area.h"
#include "app/ui/scene/scene_view.h"

namespace app {

/// The settings of a film of a run, which has one picture for each frame.
struct FilmPlan
{
    Experiment experiment;
    QString out;                    ///< the file, or the pattern for several files; see filmKind()
    QSize size{640, 480};           ///< of a picture
    Scheme scheme = Scheme::light;  ///< colour scheme of the pictures
    std::optional<Extras> extras{}; ///< what is shown besides the creature; empty: the step's own
    std::int64_t from = 0;          ///< the first frame
    std::int64_t to = 0;            ///< the last frame
    double rate = 30.0;             ///< frames per second; 30 is the speed of the window
};

/// A film of a run. It uses its own session. A piece is at most one picture, and the event loop must run between two
/// pieces.
class Film : public Export
{
public:
    /// @throws UserError if the file name is not a film name, the frames do not exist, or the rate is too
    /// high for a GIF
    Film(const FilmPlan &plan, const LessonLibrary &library);

    bool goOn() override;
    std::int64_t done() const override { return m_done; }
    std::int64_t total() const override { return m_total; }
    std::int64_t frame() const override;

private:
    /// Measures how far the bodies move in the film, then fits the view to that area.
    void measureMotion();
    /// Returns a picture of the current view. @throws std::bad_alloc
    QImage picture();
    /// Counts the colours of a sample, and goes to the next.
    void collectColors();
    /// Adds the picture of the current frame, and goes to the next. Returns false after the last.
    bool addPicture();
    std::int64_t sampleFrame(int number) const;
    void beginFile();

    FilmPlan m_plan;
    LessonLibrary m_library; ///< contains only the step
    Session m_session;
    Theme m_theme;
    SceneView m_view;
    std::optional<MotionArea> m_motion; ///< only while it measures
    int m_samples = 0;                  ///< pictures that are sampled first for their colours
    int m_sampled = 0;
    ColorCount m_colors;
    std::unique_ptr<FilmFile> m_file; ///< null until the colours are known
    std::int64_t m_done = 0;
    std::int64_t m_total = 0;
};

}
