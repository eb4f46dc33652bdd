// One cursor for picture, code, values, plots and timeline: where the mouse is in one of them is seen in all others.

#include "cursor_bench.h"

#include "app/ui/code/code_panel.h"
#include "app/ui/code/code_view.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/energy/energy_plot.h"
#include "app/ui/panels/measure_row.h"
#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/time/footfall_strip.h"
#include "app/ui/time/frame_counter.h"
#include "app/ui/time/timeline_strip.h"

#include <QAccessible>
#include <QLabel>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

using namespace app;
using cursor_bench::Bench;
using cursor_bench::stands;

namespace {

/// All that a learner sees and that a look must give back.
struct Sight
{
    explicit Sight(Bench &bench)
        : picture(bench.view.picture()), chips(bench.code.view().values()),
          line(bench.code.view().firstVisibleLine()), status(bench.status()), counter(bench.counter.text()),
          timeline(bench.timeline.grab().toImage()), plot(bench.plot().grab().toImage()),
          code(bench.code.view().viewport()->grab().toImage())
    {
        for (const MeasureRow *row : bench.window.findChildren<MeasureRow *>())
            numbers << row->number();
        for (const EnergyLine &one : bench.energy.lines())
            numbers << one.number;
    }
    friend bool operator==(const Sight &, const Sight &) = default;

    QImage picture;
    std::vector<CodeChip> chips;
    int line;
    QString status, counter;
    QImage timeline, plot, code;
    QStringList numbers;
};

}

class TestOneCursor : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName("springstep-test");
        QCoreApplication::setApplicationName("one_cursor");
        QVERIFY(m_settings.isValid());
        window_bench::keepSettingsIn(m_settings.path());
    }

    void whereTheMouseIsInAPlotOrOnTheTimelineIsShownEverywhere_data()
    {
        QTest::addColumn<int>("where");
        QTest::newRow("a plot") << 0;
        QTest::newRow("the plot of energy") << 1;
        QTest::newRow("the timeline") << 2;
    }
    void whereTheMouseIsInAPlotOrOnTheTimelineIsShownEverywhere()
    {
        QFETCH(int, where);
        Bench bench;
        const Sight before(bench);
        const std::pair<QWidget *, QPointF> targets[] = {{&bench.plot(), bench.onPlot(20.0)},
                                                         {&bench.energy.plot(), bench.onEnergy(20.0)},
                                                         {&bench.timeline, bench.onTrack(20)}};
        bench.hover(*targets[where].first, targets[where].second);
        QVERIFY(bench.session.isGlancing());
        const std::int64_t frame = bench.session.shown().cursor().frame;
        QVERIFY(std::abs(frame - 20) <= 1);
        QVERIFY(QLineF(bench.shown("foot0"), bench.places(frame, "foot0")).length() < 1e-9);
        QVERIFY(QLineF(bench.shown("foot0"), bench.places(stands, "foot0")).length() > 1e-3);
        QCOMPARE(bench.plot().hovered(), frame);
        QCOMPARE(bench.energy.plot().hovered(), frame);
        QCOMPARE(bench.timeline.pointed(), frame);
        QVERIFY(bench.code.view().values() != before.chips);
        QVERIFY(Sight(bench).numbers != before.numbers);
        const QString said = QString("frame %1").arg(frame);
        QVERIFY2(bench.status().contains(said), qPrintable(bench.status()));
        QVERIFY2(bench.view.caption().contains(said), qPrintable(bench.view.caption()));
        QVERIFY2(bench.counter.text().contains(said), qPrintable(bench.counter.text()));
        QVERIFY(bench.counter.text().contains("60"));
        QCOMPARE(bench.session.timeline().cursor(), (sim::Cursor{stands, 0}));
        bench.park();
        const Sight after(bench);
        QCOMPARE(after.picture, before.picture);
        QCOMPARE(after.timeline, before.timeline);
        QCOMPARE(after.plot, before.plot);
        QCOMPARE(after.code, before.code);
        QVERIFY(after == before);
    }

    void aPictureThatWalkedAlongGoesBackAndComesAgain()
    {
        Bench bench("walking_gait", "ground");
        bench.goTo(900);
        bench.goTo(820); // the picture stays: coming from the left it would stand elsewhere
        bench.park();
        const QTransform before = bench.view.viewportTransform();
        const QImage picture = bench.view.picture();
        bench.hover(bench.timeline, bench.onTrack(20));
        QVERIFY(bench.session.isGlancing());
        QVERIFY(bench.view.viewportTransform() != before);
        QVERIFY(bench.view.viewport()->rect().contains(bench.view.mapFromScene(bench.shown("body"))));
        bench.park();
        QCOMPARE(bench.view.viewportTransform(), before);
        QCOMPARE(bench.view.picture(), picture);
    }

    void whereTheMouseIsUnderTheFeetIsShownToo()
    {
        Bench bench("walking_gait", "ground");
        auto &feet = *bench.window.findChild<FootfallStrip *>();
        QVERIFY(feet.isVisible());
        bench.hover(feet, {bench.timeline.axis().xOf(20), feet.height() / 2.0});
        QVERIFY(bench.session.isGlancing());
        QCOMPARE(bench.timeline.pointed(), bench.session.shown().cursor().frame);
        bench.park();
        QVERIFY(!bench.session.marked());
    }

    void whoCannotSeeItHearsWhatIsLookedAt()
    {
        Bench bench;
        bench.hover(bench.plot(), bench.onPlot(20.0));
        const QString frame = QString("frame %1").arg(bench.session.shown().cursor().frame);
        const auto says = [&](QWidget &widget, QAccessible::Text kind) {
            const QString text = bench.spoken(widget, kind);
            return text.contains(frame, Qt::CaseInsensitive) ? QString() : text;
        };
        QCOMPARE(says(bench.plot(), QAccessible::Value), QString());
        QCOMPARE(says(bench.energy.plot(), QAccessible::Value), QString());
        QCOMPARE(says(bench.timeline, QAccessible::Value), QString());
        QCOMPARE(says(bench.view, QAccessible::Description), QString());
        QCOMPARE(says(bench.counter, QAccessible::Name), QString());
    }

    void aPressGoesThere()
    {
        Bench bench;
        bench.hover(bench.plot(), bench.onPlot(20.0));
        QTest::mouseClick(&bench.plot(), Qt::LeftButton, {}, bench.onPlot(20.0).toPoint());
        QVERIFY(!bench.session.isGlancing());
        QCOMPARE(bench.session.timeline().cursor().frame, 20);
        QVERIFY(QLineF(bench.shown("foot0"), bench.places(20, "foot0")).length() < 1e-9);
    }

    void aKeyCarriesABodyFromWhereTheRunStands()
    {
        Bench bench;
        bench.session.select("foot0");
        const QPointF from = bench.shown("foot0");
        bench.hover(bench.plot(), bench.onPlot(20.0));
        QVERIFY(bench.shown("foot0") != from);
        bench.view.setFocus();
        bench.press(Qt::Key_Right, Qt::AltModifier);
        QVERIFY(!bench.session.isGlancing());
        QVERIFY(QLineF(bench.shown("foot0"), from + QPointF(10.0, 0.0)).length() < 1e-9);
        QCOMPARE(bench.session.timeline().cursor().frame, stands);
    }

    void theCursorThatKeysMoveTakesAllWithIt()
    {
        Bench bench;
        bench.plot().setFocus();
        QTest::keyClick(&bench.plot(), Qt::Key_Left);
        QCOMPARE(bench.session.timeline().cursor().frame, stands - 1);
        QVERIFY(QLineF(bench.shown("foot0"), bench.places(stands - 1, "foot0")).length() < 1e-9);
        QCOMPARE(bench.timeline.frame(), stands - 1);
        QVERIFY(bench.spoken(bench.plot(), QAccessible::Value).contains("frame 59"));
    }

    void aPhaseUnderTheMouseShowsWhatThereIsAfterIt()
    {
        Bench bench;
        const Sight before(bench);
        bench.hover(bench.timeline, bench.onPhase(1));
        QVERIFY(bench.session.isGlancing());
        QCOMPARE(bench.session.shown().cursor(), (sim::Cursor{stands, 2}));
        QVERIFY2(bench.view.caption().contains("Inside frame 60"), qPrintable(bench.view.caption()));
        QVERIFY(bench.code.view().values() != before.chips);
        QCoreApplication::processEvents();
        QVERIFY(bench.plot().insidePlace()); // beside the cursor's own dot
        bench.park();
        QVERIFY(!bench.plot().insidePlace());
        QVERIFY(Sight(bench) == before);
        QCOMPARE(bench.session.timeline().cursor(), (sim::Cursor{stands, 0}));
    }

    void aLineOfCodeMarksItsPhaseAndShowsItInsideAFrameOnly()
    {
        Bench bench;
        const QPointF line = bench.onCode("radialSpring(");
        const QImage strip = bench.timeline.grab().toImage();
        const std::vector<CodeChip> chips = bench.code.view().values();
        bench.hover(*bench.code.view().viewport(), line);
        QVERIFY(bench.session.marked() && !bench.session.isGlancing());
        QCOMPARE(bench.session.marked()->frame, stands);
        QVERIFY(!bench.plot().hovered()); // its cursor is there already
        QVERIFY(bench.timeline.grab().toImage() != strip);
        bench.park();
        QCOMPARE(bench.timeline.grab().toImage(), strip);

        bench.session.goTo({stands, 3});
        QCoreApplication::processEvents();
        const QPointF inside = bench.onCode("radialSpring(");
        const Sight before(bench);
        bench.hover(*bench.code.view().viewport(), inside);
        QVERIFY(bench.session.isGlancing());
        QCOMPARE(bench.session.shown().cursor().frame, stands);
        QCOMPARE(bench.code.view().values(), before.chips); // what is under the mouse stays
        bench.park();
        QVERIFY(Sight(bench) == before);
    }

    void aTrailTellsWhenABodyWasThere()
    {
        Bench bench("walking_gait", "ground");
        for (std::int64_t frame = stands - 15; frame <= stands; ++frame)
            bench.goTo(frame); // only one after the other do they leave a trail
        const auto &marks = bench.view.shown().trail.marks();
        QVERIFY(marks.size() > 10);
        const auto body = bench.view.shown().picture.interval->scene.find("body");
        const Trail::Mark mark = marks[1];
        const sim::State now = bench.view.shown().state();
        const QImage before = bench.view.picture();
        const QPointF there(mark.position(body, 0), mark.position(body, 1));
        bench.hover(*bench.view.viewport(), bench.view.mapFromScene(there));
        QCOMPARE(bench.session.marked(), (sim::Cursor{mark.frame, 0}));
        QCOMPARE(bench.timeline.pointed(), mark.frame);
        QCOMPARE(bench.plot().hovered(), mark.frame);
        QVERIFY(sim::sameBits(bench.view.shown().state(), now)); // the figure stays under the hand
        QVERIFY(bench.view.shown().past);
        QCOMPARE(bench.view.shown().past->state.frame, mark.frame);
        QVERIFY(bench.view.picture() != before);
        bench.park();
        QVERIFY(!bench.session.marked());
        QCOMPARE(bench.view.picture(), before);
    }

    void noButtonMovesForALook()
    {
        Bench bench;
        const auto places = [&] {
            QList<QRect> all;
            for (const QWidget *one : bench.counter.parentWidget()->findChildren<QToolButton *>())
                all << one->geometry();
            return all;
        };
        for (const int width : {1280, 1366, 1920}) {
            bench.window.resize(width, 900);
            bench.settle();
            const QList<QRect> before = places();
            QVERIFY(before.size() > 5);
            bench.hover(bench.timeline, bench.onTrack(20));
            QVERIFY(bench.session.isGlancing());
            QCoreApplication::processEvents();
            QCOMPARE(places(), before);
            bench.park();
        }
    }

    void theCurvesOfTheBodyUnderTheMouseAreThicker()
    {
        Bench bench;
        const QString body = bench.session.selected();
        const QPointF at = bench.shown(qPrintable(body));
        QVERIFY(!bench.plot().isThick());
        bench.hover(*bench.view.viewport(), bench.view.mapFromScene(at));
        QVERIFY(bench.plot().isThick());
        QVERIFY(!bench.session.marked()); // it is where it is
        bench.park();
        QVERIFY(!bench.plot().isThick());
    }

    void whileTheRunPlaysTheMouseOnlyMarks()
    {
        Bench bench;
        bench.session.play();
        bench.hover(bench.plot(), bench.onPlot(20.0));
        QCOMPARE(bench.plot().hovered(), bench.session.marked()->frame);
        QVERIFY(!bench.session.isGlancing());
        bench.session.pause();
    }

private:
    QTemporaryDir m_settings;
};

QTEST_MAIN(TestOneCursor)
#include "tst_one_cursor.moc"
