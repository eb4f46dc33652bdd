// The height that the text of a step and the things to try share.

#include "app/ui/learn/step/step_room.h"
#include "tests/app/support/waiting.h"
#include "tests/suite.h"

#include <QLabel>
#include <QVBoxLayout>
#include <QtTest>

using namespace app;

namespace {

/// A panel of 300 x 400 px with a text of 800 px, whose last 60 px are `box`, and things to try of `tries` px.
struct RoomFixture
{
    RoomFixture()
    {
        panel.setAttribute(Qt::WA_DontShowOnScreen);
        panel.resize(300, 400);
        auto *text = new QVBoxLayout;
        text->setContentsMargins(0, 0, 0, 0);
        text->setSpacing(0);
        auto *story = new QLabel("A text that wraps", room.page());
        story->setWordWrap(true);
        story->setFixedHeight(740);
        box = new QWidget(room.page());
        box->setFixedHeight(60);
        text->addWidget(story);
        text->addWidget(box);
        room.addText(text);
        tries = new QWidget;
        auto *column = new QVBoxLayout(tries);
        column->setContentsMargins(0, 0, 0, 0);
        one = new QWidget(tries);
        one->setFixedHeight(40);
        column->addWidget(one);
        buttons = new QWidget;
        buttons->setFixedHeight(30);
        heading = new QWidget;
        heading->setFixedHeight(20);
        room.addBelow(heading, tries, buttons);
        panel.show();
        fit();
    }
    void fit()
    {
        room.fit(100);
        settle();
    }
    bool isWhole() const
    {
        const int top = box->mapTo(room.viewport(), QPoint()).y();
        return top >= 0 && top + box->height() <= room.viewport()->height();
    }

    QWidget panel;
    StepRoom room{panel};
    QWidget *box = nullptr;
    QWidget *heading = nullptr;
    QWidget *tries = nullptr;
    QWidget *one = nullptr;
    QWidget *buttons = nullptr;
};

}

class StepRoomTest : public QObject
{
    Q_OBJECT

private slots:
    void aBoxShownWholeStaysWholeWhenTheTriesGrow();
    void aBoxShownWholeStaysWholeWhenItGrows();
    void aLearnerWhoScrolledIsLeftWhereSheIs();
    void theHeadingStaysWhileTheTriesScroll();
};

void StepRoomTest::aBoxShownWholeStaysWholeWhenTheTriesGrow()
{
    RoomFixture fixture;
    QVERIFY(!fixture.isWhole());
    fixture.room.showWhole(fixture.box);
    QTRY_VERIFY(fixture.isWhole());
    fixture.one->setFixedHeight(120);
    fixture.fit();
    QTRY_VERIFY(fixture.isWhole());
}

void StepRoomTest::aBoxShownWholeStaysWholeWhenItGrows()
{
    RoomFixture fixture;
    fixture.room.showWhole(fixture.box);
    QTRY_VERIFY(fixture.isWhole());
    fixture.box->setFixedHeight(90); // its text has one more line
    fixture.fit();
    QTRY_VERIFY(fixture.isWhole());
}

void StepRoomTest::theHeadingStaysWhileTheTriesScroll()
{
    RoomFixture fixture;
    fixture.one->setFixedHeight(600);
    fixture.fit();
    fixture.room.showTry(fixture.one);
    settle();
    QCOMPARE(fixture.heading->visibleRegion().boundingRect(), fixture.heading->rect());
    QVERIFY(fixture.heading->geometry().bottom() < fixture.panel.findChild<QScrollArea *>("tries")->y());
}

void StepRoomTest::aLearnerWhoScrolledIsLeftWhereSheIs()
{
    RoomFixture fixture;
    fixture.room.showWhole(fixture.box);
    QTRY_VERIFY(fixture.isWhole());
    fixture.room.bar().triggerAction(QAbstractSlider::SliderToMinimum);
    QCOMPARE(fixture.room.bar().value(), 0);
    fixture.one->setFixedHeight(120);
    fixture.fit();
    QCOMPARE(fixture.room.bar().value(), 0);
}

SUITE(tst_step_room, StepRoomTest)
#include "tst_step_room.moc"
