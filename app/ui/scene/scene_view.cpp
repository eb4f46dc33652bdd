#include "app/ui/scene/scene_view.h"

#include "app/model/accuracy_study.h"
#include "app/model/player.h"
#include "app/ui/scene/body_text.h"
#include "app/ui/scene/layers.h"
#include "app/ui/scene/reference_marks.h"
#include "lessons/api/view/view.h"
#include "sim/run/phase_before.h"
#include "sim/run/script/composed_interval.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double dotStep = 25.0;    ///< px
constexpr double dotRadius = 1.3;   ///< px of the screen
constexpr int crossEvery = 4;       ///< dots, where a cross is drawn instead
constexpr double gridArm = 4.0;     ///< px of the screen
constexpr double densest = 18.0;    ///< px of the screen between two dots
constexpr int mostSkinned = 20'000; ///< points: earlier moments of more would take too long to find again
constexpr double ghostShows = 1e-9; ///< px: a ghost that is closer to the run is not drawn

template <class... Layers>
void addLayers(QGraphicsScene &scene, const Shown &shown, const Theme &theme)
{
    (scene.addItem(new Layers(shown, theme)), ...);
}

bool differ(const Picture &a, const Picture &b)
{
    return a.state.pointCount() != b.state.pointCount() ||
           ((a.state.position - b.state.position).abs() > ghostShows).any();
}

}

SceneView::SceneView(Session &session, const Theme &theme, QWidget *parent)
    : QGraphicsView(parent), m_session(session), m_theme(theme), m_overlay(m_shown, m_beside, theme),
      m_hand(session), m_tools(session)
{
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setOptimizationFlags(DontSavePainterState | DontAdjustForAntialiasing);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTransformationAnchor(NoAnchor);
    setResizeAnchor(AnchorViewCenter);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(240, 160);
    setAccessibleName(tr("Scene"));
    viewport()->setMouseTracking(true);

    m_scene.setItemIndexMethod(QGraphicsScene::NoIndex);
    m_scene.setSceneRect(-worldReach, -worldReach, 2.0 * worldReach, 2.0 * worldReach);
    addLayers<RoomLayer, RampLayer, GroundLayer, ShadowLayer, GhostLayer, OnionLayer, TrailLayer, TreeLayer,
              MeadowLayer, LimbLayer, SkinLayer, SheetLayer, ChainLayer, LegLayer, SpringLayer, StickLayer,
              BodyLayer, RestLayer, ReferenceLayer, GuideLayer, ArrowLayer>(m_scene, m_shown, theme);
    addLayers<RoomLayer, ShadowLayer, LimbLayer, SkinLayer, ChainLayer, LegLayer, SpringLayer, StickLayer,
              BodyLayer, RestLayer, GuideLayer, NameLayer>(m_scene, m_beside, theme);
    m_scene.addItem(new NameLayer(m_shown, theme));
    m_scene.addItem(new RecordedHandLayer(session, m_shown, theme));
    setScene(&m_scene);

    connect(&session, &Session::stepOpened, this, &SceneView::open);
    connect(&session, &Session::moved, this, &SceneView::refresh);
    connect(&session, &Session::glanceChanged, this, &SceneView::followGlance);
    connect(&session, &Session::runChanged, this, [this] {
        m_motion.reset();
        refresh();
    });
    connect(&session, &Session::selectionChanged, this, &SceneView::refresh);
    connect(&session, &Session::playingChanged, this, &SceneView::refresh);
    connect(&theme, &Theme::changed, this, &SceneView::readTheme);
    readTheme();
    open();
}

SceneView::~SceneView()
{
    // The scene dies before the view does: the view must not ask it anything then.
    setScene(nullptr);
}

void SceneView::readTheme()
{
    m_shown.text = m_theme.ui(12);
    m_shown.figures = m_theme.ui(12, QFont::DemiBold);
    m_beside.text = m_shown.text;
    m_beside.figures = m_shown.figures;
    viewport()->update();
}

void SceneView::open()
{
    m_hand.letGo();
    m_tools.letUp();
    m_shown.trail.clear();
    m_runScales = {};
    m_follows = true;
    m_atHome = false; // another scene is shown as a whole
    m_motion.reset();
    refresh();
    takeExtrasOfStep();
    showHome();
}

void SceneView::refresh()
{
    if (m_looksBack && m_session.isGlancing())
        return;
    takeMoment();
    if (!m_session.isGlancing()) { // what was stays that of the run
        m_shown.trail.follow(m_session.timeline());
        takeOnion();
        if (m_atHome && m_shown.look().stage != m_stage)
            showHome(); // the scene has another size now
    }
    m_shown.selected = m_shown.picture.interval->scene.find(m_session.selected().toStdString());
    m_shown.scales = m_runScales;
    measureArrows(m_shown, m_session.shown().cursor().frame);
    if (!m_session.isGlancing())
        m_runScales = m_shown.scales;
    if (!m_session.isPlaying())
        describe();
    keepSubject();
    updateCursor();
    viewport()->update();
}

void SceneView::takeMoment()
{
    m_shown.picture = m_session.picture();
    m_shown.ghost = m_session.ghost();
    if (m_shown.ghost && !differ(*m_shown.ghost, m_shown.picture))
        m_shown.ghost.reset();
    m_shown.ghostName = m_session.ghostName();
    takePulls();
    takeCaption();
    takeReference();
    takeCompanion();
}

void SceneView::takePulls()
{
    const sim::Timeline &timeline = m_session.shown();
    m_shown.isInside = timeline.cursor().phase > 0 && m_wantsVelocities.value_or(true);
    m_shown.before.reset();
    if (m_shown.isInside && !m_shown.isCrowd())
        m_shown.before = sim::stateBeforeLastPhase(timeline.track());
    m_shown.pullsAreAll = m_shown.extras.pulls && timeline.cursor().phase == 0;
    m_shown.gathered = m_shown.pullsAreAll ? sim::currentForces(timeline.track()) : m_session.gathered();
    m_shown.clock =
        tr("frame %1 = %2\u2009s")
            .arg(timeline.cursor().frame)
            .arg(QLocale().toString(double(timeline.cursor().frame) / Player::framesPerSecond, 'f', 2));
}

void SceneView::describe()
{
    QString text;
    if (m_shown.selected >= 0)
        text = bodySentence(m_session.selected(), m_shown.state().positionOf(m_shown.selected),
                            m_shown.state().velocityOf(m_shown.selected));
    if (!m_shown.caption.isEmpty())
        text += ". " + m_shown.caption;
    if (const std::optional<sim::Vec2> hand = m_session.recordedHand())
        text +=
            ". " +
            tr("The hand of the recorded run is at %1, %2").arg(hand->x, 0, 'f', 0).arg(hand->y, 0, 'f', 0);
    if (m_beside.points() > 0)
        text += ". " + tr("Beside it: %1").arg(m_beside.name);
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
    if (extras.ruler && !m_shown.extras.ruler) { // it comes to the middle of what is seen
        const QPointF middle = viewRect().center();
        m_shown.ruler = {camera().back(middle - QPointF(80.0, 0.0)),
                         camera().back(middle + QPointF(80.0, 0.0))};
    }
    m_shown.extras = extras;
    refresh();
}

void SceneView::takeExtrasOfStep()
{
    Extras extras = m_shown.extras;
    extras.velocities = m_wantsVelocities.value_or(m_shown.look().showsVelocities);
    extras.onion = m_wantsOnion.value_or(m_shown.look().showsOnionSkins);
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
    // At whole multiples, so that a skin stays where it is while it fades.
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
    const sim::Cursor at = m_session.shown().cursor();
    if (m_study && m_study->isWatched() && m_study->accuracy() && at.phase == 0)
        m_shown.reference = referencePlaces(m_shown, *m_study->accuracy(), at.frame);
    if (!m_shown.reference || !m_shown.extras.reference)
        return;
    // The reference shows where the bodies should be: a step's guides of the same would say it twice.
    std::erase_if(m_shown.picture.guides, [](const lessons::Overlay &guide) {
        return guide.about == lessons::Overlay::About::exactMotion;
    });
}

void SceneView::takeCompanion()
{
    m_beside.picture = m_session.companion().value_or(Picture());
    const std::optional<lessons::Companion> &companion = m_session.step().companion;
    m_shown.name = companion ? m_session.ownCaption() : QString();
    m_beside.name = companion ? companion->caption : QString();
    m_beside.shift = companion ? companion->offset : sim::Vec2();
    m_beside.extras = m_shown.extras;
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
    const bool isPaper = m_shown.look().sky == lessons::View::Sky::paper;
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
    painter->setWorldTransform(toView);
}

}
