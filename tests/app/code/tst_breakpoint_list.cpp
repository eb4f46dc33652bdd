#include "app/ui/code/breakpoint_list.h"
#include "tests/app/code/code_support.h"
#include "tests/suite.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QSignalSpy>

using namespace code_support;

namespace {

struct Stopped : CodeFixture
{
    Stopped() : CodeFixture("gravity_walls", "gravity") { QVERIFY(QTest::qWaitForWindowActive(&window)); }

    sim::Cursor at() const { return session.timeline().cursor(); }
    const std::vector<Breakpoint> &all() const { return session.playback().breakpoints().all(); }
    QLineEdit *field() { return panel->stops().field(); }
    void type(const QString &text)
    {
        field()->setFocus();
        field()->selectAll();
        QTest::keyClicks(field(), text);
        QTest::keyClick(field(), Qt::Key_Return);
        QCoreApplication::processEvents(); // the list follows a little later
    }
    template <class Widget>
    Widget *inRow(const QString &name, std::size_t index)
    {
        QCoreApplication::processEvents();
        return panel->stops().findChild<Widget *>(name + QString::number(all()[index].id));
    }
    QPoint margin(const QString &line)
    {
        const std::size_t there = row(line);
        view().showPlace(view().placeOf(there));
        return {CodeView::marginsWidth() - 16, view().rowRect(there).center().y()};
    }
    void clickMargin(const QString &line)
    {
        QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, margin(line));
    }
    bool isRed(const QString &line)
    {
        const QImage image = view().viewport()->grab().toImage();
        const QPoint middle = margin(line);
        for (int dx = -6; dx <= 4; ++dx) {
            const QColor color = image.pixelColor(middle + QPoint(dx, 0));
            if (color.red() - color.green() > 80 && color.red() - color.blue() > 80)
                return true;
        }
        return false;
    }
};

constexpr const char *falls = "Vec2 pull = {0, gravity}";

}

/// Setting and editing breakpoints in the panel.
class TestCodeStops : public QObject
{
    Q_OBJECT

private slots:
    void clickInTheMarginTogglesABreakpoint()
    {
        Stopped shown;
        QVERIFY(!shown.isRed(falls));
        shown.clickMargin(falls);
        QCOMPARE(shown.all().size(), std::size_t(1));
        QVERIFY(shown.all()[0].place == shown.view().placeOf(shown.row(falls)));
        QVERIFY(shown.isRed(falls));
        QCOMPARE(shown.at(), sim::Cursor{}); // nothing ran
        shown.session.playback().frameForward();
        QCOMPARE(shown.at(), (sim::Cursor{0, 1}));
        shown.clickMargin(falls);
        QVERIFY(shown.all().empty());
        QVERIFY(!shown.isRed(falls));
    }

    void f9TogglesABreakpoint()
    {
        Stopped shown;
        shown.view().showPlace(shown.view().placeOf(shown.row(falls)));
        shown.view().setFocus(Qt::TabFocusReason);
        QTest::keyClick(&shown.view(), Qt::Key_F9);
        QCOMPARE(shown.all().size(), std::size_t(1));
        QTest::keyClick(&shown.view(), Qt::Key_F9);
        QVERIFY(shown.all().empty());
        shown.view().showPlace(shown.view().placeOf(shown.row("Scene scene")));
        QSignalSpy said(&shown.session.changes(), &ChangeNotifier::messageRequested);
        QTest::keyClick(&shown.view(), Qt::Key_F9);
        QVERIFY(shown.all().empty());
        QVERIFY(said[0][0].toString().contains("before the first frame"));
    }

    void aConditionIsTypedInTheField()
    {
        Stopped shown;
        shown.type("frame == 3 and phase == \"damping\"");
        QCOMPARE(shown.field()->text(), QString());
        QCOMPARE(shown.all().size(), std::size_t(1));
        QVERIFY(shown.panel->stops().errorText().isEmpty());
        shown.session.playback().runTo({9, 0});
        QTRY_VERIFY(!shown.session.playback().goal()); // computed in slices
        QCOMPARE(shown.at(), (sim::Cursor{3, 2}));
        QVERIFY(
            shown.session.playback().breakHit()->sentence.startsWith("Stopped at frame 3 before damping: "));
    }

    void invalidConditionIsRefusedAndStaysInItsField()
    {
        Stopped shown;
        shown.type("foot9.y > 380");
        QVERIFY(shown.all().empty());
        QVERIFY(shown.panel->stops().errorText().startsWith("Character 1: "));
        QCOMPARE(shown.field()->text(), QString("foot9.y > 380"));
        QTest::keyClick(shown.field(), Qt::Key_Backspace);
        QVERIFY(shown.panel->stops().errorText().isEmpty());
        shown.type("foot0.y > 380");
        QCOMPARE(shown.all().size(), std::size_t(1));
    }

    void theListSwitchesOffEditsAndDeletes()
    {
        Stopped shown;
        shown.clickMargin(falls);
        shown.type("frame == 4");
        QCOMPARE(shown.all().size(), std::size_t(2));
        auto *on = shown.inRow<QCheckBox>("on", 0);
        QVERIFY(on && on->isChecked() && on->text().startsWith("gravity.cpp:"));
        QTest::mouseClick(on, Qt::LeftButton, {}, {8, on->height() / 2});
        QVERIFY(!shown.all()[0].isOn);
        QVERIFY(shown.isRed(falls)); // a ring
        shown.session.playback().frameForward();
        QCOMPARE(shown.at(), (sim::Cursor{1, 0}));
        auto *condition = shown.inRow<QLineEdit>("condition", 1);
        QCOMPARE(condition->text(), QString("frame == 4"));
        condition->setFocus();
        condition->selectAll();
        QTest::keyClicks(condition, "frame == ");
        QTest::keyClick(condition, Qt::Key_Return);
        QVERIFY(shown.panel->stops().errorText().startsWith("Character "));
        QCOMPARE(shown.all()[1].condition, QString("frame == 4"));
        QTest::keyClicks(condition, "2");
        QTest::keyClick(condition, Qt::Key_Return);
        QCOMPARE(shown.all()[1].condition, QString("frame == 2"));
        QVERIFY(shown.panel->stops().errorText().isEmpty());
        shown.session.playback().runTo({9, 0});
        QTRY_VERIFY(!shown.session.playback().goal()); // computed in slices
        QCOMPARE(shown.at(), (sim::Cursor{2, 0}));
        QTest::mouseClick(shown.inRow<QToolButton>("remove", 1), Qt::LeftButton);
        QTest::mouseClick(shown.inRow<QToolButton>("remove", 0), Qt::LeftButton);
        QVERIFY(shown.all().empty());
        QTRY_VERIFY(!shown.panel->stops().findChild<QCheckBox *>());
    }

    void aLineGetsAConditionInTheList()
    {
        Stopped shown;
        shown.clickMargin(falls);
        auto *condition = shown.inRow<QLineEdit>("condition", 0);
        condition->setFocus();
        QTest::keyClicks(condition, "frame == 5");
        QTest::keyClick(condition, Qt::Key_Return);
        QCOMPARE(shown.all()[0].condition, QString("frame == 5"));
        shown.session.playback().runTo({9, 0});
        QTRY_VERIFY(!shown.session.playback().goal()); // computed in slices
        QCOMPARE(shown.at(), (sim::Cursor{5, 1}));
        condition = shown.inRow<QLineEdit>("condition", 0);
        condition->selectAll();
        QTest::keyClick(condition, Qt::Key_Delete);
        QTest::keyClick(condition, Qt::Key_Return);
        QCOMPARE(shown.all()[0].condition, QString()); // always, again
    }

    void theLineThatStoppedComesIntoView()
    {
        Stopped shown;
        shown.clickMargin(falls);
        shown.panel->resize(400, 300);
        shown.session.playback().runTo({9, 0});
        QTRY_VERIFY(!shown.session.playback().goal()); // computed in slices
        QVERIFY(shown.session.playback().breakHit());
        QVERIFY(shown.view().viewport()->rect().contains(shown.view().rowRect(shown.row(falls))));
        shown.panel->resize(400, 240); // as when the list below grows
        QCoreApplication::processEvents();
        QVERIFY(shown.view().viewport()->rect().contains(shown.view().rowRect(shown.row(falls))));
    }

    void playingStopsAtThePhase()
    {
        Stopped shown;
        shown.type("foot0.y > 300");
        sim::Timeline search(shown.session.timeline().script());
        while (search.state().position(0, 1) <= 300.0)
            search.nextPhase();
        shown.session.playback().play();
        QTRY_VERIFY_WITH_TIMEOUT(!shown.session.playback().isPlaying(), 20000);
        QCOMPARE(shown.at(), search.cursor());
        QVERIFY(sim::sameBits(shown.session.timeline().state(), search.state()));
    }

    void screenReadersGetANameForEachControl()
    {
        Stopped shown;
        shown.clickMargin(falls);
        shown.type("frame == 4");
        QCoreApplication::processEvents();
        int seen = 0;
        for (QWidget *widget : shown.panel->stops().findChildren<QWidget *>()) {
            if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisibleTo(shown.panel))
                continue;
            ++seen;
            QVERIFY2(!widget->accessibleName().isEmpty(), widget->metaObject()->className());
            QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->accessibleName()));
        }
        QVERIFY2(seen >= 3,
                 qPrintable(QString::number(seen))); // the switch, the condition, the button that deletes
    }
};

SUITE(tst_breakpoint_list, TestCodeStops)
#include "tst_breakpoint_list.moc"
