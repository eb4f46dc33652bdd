#include "app/ui/scene/scene_view.h"

#include "app/model/analysis/accuracy_study.h"
#include "app/model/learning/project_desk.h"
#include "app/model/run/frame_clock.h"
#include "app/ui/scene/drawing/body_text.h"
#include "app/ui/scene/layers/highlight_marks.h"
#include "app/ui/scene/layers/layers.h"
#include "app/ui/scene/layers/reference_marks.h"
#include "lessons/api/view/view.h"
#include "sim/run/phase_before.h"
#include "sim/run/script/composed_interval.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double dotStep = 25.0;         ///< px
constexpr double dotRadius = 1.3;        ///< screen px
constexpr int crossEvery = 4;            ///< dots per cross
constexpr double gridArm = 4.0;          ///< screen px
constexpr double densest = 18.0;         ///< smallest distance between two dots, screen px
constexpr int mostSkinned = 20'000;      ///< points; with more, computing earlier moments would take too long
constexpr double leastDifference = 1e-9; ///< px; a ghost closer to the run than this is not drawn

bool differ(const Picture &a, const Picture &b)
{
    return a.state.pointCount() != b.state.pointCount() ||
           ((a.state.position - b.state.position).abs() > leastDifference).any();
}

}

SceneView::SceneView(Session &session, const Theme &theme, QWidget *parent)
    : QGraphicsView(parent), m_session(session), m_theme(theme), m_overlay(m_shown, m_companion, theme),
      m_drag(session.playback(), session.input()), m_tools(session.run(), session.playback(), session.input())
{
    setFrameShape(QFrame::NoFrame);
    setLayoutDirection(Qt::LeftToRight); // x grows to the right in every language
    setRenderHint(QPainter::Antialiasing);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setOptimizationFlags(DontSavePainterState | DontAdjustForAntialiasing);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTransformationAnchor(NoAnchor);
    setResizeAnchor(AnchorViewCenter);
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(false); // the window takes files
    viewport()->setAcceptDrops(false);
    setMinimumSize(240, 160);
    setAccessibleName(tr("Scene"));
    viewport()->setMouseTracking(true);

    m_scene.setItemIndexMethod(QGraphicsScene::NoIndex);
    m_scene.setSceneRect(-worldReach, -worldReach, 2.0 * worldReach, 2.0 * worldReach);
    addLayers(m_scene, m_shown, theme, session.input());
    addCompanionLayers(m_scene, m_companion, theme);
    setScene(&m_scene);

    session.onChange(everyChange, this, &SceneView::followChange);
    connect(&theme, &Theme::changed, this, &SceneView::readTheme);
    readTheme();
    open();
}

SceneView::~SceneView()
{
    // The scene is destroyed before the view, which must not access it then.
    setScene(nullptr);
}

void SceneView::readTheme()
{
    m_shown.text = m_theme.ui(12);
    m_shown.figures = m_theme.ui(12, QFont::DemiBold);
    m_companion.text = m_shown.text;
    m_companion.figures = m_shown.figures;
    viewport()->update();
}

void SceneView::open()
{
    m_drag.release();
    m_tools.release();
    m_shown.trail.clear();
    m_shown.highlights.clear();
    m_runScales = {};
    m_follows = true;
    m_atHome = false; // show another scene as a whole
    m_motion.reset();
    refresh();
    takeExtrasOfStep();
    showHome();
}

void SceneView::followChange(const Change &change)
{
    if (change.isAny(ChangeKind::run))
        m_motion.reset();
    if (change.isAny(ChangeKind::step))
        open();
    else if (change.isAny(ChangeKind::preview))
        followPreview(change);
    else
        refresh();
}

void SceneView::refresh()
{
    if (m_ownsPreview && m_session.preview().isActive())
        return;
    takeMoment();
    if (!m_session.preview().isActive()) { // a preview does not change the trail
        m_shown.trail.follow(m_session.timeline());
        takeOnion();
        if (m_atHome && m_shown.view().stage != m_stage)
            showHome(); // the stage has changed its size
    }
    m_shown.selected = m_shown.picture.interval->scene.find(m_session.selected().toStdString());
    m_shown.scales = m_runScales;
    measureArrows(m_shown, m_session.preview().run().cursor().frame);
    if (!m_session.preview().isActive())
        m_runScales = m_shown.scales;
    if (!m_session.playback().isPlaying())
        describe();
    keepSubject();
    updateCursor();
    viewport()->update();
    emit contentChanged();
}

void SceneView::takeMoment()
{
    m_shown.picture = m_session.presentation().picture();
    m_shown.comparison = m_session.presentation().comparison();
    if (m_projects) {
        for (const lessons::ProjectRing &ring : m_projects->rings())
            m_shown.picture.overlays.push_back(
                {.shape = lessons::Overlay::Shape::ring, .a = ring.centre, .size = ring.radius});
    }
    if (m_shown.comparison && !differ(*m_shown.comparison, m_shown.picture))
        m_shown.comparison.reset();
    m_shown.comparisonName = m_session.comparisons().comparisonName();
    takePulls();
    takeCaption();
    takeReference();
    takeCompanion();
}

void SceneView::takePulls()
{
    const sim::Timeline &timeline = m_session.preview().run();
    m_shown.isInside = timeline.cursor().phase > 0 && m_wantsVelocities.value_or(true);
    m_shown.before.reset();
    if (m_shown.isInside && !m_shown.isCrowd())
        m_shown.before = sim::stateBeforeLastPhase(timeline.track());
    m_shown.pullsAreAll = m_shown.extras.pulls && timeline.cursor().phase == 0;
    m_shown.gathered =
        m_shown.pullsAreAll ? sim::currentForces(timeline.track()) : m_session.presentation().forces();
    m_shown.clock =
        tr("frame %1 = %2\u2009s")
            .arg(timeline.cursor().frame)
            .arg(QLocale().toString(double(timeline.cursor().frame) / FrameClock::framesPerSecond, 'f', 2));
}

void SceneView::describe()
{
    QString text;
    if (m_shown.selected >= 0)
        text = bodySentence(m_session.selected(), m_shown.state().positionOf(m_shown.selected),
                            m_shown.state().velocityOf(m_shown.selected));
    if (!m_shown.caption.isEmpty())
        text += ". " + m_shown.caption;
    if (const std::optional<sim::Vec2> pointer = m_session.input().recordedPointer())
        text += ". " + tr("The hand of the recorded run is at %1, %2")
                           .arg(pointer->x, 0, 'f', 0)
                           .arg(pointer->y, 0, 'f', 0);
    if (const QString marks = m_picker.words(); !marks.isEmpty())
        text += ". " + marks;
    if (!m_shown.highlights.empty())
        text += ". " + tr("The formula is about: %1").arg(highlightWords(m_shown.highlights));
    if (m_companion.points() > 0)
        text += ". " + tr("Beside it: %1").arg(m_companion.name);
    if (m_shown.reference && m_shown.extras.reference)
        text += ". " + referenceSentence(*m_shown.reference);
    if (text != accessibleDescription())
        setAccessibleDescription(text);
}

QString SceneView::nameOf(int point) const
{
    return QString::fromStdString(m_shown.picture.interval->scene.names[static_cast<std::size_t>(point)]);
}

void SceneView::setExtras(const Extras &extras)
{
    if (extras.velocities != m_shown.extras.velocities)
        m_wantsVelocities = extras.velocities;
    if (extras.onion != m_shown.extras.onion)
        m_wantsOnion = extras.onion;
    if (extras.ruler && !m_shown.extras.ruler) { // put it in the middle of the view
        const QPointF middle = viewRect().center();
        m_shown.ruler = {camera().back(middle - QPointF(80.0, 0.0)),
                         camera().back(middle + QPointF(80.0, 0.0))};
    }
    m_shown.extras = extras;
    refresh();
}

void SceneView::setVector(const std::optional<VectorMark> &vector)
{
    if (vector == m_shown.vector)
        return;
    m_shown.vector = vector;
    viewport()->update();
}

void SceneView::attach(PredictionDesk &desk)
{
    m_picker.attach(desk);
    connect(&desk, &PredictionDesk::changed, this, [this] {
        describe();
        updateCursor();
        viewport()->update();
    });
    connect(&desk, &PredictionDesk::pickingStarted, this, [this] {
        setFocus(Qt::ShortcutFocusReason);
        fit(); // a body can end far from where it starts
    });
}

void SceneView::attach(ProjectDesk &desk)
{
    m_projects = &desk;
    connect(&desk, &ProjectDesk::changed, this, &SceneView::refresh);
    refresh();
}

void SceneView::setHighlights(const std::vector<lessons::Highlight> &highlights)
{
    if (highlights == m_shown.highlights)
        return;
    m_shown.highlights = highlights;
    measureArrows(m_shown, m_session.preview().run().cursor().frame);
    if (!m_session.preview().isActive())
        m_runScales = m_shown.scales;
    describe();
    viewport()->update();
}

void SceneView::setCard(const QRectF &box)
{
    if (box == m_shown.card)
        return;
    m_shown.card = box;
    viewport()->update();
}

void SceneView::takeExtrasOfStep()
{
    Extras extras = m_shown.extras;
    extras.velocities = m_wantsVelocities.value_or(m_shown.view().showsVelocities);
    extras.onion = m_wantsOnion.value_or(m_shown.view().showsOnionSkins);
    if (extras.velocities == m_shown.extras.velocities && extras.onion == m_shown.extras.onion)
        return;
    m_shown.extras = extras;
    refresh();
    emit extrasChanged();
}

void SceneView::takeOnion()
{
    m_shown.onion.clear();
    const sim::Track &track = m_session.timeline().track();
    if (!m_shown.extras.onion || track.state().pointCount() > mostSkinned)
        return;
    // At multiples of `every`, so that an onion skin keeps its position while it fades.
    const std::int64_t every = onionFrames * track.framesPerOutput();
    std::int64_t frame = (track.cursor().frame - 1) / every * every;
    for (int k = 0; k < onionSkins && frame >= 0; ++k, frame -= every) {
        if (frame < track.cursor().frame)
            m_shown.onion.push_back(track.stateAt(frame));
    }
}

void SceneView::attach(const AccuracyStudy &study)
{
    m_study = &study;
    connect(&study, &AccuracyStudy::changed, this, &SceneView::refresh);
    refresh();
}

void SceneView::takeReference()
{
    m_shown.reference.reset();
    const sim::Cursor at = m_session.preview().run().cursor();
    if (m_study && m_study->isActive() && m_study->accuracy() && at.phase == 0)
        m_shown.reference = referencePlaces(m_shown, *m_study->accuracy(), at.frame);
    if (!m_shown.reference || !m_shown.extras.reference)
        return;
    // The reference shows where the bodies should be. The step's own overlays of the exact motion would
    // repeat it.
    std::erase_if(m_shown.picture.overlays, [](const lessons::Overlay &overlay) {
        return overlay.about == lessons::Overlay::About::exactMotion;
    });
}

void SceneView::takeCompanion()
{
    m_companion.picture = m_session.presentation().companion().value_or(Picture());
    const std::optional<lessons::Companion> &companion = m_session.step().companion;
    m_shown.name = companion ? m_session.presentation().ownCaption() : QString();
    m_companion.name = companion ? companion->caption : QString();
    m_companion.shift = companion ? companion->offset : sim::Vec2();
    m_companion.extras = m_shown.extras;
}

void SceneView::drawGrid(QPainter &painter, const QTransform &toView, const QRectF &area) const
{
    double step = dotStep * toView.m11();
    while (step < densest)
        step *= 2.0;
    const auto firstLine = [step](double origin) { return static_cast<int>(std::floor(-origin / step)); };
    QList<QLineF> crosses;
    QList<QPointF> dots;
    for (int row = firstLine(toView.dy()); toView.dy() + row * step < area.bottom() + step; ++row) {
        for (int column = firstLine(toView.dx()); toView.dx() + column * step < area.right() + step;
             ++column) {
            const QPointF at(toView.dx() + column * step, toView.dy() + row * step);
            if (row % crossEvery != 0 || column % crossEvery != 0) {
                dots << at;
                continue;
            }
            crosses << QLineF(at - QPointF(gridArm, 0.0), at + QPointF(gridArm, 0.0))
                    << QLineF(at - QPointF(0.0, gridArm), at + QPointF(0.0, gridArm));
        }
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.tokens().dots);
    for (const QPointF &dot : dots)
        painter.drawEllipse(dot, dotRadius, dotRadius);
    painter.setPen(QPen(m_theme.tokens().dots, 1.3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(crosses);
    painter.setBrush(Qt::NoBrush);
}

void SceneView::drawBackground(QPainter *painter, const QRectF &)
{
    const QTransform toView = painter->worldTransform();
    const QRectF area = viewRect();
    painter->setWorldTransform({});
    const bool isPaper = m_shown.view().sky == lessons::View::Sky::paper;
    if (isPaper)
        painter->fillRect(area, m_theme.tokens().scene);
    else
        m_sky.draw(*painter, area, Camera(toView).at({0.0, horizonOf(m_shown)}).y(), m_theme.scheme());
    if (m_shown.extras.grid && isPaper)
        drawGrid(*painter, toView, area);
    painter->setWorldTransform(toView);
}

QImage SceneView::picture(double scale)
{
    QImage image(viewport()->size() * scale, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    QPainter painter(&image);
    paintPicture(painter);
    return image;
}

void SceneView::paintPicture(QPainter &painter)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setWorldTransform(viewportTransform());
    drawBackground(&painter, {});
    painter.resetTransform();
    m_scene.render(&painter, viewRect(), viewportTransform().inverted().mapRect(viewRect()),
                   Qt::IgnoreAspectRatio);
}

void SceneView::drawForeground(QPainter *painter, const QRectF &)
{
    const QTransform toView = painter->worldTransform();
    painter->setWorldTransform({});
    m_overlay.draw(*painter, Camera(toView), viewRect());
    if (m_picker.isMarked())
        m_picker.draw({*painter, m_shown, m_theme, Camera(toView), viewRect()},
                      m_overlay.labelPlaces(Camera(toView), viewRect()),
                      m_overlay.textBoxes(Camera(toView), viewRect()));
    painter->setWorldTransform(toView);
}

}
