// The things to try of every lesson recognise what their texts ask for.

#include "tests/lessons/attempts/attempts.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>

using namespace support;

namespace {

/// Returns `text` with plain spaces in place of thin ones.
QString plainSpaces(QString text)
{
    return text.replace(QChar(0x2009), ' ').replace(QChar(0x202f), ' ');
}

}

class AttemptsTest : public QObject
{
    Q_OBJECT

private slots:
    void everyThingToTryHasAnAttempt_data() { addStepRows(); }
    void everyThingToTryHasAnAttempt()
    {
        QFETCH(QString, lesson);
        const lessons::Step step = stepOfRow();
        const std::vector<Attempt> all = attemptsOf(lesson.toStdString());
        for (std::size_t number = 0; number < step.tries.size(); ++number) {
            const bool hasAttempt = std::any_of(all.begin(), all.end(), [&](const Attempt &attempt) {
                return step.id == attempt.step && number == attempt.number && !attempt.isNearMiss();
            });
            QVERIFY2(hasAttempt, qPrintable(step.tries[number].text));
        }
    }

    void thingsToTryRecogniseAttempts_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<Attempt>("attempt");
        for (const QString &lesson : lessonIds()) {
            for (const Attempt &attempt : attemptsOf(lesson.toStdString()))
                QTest::addRow("%s/%s: %s", qPrintable(lesson), attempt.step, attempt.name)
                    << lesson << attempt;
        }
    }
    /// A thing to try is not done at the start, and is done at the end. Once it has begun, a hint always names
    /// the missing part. A near miss does not complete it and gets the expected hint.
    void thingsToTryRecogniseAttempts()
    {
        QFETCH(QString, lesson);
        QFETCH(Attempt, attempt);
        RunPlayer player(loadLesson(lesson).step(QString::fromUtf8(attempt.step)), attempt.number);
        QVERIFY(!player.done());
        attempt.act(player);
        if (attempt.isNearMiss()) {
            QVERIFY(!player.done());
            QCOMPARE(plainSpaces(player.missing()), QString::fromUtf8(attempt.missing));
        } else {
            QVERIFY2(player.done(), qPrintable(player.todo()));
            QVERIFY(!player.lackedHint());
        }
    }
};

SUITE(tst_attempts, AttemptsTest)
#include "tst_attempts.moc"
