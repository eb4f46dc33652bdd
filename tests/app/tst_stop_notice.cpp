// A run that stops by itself: the card over the picture, and what mends it, with real widgets.

#include "app/model/sentences.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/stop_notice.h"

#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

using namespace app;

namespace {

/// Sixty feet at one step a frame: more than `published` holds.
struct Bench
{
    LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    Theme theme{Scheme::light};
    Session session{library};
    MainWindow window{session, theme};
    StopNotice &notice = *window.findChild<StopNotice *>();

    Bench()
    {
        theme.apply(*qApp);
        session.openStep("multi_foot", "grown_feet");
        session.setParameter("feet", 60);
        window.resize(1280, 800);
        window.show();
        QApplication::setActiveWindow(&window);
        window.findChild<SceneView *>()->setFocus();
        QCoreApplication::processEvents();
    }
    const sim::Timeline &run() const { return session.timeline(); }
    bool stops()
    {
        session.goTo({1'000'000, 0});
        return QTest::qWaitFor([this] { return run().stop() && !session.goingTo(); }, 20'000);
    }
    bool findsRemedies() const
    {
        return QTest::qWaitFor([this] { return !notice.search().isSearching(); }, 20'000);
    }
    bool arrives() const
    {
        return QTest::qWaitFor([this] { return !session.goingTo(); }, 20'000);
    }
    QPushButton *button(const QString &start) const
    {
        for (QPushButton *one : notice.findChildren<QPushButton *>()) {
            if (one->accessibleName().startsWith(start))
                return one;
        }
        return nullptr;
    }
};

}

class StopNoticeTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_settings.path());
    }

    void itSaysWhatFailedAndOffersWhatHolds()
    {
        Bench bench;
        QVERIFY(bench.notice.isHidden());
        QVERIFY(bench.stops());
        const sim::Stop stop = *bench.run().stop();
        QVERIFY(bench.notice.isVisible());
        QVERIFY2(bench.notice.sentence().contains(QString::number(stop.frame)),
                 qPrintable(bench.notice.sentence()));
        const QString body = bodyTitle(QString::fromStdString(stop.body));
        QVERIFY(bench.notice.sentence().contains(body));
        QVERIFY(bench.notice.sentence().contains("The spring " + body + " – ")); // and its other end
        QCOMPARE(bench.notice.accessibleName(), bench.notice.sentence());
        QVERIFY(bench.findsRemedies());
        for (const char *start : {"Use a step of 1/", "Use TR-BDF2", "Damp more: damp 0"}) {
            QPushButton *button = bench.button(start);
            QVERIFY2(button && button->isVisible() && button->isEnabled(), start);
            QVERIFY2(button->toolTip().contains("Alt+"), qPrintable(button->toolTip()));
            QVERIFY2(button->toolTip().contains("it holds for"), qPrintable(button->toolTip()));
            QVERIFY(!button->accessibleName().contains('&'));
            QVERIFY(button->height() >= 24);
        }
        const QWidget *picture = bench.notice.parentWidget();
        QVERIFY(picture->rect().contains(bench.notice.geometry()));
    }

    void aRemedyRunsAgainToThatFrame_data()
    {
        QTest::addColumn<QString>("remedy");
        QTest::addColumn<bool>("byKey");
        for (const char *remedy : {"Use a step", "Use TR-BDF2", "Damp more"}) {
            QTest::addRow("%s, by mouse", remedy) << remedy << false;
            QTest::addRow("%s, by key", remedy) << remedy << true;
        }
    }
    void aRemedyRunsAgainToThatFrame()
    {
        QFETCH(QString, remedy);
        QFETCH(bool, byKey);
        Bench bench;
        bench.session.goTo({5, 0});
        bench.session.grab("foot3");
        bench.session.moveHand({300, 120});
        bench.session.frameForward();
        bench.session.letGo();
        QVERIFY(bench.stops());
        const std::vector<sim::Event> input = bench.run().script().input;
        QVERIFY(input.size() >= 3);
        const sim::Stop stop = *bench.run().stop();
        QVERIFY(bench.findsRemedies());
        QPushButton *button = bench.button(remedy);
        QVERIFY(button);
        if (byKey) {
            const QKeyCombination key = QKeySequence::mnemonic(button->text())[0];
            QTest::keyClick(&bench.window, key.key(), key.keyboardModifiers());
        } else {
            QTest::mouseClick(button, Qt::LeftButton);
        }
        QVERIFY(QTest::qWaitFor([&] { return !bench.run().stop(); }));
        QVERIFY(bench.arrives());
        QCOMPARE(bench.run().cursor().frame, stop.frame);
        QVERIFY(bench.run().script().input == input);
        QVERIFY(bench.notice.isHidden());
        QVERIFY(bench.window.findChild<SceneView *>()->hasFocus());
        QVERIFY(bench.run().comparison() && bench.run().comparison()->stop());
        QCOMPARE(bench.run().comparison()->stop()->frame, stop.frame);
        QVERIFY(bench.session.ghostName().startsWith("before: "));
        bench.session.goTo({10 * stop.frame, 0});
        QVERIFY(bench.arrives());
        QVERIFY(!bench.run().stop());
        for (int i = 0; i < bench.run().state().pointCount(); ++i) // in the picture, and calm
            QVERIFY(sim::length(bench.run().state().velocityOf(i)) < 1e-3 &&
                    sim::length(bench.run().state().positionOf(i) - sim::Vec2{270, 200}) < 1000.0);
    }

    void goingBackHidesItAndLosesNothing()
    {
        Bench bench;
        QVERIFY(bench.stops() && bench.findsRemedies());
        const std::int64_t end = bench.run().cursor().frame;
        const sim::State state = bench.run().state();
        bench.session.frameBack();
        QVERIFY(bench.notice.isHidden());
        bench.session.goTo({end, 0});
        QVERIFY(bench.notice.isVisible() && !bench.notice.search().isSearching());
        QVERIFY(bench.button("Use a step"));
        QVERIFY(sim::sameBits(bench.run().state(), state));
        bench.session.goTo({10, 0});
        bench.session.setParameter("feet", 5); // another run, with a future
        QVERIFY(bench.notice.isHidden());
        QVERIFY(bench.notice.search().found().empty());
    }

    void whereNothingHelpsItSaysSo()
    {
        Bench bench;
        bench.session.setParameter("k", 1e9);
        bench.session.setParameter("damp", 1.0);
        bench.session.setMethod("explicit_euler");
        QVERIFY(bench.stops() && bench.findsRemedies());
        QVERIFY(!bench.button("Use a step") && !bench.button("Damp more"));
        if (bench.notice.search().found().empty())
            QVERIFY(bench.notice.findChild<QLabel *>("caption")->isVisible());
    }

private:
    QTemporaryDir m_settings;
};

QTEST_MAIN(StopNoticeTest)
#include "tst_stop_notice.moc"
