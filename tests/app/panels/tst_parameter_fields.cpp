// The fields of parameters and the input that they accept, by mouse and keyboard.

#include "app/ui/parameters/number_box.h"
#include "app/ui/parameters/parameter_slider.h"
#include "tests/app/support/panel_fixture.h"
#include "tests/suite.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QSettings>
#include <QShortcut>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <QWindow>

#include <cmath>

using namespace app;
using namespace tests;

namespace {

/// Returns the position of a slider's handle for a share of its range.
QPoint onGroove(const ParameterSlider &slider, double share)
{
    return {qRound(8 + (slider.width() - 16) * share), slider.height() / 2};
}

}

class ParameterFieldsTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void aClickOnTheGrooveSetsTheValue();
    void theSliderIsDragged();
    void theArrowKeysMoveTheSlider();
    void aTypedNumberIsSet_data();
    void aTypedNumberIsSet();
    void numberOutOfRangeIsClampedWithAMessage();
    void textThatIsNoNumberChangesNothing();
    void anExactNumberIsNeverRounded();
    void aLargeNumberIsShownInFull_data();
    void aLargeNumberIsShownInFull();
    void aValueBeyondTheSliderHoldsTheHandleAtItsEnd();
    void aChoiceIsChosenByName();
    void aListOfChoicesHasRoomForFingersAndNames();
    void aCountMovesByWholeNumbers();
    void logarithmicSliderStepsThroughLeadingDigits();
    void logarithmicBoxStepsThroughLeadingDigits();
    void wheelChangesOnlyTheFocusedField();
    void aClickSelectsTheNumberAndSpaceOrEnterTakesWhatWasTyped_data();
    void aClickSelectsTheNumberAndSpaceOrEnterTakesWhatWasTyped();
    void aDoubleClickSelectsTheWholeNumber();
    void aClickElsewhereTakesTheTypedNumber();
    void enterLeavesTheFocusInAFieldEnteredByTab();
};

/// A window with something that has the keys, a panel beside it, and a command for Space.
struct BesidePicture
{
    SessionFixture world;
    QWidget window;
    QWidget picture{&window};
    ParameterPanel panel{world.session.run(), world.session.editor(), world.session.playback(), world.theme,
                         &window};
    QShortcut space{Qt::Key_Space, &window};
    QSignalSpy played{&space, &QShortcut::activated};

    BesidePicture()
    {
        picture.setGeometry(0, 0, 100, 200);
        picture.setFocusPolicy(Qt::StrongFocus);
        panel.setGeometry(100, 0, 400, 200);
        window.resize(500, 200);
        window.show();
        QApplication::setActiveWindow(&window);
        picture.setFocus();
    }
    NumberBox &box() { return *rowOf(panel, "k")->findChild<NumberBox *>(); }
};

void ParameterFieldsTest::aClickOnTheGrooveSetsTheValue()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    auto *slider = rowOf(fixture.panel, "k")->findChild<ParameterSlider *>();
    QTest::mouseClick(slider, Qt::LeftButton, {}, onGroove(*slider, 1.0));
    QCOMPARE(fixture.session.editor().parameter("k"), 1.0);
    QTest::mouseClick(slider, Qt::LeftButton, {}, onGroove(*slider, 0.0));
    QCOMPARE(fixture.session.editor().parameter("k"), 0.0);
    QTest::mouseClick(slider, Qt::LeftButton, {}, onGroove(*slider, 0.5));
    QCOMPARE(fixture.session.editor().parameter("k"), 0.5);
    QCOMPARE(rowOf(fixture.panel, "k")->findChild<NumberBox *>()->text(), QString("0.50"));
}

void ParameterFieldsTest::theSliderIsDragged()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    auto *slider = rowOf(fixture.panel, "k")->findChild<ParameterSlider *>();
    const QPoint start = onGroove(*slider, 0.2) + QPoint(3, 0); // beside the handle's middle
    QTest::mousePress(slider, Qt::LeftButton, {}, start);
    QCOMPARE(fixture.session.editor().parameter("k"), 0.2);
    const QPoint way = onGroove(*slider, 0.7) - onGroove(*slider, 0.2);
    QTest::mouseMove(slider, start + way);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, start + way);
    QVERIFY(std::abs(fixture.session.editor().parameter("k") - 0.7) < 0.015);
}

void ParameterFieldsTest::theArrowKeysMoveTheSlider()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    auto *slider = rowOf(fixture.panel, "damp")->findChild<ParameterSlider *>();
    slider->setFocus(Qt::TabFocusReason);
    QTest::keyClick(slider, Qt::Key_Right);
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(fixture.session.editor().parameter("damp"), 0.92); // exactly, not a sum of hundredths
    QTest::keyClick(slider, Qt::Key_Left);
    QCOMPARE(fixture.session.editor().parameter("damp"), 0.91);
}

void ParameterFieldsTest::aTypedNumberIsSet_data()
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

void ParameterFieldsTest::aTypedNumberIsSet()
{
    QFETCH(QString, text);
    QFETCH(int, end);
    QFETCH(double, value);
    PanelFixture<ParameterPanel> fixture({400, 192});
    typeInto(*rowOf(fixture.panel, "k")->findChild<NumberBox *>(), text, Qt::Key(end));
    QCOMPARE(fixture.session.editor().parameter("k"), value);
}

void ParameterFieldsTest::numberOutOfRangeIsClampedWithAMessage()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    QSignalSpy said(&fixture.session.changes(), &ChangeNotifier::messageRequested);
    auto *box = rowOf(fixture.panel, "damp")->findChild<NumberBox *>();
    typeInto(*box, "1.4");
    QCOMPARE(fixture.session.editor().parameter("damp"), 1.0);
    QCOMPARE(said.count(), 1);
    QCOMPARE(said.front().front().toString(), QString("Damping can be 0 to 1."));
    QCOMPARE(box->text(), QString("1.00"));
    typeInto(*box, "-3"); // now it is at the other end
    QCOMPARE(fixture.session.editor().parameter("damp"), 0.0);
    QCOMPARE(said.count(), 2);
    typeInto(*box, "-4"); // nothing changes in the run, but the field must not keep it
    QCOMPARE(box->text(), QString("0.00"));
    QCOMPARE(said.count(), 3);
}

void ParameterFieldsTest::textThatIsNoNumberChangesNothing()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    auto *box = rowOf(fixture.panel, "k")->findChild<NumberBox *>();
    for (const char *text : {"", "-", "1e", "..", "nan"}) {
        typeInto(*box, text);
        QCOMPARE(fixture.session.editor().parameter("k"), 0.2);
        QTest::keyClick(box, Qt::Key_Tab);
        QCOMPARE(box->text(), QString("0.20"));
    }
}

void ParameterFieldsTest::anExactNumberIsNeverRounded()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    fixture.session.editor().setParameter("k", 0.123456);
    auto *box = rowOf(fixture.panel, "k")->findChild<NumberBox *>();
    QVERIFY2(box->text().endsWith(QChar(0x2026)), qPrintable(box->text()));
    QVERIFY2(box->toolTip().contains("0.123456"), qPrintable(box->toolTip()));
    // Entering and leaving the field must not change the value.
    QTest::mouseClick(box, Qt::LeftButton);
    QCOMPARE(box->text(), QString("0.123456"));
    QTest::keyClick(box, Qt::Key_Return); // which leaves it, as a click came here
    QVERIFY(!box->hasFocus());
    QCOMPARE(fixture.session.editor().parameter("k"), 0.123456);
    QVERIFY(box->text().endsWith(QChar(0x2026)));
}

void ParameterFieldsTest::aValueBeyondTheSliderHoldsTheHandleAtItsEnd()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    fixture.session.editor().setParameter("k", 7.5);
    const auto *slider = rowOf(fixture.panel, "k")->findChild<ParameterSlider *>();
    QCOMPARE(slider->value(), slider->maximum());
    QCOMPARE(fixture.session.editor().parameter("k"), 7.5);
    QCOMPARE(rowOf(fixture.panel, "k")->findChild<NumberBox *>()->text(), QString("7.50"));
}

void ParameterFieldsTest::aChoiceIsChosenByName()
{
    SessionFixture world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session.run(), world.session.editor(), world.session.playback(), world.theme);
    show(panel, {400, 400});
    auto *choice = rowOf(panel, "formula")->findChild<QComboBox *>();
    QCOMPARE(choice->currentText(), QString("corrected"));
    choice->setFocus(Qt::TabFocusReason);
    QTest::keyClick(choice, Qt::Key_Down);
    QCOMPARE(choice->currentText(), QString("printed"));
    QCOMPARE(world.session.editor().parameter("formula"), 1.0);
    world.session.editor().resetParameters();
    QCOMPARE(choice->currentText(), QString("corrected"));
}

void ParameterFieldsTest::aListOfChoicesHasRoomForFingersAndNames()
{
    SessionFixture world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session.run(), world.session.editor(), world.session.playback(), world.theme);
    show(panel, {400, 400});
    auto *choice = rowOf(panel, "formula")->findChild<QComboBox *>();
    choice->showPopup();
    QVERIFY(choice->view()->isVisible());
    QVERIFY(choice->view()->sizeHintForRow(0) >= 24); // px, the least that is hit well
    choice->hidePopup();
    QCOMPARE(choice->count(), 2);
    for (int i = 0; i < choice->count(); ++i)
        QVERIFY(choice->view()->width() >= choice->fontMetrics().horizontalAdvance(choice->itemText(i)));
}

void ParameterFieldsTest::aCountMovesByWholeNumbers()
{
    SessionFixture world;
    world.session.openStep("two", "many");
    ParameterPanel panel(world.session.run(), world.session.editor(), world.session.playback(), world.theme);
    show(panel, {400, 400});
    auto *slider = rowOf(panel, "feet")->findChild<ParameterSlider *>();
    auto *box = rowOf(panel, "feet")->findChild<NumberBox *>();
    slider->setFocus(Qt::TabFocusReason);
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(world.session.editor().parameter("feet"), 6.0);
    QTest::keyClick(box, Qt::Key_Up);
    QCOMPARE(world.session.editor().parameter("feet"), 7.0);
    typeInto(*box, "8.4");
    QCOMPARE(world.session.editor().parameter("feet"), 8.0);
    QCOMPARE(box->text(), QString("8"));
}

namespace {

lessons::Parameter oneToAMillion()
{
    lessons::Parameter parameter;
    parameter.id = "many";
    parameter.min = parameter.sliderMin = 1.0;
    parameter.max = parameter.sliderMax = 1e6;
    parameter.decimals = 0;
    parameter.isInteger = true;
    parameter.scale = lessons::Scale::logarithmic;
    return parameter;
}

}

void ParameterFieldsTest::logarithmicSliderStepsThroughLeadingDigits()
{
    SessionFixture world;
    ParameterSlider slider(oneToAMillion(), world.theme);
    QSignalSpy chosen(&slider, &ParameterSlider::chosen);
    QCOMPARE(slider.maximum(), 6 * 9);
    for (int position = 1; position <= slider.maximum(); ++position)
        slider.setValue(position);
    QCOMPARE(chosen.size(), 54);
    double decade = 1.0;
    for (int i = 0; i < 54; ++i) {
        if (i % 9 == 8)
            decade *= 10.0;
        const double digit = i % 9 == 8 ? 1.0 : i % 9 + 2.0;
        QCOMPARE(chosen[i].first().toDouble(), digit * decade);
    }
    // The slider shows any value between the steps. Showing a value does not count as a choice.
    chosen.clear();
    for (const auto &[value, position] : {std::pair{1.0, 0},
                                          {7.0, 6},
                                          {10.0, 9},
                                          {100.0, 18},
                                          {149.0, 18},
                                          {151.0, 19},
                                          {1e6, 54},
                                          {0.0, 0},
                                          {1e9, 54}}) {
        slider.show(value);
        QCOMPARE(slider.value(), position);
    }
    QVERIFY(chosen.isEmpty());
}

void ParameterFieldsTest::aLargeNumberIsShownInFull_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("six figures, without noughts after the point") << 123456.0 << "123456";
    QTest::newRow("a million") << 1e6 << "1000000";
    QTest::newRow("below zero") << -123456.0 << QString(QChar(0x2212)) + "123456";
    QTest::newRow("with a fraction") << 100000.25 << "100000.25";
}

void ParameterFieldsTest::aLargeNumberIsShownInFull()
{
    QFETCH(double, value);
    QFETCH(QString, text);
    SessionFixture world;
    lessons::Parameter parameter = oneToAMillion();
    parameter.isInteger = false;
    parameter.decimals = 2;
    NumberBox box(parameter, world.theme);
    const int usual = box.width();
    box.show(value);
    QCOMPARE(box.text(), text);
    QVERIFY(box.fontMetrics().horizontalAdvance(text) < box.width());
    QCOMPARE(box.sizeHint().width(), box.width());
    box.show(0.5);
    QCOMPARE(box.text(), QString("0.50"));
    QCOMPARE(box.width(), usual);
}

void ParameterFieldsTest::logarithmicBoxStepsThroughLeadingDigits()
{
    SessionFixture world;
    NumberBox box(oneToAMillion(), world.theme);
    const auto pressed = [&](double from, int steps) {
        box.show(from);
        box.stepBy(steps);
        return box.value();
    };
    QCOMPARE(pressed(1.0, 1), 2.0);
    QCOMPARE(pressed(9.0, 1), 10.0);
    QCOMPARE(pressed(10.0, 1), 20.0);
    QCOMPARE(pressed(10.0, -1), 9.0);
    QCOMPARE(pressed(1000.0, 1), 2000.0);
    QCOMPARE(pressed(1000.0, -1), 900.0);
    QCOMPARE(pressed(1.0, -1), 1.0);
    QCOMPARE(pressed(1e6, 1), 1e6);
    box.setFocus();
    box.show(123456.0);
    QCOMPARE(box.text(), QString("123456"));
}

void ParameterFieldsTest::wheelChangesOnlyTheFocusedField()
{
    PanelFixture<ParameterPanel> fixture({400, 192});
    QApplication::setActiveWindow(&fixture.panel);
    const auto turn = [](QWidget &at) {
        const QPointF place = QPointF(at.rect().center());
        QWheelEvent event(place, at.mapToGlobal(place), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QSpontaneKeyEvent::setSpontaneous(&event); // from a mouse, which may move the focus
        qApp->notify(&at, &event);
    };
    QWidget *row = rowOf(fixture.panel, "k");
    const double before = fixture.session.editor().parameter("k");
    for (QWidget *field : {static_cast<QWidget *>(row->findChild<NumberBox *>()),
                           static_cast<QWidget *>(row->findChild<ParameterSlider *>())}) {
        field->clearFocus();
        turn(*field);
        QVERIFY(!field->hasFocus());
        QCOMPARE(fixture.session.editor().parameter("k"), before);
    }
    row->findChild<NumberBox *>()->setFocus();
    turn(*row->findChild<NumberBox *>());
    QVERIFY(fixture.session.editor().parameter("k") > before);
}

void ParameterFieldsTest::aClickSelectsTheNumberAndSpaceOrEnterTakesWhatWasTyped_data()
{
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<int>("played");
    QTest::newRow("Space, which is the window's, too") << Qt::Key_Space << 1;
    QTest::newRow("Enter") << Qt::Key_Return << 0;
}

void ParameterFieldsTest::aClickSelectsTheNumberAndSpaceOrEnterTakesWhatWasTyped()
{
    QFETCH(Qt::Key, key);
    QFETCH(int, played);
    BesidePicture fixture;
    QVERIFY(fixture.picture.hasFocus());
    NumberBox &box = fixture.box();
    auto *edit = box.findChild<QLineEdit *>();
    QTest::mouseClick(edit, Qt::LeftButton);
    QTRY_COMPARE(edit->selectedText(), edit->text());
    QTest::keyClicks(&box, "0.7");
    QTest::keyClick(&box, key);
    QCOMPARE(fixture.world.session.editor().parameter("k"), 0.7);
    QCOMPARE(box.text(), QString("0.70"));
    QCOMPARE(fixture.played.count(), played);
    QVERIFY(fixture.picture.hasFocus());
}

void ParameterFieldsTest::aDoubleClickSelectsTheWholeNumber()
{
    BesidePicture fixture;
    auto *edit = fixture.box().findChild<QLineEdit *>();
    for (int x = 2; x < edit->width(); x += 3) { // also beside the point
        QTest::mouseDClick(edit, Qt::LeftButton, {}, {x, edit->height() / 2});
        QCOMPARE(edit->selectedText(), QString("0.20"));
    }
    QTest::keyClicks(&fixture.box(), "0.3");
    QTest::keyClick(&fixture.box(), Qt::Key_Return);
    QCOMPARE(fixture.world.session.editor().parameter("k"), 0.3);
}

void ParameterFieldsTest::aClickElsewhereTakesTheTypedNumber()
{
    BesidePicture fixture;
    NumberBox &box = fixture.box();
    fixture.picture.setFocusPolicy(Qt::NoFocus); // like a button, which leaves the focus where it is
    box.setFocus(Qt::TabFocusReason);
    QTest::keyClicks(&box, "0.7");
    QTest::mouseClick(fixture.window.windowHandle(), Qt::LeftButton, {}, {50, 100});
    QCOMPARE(fixture.world.session.editor().parameter("k"), 0.7);
    QVERIFY(box.hasFocus());
}

void ParameterFieldsTest::enterLeavesTheFocusInAFieldEnteredByTab()
{
    BesidePicture fixture;
    NumberBox &box = fixture.box();
    box.setFocus(Qt::TabFocusReason);
    QTest::keyClicks(&box, "0.7");
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(fixture.world.session.editor().parameter("k"), 0.7);
    QVERIFY(box.hasFocus());
}

SUITE(tst_parameter_fields, ParameterFieldsTest)

#include "tst_parameter_fields.moc"
