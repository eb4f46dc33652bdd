// A run that stops by itself: the card over the picture, and what mends it, with real widgets.

#include "app/model/text/sentences.h"
#include "app/ui/window/failure_notice.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QLabel>
#include <QPushButton>
#include <QtTest>

using namespace app;
using namespace tests;

namespace {

/// Sixty feet at one step a frame: more than `published` holds.
struct FailureFixture : WindowFixture
{
    FailureFixture() : WindowFixture({"multi_foot", "grown_feet"})
    {
        session.editor().setParameter("feet", 60);
    }

    const sim::Timeline &run() const { return session.timeline(); }
    bool stops()
    {
        session.playback().goTo({1'000'000, 0});
        return QTest::qWaitFor([this] { return run().stop() && !session.playback().goal(); }, 20'000);
    }
    bool findsRemedies() const
    {
        return QTest::qWaitFor([this] { return !failure.search().isSearching(); }, 20'000);
    }
    QPushButton *button(const QString &start) const
    {
        for (QPushButton *one : failure.findChildren<QPushButton *>()) {
            if (one->accessibleName().startsWith(start))
                return one;
        }
        return nullptr;
    }

    FailureNotice &failure = part<FailureNotice>();
};

}

class FailureNoticeTest : public QObject
{
    Q_OBJECT

private slots:
    void itSaysWhatFailedAndOffersWhatHolds()
    {
        FailureFixture fixture;
        QVERIFY(fixture.failure.isHidden());
        QVERIFY(fixture.stops());
        const sim::Stop stop = *fixture.run().stop();
        QVERIFY(fixture.failure.isVisible());
        QVERIFY2(fixture.failure.sentence().contains(QString::number(stop.frame)),
                 qPrintable(fixture.failure.sentence()));
        const QString body = bodyTitle(QString::fromStdString(stop.body));
        QVERIFY(fixture.failure.sentence().contains(body));
        QVERIFY(fixture.failure.sentence().contains("The spring " + body + " – ")); // and its other end
        QCOMPARE(fixture.failure.accessibleName(), fixture.failure.sentence());
        QVERIFY(fixture.findsRemedies());
        for (const char *start : {"Use a step of 1/", "Use TR-BDF2", "Damp more: damp 0"}) {
            QPushButton *button = fixture.button(start);
            QVERIFY2(button && button->isVisible() && button->isEnabled(), start);
            QVERIFY2(button->toolTip().contains("Alt+"), qPrintable(button->toolTip()));
            QVERIFY2(button->toolTip().contains("it is stable for"), qPrintable(button->toolTip()));
            QVERIFY(!button->accessibleName().contains('&'));
            QVERIFY(button->height() >= 24);
        }
        const QWidget *picture = fixture.failure.parentWidget();
        QVERIFY(picture->rect().contains(fixture.failure.geometry()));
    }

    void theRemediesWrapInANarrowPicture()
    {
        FailureFixture fixture;
        QWidget picture; // narrower than the remedies in one row
        picture.setAttribute(Qt::WA_DontShowOnScreen);
        picture.resize(360, 500);
        FailureNotice narrow(fixture.session.run(), fixture.session.editor(), fixture.theme, &picture);
        picture.show();
        QVERIFY(fixture.stops());
        QVERIFY(QTest::qWaitFor([&] { return !narrow.search().isSearching(); }, 20'000));
        settle();
        QVERIFY(picture.rect().contains(narrow.geometry()));
        const auto remedies = narrow.findChildren<QPushButton *>("remedy");
        QVERIFY(remedies.size() >= 3);
        for (const QPushButton *one : remedies) {
            QVERIFY2(one->width() >= one->sizeHint().width(), qPrintable(one->text()));
            const QRect place(one->mapTo(&narrow, QPoint()), one->size());
            QVERIFY2(narrow.rect().contains(place), qPrintable(one->text()));
        }
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
        FailureFixture fixture;
        fixture.goTo(5);
        fixture.session.input().grab("foot3");
        fixture.session.input().moveTo({300, 120});
        fixture.session.playback().frameForward();
        fixture.session.input().release();
        QVERIFY(fixture.stops());
        const std::vector<sim::Event> input = fixture.run().script().input;
        QVERIFY(input.size() >= 3);
        const sim::Stop stop = *fixture.run().stop();
        QVERIFY(fixture.findsRemedies());
        QPushButton *button = fixture.button(remedy);
        QVERIFY(button);
        if (byKey) {
            const QKeyCombination key = QKeySequence::mnemonic(button->text())[0];
            QTest::keyClick(&fixture.window, key.key(), key.keyboardModifiers());
        } else {
            QTest::mouseClick(button, Qt::LeftButton);
        }
        QVERIFY(QTest::qWaitFor([&] { return !fixture.run().stop(); }));
        QVERIFY(fixture.arrives());
        QCOMPARE(fixture.run().cursor().frame, stop.frame);
        QVERIFY(fixture.run().script().input == input);
        QVERIFY(fixture.failure.isHidden());
        QVERIFY(fixture.view.hasFocus());
        QVERIFY(fixture.run().comparison() && fixture.run().comparison()->stop());
        QCOMPARE(fixture.run().comparison()->stop()->frame, stop.frame);
        QVERIFY(fixture.session.comparisons().comparisonName().startsWith("before: "));
        fixture.session.playback().goTo({10 * stop.frame, 0});
        QVERIFY(fixture.arrives());
        QVERIFY(!fixture.run().stop());
        for (int i = 0; i < fixture.run().state().pointCount(); ++i) // in the picture, and calm
            QVERIFY(sim::length(fixture.run().state().velocityOf(i)) < 1e-3 &&
                    sim::length(fixture.run().state().positionOf(i) - sim::Vec2{270, 200}) < 1000.0);
    }

    void goingBackHidesItAndLosesNothing()
    {
        FailureFixture fixture;
        QVERIFY(fixture.stops() && fixture.findsRemedies());
        const std::int64_t end = fixture.run().cursor().frame;
        const sim::State state = fixture.run().state();
        fixture.session.playback().frameBack();
        QVERIFY(fixture.failure.isHidden());
        fixture.session.playback().goTo({end, 0});
        QVERIFY(fixture.failure.isVisible() && !fixture.failure.search().isSearching());
        QVERIFY(fixture.button("Use a step"));
        QVERIFY(sim::sameBits(fixture.run().state(), state));
        fixture.goTo(10);
        fixture.session.editor().setParameter("feet", 5); // another run, with a future
        QVERIFY(fixture.failure.isHidden());
        QVERIFY(fixture.failure.search().found().empty());
    }

    void aMistakeInTheListingAsksForItsCorrection()
    {
        WindowFixture fixture({"single_spring", "radial"});
        const QString text = fixture.session.code().text();
        fixture.session.code().write(
            QString(text).replace("*= damp;", "*= damp; int zero = 0; int one = 1 / zero;"));
        fixture.session.playback().frameForward();
        QVERIFY(fixture.session.timeline().stop());
        auto &notice = fixture.part<FailureNotice>();
        QVERIFY(notice.isVisible());
        const QString hint = notice.findChild<QLabel *>("caption")->text();
        QVERIFY2(hint.startsWith("Correct this line"), qPrintable(hint));
        fixture.session.code().write(text);
        QVERIFY(fixture.arrives());
        QVERIFY(notice.isHidden());
    }

    void whereNothingHelpsItSaysSo()
    {
        FailureFixture fixture;
        fixture.session.editor().setParameter("k", 1e9);
        fixture.session.editor().setParameter("damp", 1.0);
        fixture.session.editor().setMethod("explicit_euler");
        QVERIFY(fixture.stops() && fixture.findsRemedies());
        QVERIFY(!fixture.button("Use a step") && !fixture.button("Damp more"));
        if (fixture.failure.search().found().empty())
            QVERIFY(fixture.failure.findChild<QLabel *>("caption")->isVisible());
    }
};

SUITE(tst_failure_notice, FailureNoticeTest)
#include "tst_failure_notice.moc"
