#include "app/model/text/sentences.h"
#include "sim/effects/springs/body_spring.h"
#include "tests/suite.h"

#include <QTest>

/// Each error of sim gets one sentence with everything that the learner has to know.
class Sentences : public QObject
{
    Q_OBJECT

private slots:
    void userErrors_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QStringList>("values"); // name, value...
        QTest::addColumn<QString>("sentence");
        QTest::newRow("a step") << "step-size" << QStringList{"h", "0.3"}
                                << "The step 0.3 is not allowed. It can be a whole number of frames, or 1 "
                                   "divided by a whole number, from 0.000001 to 100 frames.";
        QTest::newRow("a tolerance") << "tolerance" << QStringList{"tolerance", "0"}
                                     << "The tolerance 0 is not allowed. It can be from 1e-13 to 100 px.";
        QTest::newRow("a step where a tolerance is needed")
            << "needs-tolerance" << QStringList{"method", "dormand_prince"}
            << "The method dormand_prince chooses its own steps. Choose a tolerance in px instead of a step.";
        QTest::newRow("a tolerance where a step is needed")
            << "needs-step" << QStringList{"method", "rk4"}
            << "The method rk4 has fixed steps. Choose a step in frames instead of a tolerance.";
        QTest::newRow("a method and an effect")
            << "method-does-not-fit" << QStringList{"method", "rk4", "effect", "sticks"}
            << "The method rk4 cannot compute sticks: choose another method, or switch that effect off.";
        QTest::newRow("points without inertia")
            << "needs-inertia" << QStringList{"method", "tr_bdf2"}
            << "The method tr_bdf2 cannot compute this scene, because parts of it have no velocity of their "
               "own. Choose another method.";
        QTest::newRow("a scene at rest") << "nothing-moves" << QStringList{"method", "published"}
                                         << "Nothing in this scene can move. Leave at least one body free.";
        QTest::newRow("a place that is no number")
            << "input-not-finite" << QStringList{"event", "move", "frame", "7"}
            << "The event move before frame 7 has a value that is infinite or not a number. Give it a finite "
               "number.";
        QTest::newRow("a start that is no number")
            << "start-not-finite" << QStringList{"body", "foot0"}
            << "The start of foot 0 has a value that is infinite or not a number. Give it a finite number.";
        QTest::newRow("a step that is too long")
            << "claim-grows"
            << QStringList{"method", "rk4", "h", "1", "k", "9", "apart", "100", "left", "300"}
            << "With a step of 1, its stiffest spring (stiffness 9) would swing from 100 px to 300 px, and "
               "farther.";
        QTest::newRow("a step that is longer than sticks are measured by")
            << "claim-longer-step" << QStringList{"method", "published", "h", "1", "most", "0.05"}
            << "Its sticks are only tested with steps up to 0.05. With a step of 1, their errors are larger.";
        QTest::newRow("a body that is lost")
            << "hard-not-finite" << QStringList{"frame", "3", "body", "foot0", "phase", "move"}
            << "After frame 3, the position of foot 0 is no longer a finite number: it overflowed in "
               "\"move\".";
        QTest::newRow("a frame that would take too long")
            << "hard-too-many-steps" << QStringList{"frame", "7"}
            << "After frame 7, the method needs more steps for one frame than allowed.";
        QTest::newRow("a case that would take too long")
            << "claim-too-many-steps" << QStringList{"method", "rk4", "steps", "1800", "most", "700"}
            << "It would need about 1800 steps in a frame, but stops after 700.";
        QTest::newRow("a stick without an end")
            << "stick-without-end" << QStringList{"stick", "4", "end", "7", "points", "5"}
            << "Stick 4 ends at p7, but there is no such point. There are 5 points, and the first is p0.";
        QTest::newRow("a spring without an end")
            << "spring-without-end" << QStringList{"spring", "1", "end", "9", "points", "3"}
            << "Spring 1 ends at p9, but there is no such point. There are 3 points, and the first is p0.";
    }
    void userErrors()
    {
        QFETCH(QString, id);
        QFETCH(QStringList, values);
        QFETCH(QString, sentence);
        std::map<std::string, std::string> given;
        for (qsizetype i = 0; i + 1 < values.size(); i += 2)
            given[values[i].toStdString()] = values[i + 1].toStdString();
        QCOMPARE(app::sentenceFor(sim::Error(id.toStdString(), given)), sentence);
    }

    void stops_data()
    {
        QTest::addColumn<int>("reason");
        QTest::addColumn<QString>("phase");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("a number that is not finite")
            << int(sim::StopReason::notFinite) << "spring"
            << "Stopped at frame 7: in the next frame, “foot 3” is too far away or too fast for a number "
               "(not finite). It began in “spring”.";
        QTest::newRow("one that no phase made") << int(sim::StopReason::notFinite) << QString()
                                                << "Stopped at frame 7: in the next frame, “foot 3” is too "
                                                   "far away or too fast for a number (not finite).";
        QTest::newRow("too many steps")
            << int(sim::StopReason::tooManySteps) << "adaptive steps"
            << "Stopped at frame 7: the method needs too many steps for the next frame. The strongest force "
               "acts on foot 3. Try a larger tolerance, or a method with fixed steps.";
    }
    void stopNamesTheSpringAndBothItsEnds()
    {
        sim::Stop stop;
        stop.frame = 7;
        stop.phase = "kick";
        stop.body = "foot3";
        stop.otherBody = "body";
        stop.effect = std::make_shared<sim::BodySpring>(std::vector<sim::Link>{}, 0.2);
        QVERIFY(
            app::sentenceFor(stop).endsWith("It began in “kick”. The spring foot 3 – body is strongest."));
        stop.otherBody.clear();
        QVERIFY(app::sentenceFor(stop).endsWith("The spring of foot 3 is strongest."));
    }

    void stops()
    {
        QFETCH(int, reason);
        QFETCH(QString, phase);
        QFETCH(QString, sentence);
        sim::Stop stop;
        stop.reason = sim::StopReason(reason);
        stop.frame = 7;
        stop.phase = phase.toStdString();
        stop.body = "foot3";
        QCOMPARE(app::sentenceFor(stop), sentence);
    }
};

SUITE(tst_sentences, Sentences)
#include "tst_sentences.moc"
