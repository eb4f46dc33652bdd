#include "tests/lessons/attempts/attempts.h"

#include <QTest>

#include <algorithm>
#include <map>

namespace support {

namespace {

/// Returns `text` with plain spaces in place of thin ones.
QString plainSpaces(QString text)
{
    return text.replace(QChar(0x2009), ' ').replace(QChar(0x202f), ' ');
}

}

std::vector<Attempt> attemptsOf(const std::string &lesson)
{
    static const std::map<std::string, std::vector<Attempt> (*)()> all{
        {"single_spring", singleSpringAttempts},
        {"two_body", twoBodyAttempts},
        {"multi_foot", multiFootAttempts},
        {"gravity_walls", gravityWallsAttempts},
        {"walking_gait", walkingGaitAttempts},
        {"swaying_tree", swayingTreeAttempts},
        {"rigid_constraint", rigidConstraintAttempts},
        {"codeling", codelingAttempts},
        {"accuracy", accuracyAttempts},
        {"hard_cases", hardCasesAttempts},
    };
    return all.at(lesson)();
}

void addAttemptRows(const LoadedLesson &lesson, const std::vector<Attempt> &all)
{
    QTest::addColumn<Attempt>("attempt");
    for (const Attempt &attempt : all)
        QTest::addRow("%s: %s", attempt.step, attempt.name) << attempt;
    for (const lessons::Step &step : lesson.steps) {
        for (std::size_t number = 0; number < step.tries.size(); ++number) {
            const bool hasAttempt = std::any_of(all.begin(), all.end(), [&](const Attempt &attempt) {
                return step.id == attempt.step && number == attempt.number && !attempt.isNearMiss();
            });
            QVERIFY2(
                hasAttempt,
                qPrintable(QStringLiteral("%1: no attempt for: %2").arg(step.id, step.tries[number].text)));
        }
    }
}

void checkAttempt(const LoadedLesson &lesson)
{
    QFETCH(Attempt, attempt);
    RunPlayer player(lesson.step(QString::fromUtf8(attempt.step)), attempt.number);
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

}
