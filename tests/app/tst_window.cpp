// The whole window, driven as a learner drives it.

#include "app/model/experiment.h"
#include "app/ui/panels/parameter_panel.h"
#include "app/ui/panels/parameter_row.h"
#include "app/ui/panels/summary_page.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/notice.h"
#include "quick_bench.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

using namespace app;
using quick_bench::Bench;

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
    void initTestCase();
    void aThrowByMouseIsTheSameRunInTrace();
    void keysDoWhatTheHelpPageSays_data();
    void keysDoWhatTheHelpPageSays();
    void homeRestartsAndWithShiftItRepeats();
    void pageKeysWalkThroughAllStepsOfAllLessons();
    void scrubbingTheTimelineComesBackToTheSameBits();
    void aParameterChangedInThePastLeavesAGhost();
    void aBadFileIsNamedAndTheSceneIsUnchanged();
    void aSavedExperimentOpensAsTheSameRun();
    void arrowKeysMoveASliderThatHasTheFocus();
    void everyControlHasANameAndATooltip();
    void theOldRunIsForgottenWhereThereIsOne();

private:
    QTemporaryDir m_folder;
};

void WindowTest::initTestCase()
{
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
}

void WindowTest::aThrowByMouseIsTheSameRunInTrace()
{
    Bench bench("multi_foot", "any_number");
    bench.session.goTo({10, 0});
    const QPoint start = bench.onScreen("foot0");
    QWidget *target = bench.view.viewport();
    QTest::mousePress(target, Qt::LeftButton, {}, start);
    for (int i = 1; i <= 8; ++i) {
        QMouseEvent move(QEvent::MouseMove, start + QPoint(6 * i, -4 * i),
                         target->mapToGlobal(start + QPoint(6 * i, -4 * i)), Qt::NoButton, Qt::LeftButton,
                         {});
        QApplication::sendEvent(target, &move);
        QTest::keyClick(&bench.view, Qt::Key_Right);
    }
    QTest::mouseRelease(target, Qt::LeftButton, {}, start + QPoint(48, -32));
    bench.session.goTo({60, 0});
    const QString file = m_folder.filePath("throw.json");
    QVERIFY(bench.window.saveFile(file));

    QProcess trace;
    trace.start(PROGRAM, {"trace", file});
    QVERIFY(trace.waitForFinished());
    QCOMPARE(trace.exitCode(), 0);
    const QStringList rows = bodiesOf(trace.readAllStandardOutput(), 60);
    const sim::State &now = bench.session.timeline().state();
    QCOMPARE(rows.size(), now.pointCount());
    for (int i = 0; i < now.pointCount(); ++i) {
        const QStringList fields = rows[i].split(',');
        QCOMPARE(fields[2].toDouble(), now.position(i, 0));
        QCOMPARE(fields[3].toDouble(), now.position(i, 1));
        QCOMPARE(fields[4].toDouble(), now.velocity(i, 0));
        QCOMPARE(fields[5].toDouble(), now.velocity(i, 1));
    }
    QVERIFY(bench.session.timeline().script().input.size() >= 3);
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
    Bench bench;
    bench.session.goTo({40, 0});
    bench.session.goTo({20, 0});
    QTest::keyClick(&bench.view, Qt::Key(key), Qt::KeyboardModifiers(modifiers));
    QTEST(int(bench.frame()), "frame");
    QTEST(bench.phase(), "phase");
}

void WindowTest::homeRestartsAndWithShiftItRepeats()
{
    Bench bench;
    bench.session.goTo({5, 0});
    bench.session.grab("foot");
    bench.session.moveHand({200, 150});
    bench.session.frameForward();
    bench.session.letGo();
    bench.session.goTo({12, 0});
    const sim::State end = bench.session.timeline().state();
    QTest::keyClick(&bench.view, Qt::Key_Home, Qt::ShiftModifier);
    QVERIFY(bench.session.isPlaying());
    QVERIFY(bench.session.hasInput());
    bench.session.pause();
    bench.session.goTo({12, 0});
    QVERIFY(sim::sameBits(bench.session.timeline().state(), end));
    QTest::keyClick(&bench.view, Qt::Key_Home);
    QCOMPARE(bench.frame(), 0);
    QVERIFY(!bench.session.isPlaying());
    QVERIFY(!bench.session.hasInput());
    QTest::keyClick(&bench.view, Qt::Key_Z, Qt::ControlModifier);
    bench.session.goTo({12, 0});
    QVERIFY(sim::sameBits(bench.session.timeline().state(), end));
}

void WindowTest::pageKeysWalkThroughAllStepsOfAllLessons()
{
    Bench bench("single_spring", "drag");
    for (const LessonEntry &lesson : bench.library.lessons) {
        for (const lessons::Step &step : lesson.steps) {
            QCOMPARE(bench.session.step().id, step.id);
            QVERIFY(bench.window.windowTitle().contains(step.title));
            QVERIFY(!bench.window.grab().isNull());
            QTest::keyClick(&bench.view, Qt::Key_PageDown);
        }
        QVERIFY(bench.window.findChild<SummaryPage *>()->isVisible());
        QTest::keyClick(&bench.view, Qt::Key_PageDown);
    }
    QVERIFY(bench.window.findChild<SummaryPage *>()->isVisible()); // nothing comes after the last one
    QTest::keyClick(&bench.view, Qt::Key_PageUp);
    QVERIFY(!bench.window.findChild<SummaryPage *>()->isVisible());
    QVERIFY(!bench.session.following());
    QTest::keyClick(&bench.view, Qt::Key_PageUp);
    QVERIFY(bench.session.following());
}

void WindowTest::scrubbingTheTimelineComesBackToTheSameBits()
{
    Bench bench("two_body", "leg_line");
    bench.session.goTo({100, 0});
    const sim::State end = bench.session.timeline().state();
    auto *strip = bench.window.findChild<TimelineStrip *>();
    QTest::mouseClick(strip, Qt::LeftButton, {}, QPoint(strip->width() / 4, 25));
    QVERIFY(bench.frame() > 0 && bench.frame() < 100);
    QTest::keyClick(&bench.view, Qt::Key_End);
    QCOMPARE(bench.frame(), 100);
    QVERIFY(sim::sameBits(bench.session.timeline().state(), end));
}

void WindowTest::aParameterChangedInThePastLeavesAGhost()
{
    Bench bench("gravity_walls", "gravity");
    bench.session.goTo({80, 0});
    bench.session.goTo({30, 0});
    QVERIFY(!bench.session.ghost());
    auto *slider = bench.window.findChild<ParameterPanel *>()->findChild<QAbstractSlider *>();
    QVERIFY(slider);
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(bench.session.timeline().comparison());
    QCOMPARE(bench.session.timeline().forkFrame(), 31);
    QCOMPARE(bench.session.timeline().comparison()->computed(), 80);
    bench.session.goTo({60, 0});
    QVERIFY(!sim::sameBits(bench.session.timeline().state(), bench.session.timeline().comparison()->state()));
}

void WindowTest::aBadFileIsNamedAndTheSceneIsUnchanged()
{
    Bench bench;
    bench.session.goTo({12, 0});
    const sim::State before = bench.session.timeline().state();
    QFile bad(m_folder.filePath("bad.json"));
    QVERIFY(bad.open(QFile::WriteOnly));
    bad.write(
        "{\"format\": \"springstep-experiment/1\",\n\"lesson\": \"single_spring\", \"step\": \"radial\",\n"
        "\"parameters\": {\"damp\": 1.4}}");
    bad.close();
    bench.window.openFile(bad.fileName());
    const QString said = bench.window.findChild<Notice *>()->sentence();
    QVERIFY2(said.contains("bad.json") && said.contains("line 3") && said.contains("1.4"), qPrintable(said));
    QCOMPARE(bench.session.step().id, QString("fixed_centre"));
    QVERIFY(sim::sameBits(bench.session.timeline().state(), before));
}

void WindowTest::aSavedExperimentOpensAsTheSameRun()
{
    Bench bench("multi_foot", "two_feet");
    bench.session.goTo({5, 0});
    bench.session.setParameter("k", 0.31);
    bench.session.goTo({50, 0});
    const sim::State end = bench.session.timeline().state();
    const QString file = m_folder.filePath("saved.json");
    QVERIFY(bench.window.saveFile(file));
    bench.session.openStep("single_spring", "drag");
    bench.window.openFile(file);
    QCOMPARE(bench.session.step().id, QString("two_feet"));
    bench.session.goTo({50, 0});
    QVERIFY(sim::sameBits(bench.session.timeline().state(), end));
}

void WindowTest::arrowKeysMoveASliderThatHasTheFocus()
{
    Bench bench;
    QAbstractSlider *slider = nullptr;
    for (const ParameterRow *row :
         bench.window.findChild<ParameterPanel *>()->findChildren<ParameterRow *>()) {
        if (row->parameter().id == "k")
            slider = row->findChild<QAbstractSlider *>();
    }
    QVERIFY(slider);
    slider->setFocus();
    const double before = bench.session.parameter("k");
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(bench.session.parameter("k") > before);
    QCOMPARE(bench.frame(), 0);
}

void WindowTest::everyControlHasANameAndATooltip()
{
    Bench bench("gravity_walls", "walls");
    int seen = 0;
    for (const QWidget *widget : bench.window.findChildren<QWidget *>()) {
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

void WindowTest::theOldRunIsForgottenWhereThereIsOne()
{
    Bench bench;
    const auto actions = bench.window.actions();
    const auto found = std::find_if(actions.begin(), actions.end(),
                                    [](const QAction *one) { return one->text() == "Forget the &old run"; });
    QVERIFY(found != actions.end());
    QVERIFY(!(*found)->isEnabled());
    bench.session.goTo({60, 0});
    bench.session.goTo({30, 0});
    bench.session.setParameter("k", 0.31);
    QVERIFY((*found)->isEnabled());
    QTest::keyClick(&bench.view, Qt::Key_D, Qt::ControlModifier);
    QVERIFY(bench.session.branches().isEmpty());
    QVERIFY(!(*found)->isEnabled());
}

QTEST_MAIN(WindowTest)
#include "tst_window.moc"
