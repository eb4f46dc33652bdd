#include "app/ui/film/film.h"

#include "app/model/gif_file.h"
#include "app/model/words.h"

#include <QCoreApplication>
#include <QResizeEvent>

#include <algorithm>
#include <new>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Film)
};

constexpr qint64 sliceMilliseconds = 15; ///< of measuring
constexpr int mostSamples = 24;          ///< pictures, evenly over the film, whose colours are the film's

/// The experiment's step alone, with nothing to try: making a film gets nothing done.
LessonLibrary libraryOf(const Experiment &experiment, const LessonLibrary &library)
{
    const LessonEntry &lesson = *library.lesson(experiment.lesson);
    lessons::Step step = *lesson.step(experiment.step);
    step.tries.clear();
    step.measures.clear();
    LessonLibrary alone;
    alone.lessons.push_back({lesson.id, lesson.order, lesson.title, lesson.summary, {std::move(step)}});
    return alone;
}

/// Colours that carry meaning, or large areas: they stay exactly what they are.
std::vector<QRgb> inksOf(const Tokens &t)
{
    std::vector<QRgb> inks;
    for (const QColor &color : {t.scene, t.dots, t.ink, t.ink2, t.ink3, t.body, t.bodyInk, t.ghost, t.now,
                                t.spring, t.gravity, t.damping, t.contact, t.driver, t.wind, t.stick, t.link})
        inks.push_back(color.rgb());
    return inks;
}

/// @throws Refusal
FilmPlan checked(FilmPlan plan)
{
    if (plan.to < plan.from)
        throw Refusal(Text::tr("The last frame, %1, comes before the first, %2. Swap them.")
                          .arg(plan.to)
                          .arg(plan.from));
    if (filmKind(plan.out) == FilmKind::gif && plan.rate > mostGifRate)
        throw Refusal(
            Text::tr("A GIF shows at most %1 pictures a second, and this would be %2. Choose fewer, or PNG "
                     "files.")
                .arg(mostGifRate)
                .arg(plan.rate));
    return plan;
}

}

Film::Film(const FilmPlan &plan, const LessonLibrary &library)
    : m_plan(checked(plan)), m_library(libraryOf(plan.experiment, library)), m_session(m_library),
      m_theme(plan.scheme), m_view(m_session, m_theme)
{
    m_view.setFixedSize(plan.size);
    QResizeEvent resized(plan.size, {}); // it is never shown, and must know its size all the same
    QCoreApplication::sendEvent(&m_view, &resized);
    m_session.open(plan.experiment);
    m_session.select({}); // a ring round a body says something to who is there alone
    if (plan.extras)
        m_view.setExtras(*plan.extras);
    const int framesPerOutput = m_session.timeline().track().framesPerOutput();
    const std::int64_t pictures = (plan.to - plan.from) / framesPerOutput + 1;
    if (filmKind(plan.out) == FilmKind::gif)
        m_samples = static_cast<int>(std::min<std::int64_t>(mostSamples, pictures));
    m_total = m_samples + pictures;
    m_motion.emplace(m_session.timeline().script(), m_view.shown().picture.look, plan.from, plan.to);
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
        frameSpan();
        return true;
    }
    if (m_session.goingTo() || m_session.isCompanionComing())
        return true;
    if (m_file)
        return shoot();
    lookAtColors();
    return true;
}

void Film::frameSpan()
{
    if (!m_motion->goOn(sliceMilliseconds))
        return;
    m_view.showSpan(m_motion->area());
    m_motion.reset();
    if (m_samples > 0)
        m_session.goTo({sampleFrame(0), 0});
    else
        begin();
}

QImage Film::picture()
{
    const QImage picture = m_view.picture();
    return picture.isNull() ? throw std::bad_alloc() : picture;
}

void Film::lookAtColors()
{
    m_colors.add(picture());
    ++m_done;
    if (++m_sampled < m_samples)
        m_session.goTo({sampleFrame(m_sampled), 0});
    else
        begin();
}

void Film::begin()
{
    std::vector<QRgb> palette;
    if (m_samples > 0)
        palette = paletteOf(m_colors, inksOf(m_theme.tokens()), GifFile::mostColors);
    m_file = beginFilm(m_plan.out, m_view.viewport()->size(), std::move(palette));
    m_view.returnHome();
    // Far enough before the first picture for the trail that it shows.
    m_session.goTo({std::max<std::int64_t>(0, m_plan.from - Trail::length), 0});
}

bool Film::shoot()
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
        m_session.frameForward();
        return true;
    }
    if (isStopped && frame < m_plan.to)
        m_stop = timeline.stop();
    if (frame < m_plan.from)
        throw Refusal(
            Text::tr("The run does not reach frame %1: it stops at frame %2. Begin the film earlier.")
                .arg(m_plan.from)
                .arg(frame));
    m_file->finish();
    m_done = m_total;
    return false;
}

}
