// Every step keeps enough of its bodies in the picture while it runs.

#include "tests/app/scene/scene_support.h"

#include "app/model/experiment/experiment.h"
#include "app/ui/scene/layers/layers.h"
#include "app/ui/scene/layers/sky.h"
#include "tests/suite.h"

#include <QtTest>

#include <cmath>

using namespace app;

namespace {

const LessonLibrary &lessonsOf()
{
    static const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    return library;
}

/// A view on a step of a real lesson, as large as a window of 1280 by 800 px has it.
struct Stage
{
    Session session{lessonsOf()};
    Theme theme{Scheme::light};
    SceneView view{session, theme};

    Stage(const QString &lesson, const QString &step, QSize size = {676, 520})
    {
        view.resize(size);
        view.show();
        session.openStep(lesson, step);
        QApplication::processEvents();
    }

    QPointF onScreen(sim::Vec2 place) const
    {
        return view.viewportTransform().map(QPointF(place.x, place.y));
    }

    /// The end of a branch, by its definition.
    static sim::Vec2 endOf(const Picture &picture, int branch)
    {
        const double angle = picture.state.angle[branch] * 3.14159265358979323846 / 180.0;
        const double length = picture.view->tree->length[static_cast<std::size_t>(branch)];
        const sim::Vec2 at = picture.state.positionOf(branch);
        return {at.x + length * std::cos(angle), at.y + length * std::sin(angle)};
    }

    /// Returns how many bodies, or ends of branches, have their centre outside the view.
    int outside() const
    {
        const Picture picture = session.presentation().picture();
        const QRectF seen(view.viewport()->rect());
        int count = 0;
        for (int i = 0; i < picture.state.pointCount(); ++i)
            count +=
                seen.contains(onScreen(picture.view->tree ? endOf(picture, i) : picture.state.positionOf(i)))
                    ? 0
                    : 1;
        return count;
    }

    /// Returns whether all bodies of the companion are in the picture; false without a companion.
    bool isCompanionSeen() const
    {
        const SceneContent &companion = view.companion();
        const QRectF seen = view.viewport()->rect();
        for (int i = 0; i < companion.points(); ++i) {
            const sim::Vec2 at = companion.state().positionOf(i) + companion.shift;
            if (!seen.contains(onScreen(at)))
                return false;
        }
        return companion.points() > 0;
    }

    /// Whether enough is in the picture: all; or, of a run that is there to blow up, something, as long as there is any
    /// body within half the way to where no picture goes, or else the companion that it is compared with.
    bool isSeen(const QString &lesson) const
    {
        if (lesson != "hard_cases")
            return outside() == 0;
        const sim::State state = session.presentation().picture().state;
        const bool isGone = (state.position.abs().rowwise().maxCoeff() > 0.5 * worldReach).all();
        return isGone || outside() < state.pointCount() || isCompanionSeen();
    }

    void goOn(int frames)
    {
        for (int i = 0; i < frames; ++i) {
            session.playback().frameForward();
            QVERIFY(QTest::qWaitFor([&] { return !session.presentation().isCompanionComing(); }, 60'000));
        }
    }

    void send(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons buttons)
    {
        QMouseEvent event(type, at, view.mapToGlobal(at.toPoint()), button, buttons, {});
        QApplication::sendEvent(view.viewport(), &event);
    }
    void press(QPointF at) { send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton); }
    void move(QPointF at) { send(QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton); }
    void release(QPointF at) { send(QEvent::MouseButtonRelease, at, Qt::LeftButton, {}); }
};

void addAllSteps()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    for (const LessonEntry &lesson : lessonsOf().lessons) {
        for (const lessons::Step &step : lesson.steps)
            QTest::newRow(qPrintable(lesson.id + '/' + step.id)) << lesson.id << step.id;
    }
}

}

class SceneMotionTest : public QObject
{
    Q_OBJECT

private slots:
    void aStepPlaysInsideItsPicture_data() { addAllSteps(); }
    void aStepPlaysInsideItsPicture();
    void afterADragAllBodiesAreSeenAgain_data() { addAllSteps(); }
    void afterADragAllBodiesAreSeenAgain();
    void aTreeThatTheWindLaysDownIsSeenBelowTheGround_data();
    void aTreeThatTheWindLaysDownIsSeenBelowTheGround();
};

void SceneMotionTest::aStepPlaysInsideItsPicture()
{
    QFETCH(QString, lesson);
    QFETCH(QString, step);
    Stage stage(lesson, step);
    QCOMPARE(stage.outside(), 0);
    const double before = stage.view.zoom();
    double least = before;
    for (int frame = 1; frame <= 200; ++frame) {
        stage.goOn(1);
        QVERIFY2(stage.isSeen(lesson), qPrintable(QString("frame %1: %2").arg(frame).arg(stage.outside())));
        least = std::min(least, stage.view.zoom());
    }
    QVERIFY2(lesson == "hard_cases" || least > 0.7 * before,
             qPrintable(QString("%1 to %2").arg(before).arg(least)));
    stage.session.playback().goTo({0, 0});
    QTRY_VERIFY(!stage.session.playback().goal());
    QCOMPARE(stage.view.zoom(), before);
    QCOMPARE(stage.outside(), 0);
}

void SceneMotionTest::afterADragAllBodiesAreSeenAgain()
{
    QFETCH(QString, lesson);
    QFETCH(QString, step);
    Stage stage(lesson, step);
    const Picture picture = stage.session.presentation().picture();
    for (const QPointF by : {QPointF(-260, -180), QPointF(300, 20)}) {
        stage.session.editor().startAfresh();
        const int point = picture.interval->scene.find(stage.session.selected().toStdString());
        const QPointF at =
            stage.onScreen(stage.session.presentation().picture().state.positionOf(std::max(0, point)));
        stage.session.playback().play();
        stage.press(at);
        stage.move(at + by);
        stage.session.playback().pause();
        // A drag on the background pans the picture. Some body stays visible.
        const bool isPan = stage.session.timeline().script().input.empty();
        stage.goOn(5);
        stage.release(at + by);
        for (int frame = 0; frame < 60; ++frame) {
            stage.goOn(1);
            QVERIFY2(isPan ? stage.outside() < picture.state.pointCount() : stage.isSeen(lesson),
                     qPrintable(QString("frame %1: %2").arg(frame).arg(stage.outside())));
        }
    }
}

void SceneMotionTest::aTreeThatTheWindLaysDownIsSeenBelowTheGround_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<int>("scheme");
    for (const char *step : {"towards_pointer", "wind", "rest", "real_sway"}) {
        for (const Scheme scheme : {Scheme::light, Scheme::dark, Scheme::highContrast})
            QTest::addRow("%s %d", step, int(scheme)) << QString(step) << int(scheme);
    }
}

void SceneMotionTest::aTreeThatTheWindLaysDownIsSeenBelowTheGround()
{
    QFETCH(QString, step);
    QFETCH(int, scheme);
    Stage stage("swaying_tree", step);
    stage.theme.setScheme(static_cast<Scheme>(scheme));
    const QPointF pointer = stage.onScreen({60, 330});
    stage.press(pointer);
    stage.goOn(25);
    QCOMPARE(stage.outside(), 0);
    stage.release(pointer);
    stage.goOn(1);
    QCOMPARE(stage.outside(), 0);
    const Picture picture = stage.session.presentation().picture();
    const QImage image = stage.view.picture();
    const QColor meadow = skyColors(static_cast<Scheme>(scheme)).meadow;
    int buried = 0;
    for (int i = 0; i < picture.state.pointCount(); ++i) {
        const sim::Vec2 from = picture.state.positionOf(i), to = Stage::endOf(picture, i);
        const sim::Vec2 middle{(from.x + to.x) / 2.0, (from.y + to.y) / 2.0};
        if (middle.y < 420.0)
            continue;
        ++buried;
        const QColor ink = image.pixelColor(stage.onScreen(middle).toPoint());
        const int apart = std::abs(ink.red() - meadow.red()) + std::abs(ink.green() - meadow.green()) +
                          std::abs(ink.blue() - meadow.blue());
        QVERIFY2(apart > 40, qPrintable(QString("branch %1: %2").arg(i).arg(ink.name())));
    }
    if (step == "wind")
        QVERIFY(buried > 10);
}

SUITE(tst_scene_motion, SceneMotionTest)
#include "tst_scene_motion.moc"
