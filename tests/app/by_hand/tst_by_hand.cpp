// A learner walks through one lesson, with mouse and keys only: opens it in the list, reads each step, does each
// thing to try, sees its tick, and goes on. A suite for each lesson, with that lesson's attempts. In a window of
// another size: SPRINGSTEP_WINDOW=1920x1080.

#include "app/ui/learn/after/summary_page.h"
#include "tests/app/by_hand/learner.h"
#include "tests/app/support/window_fixture.h"
#include "tests/lesson_list.h"
#include "tests/lessons/attempts/attempts.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>

using namespace app;
using namespace support;

class ByHand : public QObject
{
    Q_OBJECT

    const char *m_id;
    const LessonLibrary m_library = LessonLibrary::load({LESSON_DIR});
    std::unique_ptr<tests::WindowFixture> m_fixture;
    std::unique_ptr<Learner> m_learner;

    const LessonEntry &lesson() const { return *m_library.lesson(m_id); }
    void followTry(const Attempt &attempt);

public:
    explicit ByHand(const char *lesson) : m_id(lesson) {}

private slots:
    void initTestCase();
    void aStepIsReadAndDone_data();
    void aStepIsReadAndDone();
    void theSummarySaysThatAllIsDone();
    void cleanupTestCase();
};

void ByHand::initTestCase()
{
    const QList<QByteArray> size =
        qEnvironmentVariable("SPRINGSTEP_WINDOW", "1280x800").toLatin1().split('x');
    QCOMPARE(size.size(), 2);
    m_fixture =
        std::make_unique<tests::WindowFixture>(tests::WindowSetup{.lesson = {},
                                                                  .size = {size[0].toInt(), size[1].toInt()},
                                                                  .study = sim::studyAccuracy,
                                                                  .cost = measureCost});
    m_learner = std::make_unique<Learner>(m_fixture->session, m_fixture->window);
    m_learner->openLesson(lesson().title);
    QCOMPARE(m_fixture->session.lesson().id, QString(m_id));
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
    if (m_fixture->session.step().id != step.id) // the row before did not lead here, or was left out
        m_learner->openStep(step.title);
    QCOMPARE(m_fixture->session.step().id, step.id);

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
        const std::vector<Attempt> all = attemptsOf(m_id);
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
        QVERIFY(m_fixture->window.findChild<SummaryPage *>()->isVisible());
    } else {
        QCOMPARE(m_fixture->session.step().id, lesson().steps[static_cast<std::size_t>(number) + 1].id);
    }
}

void ByHand::followTry(const Attempt &attempt)
{
    const QString text = m_fixture->session.step().tries[attempt.number].text;
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
    const QString todo =
        m_fixture->session.step().tries[attempt.number].conditions.todo(m_fixture->session.timeline());
    QVERIFY2(isTicked, qPrintable(text + " Still to do: " + todo));
}

void ByHand::theSummarySaysThatAllIsDone()
{
    const auto *page = m_fixture->window.findChild<SummaryPage *>();
    QVERIFY(page->isVisible());
    const LessonSummary summary = summaryOf(lesson(), m_library, m_fixture->session.progress());
    QCOMPARE(summary.done, summary.count);
    for (const StepSummary &step : summary.steps)
        QVERIFY2(!step.learnt.isEmpty() && step.open.isEmpty(), qPrintable(step.id));
    m_learner->pressNext();
    if (summary.next)
        QCOMPARE(m_fixture->session.lesson().id, summary.next->id);
    else
        QVERIFY(page->isVisible());
}

void ByHand::cleanupTestCase()
{
    m_learner.reset();
    m_fixture.reset();
}

#define BY_HAND(lesson)                                                                                      \
    std::unique_ptr<QObject> tst_by_hand_##lesson()                                                          \
    {                                                                                                        \
        return std::make_unique<ByHand>(#lesson);                                                            \
    }

LESSONS(BY_HAND)

#include "tst_by_hand.moc"
