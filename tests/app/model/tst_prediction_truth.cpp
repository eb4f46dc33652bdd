// The true answers to predictions, computed from their runs.

#include "app/model/learning/prediction_truth.h"
#include "app/model/text/user_error.h"
#include "tests/app/model/predictions_support.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace app;
using namespace predictions_support;

class PredictionTruthTest : public QObject
{
    Q_OBJECT

private slots:
    void aThrowEndsWhereItsVelocitiesAddUpTo();
    void theFramesUntilTheEndAreCounted();
    void curvesAreThoseOfThePublishedProgram();
    void aNumberAtTheEndIsComputed();
    void aRunThatDoesNotExistIsExplained_data();
    void aRunThatDoesNotExistIsExplained();
    void everyPredictionOfALessonHasAnAnswer_data();
    void everyPredictionOfALessonHasAnAnswer();
};

void PredictionTruthTest::aThrowEndsWhereItsVelocitiesAddUpTo()
{
    const LessonLibrary library = predictedLessons();
    const auto truth = truthOf(throwOfFoot(), *library.lesson("single_spring")->step("drag"));
    // The foot is released at frame 10 with 10 px per frame. Damping keeps 0.9 of the velocity in each frame.
    const int free = static_cast<int>(std::ceil(std::log(0.05 / 10.0) / std::log(0.9)));
    const double way = 10.0 * 0.9 * (1.0 - std::pow(0.9, free)) / (1.0 - 0.9);
    QVERIFY(truth && truth->isReached);
    QCOMPARE(truth->end, std::int64_t{10 + free});
    QVERIFY2(std::abs(truth->answer.place.x - (200.0 + way)) < 1e-9,
             qPrintable(QString::number(truth->answer.place.x)));
    QCOMPARE(truth->answer.place.y, 200.0);
}

void PredictionTruthTest::theFramesUntilTheEndAreCounted()
{
    const LessonLibrary library = predictedLessons();
    const auto truth = truthOf(pastTheCross(), *library.lesson("single_spring")->step("fixed_centre"));
    const std::vector<double> x = publishedX(510.0, 0.05, 0.9, 100);
    const auto past = std::find_if(x.begin(), x.end(), [](double at) { return at < 270.0; }) - x.begin();
    QVERIFY(truth && truth->isReached);
    QCOMPARE(truth->end, std::int64_t{past});
    QCOMPARE(truth->answer.number, static_cast<double>(past));
}

void PredictionTruthTest::curvesAreThoseOfThePublishedProgram()
{
    const LessonLibrary library = predictedLessons();
    const auto truth = truthOf(curveToCross(), *library.lesson("single_spring")->step("fixed_centre"));
    QVERIFY(truth && truth->curves.size() == 3U);
    const std::pair<double, double> numbers[] = {{0.05, 0.9}, {0.2, 0.9}, {0.05, 0.3}};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::vector<double> x = publishedX(510.0, numbers[i].first, numbers[i].second, 60);
        QCOMPARE(truth->curves[i].size(), x.size());
        for (std::size_t j = 0; j < x.size(); ++j)
            QVERIFY(std::abs(truth->curves[i][j] - x[j]) < 1e-9);
    }
}

void PredictionTruthTest::aNumberAtTheEndIsComputed()
{
    const LessonLibrary library = predictedLessons();
    lessons::Prediction one = pastTheCross();
    one.run.frames = 3;
    one.run.until.clear();
    one.question = {Asked::number, "(foot.x - 270) / 240 + frame", "px"};
    const auto truth = truthOf(one, *library.lesson("single_spring")->step("fixed_centre"));
    QVERIFY(truth);
    QCOMPARE(truth->end, std::int64_t{3});
    QVERIFY(std::abs(truth->answer.number -
                     ((publishedX(510.0, 0.05, 0.9, 3).back() - 270.0) / 240.0 + 3.0)) < 1e-12);
}

void PredictionTruthTest::aRunThatDoesNotExistIsExplained_data()
{
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("says");
    QTest::newRow("parameter") << "stiffness"
                               << "1"
                               << "There is no parameter \"stiffness\" here; there are k, damp";
    QTest::newRow("number") << "k"
                            << "much"
                            << "k cannot be \"much\". It can be a number from";
    QTest::newRow("range") << "damp"
                           << "1e9"
                           << "damp cannot be \"1e9\".";
    QTest::newRow("body") << "place"
                          << "tail"
                          << "There is no body \"tail\" here; there are foot";
    QTest::newRow("method") << "method"
                            << "magic"
                            << "There is no method \"magic\"; the methods are published, ";
    QTest::newRow("until") << "until"
                           << "foot.z > 1"
                           << "Character 6: ";
    QTest::newRow("number asked") << "ask"
                                  << "foot.x > 1"
                                  << "true or false, not a number";
}

void PredictionTruthTest::aRunThatDoesNotExistIsExplained()
{
    QFETCH(QString, what);
    QFETCH(QString, value);
    QFETCH(QString, says);
    const LessonLibrary library = predictedLessons();
    lessons::Prediction one = pastTheCross();
    if (what == u"place")
        one.run.places = {{value, {1.0, 1.0}}};
    else if (what == u"method")
        one.run.method = value;
    else if (what == u"until")
        one.run.until = value;
    else if (what == u"ask")
        one.question = {Asked::number, value, "px"};
    else
        one.run.values = {{what, value}};
    QString sentence;
    try {
        truthOf(one, *library.lesson("single_spring")->step("fixed_centre"));
    } catch (const UserError &error) {
        sentence = error.sentence();
    }
    QVERIFY2(sentence.contains(says), qPrintable(sentence));
}

void PredictionTruthTest::everyPredictionOfALessonHasAnAnswer_data()
{
    QTest::addColumn<QString>("lesson");
    for (const LessonEntry &lesson : LessonLibrary::load({LESSON_DIR}).lessons)
        QTest::newRow(qPrintable(lesson.id)) << lesson.id;
}

void PredictionTruthTest::everyPredictionOfALessonHasAnAnswer()
{
    QFETCH(QString, lesson);
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    QStringList wrong;
    for (const lessons::Step &step : library.lesson(lesson)->steps) {
        for (const lessons::Prediction &one : step.predictions) {
            const QString where = step.id + '/' + one.id + ": ";
            try {
                const PredictionTruth truth = truthOf(one, step).value();
                if (!truth.isReached)
                    wrong << where + QString("its condition does not hold within %1 frames").arg(truth.end);
                if (!std::isfinite(truth.answer.number) || !std::isfinite(truth.answer.place.x))
                    wrong << where + "its answer is not a number";
                if (one.question.kind != Asked::curve)
                    continue;
                double least = truth.curves[0][0], most = least;
                for (const std::vector<double> &curve : truth.curves) {
                    least = std::min(least, *std::min_element(curve.begin(), curve.end()));
                    most = std::max(most, *std::max_element(curve.begin(), curve.end()));
                }
                for (std::size_t a = 0; a < 3; ++a) {
                    const std::vector<double> &first = truth.curves[a], &second = truth.curves[(a + 1) % 3];
                    double apart = 0.0;
                    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
                        apart = std::max(apart, std::abs(first[i] - second[i]));
                    if (apart < 0.1 * (most - least) || most <= least)
                        wrong << where + QString("curves %1 and %2 look the same").arg(a).arg((a + 1) % 3);
                }
            } catch (const std::exception &error) {
                wrong << where + error.what();
            }
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable('\n' + wrong.join('\n')));
}

SUITE(tst_prediction_truth, PredictionTruthTest)
#include "tst_prediction_truth.moc"
