#include "tests/lessons/attempts.h"

#include <QTest>

#include <algorithm>

namespace support {

void addAttemptRows(const LoadedLesson &lesson, const std::vector<Attempt> &all)
{
    QTest::addColumn<Attempt>("attempt");
    for (const Attempt &attempt : all)
        QTest::addRow("%s: %s", attempt.step, attempt.name) << attempt;
    for (const lessons::Step &step : lesson.steps) {
        for (std::size_t number = 0; number < step.tries.size(); ++number) {
            const bool tried = std::any_of(all.begin(), all.end(), [&](const Attempt &attempt) {
                return step.id == attempt.step && number == attempt.number;
            });
            QVERIFY2(
                tried,
                qPrintable(QStringLiteral("%1: nobody tries: %2").arg(step.id, step.tries[number].text)));
        }
    }
}

void checkAttempt(const LoadedLesson &lesson)
{
    QFETCH(Attempt, attempt);
    RunPlayer player(lesson.step(QString::fromUtf8(attempt.step)), attempt.number);
    QVERIFY(!player.done());
    attempt.act(player);
    QVERIFY(player.done());
}

}
