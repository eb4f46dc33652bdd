// Tests of the notice over the picture after a run has failed, and of its remedies, with real widgets.

#include "app/model/text/sentences.h"
#include "app/ui/window/failure_notice.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

using namespace app;
using namespace tests;

namespace {

/// Sixty feet at one step per frame, which is unstable with `published`.
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
    void noticeNamesTheFailureAndOffersRemedies()
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

    void undoIsNamedOnlyIfThereIsSomethingToUndo()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("mistake.json");
        WindowFixture fixture({"single_spring", "radial"});
        fixture.session.code().write(
            fixture.session.code().text().replace("*= damp;", "*= damp; int zero = 0; int one = 1 / zero;"));
        fixture.session.playback().frameForward();
        const auto &hint = *fixture.part<FailureNotice>().findChild<QLabel *>("caption");
        QCOMPARE(hint.text(),
                 QString("Correct this line, and the run goes on. Undo reverts your last change."));
        QVERIFY(fixture.window.saveFile(path));
        fixture.window.openFile(path); // an opened run has no changes to undo
        fixture.session.playback().frameForward();
        QTRY_VERIFY(fixture.session.timeline().stop());
        QTRY_COMPARE(hint.text(), QString("Correct this line, and the run goes on."));
    }

    void aFailureWithoutARemedySaysSo()
    {
        FailureFixture fixture;
        sim::Script script = fixture.run().script(); // a hand so fast that its velocity is not finite
        script.input = {{1, sim::Grab{"foot1"}}, {1, sim::Move{{1e308, 0.0}}}, {2, sim::Move{{-1e308, 0.0}}}};
        QVERIFY(fixture.session.editor().setUp({"a fast hand", {}, {}}, script, RunEditor::Maker::learner));
        QVERIFY(fixture.stops() && fixture.findsRemedies());
        const auto &hint = *fixture.failure.findChild<QLabel *>("caption");
        QCOMPARE(hint.text(),
                 QString("No smaller step and no other method was found to be stable. Go back, and "
                         "undo the change that caused this."));
        QVERIFY(!hint.isHidden());
        QVERIFY(fixture.failure.isVisible());
        QCOMPARE(fixture.failure.findChildren<QPushButton *>().size(), 0);
    }
};

SUITE(tst_failure_notice, FailureNoticeTest)
#include "tst_failure_notice.moc"
