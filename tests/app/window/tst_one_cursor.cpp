// One cursor for picture, code, values, plots and timeline: hovering one of them marks the moment in all others.

#include "tests/app/window/cursor_support.h"

#include "app/ui/code/engine/code_panel.h"
#include "app/ui/code/engine/code_view.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/energy/energy_plot.h"
#include "app/ui/parameters/measure_row.h"
#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/time/footfall_strip.h"
#include "app/ui/time/frame_counter.h"
#include "app/ui/time/timeline_strip.h"
#include "tests/suite.h"

#include <QAccessible>
#include <QLabel>
#include <QStatusBar>
#include <QToolButton>
#include <QtTest>

using namespace app;
using cursor_support::currentFrame;
using cursor_support::CursorFixture;

namespace {

/// Everything on the screen that a preview must restore.
struct Sight
{
    explicit Sight(CursorFixture &fixture)
        : picture(fixture.view.picture()), chips(fixture.code.view().values()),
          line(fixture.code.view().firstVisibleLine()), status(fixture.status()),
          counter(fixture.counter.text()), timeline(fixture.timeline.grab().toImage()),
          plot(fixture.plot().grab().toImage()), code(fixture.code.view().viewport()->grab().toImage())
    {
        for (const MeasureRow *row : fixture.window.findChildren<MeasureRow *>())
            numbers << row->number();
        for (const EnergyLine &one : fixture.energy.lines())
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
    void theFrameUnderTheMouseIsShownEverywhere_data()
    {
        QTest::addColumn<int>("where");
        QTest::newRow("a plot") << 0;
        QTest::newRow("the plot of energy") << 1;
        QTest::newRow("the timeline") << 2;
    }
    void theFrameUnderTheMouseIsShownEverywhere()
    {
        QFETCH(int, where);
        CursorFixture fixture;
        const Sight before(fixture);
        const std::pair<QWidget *, QPointF> targets[] = {{&fixture.plot(), fixture.onPlot(20.0)},
                                                         {&fixture.energy.plot(), fixture.onEnergy(20.0)},
                                                         {&fixture.timeline, fixture.onTrack(20)}};
        fixture.hover(*targets[where].first, targets[where].second);
        QVERIFY(fixture.session.preview().isActive());
        const std::int64_t frame = fixture.session.preview().run().cursor().frame;
        QVERIFY(std::abs(frame - 20) <= 1);
        QVERIFY(QLineF(fixture.shown("foot0"), fixture.places(frame, "foot0")).length() < 1e-9);
        QVERIFY(QLineF(fixture.shown("foot0"), fixture.places(currentFrame, "foot0")).length() > 1e-3);
        QCOMPARE(fixture.plot().hovered(), frame);
        QCOMPARE(fixture.energy.plot().hovered(), frame);
        QCOMPARE(fixture.timeline.pointed(), frame);
        QVERIFY(fixture.code.view().values() != before.chips);
        QVERIFY(Sight(fixture).numbers != before.numbers);
        const QString said = QString("frame %1").arg(frame);
        QVERIFY2(fixture.status().contains(said), qPrintable(fixture.status()));
        QVERIFY2(fixture.view.caption().contains(said), qPrintable(fixture.view.caption()));
        QVERIFY2(fixture.counter.text().contains(said), qPrintable(fixture.counter.text()));
        QVERIFY(fixture.counter.text().contains("60"));
        QCOMPARE(fixture.session.timeline().cursor(), (sim::Cursor{currentFrame, 0}));
        fixture.park();
        const Sight after(fixture);
        QCOMPARE(after.picture, before.picture);
        QCOMPARE(after.timeline, before.timeline);
        QCOMPARE(after.plot, before.plot);
        QCOMPARE(after.code, before.code);
        QVERIFY(after == before);
    }

    void aPictureThatWalkedAlongGoesBackAndComesAgain()
    {
        CursorFixture fixture("walking_gait", "ground");
        fixture.goTo(900);
        fixture.goTo(820); // the picture stays: coming from the left it would stand elsewhere
        fixture.park();
        const QTransform before = fixture.view.viewportTransform();
        const QImage picture = fixture.view.picture();
        fixture.hover(fixture.timeline, fixture.onTrack(20));
        QVERIFY(fixture.session.preview().isActive());
        QVERIFY(fixture.view.viewportTransform() != before);
        QVERIFY(fixture.view.viewport()->rect().contains(fixture.view.mapFromScene(fixture.shown("body"))));
        fixture.park();
        QCOMPARE(fixture.view.viewportTransform(), before);
        QCOMPARE(fixture.view.picture(), picture);
    }

    void theFrameUnderTheMouseInTheFootfallStripIsShownToo()
    {
        CursorFixture fixture("walking_gait", "ground");
        auto &feet = *fixture.window.findChild<FootfallStrip *>();
        QVERIFY(feet.isVisible());
        fixture.hover(feet, {fixture.timeline.axis().xOf(20), feet.height() / 2.0});
        QVERIFY(fixture.session.preview().isActive());
        QCOMPARE(fixture.timeline.pointed(), fixture.session.preview().run().cursor().frame);
        fixture.park();
        QVERIFY(!fixture.session.preview().marked());
    }

    void feetThatAParameterAddsDuringTheRunAreShown()
    {
        CursorFixture fixture("walking_gait", "more_feet");
        const auto &feet = *fixture.window.findChild<FootfallStrip *>();
        const auto shown = [&] { return feet.sentence().count(". ") + 1; };
        QCOMPARE(shown(), 5);
        fixture.session.editor().setParameter("feet", 8);
        fixture.goTo(fixture.session.timeline().cursor().frame + 10);
        QTRY_COMPARE(shown(), 8);
    }

    void screenReadersHearThePreviewedFrame()
    {
        CursorFixture fixture;
        fixture.hover(fixture.plot(), fixture.onPlot(20.0));
        const QString frame = QString("frame %1").arg(fixture.session.preview().run().cursor().frame);
        const auto says = [&](QWidget &widget, QAccessible::Text kind) {
            const QString text = fixture.spoken(widget, kind);
            return text.contains(frame, Qt::CaseInsensitive) ? QString() : text;
        };
        QCOMPARE(says(fixture.plot(), QAccessible::Value), QString());
        QCOMPARE(says(fixture.energy.plot(), QAccessible::Value), QString());
        QCOMPARE(says(fixture.timeline, QAccessible::Value), QString());
        QCOMPARE(says(fixture.view, QAccessible::Description), QString());
        QCOMPARE(says(fixture.counter, QAccessible::Name), QString());
    }

    void aPressGoesThere()
    {
        CursorFixture fixture;
        fixture.hover(fixture.plot(), fixture.onPlot(20.0));
        QTest::mouseClick(&fixture.plot(), Qt::LeftButton, {}, fixture.onPlot(20.0).toPoint());
        QVERIFY(!fixture.session.preview().isActive());
        QCOMPARE(fixture.session.timeline().cursor().frame, 20);
        QVERIFY(QLineF(fixture.shown("foot0"), fixture.places(20, "foot0")).length() < 1e-9);
    }

    void aKeyCarriesABodyFromWhereTheRunStands()
    {
        CursorFixture fixture;
        fixture.session.select("foot0");
        const QPointF from = fixture.shown("foot0");
        fixture.hover(fixture.plot(), fixture.onPlot(20.0));
        QVERIFY(fixture.shown("foot0") != from);
        fixture.view.setFocus();
        fixture.key(Qt::Key_Right, Qt::AltModifier);
        QVERIFY(!fixture.session.preview().isActive());
        QVERIFY(QLineF(fixture.shown("foot0"), from + QPointF(10.0, 0.0)).length() < 1e-9);
        QCOMPARE(fixture.session.timeline().cursor().frame, currentFrame);
    }

    void theCursorThatKeysMoveTakesAllWithIt()
    {
        CursorFixture fixture;
        fixture.plot().setFocus();
        QTest::keyClick(&fixture.plot(), Qt::Key_Left);
        QCOMPARE(fixture.session.timeline().cursor().frame, currentFrame - 1);
        QVERIFY(QLineF(fixture.shown("foot0"), fixture.places(currentFrame - 1, "foot0")).length() < 1e-9);
        QCOMPARE(fixture.timeline.frame(), currentFrame - 1);
        QVERIFY(fixture.spoken(fixture.plot(), QAccessible::Value).contains("frame 59"));
    }

    void aPhaseUnderTheMouseShowsWhatThereIsAfterIt()
    {
        CursorFixture fixture;
        const Sight before(fixture);
        fixture.hover(fixture.timeline, fixture.onPhase(1));
        QVERIFY(fixture.session.preview().isActive());
        QCOMPARE(fixture.session.preview().run().cursor(), (sim::Cursor{currentFrame, 2}));
        QVERIFY2(fixture.view.caption().contains("Inside frame 60"), qPrintable(fixture.view.caption()));
        QVERIFY(fixture.code.view().values() != before.chips);
        QCoreApplication::processEvents();
        QVERIFY(fixture.plot().insidePlace()); // beside the cursor's own dot
        fixture.park();
        QVERIFY(!fixture.plot().insidePlace());
        QVERIFY(Sight(fixture) == before);
        QCOMPARE(fixture.session.timeline().cursor(), (sim::Cursor{currentFrame, 0}));
    }

    void aLineOfCodeMarksItsPhaseAndShowsItInsideAFrameOnly()
    {
        CursorFixture fixture;
        const QPointF line = fixture.onCode("radialSpring(");
        const QImage strip = fixture.timeline.grab().toImage();
        const std::vector<CodeChip> chips = fixture.code.view().values();
        fixture.hover(*fixture.code.view().viewport(), line);
        QVERIFY(fixture.session.preview().marked() && !fixture.session.preview().isActive());
        QCOMPARE(fixture.session.preview().marked()->frame, currentFrame);
        QVERIFY(!fixture.plot().hovered()); // its cursor is there already
        QVERIFY(fixture.timeline.grab().toImage() != strip);
        fixture.park();
        QCOMPARE(fixture.timeline.grab().toImage(), strip);

        fixture.session.playback().goTo({currentFrame, 3});
        QCoreApplication::processEvents();
        const QPointF inside = fixture.onCode("radialSpring(");
        const Sight before(fixture);
        fixture.hover(*fixture.code.view().viewport(), inside);
        QVERIFY(fixture.session.preview().isActive());
        QCOMPARE(fixture.session.preview().run().cursor().frame, currentFrame);
        QCOMPARE(fixture.code.view().values(), before.chips); // what is under the mouse stays
        fixture.park();
        QVERIFY(Sight(fixture) == before);
    }

    void aTrailTellsWhenABodyWasThere()
    {
        CursorFixture fixture("walking_gait", "ground");
        for (std::int64_t frame = currentFrame - 15; frame <= currentFrame; ++frame)
            fixture.goTo(frame); // only one after the other do they leave a trail
        const auto &marks = fixture.view.shown().trail.marks();
        QVERIFY(marks.size() > 10);
        const auto body = fixture.view.shown().picture.interval->scene.find("body");
        const Trail::Mark mark = marks[1];
        const sim::State now = fixture.view.shown().state();
        const QImage before = fixture.view.picture();
        const QPointF there(mark.position(body, 0), mark.position(body, 1));
        fixture.hover(*fixture.view.viewport(), fixture.view.mapFromScene(there));
        QCOMPARE(fixture.session.preview().marked(), (sim::Cursor{mark.frame, 0}));
        QCOMPARE(fixture.timeline.pointed(), mark.frame);
        QCOMPARE(fixture.plot().hovered(), mark.frame);
        QVERIFY(sim::sameBits(fixture.view.shown().state(), now)); // the figure stays under the mouse
        QVERIFY(fixture.view.shown().past);
        QCOMPARE(fixture.view.shown().past->state.frame, mark.frame);
        QVERIFY(fixture.view.picture() != before);
        fixture.park();
        QVERIFY(!fixture.session.preview().marked());
        QCOMPARE(fixture.view.picture(), before);
    }

    void noButtonMovesForAPreview()
    {
        CursorFixture fixture;
        const auto places = [&] {
            QList<QRect> all;
            for (const QWidget *one : fixture.counter.parentWidget()->findChildren<QToolButton *>())
                all << one->geometry();
            return all;
        };
        for (const int width : {1280, 1366, 1920}) {
            fixture.window.resize(width, 900);
            fixture.settle();
            const QList<QRect> before = places();
            QVERIFY(before.size() > 5);
            fixture.hover(fixture.timeline, fixture.onTrack(20));
            QVERIFY(fixture.session.preview().isActive());
            QCoreApplication::processEvents();
            QCOMPARE(places(), before);
            fixture.park();
        }
    }

    void theCurvesOfTheBodyUnderTheMouseAreThicker()
    {
        CursorFixture fixture;
        const QString body = fixture.session.selected();
        const QPointF at = fixture.shown(qPrintable(body));
        QVERIFY(!fixture.plot().isThick());
        fixture.hover(*fixture.view.viewport(), fixture.view.mapFromScene(at));
        QVERIFY(fixture.plot().isThick());
        QVERIFY(!fixture.session.preview().marked()); // it is where it is
        fixture.park();
        QVERIFY(!fixture.plot().isThick());
    }

    void whileTheRunPlaysTheMouseOnlyMarks()
    {
        CursorFixture fixture;
        fixture.session.playback().play();
        fixture.hover(fixture.plot(), fixture.onPlot(20.0));
        QCOMPARE(fixture.plot().hovered(), fixture.session.preview().marked()->frame);
        QVERIFY(!fixture.session.preview().isActive());
        fixture.session.playback().pause();
    }
};

SUITE(tst_one_cursor, TestOneCursor)
#include "tst_one_cursor.moc"
