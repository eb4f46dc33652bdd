// The tour of the window, by mouse or keyboard, which never blocks the window. Also the keys of hints and glossary.

#include "app/ui/help/tour.h"
#include "app/ui/learn/learn_panel.h"
#include "app/ui/learn/step/try_box.h"
#include "app/ui/learn/words/glossary_page.h"
#include "app/ui/window/introduction.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QTest>

using namespace app;
using namespace tests;

namespace {

struct TourFixture : WindowFixture
{
    using WindowFixture::WindowFixture;
    Tour &tour() const { return part<Tour>(); }
    QString title() const { return tour().findChild<QLabel *>("heading")->text(); }
    QPushButton *button(const QString &text) const
    {
        for (auto *one : tour().findChildren<QPushButton *>()) {
            if (one->text() == text && one->isVisible())
                return one;
        }
        return nullptr;
    }
};

}

class TourTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void tourIsOfferedOnceAndThenOnlyInTheMenu();
    void tourShowsAllCards_data();
    void tourShowsAllCards();
    void escEndsItAnywhere();
    void theWindowCanBeUsedMeanwhile();
    void cardsStayInTheWindowBesideTheirParts_data();
    void cardsStayInTheWindowBesideTheirParts();
    void aKeyShowsTheNextHint();
    void aKeyOpensTheGlossaryWhichDoesNotLeaveTheLesson();
};

void TourTest::tourIsOfferedOnceAndThenOnlyInTheMenu()
{
    QVERIFY(Tour::isWanted());
    TourFixture fixture;
    QVERIFY(!fixture.window.findChild<Tour *>());
    fixture.actionCalled("Take the tour").trigger();
    QVERIFY(fixture.tour().isRunning());
    QVERIFY(!Tour::isWanted());
}

void TourTest::tourShowsAllCards_data()
{
    QTest::addColumn<bool>("byKey");
    QTest::newRow("mouse") << false;
    QTest::newRow("keyboard") << true;
}

void TourTest::tourShowsAllCards()
{
    QFETCH(bool, byKey);
    TourFixture fixture;
    fixture.window.introduction().startTour();
    QCOMPARE(fixture.tour().count(), std::size_t(7));
    QStringList titles;
    for (std::size_t i = 0; i < fixture.tour().count(); ++i) {
        QVERIFY(fixture.tour().isRunning());
        QCOMPARE(fixture.tour().stop(), i);
        titles << fixture.title();
        const bool isLast = i + 1 == fixture.tour().count();
        if (byKey)
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        else
            QTest::mouseClick(fixture.button(isLast ? "Done" : "Next"), Qt::LeftButton);
    }
    QVERIFY(!fixture.tour().isRunning());
    QCOMPARE(titles.removeDuplicates(), 0);
    fixture.window.introduction().startTour(); // asked for again
    QVERIFY(fixture.tour().isRunning());
    QCOMPARE(fixture.tour().stop(), 0u);
    QTest::mouseClick(fixture.button("Next"), Qt::LeftButton);
    QTest::mouseClick(fixture.button("Back"), Qt::LeftButton);
    QCOMPARE(fixture.tour().stop(), 0u);
}

void TourTest::escEndsItAnywhere()
{
    TourFixture fixture;
    fixture.window.introduction().startTour();
    QTest::keyClick(&fixture.tour(), Qt::Key_Return);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!fixture.tour().isRunning());
    fixture.window.introduction().startTour();
    fixture.view.setFocus();
    QTest::keyClick(&fixture.view, Qt::Key_Escape);
    QVERIFY(!fixture.tour().isRunning());
    QVERIFY(!Tour::isWanted());
}

void TourTest::theWindowCanBeUsedMeanwhile()
{
    TourFixture fixture;
    fixture.window.introduction().startTour();
    fixture.view.setFocus();
    QTest::keyClick(&fixture.view, Qt::Key_Right);
    QCOMPARE(fixture.session.timeline().cursor().frame, 1);
    QVERIFY(fixture.tour().isRunning());
}

void TourTest::cardsStayInTheWindowBesideTheirParts_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("1280") << QSize(1280, 800);
    QTest::newRow("1920") << QSize(1920, 1080);
}

void TourTest::cardsStayInTheWindowBesideTheirParts()
{
    QFETCH(QSize, size);
    TourFixture fixture({.size = size});
    fixture.window.introduction().startTour();
    for (std::size_t i = 0; i < fixture.tour().count(); ++i) {
        QCoreApplication::processEvents();
        QVERIFY(fixture.window.rect().contains(fixture.tour().geometry()));
        for (const auto *label : fixture.tour().findChildren<QLabel *>()) {
            const QRect place(label->mapTo(&fixture.tour(), QPoint()), label->size());
            QVERIFY2(fixture.tour().rect().contains(place), qPrintable(label->text()));
        }
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    }
    QVERIFY(!fixture.tour().isRunning());
}

void TourTest::aKeyShowsTheNextHint()
{
    TourFixture fixture;
    fixture.view.setFocus();
    fixture.window.findChild<LearnPanel *>()->showSummary(true);
    QTest::keyClick(&fixture.view, Qt::Key_H);
    const auto boxes = fixture.window.findChildren<TryBox *>();
    QVERIFY(boxes[0]->showsHint() && !boxes[1]->showsHint());
    QVERIFY(boxes[0]->isVisible()); // the summary gave way
}

void TourTest::aKeyOpensTheGlossaryWhichDoesNotLeaveTheLesson()
{
    TourFixture fixture;
    fixture.goTo(7);
    fixture.view.setFocus();
    QTest::keyClick(&fixture.view, Qt::Key_F1, Qt::ShiftModifier);
    auto *page = fixture.window.findChild<GlossaryPage *>();
    QVERIFY(page && page->isVisible() && !page->isModal());
    QCOMPARE(fixture.session.timeline().cursor().frame, 7);
    QTest::keyClick(page, Qt::Key_Escape);
    QVERIFY(!page->isVisible());
}

SUITE(tst_tour, TourTest)
#include "tst_tour.moc"
