// The left side of the window and the parameters, driven with mouse and keyboard.

#include "app/ui/panels/dock_title.h"
#include "app/ui/panels/help_page.h"
#include "app/ui/panels/key_caps.h"
#include "app/ui/panels/learn_panel.h"
#include "app/ui/panels/lesson_list.h"
#include "app/ui/panels/lesson_model.h"
#include "app/ui/panels/number_box.h"
#include "app/ui/panels/parameter_panel.h"
#include "app/ui/panels/parameter_row.h"
#include "app/ui/panels/parameter_slider.h"
#include "app/ui/panels/step_button.h"
#include "app/ui/panels/try_row.h"
#include "lessons/api/creature.h"
#include "lessons/api/parameters.h"
#include "sim/effects/damping.h"
#include "sim/effects/point_spring.h"

#include <QAction>
#include <QComboBox>
#include <QFocusFrame>
#include <QLabel>
#include <QScrollArea>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>
#include <QToolButton>

using namespace app;

namespace {

lessons::Step springStep(const QString &id, const QString &title, const QString &tryText = {})
{
    lessons::Step step;
    step.id = id;
    step.title = title;
    step.narration = "A **spring** pulls the foot to the cross.\n\nTwice as far, twice the pull.";
    step.parameters = {lessons::stiffness(), lessons::damping()};
    step.scene = [](const sim::Values &values) {
        sim::Scene scene = lessons::creature(1);
        scene.start.place(0, {300, 210});
        lessons::add<sim::PointSpring>(scene, 0, sim::Vec2{270, 200}, values["k"]);
        lessons::add<sim::Damping>(scene, values["damp"]);
        return scene;
    };
    step.look = [](const sim::Scene &scene, const sim::Values &) { return lessons::creatureLook(scene); };
    const auto done = [](const sim::Timeline &timeline) { return timeline.at().frame >= 5; };
    if (!tryText.isEmpty())
        step.tries = {{tryText, done}};
    return step;
}

/// A step with more parameters than are always shown, one of them a choice, one a count.
lessons::Step manyParameters()
{
    lessons::Step step = springStep("many", "Many parameters");
    step.parameters.push_back(
        {"formula", "Formula", {}, {}, "Which one.", 0, 0, 1, 0, 1, 0, {"corrected", "printed"}});
    step.parameters.push_back(lessons::feet(5));
    step.parameters.push_back(lessons::offset());
    step.parameters.push_back(lessons::radius());
    return step;
}

LessonLibrary twoLessons()
{
    LessonLibrary library;
    library.lessons.push_back({"one",
                               1,
                               "Lesson one",
                               "The first.",
                               {springStep("first", "The first step", "Wait **five** frames."),
                                springStep("second", "The second step")}});
    library.lessons.push_back({"two", 2, "Lesson two", "The second.", {manyParameters()}});
    return library;
}

/// A library, a session and a theme for one test.
struct World
{
    explicit World(LessonLibrary given = twoLessons()) : library(std::move(given)), session(library) {}

    LessonLibrary library;
    Session session;
    Theme theme{Scheme::light};
};

template <class Widget>
void show(Widget &widget, const QSize &size)
{
    widget.resize(size);
    widget.show();
    QVERIFY(QTest::qWaitForWindowActive(&widget));
}

QTreeView &listOf(LearnPanel &panel)
{
    return *panel.findChild<LessonList *>();
}

void clickRow(QTreeView &list, const QModelIndex &index)
{
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(index).center());
}

QModelIndex stepIndex(const QTreeView &list, int lesson, int step)
{
    return list.model()->index(step, 0, list.model()->index(lesson, 0));
}

ParameterRow *rowOf(const ParameterPanel &panel, const QString &id)
{
    for (ParameterRow *row : panel.findChildren<ParameterRow *>()) {
        if (row->parameter().id == id)
            return row;
    }
    return nullptr;
}

void type(QWidget &box, const QString &text, Qt::Key end = Qt::Key_Return)
{
    QTest::mouseClick(&box, Qt::LeftButton);
    QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, end);
}

/// Where a slider's handle stands for a position.
QPoint onGroove(const ParameterSlider &slider, double share)
{
    return {qRound(8 + (slider.width() - 16) * share), slider.height() / 2};
}

}

class PanelsTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { QSettings().clear(); }

    void clickingAStepOpensIt();
    void clickingALessonOpensItsFirstStepThatIsNotDone();
    void theOpenLessonAloneShowsItsSteps();
    void theArrowKeysMoveAndEnterOpens();
    void theListSaysHowFarTheLearnerIs();
    void aFileThatIsNoLessonIsNamedLast();
    void aLowWindowKeepsTheOpenLessonInSight();

    void nextAndBackCrossLessons();
    void theEndsSayWhyNothingFollows();
    void aTryIsTickedWhenItIsDone();
    void aTryCannotBeTickedByHand();
    void theButtonsStayInSight_data();
    void theButtonsStayInSight();

    void aClickOnTheGrooveSetsTheValue();
    void theSliderIsDragged();
    void theArrowKeysMoveTheSlider();
    void aTypedNumberIsSet_data();
    void aTypedNumberIsSet();
    void aNumberOutOfRangeIsBroughtIntoItWithASentence();
    void whatIsNoNumberChangesNothing();
    void anExactNumberIsNeverRounded();
    void aChangeInThePastLeavesAGhostMark();
    void theRowsFollowValuesThatChangeInTime();
    void aValueBeyondTheSliderHoldsTheHandleAtItsEnd();
    void resetBringsOneParameterBack();
    void resetAllIsOnlyForChanges();
    void aChoiceIsChosenByName();
    void aCountMovesByWholeNumbers();
    void theRestUnfolds();
    void thePanelUnfoldsWhenThereIsRoom();
    void tabVisitsTheFieldsInOrder();

    void theHelpPageListsEveryActionThatHasAShortcut();
    void escapeClosesTheHelpPage();
    void aDockTitleIsAsHighAsItsDockExpects();
    void tabPutsARingRoundAControl();
};

void PanelsTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName("springstep-tests");
    QCoreApplication::setApplicationName("tst_panels");
    Theme(Scheme::light).apply(*qApp);
}

void PanelsTest::clickingAStepOpensIt()
{
    World world;
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    QTreeView &list = listOf(panel);
    clickRow(list, stepIndex(list, 0, 1));
    QCOMPARE(world.session.step().id, QString("second"));
    QVERIFY(stepIndex(list, 0, 1).data(LessonModel::openRole).toBool());
    QVERIFY(!stepIndex(list, 0, 0).data(LessonModel::openRole).toBool());
}

void PanelsTest::clickingALessonOpensItsFirstStepThatIsNotDone()
{
    World world;
    world.session.progress().markDone("one", "first", 0);
    world.session.openStep("two", "many");
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    QTreeView &list = listOf(panel);
    clickRow(list, list.model()->index(0, 0));
    QCOMPARE(world.session.lesson().id, QString("one"));
    QCOMPARE(world.session.step().id, QString("second"));
}

void PanelsTest::theOpenLessonAloneShowsItsSteps()
{
    World world;
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    QTreeView &list = listOf(panel);
    QVERIFY(list.isExpanded(list.model()->index(0, 0)));
    QVERIFY(!list.isExpanded(list.model()->index(1, 0)));
    QCOMPARE(list.height(), 2 * 27 + 2 * 26);
    world.session.openStep("two", "many");
    QVERIFY(!list.isExpanded(list.model()->index(0, 0)));
    QVERIFY(list.isExpanded(list.model()->index(1, 0)));
    QCOMPARE(list.height(), 2 * 27 + 26);
}

void PanelsTest::theArrowKeysMoveAndEnterOpens()
{
    World world;
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    QTreeView &list = listOf(panel);
    list.setFocus(Qt::TabFocusReason);
    QTest::keyClick(&list, Qt::Key_Down);
    QCOMPARE(list.currentIndex(), stepIndex(list, 0, 1));
    QCOMPARE(world.session.step().id, QString("first"));
    QTest::keyClick(&list, Qt::Key_Return);
    QCOMPARE(world.session.step().id, QString("second"));
    QTest::keyClick(&list, Qt::Key_Down);
    QTest::keyClick(&list, Qt::Key_Enter);
    QCOMPARE(world.session.lesson().id, QString("two"));
    QTest::keyClick(&list, Qt::Key_Up);
    QTest::keyClick(&list, Qt::Key_Up);
    QTest::keyClick(&list, Qt::Key_Return);
    QCOMPARE(world.session.lesson().id, QString("one"));
}

void PanelsTest::theListSaysHowFarTheLearnerIs()
{
    World world;
    LearnPanel panel(world.session, world.theme);
    const QModelIndex lesson = listOf(panel).model()->index(0, 0);
    const auto *title = panel.findChild<PanelTitle *>();
    QCOMPARE(lesson.data(Qt::AccessibleTextRole).toString(), QString("Lesson one, 0 of 2 steps done"));
    QCOMPARE(title->caption(), QString("0 of 3 steps"));
    world.session.progress().markDone("one", "first", 0);
    QCOMPARE(lesson.data(Qt::AccessibleTextRole).toString(), QString("Lesson one, 1 of 2 steps done"));
    QCOMPARE(title->caption(), QString("1 of 3 steps"));
    QVERIFY(stepIndex(listOf(panel), 0, 0).data(Qt::AccessibleTextRole).toString().contains("done, open"));
}

void PanelsTest::aFileThatIsNoLessonIsNamedLast()
{
    LessonLibrary library = twoLessons();
    library.problems.push_back({"broken.so", "broken.so is not a lesson: remove it."});
    World world(library);
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    QTreeView &list = listOf(panel);
    QCOMPARE(list.model()->rowCount(), 3);
    const QModelIndex last = list.model()->index(2, 0);
    QCOMPARE(last.data().toString(), QString("1 file is not a lesson"));
    QCOMPARE(last.data(Qt::ToolTipRole).toString(), QString("broken.so is not a lesson: remove it."));
    clickRow(list, last);
    QCOMPARE(world.session.step().id, QString("first"));
}

void PanelsTest::aLowWindowKeepsTheOpenLessonInSight()
{
    World world;
    world.session.openStep("two", "many");
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 500});
    QTreeView &list = listOf(panel);
    QCOMPARE(list.height(), 27 + 26);
    QTRY_VERIFY(list.viewport()->rect().contains(list.visualRect(stepIndex(list, 1, 0))));
    QVERIFY(list.viewport()->rect().contains(list.visualRect(list.model()->index(1, 0))));
}

void PanelsTest::nextAndBackCrossLessons()
{
    World world;
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    auto *next = panel.findChild<StepButton *>("next");
    auto *back = panel.findChild<QPushButton *>("back");
    QCOMPARE(next->accessibleName(), QString("Next: The second step"));
    QTest::mouseClick(next, Qt::LeftButton);
    QCOMPARE(world.session.step().id, QString("second"));
    QCOMPARE(next->accessibleName(), QString("Next: Many parameters"));
    QTest::mouseClick(next, Qt::LeftButton);
    QCOMPARE(world.session.lesson().id, QString("two"));
    back->setFocus(Qt::TabFocusReason);
    QTest::keyClick(back, Qt::Key_Space);
    QCOMPARE(world.session.step().id, QString("second"));
}

void PanelsTest::theEndsSayWhyNothingFollows()
{
    World world;
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    const auto *next = panel.findChild<StepButton *>("next");
    const auto *back = panel.findChild<QPushButton *>("back");
    QVERIFY(!back->isEnabled());
    QCOMPARE(back->toolTip(), QString("This is the first step."));
    QVERIFY(next->isEnabled());
    world.session.openStep("two", "many");
    QVERIFY(back->isEnabled());
    QVERIFY(!next->isEnabled());
    QCOMPARE(next->toolTip(), QString("No step comes after this one."));
}

void PanelsTest::aTryIsTickedWhenItIsDone()
{
    World world;
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    auto *row = panel.findChild<TryRow *>();
    const auto *next = panel.findChild<StepButton *>("next");
    QVERIFY(!row->isChecked());
    QCOMPARE(row->accessibleName(), QString("Wait five frames. not yet"));
    QVERIFY(!next->isPrimary());
    for (int i = 0; i < 5; ++i)
        world.session.frameForward();
    QVERIFY(row->isChecked());
    QCOMPARE(row->accessibleName(), QString("Wait five frames. done"));
    QVERIFY(next->isPrimary());
    const QImage picture = row->grab().toImage();
    QCOMPARE(picture.pixelColor(2, row->height() / 2), world.theme.tokens().ok);
}

void PanelsTest::aTryCannotBeTickedByHand()
{
    World world;
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    auto *row = panel.findChild<TryRow *>();
    QTest::mouseClick(row, Qt::LeftButton, {}, {8, 12});
    QTest::keyClick(row, Qt::Key_Space);
    QVERIFY(!row->isChecked());
    QVERIFY(!world.session.progress().isDone("one", "first", 0));
}

void PanelsTest::theButtonsStayInSight_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("as designed") << QSize(280, 732);
    QTest::newRow("wide") << QSize(320, 1012);
    QTest::newRow("low") << QSize(280, 420);
    QTest::newRow("very low") << QSize(280, 300);
}

void PanelsTest::theButtonsStayInSight()
{
    QFETCH(QSize, size);
    LessonLibrary library = twoLessons();
    for (int i = 0; i < 12; ++i)
        library.lessons.front().steps.front().narration += "\n\nOne more paragraph that needs its two lines.";
    World world(library);
    LearnPanel panel(world.session, world.theme);
    show(panel, size);
    QCOMPARE(panel.size(), size);
    for (const QPushButton *button : panel.findChildren<QPushButton *>()) {
        const QRect place(button->mapTo(&panel, QPoint()), button->size());
        QVERIFY2(panel.rect().contains(place), qPrintable(button->accessibleName()));
    }
    const auto *area = panel.findChild<QScrollArea *>();
    QVERIFY(area->widget()->width() <= area->viewport()->width());
    const auto *row = panel.findChild<TryRow *>();
    QVERIFY(row->height() >= row->heightForWidth(row->width()));
}

void PanelsTest::aClickOnTheGrooveSetsTheValue()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    auto *slider = rowOf(panel, "k")->findChild<ParameterSlider *>();
    QTest::mouseClick(slider, Qt::LeftButton, {}, onGroove(*slider, 1.0));
    QCOMPARE(world.session.parameter("k"), 1.0);
    QTest::mouseClick(slider, Qt::LeftButton, {}, onGroove(*slider, 0.0));
    QCOMPARE(world.session.parameter("k"), 0.0);
    QTest::mouseClick(slider, Qt::LeftButton, {}, onGroove(*slider, 0.5));
    QCOMPARE(world.session.parameter("k"), 0.5);
    QCOMPARE(rowOf(panel, "k")->findChild<NumberBox *>()->text(), QString("0.50"));
}

void PanelsTest::theSliderIsDragged()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    auto *slider = rowOf(panel, "k")->findChild<ParameterSlider *>();
    const QPoint start = onGroove(*slider, 0.2) + QPoint(3, 0); // beside the handle's middle
    QTest::mousePress(slider, Qt::LeftButton, {}, start);
    QCOMPARE(world.session.parameter("k"), 0.2);
    const QPoint way = onGroove(*slider, 0.7) - onGroove(*slider, 0.2);
    QTest::mouseMove(slider, start + way);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, start + way);
    QVERIFY(std::abs(world.session.parameter("k") - 0.7) < 0.015);
}

void PanelsTest::theArrowKeysMoveTheSlider()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    auto *slider = rowOf(panel, "damp")->findChild<ParameterSlider *>();
    slider->setFocus(Qt::TabFocusReason);
    QTest::keyClick(slider, Qt::Key_Right);
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(world.session.parameter("damp"), 0.92); // the very number, no sum of hundredths
    QTest::keyClick(slider, Qt::Key_Left);
    QCOMPARE(world.session.parameter("damp"), 0.91);
}

void PanelsTest::aTypedNumberIsSet_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("end");
    QTest::addColumn<double>("value");
    QTest::newRow("Enter takes it") << "0.35" << int(Qt::Key_Return) << 0.35;
    QTest::newRow("leaving the field takes it") << "0.35" << int(Qt::Key_Tab) << 0.35;
    QTest::newRow("all digits count") << "0.123456789012345" << int(Qt::Key_Return) << 0.123456789012345;
    QTest::newRow("a comma is a point") << "0,25" << int(Qt::Key_Return) << 0.25;
    QTest::newRow("beyond the slider") << "250" << int(Qt::Key_Return) << 250.0;
    QTest::newRow("with a power of ten") << "1e-7" << int(Qt::Key_Return) << 1e-7;
    QTest::newRow("Escape leaves it") << "0.35" << int(Qt::Key_Escape) << 0.2;
}

void PanelsTest::aTypedNumberIsSet()
{
    QFETCH(QString, text);
    QFETCH(int, end);
    QFETCH(double, value);
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    type(*rowOf(panel, "k")->findChild<NumberBox *>(), text, Qt::Key(end));
    QCOMPARE(world.session.parameter("k"), value);
}

void PanelsTest::aNumberOutOfRangeIsBroughtIntoItWithASentence()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    QSignalSpy said(&world.session, &Session::said);
    auto *box = rowOf(panel, "damp")->findChild<NumberBox *>();
    type(*box, "1.4");
    QCOMPARE(world.session.parameter("damp"), 1.0);
    QCOMPARE(said.count(), 1);
    QCOMPARE(said.front().front().toString(), QString("Damping can be 0 to 1."));
    QCOMPARE(box->text(), QString("1.00"));
    type(*box, "-3"); // now it is at the other end
    QCOMPARE(world.session.parameter("damp"), 0.0);
    QCOMPARE(said.count(), 2);
    type(*box, "-4"); // nothing changes in the run, but the field must not keep it
    QCOMPARE(box->text(), QString("0.00"));
    QCOMPARE(said.count(), 3);
}

void PanelsTest::whatIsNoNumberChangesNothing()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    auto *box = rowOf(panel, "k")->findChild<NumberBox *>();
    for (const char *text : {"", "-", "1e", "..", "nan"}) {
        type(*box, text);
        QCOMPARE(world.session.parameter("k"), 0.2);
        QTest::keyClick(box, Qt::Key_Tab);
        QCOMPARE(box->text(), QString("0.20"));
    }
}

void PanelsTest::anExactNumberIsNeverRounded()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    world.session.setParameter("k", 0.123456);
    auto *box = rowOf(panel, "k")->findChild<NumberBox *>();
    QVERIFY2(box->text().endsWith(QChar(0x2026)), qPrintable(box->text()));
    QVERIFY2(box->toolTip().contains("0.123456"), qPrintable(box->toolTip()));
    // Looking at it, and leaving again, must not change it.
    QTest::mouseClick(box, Qt::LeftButton);
    QCOMPARE(box->text(), QString("0.123456"));
    QTest::keyClick(box, Qt::Key_Return);
    QTest::keyClick(box, Qt::Key_Tab);
    QCOMPARE(world.session.parameter("k"), 0.123456);
    QVERIFY(box->text().endsWith(QChar(0x2026)));
}

void PanelsTest::aChangeInThePastLeavesAGhostMark()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    const auto *slider = rowOf(panel, "damp")->findChild<ParameterSlider *>();
    for (int i = 0; i < 20; ++i)
        world.session.frameForward();
    world.session.goTo({5, 0});
    type(*rowOf(panel, "damp")->findChild<NumberBox *>(), "0.5");
    QVERIFY(world.session.timeline().ghost());
    QCOMPARE(world.session.ghostName(), QString("before: damp 0.9"));
    QCOMPARE(slider->ghost(), std::optional<double>(0.9));
    QCOMPARE(rowOf(panel, "k")->findChild<ParameterSlider *>()->ghost(), std::optional<double>());
    world.session.forgetGhost();
    QCOMPARE(slider->ghost(), std::optional<double>());
}

void PanelsTest::theRowsFollowValuesThatChangeInTime()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    world.session.frameForward();
    world.session.frameForward();
    world.session.setParameter("k", 0.6);
    world.session.frameForward();
    const auto *box = rowOf(panel, "k")->findChild<NumberBox *>();
    const auto *slider = rowOf(panel, "k")->findChild<ParameterSlider *>();
    QSignalSpy changed(&world.session, &Session::runChanged);
    QCOMPARE(box->text(), QString("0.60"));
    world.session.rewind();
    QCOMPARE(box->text(), QString("0.20"));
    QCOMPARE(slider->value(), 20);
    world.session.goTo({3, 0});
    QCOMPARE(box->text(), QString("0.60"));
    QCOMPARE(slider->value(), 60);
    QCOMPARE(changed.count(), 0); // the panel only looked
}

void PanelsTest::aValueBeyondTheSliderHoldsTheHandleAtItsEnd()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    world.session.setParameter("k", 7.5);
    const auto *slider = rowOf(panel, "k")->findChild<ParameterSlider *>();
    QCOMPARE(slider->value(), slider->maximum());
    QCOMPARE(world.session.parameter("k"), 7.5);
    QCOMPARE(rowOf(panel, "k")->findChild<NumberBox *>()->text(), QString("7.50"));
}

void PanelsTest::resetBringsOneParameterBack()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    auto *reset = rowOf(panel, "k")->findChild<QToolButton *>("reset");
    QVERIFY(!reset->isVisible());
    world.session.setParameter("k", 0.4);
    world.session.setParameter("damp", 0.4);
    QVERIFY(reset->isVisible());
    QVERIFY(reset->width() >= 24 && reset->height() >= 24);
    QTest::mouseClick(reset, Qt::LeftButton);
    QCOMPARE(world.session.parameter("k"), 0.2);
    QCOMPARE(world.session.parameter("damp"), 0.4);
    QVERIFY(!reset->isVisible());
}

void PanelsTest::resetAllIsOnlyForChanges()
{
    World world;
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    auto *reset = panel.findChild<QToolButton *>("resetAll");
    QVERIFY(!reset->isEnabled());
    QVERIFY(reset->toolTip().contains("Nothing to reset"));
    world.session.setParameter("k", 0.4);
    world.session.setParameter("damp", 0.4);
    QVERIFY(reset->isEnabled());
    QTest::mouseClick(reset, Qt::LeftButton);
    QCOMPARE(world.session.parameter("k"), 0.2);
    QCOMPARE(world.session.parameter("damp"), 0.9);
    QVERIFY(!reset->isEnabled());
}

void PanelsTest::aChoiceIsChosenByName()
{
    World world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 400});
    auto *choice = rowOf(panel, "formula")->findChild<QComboBox *>();
    QCOMPARE(choice->currentText(), QString("corrected"));
    choice->setFocus(Qt::TabFocusReason);
    QTest::keyClick(choice, Qt::Key_Down);
    QCOMPARE(choice->currentText(), QString("printed"));
    QCOMPARE(world.session.parameter("formula"), 1.0);
    world.session.resetParameters();
    QCOMPARE(choice->currentText(), QString("corrected"));
}

void PanelsTest::aCountMovesByWholeNumbers()
{
    World world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 400});
    auto *slider = rowOf(panel, "feet")->findChild<ParameterSlider *>();
    auto *box = rowOf(panel, "feet")->findChild<NumberBox *>();
    slider->setFocus(Qt::TabFocusReason);
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(world.session.parameter("feet"), 6.0);
    QTest::keyClick(box, Qt::Key_Up);
    QCOMPARE(world.session.parameter("feet"), 7.0);
    type(*box, "8.4");
    QCOMPARE(world.session.parameter("feet"), 8.0);
    QCOMPARE(box->text(), QString("8"));
}

void PanelsTest::theRestUnfolds()
{
    World world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, panel.sizeHint().height()});
    auto *more = panel.findChild<QToolButton *>("disclosure");
    QCOMPARE(more->text(), QString("Offset, radius"));
    QVERIFY(rowOf(panel, "feet")->isVisible());
    QVERIFY(!rowOf(panel, "radius")->isVisible());
    const int folded = panel.sizeHint().height();
    QTest::mouseClick(more, Qt::LeftButton);
    QVERIFY(rowOf(panel, "radius")->isVisible());
    QCOMPARE(panel.sizeHint().height(), folded + 2 * 36);
    more->setFocus(Qt::TabFocusReason);
    QTest::keyClick(more, Qt::Key_Space);
    QVERIFY(!rowOf(panel, "radius")->isVisible());
}

void PanelsTest::thePanelUnfoldsWhenThereIsRoom()
{
    World world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 500});
    QVERIFY(rowOf(panel, "radius")->isVisible());
    panel.resize(400, 200);
    QTRY_VERIFY(!rowOf(panel, "radius")->isVisible());
}

void PanelsTest::tabVisitsTheFieldsInOrder()
{
    World world;
    world.session.setParameter("k", 0.4);
    ParameterPanel panel(world.session, world.theme);
    show(panel, {400, 192});
    const QList<QWidget *> order = {panel.findChild<QToolButton *>("resetAll"),
                                    rowOf(panel, "k")->findChild<ParameterSlider *>(),
                                    rowOf(panel, "k")->findChild<NumberBox *>(),
                                    rowOf(panel, "k")->findChild<QToolButton *>("reset"),
                                    rowOf(panel, "damp")->findChild<ParameterSlider *>(),
                                    rowOf(panel, "damp")->findChild<NumberBox *>()};
    order.front()->setFocus(Qt::TabFocusReason);
    for (int i = 1; i < order.size(); ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), order[i]);
    }
}

void PanelsTest::theHelpPageListsEveryActionThatHasAShortcut()
{
    Theme theme(Scheme::light);
    HelpPage page(theme);
    QAction play("&Play or pause");
    play.setShortcut(Qt::Key_Space);
    QAction phase("&Next phase…");
    phase.setShortcuts({QKeySequence("Shift+Right"), QKeySequence("Ctrl++")});
    QAction silent("Without a key");
    page.addAction("Time", &play);
    page.addAction("Time", &phase);
    page.addAction("Time", &silent);
    page.addGesture("Picture", "Drag a body", "grab it");
    show(page, {800, 600});
    QStringList listed;
    for (const QLabel *label : page.findChildren<QLabel *>("action"))
        listed.push_back(label->accessibleName());
    listed.sort();
    const QStringList expected = {"Grab it: Drag a body", "Next phase: Shift → or Ctrl +",
                                  "Play or pause: Space"};
    QCOMPARE(listed, expected);
    for (const KeyCaps *caps : page.findChildren<KeyCaps *>())
        QVERIFY(caps->isVisible() && caps->width() == caps->sizeHint().width());
}

void PanelsTest::escapeClosesTheHelpPage()
{
    Theme theme(Scheme::light);
    HelpPage page(theme);
    show(page, {800, 600});
    QVERIFY(!page.isModal());
    QTest::keyClick(&page, Qt::Key_Escape);
    QVERIFY(!page.isVisible());
}

void PanelsTest::aDockTitleIsAsHighAsItsDockExpects()
{
    Theme theme(Scheme::light);
    DockTitle title("Code", theme);
    title.setCaption("values of foot 0");
    auto *button = new QToolButton;
    button->setFixedSize(28, 28);
    title.addAction(button);
    QCOMPARE(title.sizeHint().height(), 36);
    QCOMPARE(title.minimumSizeHint().height(), 36);
    show(title, {400, 36});
    QCOMPARE(title.findChild<QLabel *>("caption")->text(), QString("values of foot 0"));
    title.resize(140, 36);
    QVERIFY(title.rect().contains(button->geometry()));
    QVERIFY(title.findChild<QLabel *>("caption")->text().endsWith(QChar(0x2026)));
    QCOMPARE(title.findChild<QLabel *>("caption")->toolTip(), QString("values of foot 0"));
}

void PanelsTest::tabPutsARingRoundAControl()
{
    World world;
    world.session.openFollowing();
    LearnPanel panel(world.session, world.theme);
    show(panel, {280, 732});
    auto *back = panel.findChild<QPushButton *>("back");
    QWidget *next = panel.findChild<StepButton *>("next");
    const auto ring = [&]() -> QWidget * {
        const auto *frame = panel.findChild<QFocusFrame *>();
        return frame && frame->isVisible() ? frame->widget() : nullptr;
    };
    back->setFocus(Qt::MouseFocusReason);
    QVERIFY(!ring());
    QTest::keyClick(back, Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), next);
    QCOMPARE(ring(), next);
    QTest::mousePress(back, Qt::LeftButton); // a mouse needs no ring
    QVERIFY(!ring());
    QTest::mouseRelease(back, Qt::LeftButton, {}, {-50, -50});
}

QTEST_MAIN(PanelsTest)

#include "tst_panels.moc"
