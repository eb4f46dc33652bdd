// The tour of the window: a minute with mouse or keyboard, which never stands in the way; and the keys of what helps
// to learn.

#include "app/ui/panels/glossary_page.h"
#include "app/ui/panels/learn_panel.h"
#include "app/ui/panels/try_box.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/tour.h"

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

using namespace app;

namespace {

struct Bench
{
    LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Theme theme{Scheme::light};
    Session session{library};
    MainWindow window{session, theme};
    SceneView &view = *window.findChild<SceneView *>();

    explicit Bench(QSize size = {1280, 800})
    {
        theme.apply(*qApp);
        window.resize(size);
        window.show();
        QApplication::setActiveWindow(&window);
        QCoreApplication::processEvents();
    }

    Tour &tour() const { return *window.findChild<Tour *>(); }
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

    QTemporaryDir m_folder;

private slots:
    void initTestCase();
    void init() { QSettings().clear(); }

    void itIsOfferedOnceAndThenOnlyInTheMenu();
    void itGoesThroughAllCards_data();
    void itGoesThroughAllCards();
    void escEndsItAnywhere();
    void theWindowCanBeUsedMeanwhile();
    void cardsStayInTheWindowBesideTheirParts_data();
    void cardsStayInTheWindowBesideTheirParts();
    void aKeyShowsTheNextHint();
    void aKeyOpensTheGlossaryWhichDoesNotLeaveTheLesson();
};

void TourTest::initTestCase()
{
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
}

void TourTest::itIsOfferedOnceAndThenOnlyInTheMenu()
{
    QVERIFY(MainWindow::wantsTour());
    Bench bench;
    QVERIFY(!bench.window.findChild<Tour *>());
    for (QAction *action : bench.window.findChildren<QAction *>()) {
        if (action->text().remove('&') == "Take the tour")
            action->trigger();
    }
    QVERIFY(bench.tour().isRunning());
    QVERIFY(!MainWindow::wantsTour());
}

void TourTest::itGoesThroughAllCards_data()
{
    QTest::addColumn<bool>("byKey");
    QTest::newRow("mouse") << false;
    QTest::newRow("keyboard") << true;
}

void TourTest::itGoesThroughAllCards()
{
    QFETCH(bool, byKey);
    Bench bench;
    bench.window.startTour();
    QVERIFY(bench.tour().count() >= 5 && bench.tour().count() <= 7);
    QStringList titles;
    for (std::size_t i = 0; i < bench.tour().count(); ++i) {
        QVERIFY(bench.tour().isRunning());
        QCOMPARE(bench.tour().stop(), i);
        titles << bench.title();
        const bool isLast = i + 1 == bench.tour().count();
        if (byKey)
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        else
            QTest::mouseClick(bench.button(isLast ? "Done" : "Next"), Qt::LeftButton);
    }
    QVERIFY(!bench.tour().isRunning());
    QCOMPARE(titles.removeDuplicates(), 0);
    bench.window.startTour(); // asked for again
    QVERIFY(bench.tour().isRunning());
    QCOMPARE(bench.tour().stop(), 0u);
    QTest::mouseClick(bench.button("Next"), Qt::LeftButton);
    QTest::mouseClick(bench.button("Back"), Qt::LeftButton);
    QCOMPARE(bench.tour().stop(), 0u);
}

void TourTest::escEndsItAnywhere()
{
    Bench bench;
    bench.window.startTour();
    QTest::keyClick(&bench.tour(), Qt::Key_Return);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!bench.tour().isRunning());
    bench.window.startTour();
    bench.view.setFocus();
    QTest::keyClick(&bench.view, Qt::Key_Escape);
    QVERIFY(!bench.tour().isRunning());
    QVERIFY(!MainWindow::wantsTour());
}

void TourTest::theWindowCanBeUsedMeanwhile()
{
    Bench bench;
    bench.window.startTour();
    bench.view.setFocus();
    QTest::keyClick(&bench.view, Qt::Key_Right);
    QCOMPARE(bench.session.timeline().cursor().frame, 1);
    QVERIFY(bench.tour().isRunning());
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
    Bench bench(size);
    bench.window.startTour();
    for (std::size_t i = 0; i < bench.tour().count(); ++i) {
        QCoreApplication::processEvents();
        QVERIFY(bench.window.rect().contains(bench.tour().geometry()));
        for (const auto *label : bench.tour().findChildren<QLabel *>()) {
            const QRect place(label->mapTo(&bench.tour(), QPoint()), label->size());
            QVERIFY2(bench.tour().rect().contains(place), qPrintable(label->text()));
        }
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    }
    QVERIFY(!bench.tour().isRunning());
}

void TourTest::aKeyShowsTheNextHint()
{
    Bench bench;
    bench.view.setFocus();
    bench.window.findChild<LearnPanel *>()->showSummary(true);
    QTest::keyClick(&bench.view, Qt::Key_H);
    const auto boxes = bench.window.findChildren<TryBox *>();
    QVERIFY(boxes[0]->showsHint() && !boxes[1]->showsHint());
    QVERIFY(boxes[0]->isVisible()); // the summary gave way
}

void TourTest::aKeyOpensTheGlossaryWhichDoesNotLeaveTheLesson()
{
    Bench bench;
    bench.session.goTo({7, 0});
    bench.view.setFocus();
    QTest::keyClick(&bench.view, Qt::Key_F1, Qt::ShiftModifier);
    auto *page = bench.window.findChild<GlossaryPage *>();
    QVERIFY(page && page->isVisible() && !page->isModal());
    QCOMPARE(bench.session.timeline().cursor().frame, 7);
    QTest::keyClick(page, Qt::Key_Escape);
    QVERIFY(!page->isVisible());
}

QTEST_MAIN(TourTest)
#include "tst_tour.moc"
