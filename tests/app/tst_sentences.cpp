#include "app/model/sentences.h"
#include "sim/effects/springs/body_spring.h"

#include <QTest>

/// What sim refuses is told in one sentence, with all that the learner has to know.
class Sentences : public QObject
{
    Q_OBJECT

private slots:
    void refusals_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QStringList>("values"); // name, value...
        QTest::addColumn<QString>("sentence");
        QTest::newRow("a step")
            << "step-size" << QStringList{"h", "0.3"}
            << "The step 0.3 does not fit: it can be 1 divided by a whole number, or a whole number, from "
               "0.000001 to 100 frames.";
        QTest::newRow("a tolerance") << "tolerance" << QStringList{"tolerance", "0"}
                                     << "The tolerance 0 does not fit: it can be from 1e-13 to 100 px.";
        QTest::newRow("a step where a tolerance is needed")
            << "needs-tolerance" << QStringList{"method", "dormand_prince"}
            << "The method dormand_prince chooses its steps itself: give it a tolerance in px in place of a "
               "step.";
        QTest::newRow("a tolerance where a step is needed")
            << "needs-step" << QStringList{"method", "rk4"}
            << "The method rk4 takes steps of one length: give it a step in frames in place of a tolerance.";
        QTest::newRow("a method and an effect")
            << "method-does-not-fit" << QStringList{"method", "rk4", "effect", "sticks"}
            << "The method rk4 cannot compute sticks: choose another method, or switch that effect off.";
        QTest::newRow("points without inertia") << "needs-inertia" << QStringList{"method", "tr_bdf2"}
                                                << "The method tr_bdf2 cannot compute this scene: parts of "
                                                   "it go only where they are put, and have no "
                                                   "velocity. Choose another method.";
        QTest::newRow("a scene at rest") << "nothing-moves" << QStringList{"method", "published"}
                                         << "Nothing in this scene can move: leave at least one body free.";
        QTest::newRow("a place that is no number")
            << "input-not-finite" << QStringList{"event", "move", "frame", "7"}
            << "The event move before frame 7 has a number that is infinite or none at all: give it a finite "
               "one.";
        QTest::newRow("a start that is no number")
            << "start-not-finite" << QStringList{"body", "foot0"}
            << "The start of foot 0 has a number that is infinite or none at all: give it a finite one.";
        QTest::newRow("a step that is too long")
            << "claim-grows"
            << QStringList{"method", "rk4", "h", "1", "k", "9", "apart", "100", "left", "300"}
            << "At a step of h 1 its stiffest spring (9) would go from 100 px to 300 px, and farther.";
        QTest::newRow("a step that is longer than sticks are measured by")
            << "claim-longer-step" << QStringList{"method", "published", "h", "1", "most", "0.05"}
            << "Its sticks are measured by steps of h 0.05: at 1 they err more.";
        QTest::newRow("a body that is lost")
            << "hard-not-finite" << QStringList{"frame", "3", "body", "foot0", "phase", "move"}
            << "After frame 3 foot 0 is nowhere any more: \"move\" gave a number without an end.";
        QTest::newRow("a frame that would take too long")
            << "hard-too-many-steps" << QStringList{"frame", "7"}
            << "After frame 7 it needs more steps for a frame than it may take.";
        QTest::newRow("a case that would take too long")
            << "claim-too-many-steps" << QStringList{"method", "rk4", "steps", "1800", "most", "700"}
            << "It would need about 1800 steps a frame, and gives up at 700.";
        QTest::newRow("a stick without an end")
            << "stick-without-end" << QStringList{"stick", "4", "end", "7", "points", "5"}
            << "Stick 4 ends at p7, and there is no such point: there are 5, and the first is p0.";
        QTest::newRow("a spring without an end")
            << "spring-without-end" << QStringList{"spring", "1", "end", "9", "points", "3"}
            << "Spring 1 ends at p9, and there is no such point: there are 3, and the first is p0.";
    }
    void refusals()
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
            << "Stopped at frame 7: in the next one “foot 3” is too far or too fast for any number (not "
               "finite). It began in “spring”.";
        QTest::newRow("one that no phase made")
            << int(sim::StopReason::notFinite) << QString()
            << "Stopped at frame 7: in the next one “foot 3” is too far or "
               "too fast for any number (not finite).";
        QTest::newRow("too many steps")
            << int(sim::StopReason::tooManySteps) << "steps of its own"
            << "Stopped at frame 7: the method needs too many steps for the next one. What is pulled hardest "
               "is foot 3. Try a larger tolerance, or a method whose steps all have one length.";
    }
    void aStopNamesThePullAndBothItsEnds()
    {
        sim::Stop stop;
        stop.frame = 7;
        stop.phase = "kick";
        stop.body = "foot3";
        stop.otherBody = "body";
        stop.effect = std::make_shared<sim::BodySpring>(std::vector<sim::Link>{}, 0.2);
        QVERIFY(
            app::sentenceFor(stop).endsWith("It began in “kick”. The spring foot 3 – body pulls hardest."));
        stop.otherBody.clear();
        QVERIFY(app::sentenceFor(stop).endsWith("The spring of foot 3 pulls hardest."));
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

QTEST_GUILESS_MAIN(Sentences)
#include "tst_sentences.moc"
