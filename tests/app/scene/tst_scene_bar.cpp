// The bar above the scene.

#include "app/model/text/step_text.h"
#include "app/ui/scene/flat_button.h"
#include "app/ui/scene/scene_bar.h"
#include "tests/app/scene/scene_support.h"
#include "tests/suite.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QtTest>

using namespace app;

namespace {

/// The action called `text` in any menu of `bar`.
QAction *entry(const SceneBar &bar, const QString &text)
{
    for (const QMenu *menu : bar.findChildren<QMenu *>()) {
        for (QAction *action : menu->actions()) {
            if (action->text() == text)
                return action;
        }
    }
    return nullptr;
}

/// The button whose accessible name begins with `name`.
QToolButton *button(const SceneBar &bar, const QString &name)
{
    for (QToolButton *one : bar.findChildren<QToolButton *>()) {
        if (one->accessibleName().startsWith(name))
            return one;
    }
    return nullptr;
}

}

class SceneBarTest : public QObject
{
    Q_OBJECT

private slots:
    void stepsAreReadAsTyped_data();
    void stepsAreReadAsTyped();
    void theBarSetsMethodAndStep();
    void theBarTakesATypedStep();
    void theMenuHasRoomToSayWhyAStepIsInvalid_data();
    void theMenuHasRoomToSayWhyAStepIsInvalid();
    void theBarOffersTolerancesToAdaptiveMethods();
    void theBarZoomsTheView();
    void theBarFitsInEveryWidth_data();
    void theBarFitsInEveryWidth();
    void theCaptionOfTheStepStaysLongest();
};

void SceneBarTest::stepsAreReadAsTyped_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("h");
    QTest::newRow("a fraction") << "1/6" << 1.0 / 6.0;
    QTest::newRow("with its unit") << "1/6 frame" << 1.0 / 6.0;
    QTest::newRow("a number") << "0.25" << 0.25;
    QTest::newRow("a comma") << "0,25" << 0.25;
    QTest::newRow("a division by nought") << "1/0" << 0.0;
    QTest::newRow("no number") << "half" << 0.0;
    QTest::newRow("nothing") << "" << 0.0;
}

void SceneBarTest::stepsAreReadAsTyped()
{
    QFETCH(QString, text);
    QFETCH(double, h);
    QCOMPARE(stepFromText(text), h);
}

void SceneBarTest::theBarSetsMethodAndStep()
{
    SceneFixture fixture;
    SceneBar bar(fixture.session.run(), fixture.session.editor(), fixture.session.code(), fixture.theme);
    bar.attach(fixture.view, fixture.fit);
    QVERIFY(entry(bar, "1 frame")->isChecked());
    entry(bar, "1/4 frame")->trigger();
    QCOMPARE(fixture.session.timeline().script().step.h, 0.25);
    QVERIFY(button(bar, "Step 1/4 frame"));
    QVERIFY(!entry(bar, "1 frame")->isChecked());
    for (const QMenu *menu : bar.findChildren<QMenu *>()) {
        for (QAction *action : menu->actions()) {
            if (action->data().toString() == "semi_implicit_euler")
                action->trigger();
        }
    }
    QCOMPARE(fixture.session.timeline().script().method->id(), "semi_implicit_euler");
    fixture.session.editor().setStepSize(2.0);
    QVERIFY(button(bar, "Step 2 frames"));
}

void SceneBarTest::theBarTakesATypedStep()
{
    SceneFixture fixture;
    SceneBar bar(fixture.session.run(), fixture.session.editor(), fixture.session.code(), fixture.theme);
    bar.attach(fixture.view, fixture.fit);
    bar.show();
    auto *field = bar.findChild<QLineEdit *>();
    QTest::keyClicks(field, "0.3");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(fixture.session.timeline().script().step.h, 1.0); // neither whole nor one over a whole number
    field->clear();
    QTest::keyClicks(field, "1/6");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(fixture.session.timeline().script().step.h, 1.0 / 6.0);
    QVERIFY(button(bar, "Step 1/6 frame"));
}

void SceneBarTest::theMenuHasRoomToSayWhyAStepIsInvalid_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("why");
    QTest::newRow("a number that is not allowed") << "0.3"
                                                  << "The step 0.3 is not allowed.";
    QTest::newRow("not a number") << "abc"
                                  << "A whole number of frames, or 1 divided by a whole number";
}

void SceneBarTest::theMenuHasRoomToSayWhyAStepIsInvalid()
{
    QFETCH(QString, typed);
    QFETCH(QString, why);
    SceneFixture fixture;
    SceneBar bar(fixture.session.run(), fixture.session.editor(), fixture.session.code(), fixture.theme);
    bar.attach(fixture.view, fixture.fit);
    bar.show();
    auto *field = bar.findChild<QLineEdit *>();
    auto *menu = qobject_cast<QMenu *>(field->parentWidget()->parentWidget());
    QVERIFY(menu);
    menu->popup({0, 0});
    QTRY_VERIFY(field->isVisible());
    QTest::keyClicks(field, typed);
    QTest::keyClick(field, Qt::Key_Return);
    auto *sentence = menu->findChild<QLabel *>("caption");
    QTRY_VERIFY(sentence->isVisible());
    QVERIFY2(sentence->text().startsWith(why), qPrintable(sentence->text()));
    const auto placeOf = [menu](const QWidget *part) {
        return QRect(part->mapTo(menu, QPoint()), part->size());
    };
    QTRY_VERIFY(menu->rect().contains(placeOf(sentence)));
    QVERIFY(sentence->height() >= sentence->heightForWidth(sentence->width()));
    QVERIFY(!placeOf(sentence).intersects(placeOf(field)));
    menu->close();
    menu->popup({0, 0});
    QTRY_VERIFY(field->isVisible());
    QVERIFY(!sentence->isVisible() && field->text().isEmpty());
    menu->close();
}

void SceneBarTest::theBarOffersTolerancesToAdaptiveMethods()
{
    SceneFixture fixture;
    SceneBar bar(fixture.session.run(), fixture.session.editor(), fixture.session.code(), fixture.theme);
    bar.attach(fixture.view, fixture.fit);
    bar.show();
    const QString tolerance = QString("0.1\u2009px");
    QVERIFY(!entry(bar, tolerance)->isVisible());
    fixture.session.editor().setMethod("dormand_prince");
    QVERIFY(button(bar, "Tolerance 0.001"));
    QVERIFY(entry(bar, tolerance)->isVisible());
    QVERIFY(!entry(bar, "1 frame")->isVisible());
    entry(bar, tolerance)->trigger();
    QCOMPARE(fixture.session.timeline().script().step, sim::StepSize::withTolerance(0.1));
    QVERIFY(entry(bar, tolerance)->isChecked());
    auto *field = bar.findChild<QLineEdit *>();
    QTest::keyClicks(field, "1000");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(fixture.session.timeline().script().step, sim::StepSize::withTolerance(0.1)); // too much
    field->clear();
    QTest::keyClicks(field, "5e-4");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(fixture.session.timeline().script().step, sim::StepSize::withTolerance(5e-4));
    fixture.session.editor().setMethod("rk4");
    QVERIFY(button(bar, "Step 1 frame"));
    QVERIFY(entry(bar, "1 frame")->isVisible());
}

void SceneBarTest::theBarZoomsTheView()
{
    SceneFixture fixture;
    SceneBar bar(fixture.session.run(), fixture.session.editor(), fixture.session.code(), fixture.theme);
    bar.attach(fixture.view, fixture.fit);
    bar.show();
    fixture.view.zoomIn();
    auto *zoom = button(bar, QString("Zoom %1").arg(qRound(fixture.view.zoom())));
    QVERIFY(zoom);
    QTest::mouseClick(zoom, Qt::LeftButton);
    QCOMPARE(fixture.view.zoom(), 100.0);
    QTest::mouseClick(button(bar, "Fit"), Qt::LeftButton);
    QVERIFY(fixture.view.zoom() != 100.0);
    entry(bar, "Velocity arrows")->trigger();
    QVERIFY(fixture.view.extras().velocities);
    entry(bar, "Trails")->trigger();
    QVERIFY(!fixture.view.extras().trails);
}

void SceneBarTest::theBarFitsInEveryWidth_data()
{
    QTest::addColumn<int>("width");
    QTest::newRow("480") << 480;
    QTest::newRow("600") << 600;
    QTest::newRow("1000") << 1000;
}

void SceneBarTest::theBarFitsInEveryWidth()
{
    QFETCH(int, width);
    SceneFixture fixture;
    fixture.session.editor().setMethod("semi_implicit_euler");
    fixture.session.editor().setStepSize(1.0 / 64.0);
    SceneBar bar(fixture.session.run(), fixture.session.editor(), fixture.session.code(), fixture.theme);
    bar.attach(fixture.view, fixture.fit);
    bar.resize(width, bar.height());
    bar.show();
    QApplication::processEvents();
    QCOMPARE(bar.size(), QSize(width, 36));
    int end = 0;
    for (const QToolButton *one : bar.findChildren<QToolButton *>()) {
        QVERIFY(one->x() >= end);
        QVERIFY(one->height() >= 24);
        end = one->geometry().right();
    }
    QVERIFY(end > 0 && end < width);
}

void SceneBarTest::theCaptionOfTheStepStaysLongest()
{
    SceneFixture fixture;
    SceneBar bar(fixture.session.run(), fixture.session.editor(), fixture.session.code(), fixture.theme);
    bar.attach(fixture.view, fixture.fit);
    bar.show();
    auto *method = qobject_cast<FlatButton *>(button(bar, "Method"));
    auto *step = qobject_cast<FlatButton *>(button(bar, "Step"));
    QVERIFY(method && step);
    bool hasStepAlone = false;
    for (int width = 800; width >= bar.minimumSizeHint().width(); width -= 4) {
        bar.resize(width, bar.height());
        QApplication::processEvents();
        const bool hasMethod = method->width() == method->fullWidth();
        const bool hasStep = step->width() == step->fullWidth();
        QVERIFY(hasStep || !hasMethod);
        hasStepAlone = hasStepAlone || (hasStep && !hasMethod);
    }
    QVERIFY(hasStepAlone);
}

SUITE(tst_scene_bar, SceneBarTest)
#include "tst_scene_bar.moc"
