#include "app/ui/film/film.h"

#include "app/model/film/gif_file.h"
#include "app/model/run/run_program.h"
#include "app/ui/film/step_alone.h"

#include <QCoreApplication>
#include <QResizeEvent>

#include <algorithm>
#include <new>

namespace app {

namespace {

struct FilmText
{
    Q_DECLARE_TR_FUNCTIONS(FilmText)
};

constexpr qint64 sliceMilliseconds = 15; ///< length of one piece of measuring
constexpr int mostSamples = 24;          ///< pictures, evenly spaced, from which the film's colours are taken

/// Returns the colours that carry meaning or fill large areas. The film keeps them exactly.
std::vector<QRgb> keptColors(const Tokens &t)
{
    std::vector<QRgb> colors;
    for (const QColor &color : {t.scene, t.dots, t.ink, t.ink2, t.ink3, t.body, t.bodyInk, t.ghost, t.now,
                                t.spring, t.gravity, t.damping, t.contact, t.driver, t.wind, t.stick, t.link})
        colors.push_back(color.rgb());
    return colors;
}

/// @throws UserError
FilmPlan checked(FilmPlan plan)
{
    if (plan.to < plan.from)
        throw UserError(FilmText::tr("The last frame, %1, comes before the first, %2. Swap them.")
                            .arg(plan.to)
                            .arg(plan.from));
    if (filmKind(plan.out) == FilmKind::gif && plan.rate > mostGifRate)
        throw UserError(
            FilmText::tr(
                "A GIF shows at most %1 pictures a second, and this would be %2. Choose fewer, or PNG "
                "files.")
                .arg(mostGifRate)
                .arg(plan.rate));
    return plan;
}

}

Film::Film(const FilmPlan &plan, const LessonLibrary &library)
    : m_plan(checked(plan)), m_library(stepAlone(plan.experiment, library)), m_session(m_library),
      m_theme(plan.scheme), m_view(m_session, m_theme)
{
    m_view.setFixedSize(plan.size);
    QResizeEvent resized(plan.size, {}); // a hidden view gets no resize event, but needs its size
    QCoreApplication::sendEvent(&m_view, &resized);
    m_session.open(plan.experiment);
    m_session.select({}); // the ring round a selected body is only for the learner at the window
    if (plan.extras)
        m_view.setExtras(*plan.extras);
    const int framesPerOutput = m_session.timeline().track().framesPerOutput();
    const std::int64_t pictures = (plan.to - plan.from) / framesPerOutput + 1;
    if (filmKind(plan.out) == FilmKind::gif)
        m_samples = static_cast<int>(std::min<std::int64_t>(mostSamples, pictures));
    m_total = m_samples + pictures;
    m_motion.emplace(m_session.timeline().script(), m_view.shown().picture.view, plan.from, plan.to);
}

std::int64_t Film::sampleFrame(int number) const
{
    return m_plan.from + (m_plan.to - m_plan.from) * number / std::max(1, m_samples - 1);
}

std::int64_t Film::frame() const
{
    return m_motion ? m_motion->frame() : m_session.timeline().cursor().frame;
}

bool Film::goOn()
{
    if (m_motion) {
        measureMotion();
        return true;
    }
    if (m_session.playback().goal() || m_session.presentation().isCompanionComing())
        return true;
    if (m_file)
        return addPicture();
    collectColors();
    return true;
}

void Film::measureMotion()
{
    if (!m_motion->goOn(sliceMilliseconds))
        return;
    m_view.showSpan(m_motion->area());
    m_motion.reset();
    if (m_samples > 0)
        m_session.playback().goTo({sampleFrame(0), 0});
    else
        beginFile();
}

QImage Film::picture()
{
    const QImage picture = m_view.picture();
    return picture.isNull() ? throw std::bad_alloc() : picture;
}

void Film::collectColors()
{
    m_colors.add(picture());
    ++m_done;
    if (++m_sampled < m_samples)
        m_session.playback().goTo({sampleFrame(m_sampled), 0});
    else
        beginFile();
}

void Film::beginFile()
{
    std::vector<QRgb> palette;
    if (m_samples > 0)
        palette = paletteOf(m_colors, keptColors(m_theme.tokens()), GifFile::mostColors);
    m_file = beginFilm(m_plan.out, m_view.viewport()->size(), std::move(palette));
    m_view.returnHome();
    // Starts early enough for the trail in the first picture.
    m_session.playback().goTo({std::max<std::int64_t>(0, m_plan.from - Trail::length), 0});
}

bool Film::addPicture()
{
    const sim::Timeline &timeline = m_session.timeline();
    const std::int64_t frame = timeline.cursor().frame;
    const int framesPerOutput = timeline.track().framesPerOutput();
    const bool isStopped = timeline.stop() && frame >= timeline.stop()->frame;
    if (frame >= m_plan.from) {
        const double until = static_cast<double>(frame - m_plan.from + framesPerOutput) / m_plan.rate;
        m_file->add(picture(), frame, until);
        ++m_done;
    }
    if (frame + framesPerOutput <= m_plan.to && !isStopped) {
        m_session.playback().frameForward();
        return true;
    }
    if (isStopped && frame < m_plan.to)
        m_endsEarly = endSentence(timeline.track());
    if (frame < m_plan.from)
        throw UserError(
            FilmText::tr("The run does not reach frame %1: it stops at frame %2. Begin the film earlier.")
                .arg(m_plan.from)
                .arg(frame));
    m_file->finish();
    m_done = m_total;
    return false;
}

}
