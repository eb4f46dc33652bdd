// The box of a task beside the listing: its buttons, sentences and hints, and the place for the learner's code.

#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/lessons/lesson_list.h"
#include "app/ui/learn/lessons/lesson_model.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/step/narration.h"
#include "app/ui/learn/step/task_box.h"
#include "app/ui/learn/step/try_box.h"
#include "app/ui/learn/why_box.h"
#include "tests/app/listing/listing_window.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/suite.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using namespace app;
using namespace tests;

namespace {

/// Windows of 1280 x 800 px: with text of 100 % and of 125 %.
void addWindows()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << QSize(1280, 800) << "en";
    QTest::newRow("German") << QSize(1280, 800) << "de";
    QTest::newRow("English, large text") << QSize(1024, 640) << "en";
    QTest::newRow("German, large text") << QSize(1024, 640) << "de";
}

/// Checks that these buttons of a task are whole and in view.
void checkButtons(const TaskBox &box, const QStringList &names)
{
    for (const QString &name : names) {
        const auto *button = box.findChild<QToolButton *>(name);
        QVERIFY2(button->isVisible(), qPrintable(name));
        QCOMPARE(button->visibleRegion().boundingRect(), button->rect());
        QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
    }
}

/// Scrolls the text so that `y` px of the box are above its upper edge.
void scrollTo(const TaskBox &box, int y)
{
    const QWidget *above = box.parentWidget();
    while (!qobject_cast<const QScrollArea *>(above))
        above = above->parentWidget();
    qobject_cast<const QScrollArea *>(above)->verticalScrollBar()->setValue(box.y() + y);
    settle();
}

struct TaskPanelFixture : PanelFixture<LearnPanel>
{
    TaskPanelFixture() : PanelFixture(LessonLibrary::load({LESSON_DIR}), QSize(280, 732))
    {
        session.openStep("single_spring", "fixed_centre");
        settle();
    }

    TaskBox &box() const { return *panel.findChild<TaskBox *>(); }
    QToolButton &button(const char *name) const { return *box().findChild<QToolButton *>(name); }
    /// Returns the visible texts of the box with this name.
    QStringList texts(const char *name) const
    {
        QStringList all;
        for (const NarrationText *text : box().findChildren<NarrationText *>(name)) {
            if (text->isVisible())
                all << text->toPlainText();
        }
        return all;
    }
    void press(const char *name)
    {
        QVERIFY(button(name).isVisible());
        QTest::mouseClick(&button(name), Qt::LeftButton);
    }
};

}

class TaskBoxTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void tasksAreUnfoldedAndStartedWithTheMouse();
    void buttonAboveTheThingsToTryScrollsToTheTask();
    void finishedTaskHasNoButtonAboveTheThingsToTry();
    void theLearnerTypesBelowTheComment_data();
    void theLearnerTypesBelowTheComment();
    void theCommentOfATaskIsInSight();
    void thePanelShowsWhatIsWrongAndThenTheTick();
    void theStepIsTickedInTheListOfLessons();
    void theButtonsOfATaskStayInView_data();
    void theButtonsOfATaskStayInView();
    void nothingIsCutOffInASmallWindow_data();
    void nothingIsCutOffInASmallWindow();
    void aTryThatNeedsAPhaseSaysHowToGetOne();
};

void TaskBoxTest::tasksAreUnfoldedAndStartedWithTheMouse()
{
    TaskPanelFixture world;
    auto *title = world.box().findChild<WhyButton *>();
    QVERIFY(title->text().contains("pull"));
    QVERIFY(world.texts("taskText").isEmpty());
    QTest::mouseClick(title, Qt::LeftButton);
    QCOMPARE(world.texts("taskText").size(), 1);
    QVERIFY(!world.button("stopTask").isVisible());
    QSignalSpy requests(&world.panel.narration(), &Narration::listingRequested);
    world.press("startTask");
    QCOMPARE(requests.count(), 1);
    const QStringList lines = world.session.code().text().split('\n');
    const int line = requests[0][0].toInt(); // below the two lines of the comment
    QCOMPARE(lines[line - 3].trimmed(), QString("// The spring pulls the foot towards the"));
    QCOMPARE(lines[line - 2].trimmed(), QString("// centre."));
    QCOMPARE(lines[line - 1], QString("        "));
    QVERIFY(!lines[line].contains("//"));
    QVERIFY(world.session.code().text() != world.session.step().listing.text);
    QVERIFY(!world.button("startTask").isVisible());
    world.press("taskHintButton");
    world.press("taskHintButton");
    QCOMPARE(world.texts("taskHint").size(), 2);
    QCOMPARE(world.button("taskHintButton").text(), QString("Hint 3 of 3"));
    world.press("taskSolution");
    QCOMPARE(world.session.code().text(), world.session.step().listing.text);
    QCOMPARE(world.texts("taskSentence").size(), 1);
    world.press("stopTask");
    QVERIFY(world.texts("taskHint").isEmpty() && world.texts("taskSentence").isEmpty());
}

void TaskBoxTest::buttonAboveTheThingsToTryScrollsToTheTask()
{
    TaskPanelFixture world;
    auto &pointer = *world.panel.findChild<QToolButton *>("toTask");
    QVERIFY(world.box().visibleRegion().isEmpty());
    QTRY_VERIFY(pointer.isVisible());
    QCOMPARE(pointer.text(), QString("Write it yourself"));
    QVERIFY(!pointer.toolTip().isEmpty());
    QCOMPARE(pointer.visibleRegion().boundingRect(), pointer.rect());
    QTest::mouseClick(&pointer, Qt::LeftButton);
    QTRY_VERIFY(!world.box().visibleRegion().isEmpty());
    QTRY_VERIFY(world.button("startTask").isVisible());
    QTRY_VERIFY(!pointer.isVisible()); // the task is in view
    world.press("startTask");
    world.press("taskSolution");
    scrollTo(world.box(), -2000);
    QTRY_VERIFY(pointer.isVisible());
    world.session.openStep("single_spring", "offset");
    QTRY_COMPARE(pointer.isVisible(), !world.session.step().codeTasks.empty());
}

void TaskBoxTest::finishedTaskHasNoButtonAboveTheThingsToTry()
{
    TaskPanelFixture world;
    const auto &toTask = *world.panel.findChild<QToolButton *>("toTask");
    const auto &toPredictions = *world.panel.findChild<QToolButton *>("toPredictions");
    QTRY_VERIFY(toTask.isVisible() && toPredictions.isVisible());
    const QWidget &head = *toTask.parentWidget();
    const int before = head.height();
    world.session.progress().markWritten("single_spring", "fixed_centre", "pull");
    QTRY_VERIFY(toTask.isHidden());
    QTRY_VERIFY(head.height() < before);
    QCOMPARE(toPredictions.visibleRegion().boundingRect(), toPredictions.rect());
}

void TaskBoxTest::theLearnerTypesBelowTheComment_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("task");
    QTest::newRow("gap") << "fixed_centre"
                         << "pull";
    QTest::newRow("whole frame") << "radial"
                                 << "frame";
}

void TaskBoxTest::theLearnerTypesBelowTheComment()
{
    QFETCH(QString, step);
    QFETCH(QString, task);
    listing_window::ListingFixture shown("single_spring", step);
    shown.window.findChild<LearnPanel *>()->setForm(LearnPanel::Form::whole);
    settle();
    const std::vector<lessons::CodeTask> &tasks = shown.session.step().codeTasks;
    const auto found =
        std::find_if(tasks.begin(), tasks.end(), [&](const auto &one) { return one.id == task; });
    TaskBox &box =
        *shown.part<Narration>().findChildren<TaskBox *>()[static_cast<qsizetype>(found - tasks.begin())];
    QTest::mouseClick(box.findChild<WhyButton *>(), Qt::LeftButton);
    settle();
    QTest::mouseClick(box.findChild<QToolButton *>("startTask"), Qt::LeftButton);
    settle();
    const QStringList before = shown.editor.text().split('\n');
    QTest::keyClicks(&shown.editor, "foot.velocity *= 0.5;");
    shown.compile();
    QStringList after = shown.editor.text().split('\n');
    const int line = shown.session.step().listing.lineToWrite(*found);
    QCOMPARE(after[line - 1], before[line - 1] + "foot.velocity *= 0.5;");
    QVERIFY(before[line - 1].size() >= 4 && before[line - 1].trimmed().isEmpty());
    after[line - 1] = before[line - 1];
    QCOMPARE(after, before);
    QVERIFY(shown.session.code().program());
}

void TaskBoxTest::theCommentOfATaskIsInSight()
{
    listing_window::ListingFixture shown("swaying_tree", "towards_pointer");
    const lessons::CodeTask &task = shown.session.step().codeTasks.front();
    QTest::keyClick(&shown.editor, Qt::Key_End, Qt::ControlModifier); // scrolls the task out of view
    settle();
    TaskBox &box = *shown.part<Narration>().findChildren<TaskBox *>().front();
    QTest::mouseClick(box.findChild<WhyButton *>(), Qt::LeftButton);
    settle();
    QTest::mouseClick(box.findChild<QToolButton *>("startTask"), Qt::LeftButton);
    settle();
    const int line = shown.session.step().listing.lineToWrite(task);
    QVERIFY(shown.editor.text(line - 2).contains("//"));
    QVERIFY(shown.editor.viewport()->rect().contains(shown.editor.lineRect(line)));
    QVERIFY(shown.editor.viewport()->rect().contains(shown.editor.lineRect(line - 1)));
}

void TaskBoxTest::thePanelShowsWhatIsWrongAndThenTheTick()
{
    TaskPanelFixture world;
    QTest::mouseClick(world.box().findChild<WhyButton *>(), Qt::LeftButton);
    world.press("startTask");
    const auto with = [&](const QString &code) { return world.session.step().listing.with("pull", code); };
    world.session.code().write(with("foot.velocity += k * (foot.position - centre);"));
    QVERIFY(QTest::qWaitFor([&] { return world.texts("taskSentence").join("").contains("points away"); },
                            30'000));
    world.session.code().write(with("foot.velocity = foot.velocity + (centre - foot.position) * k;"));
    QVERIFY(
        QTest::qWaitFor([&] { return world.box().findChild<WhyButton *>()->text().endsWith("✓"); }, 30'000));
    QVERIFY(world.texts("taskSentence").join("").startsWith("Right"));
}

void TaskBoxTest::theStepIsTickedInTheListOfLessons()
{
    TaskPanelFixture world;
    const LessonModel &lessons = world.panel.findChild<LessonList *>()->lessons();
    const QModelIndex row = lessons.openRow();
    for (int i = 0; i < static_cast<int>(world.session.step().tries.size()); ++i)
        world.session.progress().markDone("single_spring", "fixed_centre", i);
    QVERIFY(!lessons.data(row, LessonModel::doneRole).toBool());
    QCOMPARE(lessons.stepsDone(), 0);
    world.session.progress().markWritten("single_spring", "fixed_centre", "pull");
    QVERIFY(lessons.data(row, LessonModel::doneRole).toBool());
    QCOMPARE(lessons.stepsDone(), 1);
    QVERIFY(lessons.data(row, Qt::AccessibleTextRole).toString().contains(", done"));
}

void TaskBoxTest::theButtonsOfATaskStayInView_data()
{
    addWindows();
}

void TaskBoxTest::theButtonsOfATaskStayInView()
{
    QFETCH(QSize, size);
    QFETCH(QString, language);
    WindowFixture shown({.lesson = "walking_gait", .step = "ground", .size = size, .language = language});
    shown.window.findChild<LearnPanel *>()->setForm(LearnPanel::Form::whole);
    for (std::size_t i = 0; i < shown.session.step().codeTasks.size(); ++i) {
        auto &narration = shown.part<Narration>();
        TaskBox &box = *narration.findChildren<TaskBox *>()[static_cast<qsizetype>(i)];
        settle();
        QTest::mouseClick(box.findChild<WhyButton *>(), Qt::LeftButton);
        settle();
        checkButtons(box, {"startTask"});
        QTest::mouseClick(box.findChild<QToolButton *>("startTask"), Qt::LeftButton);
        settle();
        checkButtons(box, {"taskHintButton", "taskSolution", "stopTask"});
        for (int hint = 0; hint < 3; ++hint) {
            QTest::mouseClick(box.findChild<QToolButton *>("taskHintButton"), Qt::LeftButton);
            settle();
            checkButtons(box, {"taskSolution", "stopTask"});
        }
        scrollTo(box, 0); // its title is at the top, its end is out of view
        checkButtons(box, {"taskSolution", "stopTask"});
        QTest::mouseClick(box.findChild<QToolButton *>("taskSolution"), Qt::LeftButton);
        settle();
        checkButtons(box, {"startTask", "stopTask"});
        QTest::mouseClick(box.findChild<QToolButton *>("stopTask"), Qt::LeftButton);
        settle();
    }
}

void TaskBoxTest::nothingIsCutOffInASmallWindow_data()
{
    addWindows();
}

void TaskBoxTest::nothingIsCutOffInASmallWindow()
{
    QFETCH(QSize, size);
    QFETCH(QString, language);
    WindowFixture shown({.lesson = "walking_gait", .step = "ground", .size = size, .language = language});
    shown.window.findChild<LearnPanel *>()->setForm(LearnPanel::Form::whole);
    settle();
    // Each thing to try has the height that its text needs.
    const auto rows = shown.part<Narration>().findChildren<TryBox *>();
    QCOMPARE(rows.size(), static_cast<qsizetype>(shown.session.step().tries.size()));
    for (const TryBox *row : rows)
        QVERIFY2(row->height() >= row->heightForWidth(row->width()), qPrintable(row->accessibleName()));
    // The last one can be scrolled into view, if it is not there.
    auto &area = shown.part<QScrollArea>("tries");
    area.verticalScrollBar()->setValue(area.verticalScrollBar()->maximum());
    settle();
    QVERIFY(!rows.back()->visibleRegion().isEmpty());
    QVERIFY(rows.back()->visibleRegion().boundingRect().bottom() >= rows.back()->height() - 1);
}

void TaskBoxTest::aTryThatNeedsAPhaseSaysHowToGetOne()
{
    listing_window::ListingFixture shown("rigid_constraint", "pair");
    shown.window.findChild<LearnPanel *>()->setForm(LearnPanel::Form::whole);
    const TryBox &beforeStick = *shown.part<Narration>().findChildren<TryBox *>()[1];
    const auto &todo = *beforeStick.findChild<NarrationText *>("todoText");
    QVERIFY(todo.isHidden());                // the step's own method has phases
    shown.type("share_of_a = 1;", "1", "2"); // as after a task: the learner's code computes the run
    QCOMPARE(shown.session.timeline().script().method->id(), std::string("listing"));
    shown.session.input().setPointer({200.0, 300.0}, true);
    shown.key(Qt::Key_Right);
    QTRY_VERIFY(!todo.isHidden());
    QVERIFY2(todo.toPlainText().contains("Reset listing"), qPrintable(todo.toPlainText()));
    QTest::mouseClick(&shown.part<QToolButton>("resetListing"), Qt::LeftButton);
    QTRY_VERIFY2(todo.toPlainText().contains("Engine"), qPrintable(todo.toPlainText()));
    QVERIFY(!todo.isHidden());
}

SUITE(tst_task_box, TaskBoxTest)
#include "tst_task_box.moc"
