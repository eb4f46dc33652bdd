// The whole window without a mouse.

#include "app/model/session/session.h"
#include "app/ui/dialogs/notice.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/lessons/lesson_list.h"
#include "app/ui/parameters/parameter_panel.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/window/main_window.h"
#include "tests/app/window/keyboard_support.h"
#include "tests/suite.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <set>

using namespace app;
using keyboard_support::LargeWindow;
using namespace tests;

namespace {

/// A window in a mode, with the panels that are hidden at first, and with the focus in the scene.
struct WindowOfPanels : LargeWindow
{
    explicit WindowOfPanels(MainWindow::Mode mode)
    {
        window.setMode(mode);
        window.docks().show(Panel::energy, true);
        window.docks().show(Panel::effects, true);
        QCoreApplication::processEvents();
        view.setFocus();
    }
};

/// Returns whether a widget is a control, or a widget of the program that takes the focus.
bool isInteractive(const QWidget &widget)
{
    if (!widget.isVisible() || !widget.isEnabled() || qobject_cast<const QScrollBar *>(&widget) ||
        qobject_cast<const QMenuBar *>(&widget)) // Alt and a letter, or F10
        return false;
    if (qobject_cast<const QTabBar *>(&widget))
        return true;
    if (widget.parentWidget() && (qobject_cast<const QAbstractSpinBox *>(widget.parentWidget()) ||
                                  qobject_cast<const QTabBar *>(widget.parentWidget()) ||
                                  qobject_cast<const QComboBox *>(widget.parentWidget())))
        return false;                   // a part of a control
    if (widget.inherits("app::TryRow")) // shows what is done; a learner cannot tick it
        return false;
    return qobject_cast<const QAbstractButton *>(&widget) || qobject_cast<const QAbstractSlider *>(&widget) ||
           qobject_cast<const QAbstractSpinBox *>(&widget) || qobject_cast<const QLineEdit *>(&widget) ||
           qobject_cast<const QComboBox *>(&widget) || qobject_cast<const QAbstractItemView *>(&widget) ||
           (widget.focusPolicy() & Qt::TabFocus);
}

QString nameOf(const QWidget &widget)
{
    QString name = QString("%1 \"%2\"").arg(widget.metaObject()->className(), widget.objectName());
    for (const QWidget *holder = widget.parentWidget(); holder; holder = holder->parentWidget())
        name += QString(" in %1").arg(holder->metaObject()->className());
    return name;
}

/// Returns whether both are buttons of one exclusive group. Tab reaches one of the group, arrow keys the others.
bool standsFor(const QWidget &walked, const QWidget &widget)
{
    const auto *one = qobject_cast<const QAbstractButton *>(&walked);
    const auto *other = qobject_cast<const QAbstractButton *>(&widget);
    if (!one || !other || one->parentWidget() != other->parentWidget())
        return false;
    const bool sameGroup = one->group() && one->group() == other->group() && one->group()->exclusive();
    return sameGroup || (one->autoExclusive() && other->autoExclusive());
}

/// Returns all widgets that get the focus when Tab is pressed until it wraps around. A text first visits its links.
std::set<QWidget *> walkedByTab(QWidget &window)
{
    constexpr int mostLinks = 40;
    std::set<QWidget *> walked;
    QWidget *before = nullptr;
    int stays = 0;
    for (QWidget *at = QApplication::focusWidget(); at && at->window() == &window;
         at = QApplication::focusWidget()) {
        stays = at == before ? stays + 1 : 0;
        if (stays > mostLinks || (at != before && !walked.insert(at).second))
            break;
        before = at;
        QTest::keyClick(at, Qt::Key_Tab);
    }
    return walked;
}

}

class KeyboardTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }
    void tabReachesEveryControlAndWrapsAround_data();
    void tabReachesEveryControlAndWrapsAround();
    void everythingThatTakesTheFocusHasANameForReadersOfTheScreen_data();
    void everythingThatTakesTheFocusHasANameForReadersOfTheScreen();
    void spacePlaysAfterAnyClick();
    void theSceneAloneIsOneKeyAwayAndBack();
    void lessonListBecomesARailIfTheScreenIsSmall_data();
    void lessonListBecomesARailIfTheScreenIsSmall();
    void escapeClosesANoticeFromWithinAFieldThatHasNoUseForIt();
    void theKeyOfADisabledCommandSaysWhy();
    void theFocusOfAPanelThatHidesGoesToTheScene();
};

void KeyboardTest::tabReachesEveryControlAndWrapsAround_data()
{
    QTest::addColumn<MainWindow::Mode>("mode");
    QTest::newRow("learning") << MainWindow::Mode::learn;
    QTest::newRow("measuring") << MainWindow::Mode::measure;
}

void KeyboardTest::tabReachesEveryControlAndWrapsAround()
{
    QFETCH(const MainWindow::Mode, mode);
    WindowOfPanels fixture(mode);
    const std::set<QWidget *> walked = walkedByTab(fixture.window);
    QTRY_VERIFY(QApplication::focusWidget());
    QStringList missed;
    int found = 0;
    for (QWidget *widget : fixture.window.findChildren<QWidget *>()) {
        if (!isInteractive(*widget) || widget->window() != &fixture.window)
            continue;
        ++found;
        const QWidget *proxy = widget->focusProxy() ? widget->focusProxy() : widget;
        const bool inside = std::any_of(walked.begin(), walked.end(), [&](const QWidget *at) {
            return at == proxy || at == widget || standsFor(*at, *widget);
        });
        if (!inside)
            missed << nameOf(*widget);
    }
    QVERIFY(found > 30);
    QVERIFY2(missed.isEmpty(), qPrintable("Tab does not come to:\n" + missed.join('\n')));
}

void KeyboardTest::everythingThatTakesTheFocusHasANameForReadersOfTheScreen_data()
{
    tabReachesEveryControlAndWrapsAround_data();
}

void KeyboardTest::everythingThatTakesTheFocusHasANameForReadersOfTheScreen()
{
    QFETCH(const MainWindow::Mode, mode);
    WindowOfPanels fixture(mode);
    QStringList nameless;
    for (QWidget *widget : walkedByTab(fixture.window)) {
        QAccessibleInterface *reader = QAccessible::queryAccessibleInterface(widget);
        if (!reader || reader->text(QAccessible::Name).isEmpty())
            nameless << nameOf(*widget);
    }
    QVERIFY2(nameless.isEmpty(), qPrintable("Nameless:\n" + nameless.join('\n')));
}

void KeyboardTest::spacePlaysAfterAnyClick()
{
    LargeWindow fixture("single_spring", "drag");
    const auto plays = [&](QWidget *clicked, QPoint at) {
        fixture.window.findChild<SceneView *>()->setFocus();
        QTest::mouseClick(clicked, Qt::LeftButton, {}, at);
        const QString step = fixture.session.step().id;
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        const bool isPlaying = fixture.session.playback().isPlaying() && fixture.session.step().id == step;
        fixture.session.playback().pause();
        return isPlaying;
    };
    auto *next = fixture.window.findChild<QPushButton *>("next");
    QVERIFY(plays(next, next->rect().center()));
    QVERIFY(plays(next, next->rect().center()));
    auto *list = fixture.window.findChild<LessonList *>();
    QVERIFY(plays(list->viewport(), list->visualRect(list->currentIndex()).center()));
    auto *reset = fixture.window.findChild<QToolButton *>("resetAll");
    QVERIFY(plays(reset, reset->rect().center()));
    // A keyboard user reaches the button by Tab and presses it with Space.
    const QString before = fixture.session.step().id;
    next->setFocus(Qt::TabFocusReason);
    QTest::keyClick(next, Qt::Key_Space);
    QVERIFY(fixture.session.step().id != before);
    QVERIFY(!fixture.session.playback().isPlaying());
}

void KeyboardTest::theSceneAloneIsOneKeyAwayAndBack()
{
    LargeWindow fixture;
    const QStringList before = fixture.shownDocks();
    QVERIFY(before.contains("lessons") && before.contains("code"));
    QTest::keyClick(&fixture.window, Qt::Key_F11);
    QCOMPARE(fixture.shownDocks(), QStringList());
    QVERIFY(fixture.window.findChild<SceneView *>()->isVisible());
    QTest::keyClick(&fixture.window, Qt::Key_F11);
    QCOMPARE(fixture.shownDocks(), before);
}

void KeyboardTest::lessonListBecomesARailIfTheScreenIsSmall_data()
{
    QTest::addColumn<QSize>("room");
    QTest::addColumn<bool>("rail");
    QTest::newRow("1920 x 1080") << QSize(1920, 1080) << false;
    QTest::newRow("1280 x 800") << QSize(1280, 800) << false;
    QTest::newRow("1920 x 1080 at 200 %") << QSize(960, 540) << true;
    QTest::newRow("1280 x 800 at 150 %") << QSize(853, 533) << true;
    QTest::newRow("as small as can be") << QSize(800, 500) << true;
}

void KeyboardTest::lessonListBecomesARailIfTheScreenIsSmall()
{
    QFETCH(const QSize, room);
    QFETCH(const bool, rail);
    LargeWindow fixture;
    const auto isRail = [&fixture] {
        return fixture.window.findChild<LearnPanel *>()->form() == LearnPanel::Form::rail;
    };
    fixture.window.fitInto(room);
    QCoreApplication::processEvents();
    QCOMPARE(isRail(), rail);
    QVERIFY(fixture.shownDocks().contains("code"));
    QVERIFY2(fixture.window.width() <= room.width() && fixture.window.height() <= room.height(),
             qPrintable(QString("%1 x %2").arg(fixture.window.width()).arg(fixture.window.height())));
    QTest::keyClick(&fixture.window, Qt::Key_1,
                    Qt::ControlModifier | Qt::ShiftModifier); // comes back when asked for
    settle();
    QCOMPARE(isRail(), !rail);
}

void KeyboardTest::escapeClosesANoticeFromWithinAFieldThatHasNoUseForIt()
{
    LargeWindow fixture;
    auto *notice = fixture.window.findChild<Notice *>();
    fixture.window.openFile("/no/such/file.json");
    QVERIFY(notice->isVisible());
    QLineEdit *stop = nullptr; // "Stop when", below the code
    for (QLineEdit *one : fixture.window.findChildren<QLineEdit *>()) {
        if (one->isVisible() && !qobject_cast<QAbstractSpinBox *>(one->parentWidget()))
            stop = one;
    }
    QVERIFY(stop);
    stop->setFocus();
    QTest::keyClicks(stop, "frame");
    QTest::keyClick(stop, Qt::Key_Escape);
    QVERIFY(!notice->isVisible());
    QCOMPARE(stop->text(), QString("frame"));
    fixture.window.openFile("/no/such/file.json");
    auto *number = fixture.window.findChild<ParameterPanel *>()->findChild<QAbstractSpinBox *>();
    const QString before = number->text();
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, "7");
    QTest::keyClick(number, Qt::Key_Escape); // first of all the number
    QCOMPARE(number->text(), before);
    QVERIFY(notice->isVisible());
    QTest::keyClick(number, Qt::Key_Escape);
    QVERIFY(!notice->isVisible());
}

void KeyboardTest::theKeyOfADisabledCommandSaysWhy()
{
    LargeWindow fixture;
    QSignalSpy messages(&fixture.session.changes(), &ChangeNotifier::messageRequested);
    fixture.key(Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(messages.size(), 1);
    QCOMPARE(messages.front().front().toString(), QString("There is no folder for the gallery"));
    fixture.key(Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier | Qt::AltModifier); // of no command
    QCOMPARE(messages.size(), 1);
}

void KeyboardTest::theFocusOfAPanelThatHidesGoesToTheScene()
{
    LargeWindow fixture;
    auto *slider = fixture.part<ParameterPanel>().findChild<QAbstractSlider *>();
    QVERIFY(slider);
    slider->setFocus();
    QTRY_VERIFY(slider->hasFocus());
    fixture.dock("parameters").hide();
    QTRY_COMPARE(QApplication::focusWidget(), static_cast<QWidget *>(&fixture.view));
}

SUITE(tst_keyboard, KeyboardTest)
#include "tst_keyboard.moc"
