#include "tests/app/code/steering_support.h"
#include "tests/suite.h"

#include <QSignalSpy>

#include <cmath>

using namespace steering_support;

/// Parameters that are dragged and typed over in the code.
class TestCodeNumbers : public QObject
{
    Q_OBJECT

private slots:
    void aNumberIsDraggedInTheText_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("word");
        QTest::addColumn<QString>("parameter");
        QTest::newRow("where it is read") << "gravity = values"
                                          << "values[\"gravity\"]"
                                          << "gravity";
        QTest::newRow("the variable") << "gravity = values"
                                      << "gravity"
                                      << "gravity";
        QTest::newRow("in a phase") << "Vec2 pull = {0, gravity}"
                                    << "gravity"
                                    << "gravity";
        QTest::newRow("a member") << "x.y > room.floor"
                                  << "room.floor"
                                  << "floor";
    }
    void aNumberIsDraggedInTheText()
    {
        QFETCH(QString, line);
        QFETCH(QString, word);
        QFETCH(QString, parameter);
        SteeringFixture shown;
        const lessons::Parameter &one = *shown.session.step().parameter(parameter);
        const double before = shown.session.editor().parameter(parameter);
        const double width = one.sliderMax - one.sliderMin;
        shown.drag(shown.middleOf(line, word), 40);
        QVERIFY(std::abs(shown.session.editor().parameter(parameter) - (before + 0.2 * width)) <=
                std::pow(10.0, -one.decimals));
        QCOMPARE(shown.at(), sim::Cursor{}); // a drag is not a click
        QCOMPARE(shown.session.editor().undoStack().count(), 1);
        shown.session.editor().undo();
        QCOMPARE(shown.session.editor().parameter(parameter), before);
        shown.drag(shown.middleOf(line, word), -40, Qt::ShiftModifier);
        QVERIFY(std::abs(shown.session.editor().parameter(parameter) - (before - 0.02 * width)) <=
                std::pow(10.0, -one.decimals));
        shown.drag(shown.middleOf(line, word), 20);
        QCOMPARE(shown.session.editor().undoStack().count(), 2); // another gesture
    }

    void escapeCancelsADrag()
    {
        SteeringFixture shown;
        const QPoint from = shown.middleOf("gravity = values", "values");
        QTest::mousePress(shown.view().viewport(), Qt::LeftButton, {}, from);
        shown.move(from + QPoint(30, 0), Qt::LeftButton);
        QVERIFY(shown.session.editor().parameter("gravity") != 0.5);
        shown.key(Qt::Key_Escape);
        QCOMPARE(shown.session.editor().parameter("gravity"), 0.5);
        shown.move(from + QPoint(60, 0), Qt::LeftButton);
        QTest::mouseRelease(shown.view().viewport(), Qt::LeftButton, {}, from + QPoint(60, 0));
        QCOMPARE(shown.session.editor().parameter("gravity"), 0.5);
        QCOMPARE(shown.session.editor().undoStack().count(), 0);
    }

    void theValueAtTheEndOfTheLineIsDraggedToo()
    {
        SteeringFixture shown;
        const std::size_t row = shown.row("gravity = values");
        shown.view().showPlace(shown.view().placeOf(row));
        const QRect rect = shown.view().rowRect(row);
        QVERIFY(!shown.view().chipText(row).isEmpty());
        shown.drag({rect.right() - 24, rect.center().y()}, -20);
        QVERIFY(shown.session.editor().parameter("gravity") < 0.5);
    }

    void aNumberIsTypedOver_data()
    {
        QTest::addColumn<bool>("keyboard");
        QTest::newRow("double-click") << false;
        QTest::newRow("F2") << true;
    }
    void aNumberIsTypedOver()
    {
        QFETCH(bool, keyboard);
        SteeringFixture shown;
        QSignalSpy said(&shown.session.changes(), &ChangeNotifier::messageRequested);
        const QPoint there = shown.middleOf("gravity = values", "values");
        if (keyboard) {
            shown.goToRow("gravity = values");
            shown.key(Qt::Key_F2);
        } else {
            QTest::mouseDClick(shown.view().viewport(), Qt::LeftButton, {}, there);
        }
        QVERIFY(shown.editor() && shown.editor()->hasFocus());
        QVERIFY(shown.editor()->geometry().contains(keyboard ? shown.middleOf("gravity = values", "gravity")
                                                             : there));
        QCOMPARE(shown.editor()->text().toDouble(), 0.5);
        QTest::keyClicks(shown.editor(), "much");
        QTest::keyClick(shown.editor(), Qt::Key_Return);
        QCOMPARE(said.count(), 1);
        QVERIFY(said[0][0].toString().contains("much"));
        QCOMPARE(shown.session.editor().parameter("gravity"), 0.5);
        QTest::keyClicks(shown.editor(), "1.25");
        QTest::keyClick(shown.editor(), Qt::Key_Return);
        QCOMPARE(shown.session.editor().parameter("gravity"), 1.25);
        QCOMPARE(shown.session.editor().undoStack().count(), 1);
        QTRY_VERIFY(!shown.editor());
        QVERIFY(shown.view().hasFocus());
        QCOMPARE(shown.at(), sim::Cursor{});
    }

    void escapeLeavesANumberAsItWas()
    {
        SteeringFixture shown;
        shown.goToRow("gravity = values");
        shown.key(Qt::Key_F2);
        QTest::keyClicks(shown.editor(), "3");
        QTest::keyClick(shown.editor(), Qt::Key_Escape);
        QTRY_VERIFY(!shown.editor());
        QCOMPARE(shown.session.editor().parameter("gravity"), 0.5);
        shown.key(Qt::Key_F2);
        QTest::keyClicks(shown.editor(), "3");
        shown.button("Copy")->setFocus(Qt::TabFocusReason);
        QTRY_VERIFY(!shown.editor());
        QCOMPARE(shown.session.editor().parameter("gravity"), 0.5);
    }
};

SUITE(tst_code_numbers, TestCodeNumbers)
#include "tst_code_numbers.moc"
