// The whole window, used with mouse and keys.

#include "app/model/experiment/experiment.h"
#include "app/ui/dialogs/notice.h"
#include "app/ui/learn/after/summary_page.h"
#include "app/ui/parameters/parameter_panel.h"
#include "app/ui/parameters/parameter_row.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/window/main_window.h"
#include "tests/app/support/waiting.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

using namespace app;
using namespace tests;

namespace {

/// The tooltip that shows over `widget`: its own, or that of what holds it.
QString toolTipOver(const QWidget *widget)
{
    for (; widget && !widget->isWindow(); widget = widget->parentWidget()) {
        if (!widget->toolTip().isEmpty())
            return widget->toolTip();
    }
    return {};
}

QStringList bodiesOf(const QByteArray &csv, std::int64_t frame)
{
    QStringList rows;
    for (const QByteArray &row : csv.split('\n')) {
        if (row.startsWith(QByteArray::number(qlonglong(frame)) + ','))
            rows << QString::fromUtf8(row);
    }
    return rows;
}

}

class WindowTest : public QObject
{
    Q_OBJECT

private slots:
    void aThrowByMouseIsTheSameRunInTrace();
    void keysDoWhatTheHelpPageSays_data();
    void keysDoWhatTheHelpPageSays();
    void homeRestartsAndWithShiftItRepeats();
    void pageKeysWalkThroughAllStepsOfAllLessons();
    void scrubbingTheTimelineComesBackToTheSameBits();
    void aParameterChangedInThePastLeavesAGhost();
    void oneTickOfASliderPaintsTheSceneOnce();
    void aBadFileIsNamedAndTheSceneIsUnchanged();
    void aSavedExperimentOpensAsTheSameRun();
    void arrowKeysMoveASliderThatHasTheFocus();
    void everyControlHasANameAndATooltip();
    void theOldRunIsForgottenWhereThereIsOne();

private:
    QTemporaryDir m_folder;
};

void WindowTest::aThrowByMouseIsTheSameRunInTrace()
{
    WindowFixture fixture({"multi_foot", "any_number"});
    fixture.goTo(10);
    const QPoint start = fixture.onScreen("foot0");
    QWidget *target = fixture.view.viewport();
    QTest::mousePress(target, Qt::LeftButton, {}, start);
    for (int i = 1; i <= 8; ++i) {
        QMouseEvent move(QEvent::MouseMove, start + QPoint(6 * i, -4 * i),
                         target->mapToGlobal(start + QPoint(6 * i, -4 * i)), Qt::NoButton, Qt::LeftButton,
                         {});
        QApplication::sendEvent(target, &move);
        QTest::keyClick(&fixture.view, Qt::Key_Right);
    }
    QTest::mouseRelease(target, Qt::LeftButton, {}, start + QPoint(48, -32));
    fixture.goTo(60);
    const QString file = m_folder.filePath("throw.json");
    QVERIFY(fixture.window.saveFile(file));

    QProcess trace;
    trace.start(PROGRAM, {"trace", file});
    QVERIFY(trace.waitForFinished());
    QCOMPARE(trace.exitCode(), 0);
    const QStringList rows = bodiesOf(trace.readAllStandardOutput(), 60);
    const sim::State &now = fixture.session.timeline().state();
    QCOMPARE(rows.size(), now.pointCount());
    for (int i = 0; i < now.pointCount(); ++i) {
        const QStringList fields = rows[i].split(',');
        QCOMPARE(fields[2].toDouble(), now.position(i, 0));
        QCOMPARE(fields[3].toDouble(), now.position(i, 1));
        QCOMPARE(fields[4].toDouble(), now.velocity(i, 0));
        QCOMPARE(fields[5].toDouble(), now.velocity(i, 1));
    }
    QVERIFY(fixture.session.timeline().script().input.size() >= 3);
}

void WindowTest::keysDoWhatTheHelpPageSays_data()
{
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("modifiers");
    QTest::addColumn<int>("frame");
    QTest::addColumn<int>("phase");
    QTest::newRow("Right is a frame on") << int(Qt::Key_Right) << 0 << 21 << 0;
    QTest::newRow("Left is a frame back") << int(Qt::Key_Left) << 0 << 19 << 0;
    QTest::newRow("Shift+Right is a phase on") << int(Qt::Key_Right) << int(Qt::ShiftModifier) << 20 << 1;
    QTest::newRow("Shift+Left is a phase back") << int(Qt::Key_Left) << int(Qt::ShiftModifier) << 19 << 2;
    QTest::newRow("Home is the start") << int(Qt::Key_Home) << 0 << 0 << 0;
    QTest::newRow("End is the last frame computed") << int(Qt::Key_End) << 0 << 40 << 0;
}

void WindowTest::keysDoWhatTheHelpPageSays()
{
    QFETCH(int, key);
    QFETCH(int, modifiers);
    WindowFixture fixture;
    fixture.goTo(40);
    fixture.goTo(20);
    QTest::keyClick(&fixture.view, Qt::Key(key), Qt::KeyboardModifiers(modifiers));
    QTEST(int(fixture.frame()), "frame");
    QTEST(fixture.phase(), "phase");
}

void WindowTest::homeRestartsAndWithShiftItRepeats()
{
    WindowFixture fixture;
    fixture.goTo(5);
    fixture.session.input().grab("foot");
    fixture.session.input().moveTo({200, 150});
    fixture.session.playback().frameForward();
    fixture.session.input().release();
    fixture.goTo(12);
    const sim::State end = fixture.session.timeline().state();
    QTest::keyClick(&fixture.view, Qt::Key_Home, Qt::ShiftModifier);
    QVERIFY(fixture.session.playback().isPlaying());
    QVERIFY(fixture.session.editor().hasInput());
    fixture.session.playback().pause();
    fixture.goTo(12);
    QVERIFY(sim::sameBits(fixture.session.timeline().state(), end));
    QTest::keyClick(&fixture.view, Qt::Key_Home);
    QCOMPARE(fixture.frame(), 0);
    QVERIFY(!fixture.session.playback().isPlaying());
    QVERIFY(!fixture.session.editor().hasInput());
    QTest::keyClick(&fixture.view, Qt::Key_Z, Qt::ControlModifier);
    fixture.goTo(12);
    QVERIFY(sim::sameBits(fixture.session.timeline().state(), end));
}

void WindowTest::pageKeysWalkThroughAllStepsOfAllLessons()
{
    WindowFixture fixture({"single_spring", "drag"});
    for (const LessonEntry &lesson : fixture.library.lessons) {
        for (const lessons::Step &step : lesson.steps) {
            QCOMPARE(fixture.session.step().id, step.id);
            QVERIFY(fixture.window.windowTitle().contains(step.title));
            QVERIFY(!fixture.window.grab().isNull());
            QTest::keyClick(&fixture.view, Qt::Key_PageDown);
        }
        QVERIFY(fixture.window.findChild<SummaryPage *>()->isVisible());
        QTest::keyClick(&fixture.view, Qt::Key_PageDown);
    }
    QVERIFY(fixture.window.findChild<SummaryPage *>()->isVisible()); // nothing comes after the last one
    QTest::keyClick(&fixture.view, Qt::Key_PageUp);
    QVERIFY(!fixture.window.findChild<SummaryPage *>()->isVisible());
    QVERIFY(!fixture.session.run().following());
    QTest::keyClick(&fixture.view, Qt::Key_PageUp);
    QVERIFY(fixture.session.run().following());
}

void WindowTest::scrubbingTheTimelineComesBackToTheSameBits()
{
    WindowFixture fixture({"two_body", "leg_line"});
    fixture.goTo(100);
    const sim::State end = fixture.session.timeline().state();
    auto *strip = fixture.window.findChild<TimelineStrip *>();
    QTest::mouseClick(strip, Qt::LeftButton, {}, QPoint(strip->width() / 4, 25));
    QVERIFY(fixture.frame() > 0 && fixture.frame() < 100);
    QTest::keyClick(&fixture.view, Qt::Key_End);
    QCOMPARE(fixture.frame(), 100);
    QVERIFY(sim::sameBits(fixture.session.timeline().state(), end));
}

void WindowTest::aParameterChangedInThePastLeavesAGhost()
{
    WindowFixture fixture({"gravity_walls", "gravity"});
    fixture.goTo(80);
    fixture.goTo(30);
    QVERIFY(!fixture.session.presentation().comparison());
    auto *slider = fixture.window.findChild<ParameterPanel *>()->findChild<QAbstractSlider *>();
    QVERIFY(slider);
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(fixture.session.timeline().comparison());
    QCOMPARE(fixture.session.timeline().forkFrame(), 31);
    QCOMPARE(fixture.session.timeline().comparison()->computed(), 80);
    fixture.goTo(60);
    QVERIFY(
        !sim::sameBits(fixture.session.timeline().state(), fixture.session.timeline().comparison()->state()));
}

void WindowTest::aBadFileIsNamedAndTheSceneIsUnchanged()
{
    WindowFixture fixture;
    fixture.goTo(12);
    const sim::State before = fixture.session.timeline().state();
    QFile bad(m_folder.filePath("bad.json"));
    QVERIFY(bad.open(QFile::WriteOnly));
    bad.write(
        "{\"format\": \"springstep-experiment/1\",\n\"lesson\": \"single_spring\", \"step\": \"radial\",\n"
        "\"parameters\": {\"damp\": 1.4}}");
    bad.close();
    fixture.window.openFile(bad.fileName());
    const QString said = fixture.window.findChild<Notice *>()->sentence();
    QVERIFY2(said.contains("bad.json") && said.contains("line 3") && said.contains("1.4"), qPrintable(said));
    QCOMPARE(fixture.session.step().id, QString("fixed_centre"));
    QVERIFY(sim::sameBits(fixture.session.timeline().state(), before));
}

void WindowTest::aSavedExperimentOpensAsTheSameRun()
{
    WindowFixture fixture({"multi_foot", "two_feet"});
    fixture.goTo(5);
    fixture.session.editor().setParameter("k", 0.31);
    fixture.goTo(50);
    const sim::State end = fixture.session.timeline().state();
    const QString file = m_folder.filePath("saved.json");
    QVERIFY(fixture.window.saveFile(file));
    fixture.session.openStep("single_spring", "drag");
    fixture.window.openFile(file);
    QCOMPARE(fixture.session.step().id, QString("two_feet"));
    fixture.goTo(50);
    QVERIFY(sim::sameBits(fixture.session.timeline().state(), end));
}

void WindowTest::arrowKeysMoveASliderThatHasTheFocus()
{
    WindowFixture fixture;
    QAbstractSlider *slider = nullptr;
    for (const ParameterRow *row :
         fixture.window.findChild<ParameterPanel *>()->findChildren<ParameterRow *>()) {
        if (row->parameter().id == "k")
            slider = row->findChild<QAbstractSlider *>();
    }
    QVERIFY(slider);
    slider->setFocus();
    const double before = fixture.session.editor().parameter("k");
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(fixture.session.editor().parameter("k") > before);
    QCOMPARE(fixture.frame(), 0);
}

void WindowTest::everyControlHasANameAndATooltip()
{
    WindowFixture fixture({"gravity_walls", "walls"});
    int seen = 0;
    for (const QWidget *widget : fixture.window.findChildren<QWidget *>()) {
        const bool control = qobject_cast<const QAbstractButton *>(widget) ||
                             qobject_cast<const QAbstractSlider *>(widget) ||
                             qobject_cast<const QAbstractSpinBox *>(widget);
        if (!control || !widget->isVisible() || widget->focusPolicy() == Qt::NoFocus)
            continue;
        ++seen;
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        const QString name = widget->accessibleName() + (button ? button->text() : QString());
        const QByteArray what = QByteArray(widget->metaObject()->className()) + " " +
                                widget->objectName().toUtf8() + " of " +
                                widget->parentWidget()->metaObject()->className();
        QVERIFY2(!name.isEmpty(), what);
        QVERIFY2(!toolTipOver(widget).isEmpty(), what);
    }
    QVERIFY(seen > 15);
}

void WindowTest::oneTickOfASliderPaintsTheSceneOnce()
{
    WindowFixture fixture;
    fixture.goTo(30);
    auto &slider = *fixture.part<ParameterRow>().findChild<QAbstractSlider *>();
    slider.setFocus(Qt::TabFocusReason);
    settle();
    PaintCounter paints(*fixture.view.viewport());
    for (int tick = 1; tick <= 5; ++tick) {
        const int before = slider.value();
        QTest::keyClick(&slider, Qt::Key_Right);
        QVERIFY(slider.value() != before);
        settle();
        QCOMPARE(paints.count, tick);
    }
}

void WindowTest::theOldRunIsForgottenWhereThereIsOne()
{
    WindowFixture fixture;
    const auto actions = fixture.window.actions();
    const auto found = std::find_if(actions.begin(), actions.end(),
                                    [](const QAction *one) { return one->text() == "Delete the &old run"; });
    QVERIFY(found != actions.end());
    QVERIFY(!(*found)->isEnabled());
    fixture.goTo(60);
    fixture.goTo(30);
    fixture.session.editor().setParameter("k", 0.31);
    QVERIFY((*found)->isEnabled());
    QTest::keyClick(&fixture.view, Qt::Key_D, Qt::ControlModifier);
    QVERIFY(fixture.session.comparisons().branches().isEmpty());
    QVERIFY(!(*found)->isEnabled());
}

SUITE(tst_window, WindowTest)
#include "tst_window.moc"
