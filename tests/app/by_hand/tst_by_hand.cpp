// A learner walks through one lesson, with mouse and keys only: opens it in the list, reads each step, does each
// thing to try, sees its tick, and goes on. Built once for each lesson, with that lesson's attempts. In a window of
// another size: SPRINGSTEP_WINDOW=1920x1080.

#include "app/ui/panels/summary_page.h"
#include "tests/app/by_hand/learner.h"
#include "tests/lessons/attempts.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace app;
using namespace support;

class ByHand : public QObject
{
    Q_OBJECT

    const LessonLibrary m_library = LessonLibrary::load({LESSON_DIR});
    QTemporaryDir m_settings;
    Theme m_theme{Scheme::light};
    std::unique_ptr<Session> m_session;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<Learner> m_learner;

    const LessonEntry &lesson() const { return *m_library.lesson(LESSON); }
    void followTry(const Attempt &attempt);

private slots:
    void initTestCase();
    void aStepIsReadAndDone_data();
    void aStepIsReadAndDone();
    void theSummarySaysThatAllIsDone();
    void cleanupTestCase();
};

void ByHand::initTestCase()
{
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_settings.path());
    m_theme.apply(*qApp);
    m_session = std::make_unique<Session>(m_library);
    m_window = std::make_unique<MainWindow>(*m_session, m_theme);
    const QList<QByteArray> size =
        qEnvironmentVariable("SPRINGSTEP_WINDOW", "1280x800").toLatin1().split('x');
    QCOMPARE(size.size(), 2);
    m_window->resize(size[0].toInt(), size[1].toInt());
    m_window->show();
    QApplication::setActiveWindow(m_window.get());
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_learner = std::make_unique<Learner>(*m_session, *m_window);
    m_learner->openLesson(lesson().title);
    QCOMPARE(m_session->lesson().id, QString(LESSON));
}

void ByHand::aStepIsReadAndDone_data()
{
    QTest::addColumn<int>("number");
    for (int i = 0; i < static_cast<int>(lesson().steps.size()); ++i)
        QTest::addRow("%s", qPrintable(lesson().steps[static_cast<std::size_t>(i)].id)) << i;
}

void ByHand::aStepIsReadAndDone()
{
    QFETCH(int, number);
    const lessons::Step &step = lesson().steps[static_cast<std::size_t>(number)];
    if (m_session->step().id != step.id) // the row before did not lead here, or was left out
        m_learner->openStep(step.title);
    QCOMPARE(m_session->step().id, step.id);

    QVERIFY(m_learner->narration().size() > 100);
    const QStringList hints = m_learner->hints();
    QCOMPARE(hints.size(), static_cast<qsizetype>(step.tries.size()));
    for (const QString &hint : hints)
        QVERIFY(!hint.isEmpty());
    const QStringList answers = m_learner->answers();
    QCOMPARE(answers.size(), static_cast<qsizetype>(step.explanation.whys.size()));
    for (const QString &answer : answers)
        QVERIFY(!answer.isEmpty());

    for (std::size_t i = 0; i < step.tries.size(); ++i) {
        const std::vector<Attempt> all = attempts();
        const auto found = std::find_if(all.begin(), all.end(), [&](const Attempt &attempt) {
            return step.id == attempt.step && attempt.number == i && !attempt.isNearMiss();
        });
        QVERIFY2(found != all.end(), qPrintable(step.tries[i].text));
        followTry(*found);
        if (QTest::currentTestFailed())
            return;
    }
    m_learner->pressNext();
    if (number + 1 == static_cast<int>(lesson().steps.size())) {
        QVERIFY(m_window->findChild<SummaryPage *>()->isVisible());
    } else {
        QCOMPARE(m_session->step().id, lesson().steps[static_cast<std::size_t>(number) + 1].id);
    }
}

void ByHand::followTry(const Attempt &attempt)
{
    const QString text = m_session->step().tries[attempt.number].text;
    try {
        m_learner->begin(attempt.number);
        if (!m_learner->done()) // what was tried before may have done it, too
            attempt.act(*m_learner);
        settle();
    } catch (const std::exception &error) {
        QFAIL(qPrintable(QStringLiteral("%1: %2").arg(text, error.what())));
    }
    // A budget that was measured just before is measured again only after a while.
    const bool isTicked = QTest::qWaitFor([&] { return m_learner->sees(attempt.number); }, 2000);
    const QString todo = m_session->step().tries[attempt.number].conditions.todo(m_session->timeline());
    QVERIFY2(isTicked, qPrintable(text + " Still to do: " + todo));
}

void ByHand::theSummarySaysThatAllIsDone()
{
    const auto *page = m_window->findChild<SummaryPage *>();
    QVERIFY(page->isVisible());
    const LessonSummary summary = summaryOf(lesson(), m_library, m_session->progress());
    QCOMPARE(summary.done, summary.count);
    for (const StepSummary &step : summary.steps)
        QVERIFY2(!step.learnt.isEmpty() && step.open.isEmpty(), qPrintable(step.id));
    m_learner->pressNext();
    if (summary.next)
        QCOMPARE(m_session->lesson().id, summary.next->id);
    else
        QVERIFY(page->isVisible());
}

void ByHand::cleanupTestCase()
{
    m_learner.reset();
    m_window.reset();
    m_session.reset();
}

QTEST_MAIN(ByHand)
#include "tst_by_hand.moc"
