// The judge of tasks in listings.

#include "app/listing/listing_method.h"
#include "app/listing/program.h"
#include "app/model/listing/code_judge.h"
#include "sim/run/track.h"
#include "sim/scene/scene.h"
#include "tests/lessons/attempts/formulations.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace app;
using namespace support;

namespace {

/// A task with its step.
struct Assignment
{
    lessons::Step step;
    lessons::CodeTask task;

    Verdict judged(const QString &code) const
    {
        return judge(step, task, step.listing.with(task.id, code)).value();
    }
};

Assignment assignment(const QString &lesson, const QString &step, const QString &task)
{
    Assignment found{loadLesson(lesson).step(step), {}};
    for (const lessons::CodeTask &one : found.step.codeTasks) {
        if (one.id == task)
            found.task = one;
    }
    return found;
}

Assignment assignmentOfRow()
{
    QFETCH(QString, lesson);
    QFETCH(QString, step);
    QFETCH(QString, task);
    return assignment(lesson, step, task);
}

void addTaskColumns()
{
    QTest::addColumn<QString>("lesson");
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("task");
}

void addTaskRows()
{
    addTaskColumns();
    for (const QString &lesson : lessonIds()) {
        for (const lessons::Step &step : loadLesson(lesson).steps) {
            for (const lessons::CodeTask &task : step.codeTasks)
                QTest::addRow("%s/%s/%s", qPrintable(lesson), qPrintable(step.id), qPrintable(task.id))
                    << lesson << step.id << task.id;
        }
    }
}

QString described(const Verdict &verdict, const lessons::CodeTask &task)
{
    QString text = QString::number(static_cast<int>(verdict.kind)) + ": " + sentenceFor(verdict, task);
    if (verdict.compileError)
        text += ' ' + QString::fromStdString(verdict.compileError->sentence);
    if (verdict.runError)
        text += ' ' + QString::fromStdString(verdict.runError->sentence);
    return text;
}

}

class CodeJudgeTest : public QObject
{
    Q_OBJECT

private slots:
    void everyTaskIsComplete_data() { addTaskRows(); }
    void everyTaskIsComplete();
    void eachLessonWithTasksHasOneForTheWholeFrame();
    void theSolutionIsRight_data() { addTaskRows(); }
    void theSolutionIsRight();
    void emptyGapIsNotRight_data() { addTaskRows(); }
    void emptyGapIsNotRight();
    void eachNearMissIsRecognised_data() { addTaskRows(); }
    void eachNearMissIsRecognised();
    void anyRightFormulationPasses_data();
    void anyRightFormulationPasses();
    void theTrialRunsVaryChoicesAndWholeNumbers_data() { addTaskRows(); }
    void theTrialRunsVaryChoicesAndWholeNumbers();
    void codeThatIgnoresAParameterIsNotRight_data();
    void codeThatIgnoresAParameterIsNotRight();
    void theTrialRunsMoveBodies_data() { addTaskRows(); }
    void theTrialRunsMoveBodies();
    void anotherMistakeIsWrongAtItsFrameAndBody();
    void numberInsteadOfAParameterIsRecognised();
    void mistakeDuringADragNamesTheHeldBody();
    void aDifferenceBelowRoundingIsRight();
    void compileErrorNamesItsLine();
    void runtimeErrorNamesItsLine();
    void anEndlessLoopEnds();
    void canBeCancelled();
};

void CodeJudgeTest::everyTaskIsComplete()
{
    const auto [step, task] = assignmentOfRow();
    QVERIFY(!task.title.isEmpty() && !task.text.isEmpty() && !task.comment.isEmpty());
    QCOMPARE(task.hints.size(), 3);
    QCOMPARE(QSet<QString>(task.hints.begin(), task.hints.end()).size(), 3);
    QVERIFY(!task.nearMisses.empty());
    QVERIFY(task.isWholeFrame() || step.listing.gap(task.id));
    for (const lessons::NearMiss &miss : task.nearMisses)
        QVERIFY2(miss.gap.isEmpty() ? !task.isWholeFrame() : step.listing.gap(miss.gap) != nullptr,
                 qPrintable(miss.code));
    QStringList texts = QStringList{task.title, task.text} + task.hints;
    for (const lessons::NearMiss &miss : task.nearMisses)
        texts << miss.sentence;
    for (QString text : texts) {
        QVERIFY(!text.isEmpty());
        text.remove(QRegularExpression("`[^`]*`")); // code may have a !
        QVERIFY2(!text.contains('!'), qPrintable(text));
    }
    for (const QString &line : step.listing.emptied(task).split('\n'))
        QVERIFY2(line.size() <= 96, qPrintable(line));
}

void CodeJudgeTest::eachLessonWithTasksHasOneForTheWholeFrame()
{
    int all = 0;
    for (const QString &lesson : lessonIds()) {
        QStringList tasks;
        for (const lessons::Step &step : loadLesson(lesson).steps) {
            QSet<QString> ids;
            for (const lessons::CodeTask &task : step.codeTasks) {
                ids << task.id;
                tasks << task.id;
            }
            QCOMPARE(ids.size(), static_cast<qsizetype>(step.codeTasks.size()));
        }
        QVERIFY2(tasks.isEmpty() || (tasks.size() >= 3 && tasks.count("frame") == 1), qPrintable(lesson));
        all += static_cast<int>(tasks.size());
    }
    QVERIFY(all >= 24);
}

void CodeJudgeTest::theSolutionIsRight()
{
    const auto [step, task] = assignmentOfRow();
    const Verdict verdict = judge(step, task, step.listing.text).value();
    QVERIFY2(verdict.kind == Verdict::Kind::right, qPrintable(described(verdict, task)));
    QCOMPARE(step.listing.with(task.id, step.listing.solution(task.id)), step.listing.text);
}

void CodeJudgeTest::emptyGapIsNotRight()
{
    const auto [step, task] = assignmentOfRow();
    const Verdict verdict = judge(step, task, step.listing.emptied(task)).value();
    QVERIFY(verdict.kind != Verdict::Kind::right);
    QVERIFY(!sentenceFor(verdict, task).isEmpty());
}

void CodeJudgeTest::eachNearMissIsRecognised()
{
    const auto [step, task] = assignmentOfRow();
    for (int i = 0; i < static_cast<int>(task.nearMisses.size()); ++i) {
        const lessons::NearMiss &miss = task.nearMisses[static_cast<std::size_t>(i)];
        // The comment makes the text differ from the near miss in the document.
        const QString code = "// as I understood it\n" + miss.code;
        const QString text = step.listing.with(miss.gap.isEmpty() ? task.id : miss.gap, code);
        const Verdict verdict = judge(step, task, text).value();
        QVERIFY2(verdict.kind == Verdict::Kind::nearMiss,
                 qPrintable(miss.code + '\n' + described(verdict, task)));
        QVERIFY2(
            verdict.nearMiss == i,
            qPrintable(
                QStringLiteral("%1\nis not told from near miss %2").arg(miss.code).arg(verdict.nearMiss)));
        QCOMPARE(sentenceFor(verdict, task), miss.sentence);
    }
}

void CodeJudgeTest::anyRightFormulationPasses_data()
{
    addTaskColumns();
    QTest::addColumn<QString>("code");
    for (const Formulation &one : rightFormulations())
        QTest::addRow("%s/%s/%s", one.lesson, one.step, one.task)
            << one.lesson << one.step << one.task << one.code;
}

void CodeJudgeTest::anyRightFormulationPasses()
{
    QFETCH(QString, code);
    const Assignment row = assignmentOfRow();
    QVERIFY(!row.task.id.isEmpty());
    const Verdict verdict = row.judged(code);
    QVERIFY2(verdict.kind == Verdict::Kind::right, qPrintable(described(verdict, row.task)));
}

void CodeJudgeTest::theTrialRunsVaryChoicesAndWholeNumbers()
{
    const auto [step, task] = assignmentOfRow();
    const std::vector<sim::Script> scripts = judgeScripts(step);
    for (const lessons::Parameter &parameter : step.parameters) {
        QList<double> tried;
        for (const sim::Script &script : scripts) {
            const double value = script.values[parameter.id.toStdString()];
            QVERIFY(value >= parameter.min && value <= parameter.max);
            if (!tried.contains(value))
                tried << value;
        }
        QVERIFY(tried.contains(parameter.defaultValue));
        const qsizetype choices = parameter.choices.size();
        if (!parameter.isInteger)
            continue;
        QCOMPARE(tried.size(), choices == 0 ? 3 : std::min<qsizetype>(3, choices));
        for (const double value : tried)
            QCOMPARE(value, std::round(value));
    }
}

void CodeJudgeTest::codeThatIgnoresAParameterIsNotRight_data()
{
    addTaskColumns();
    QTest::addColumn<QString>("code");
    QTest::newRow("traction") << "walking_gait"
                              << "ground"
                              << "ground"
                              << R"(if (me != body && me.position.y > ground)
{
    me.position.y = ground;
    me.velocity.y *= -bounce;
    me.velocity.x = 0;
})";
    QTest::newRow("feet") << "multi_foot"
                          << "any_number"
                          << "loop"
                          << "for (int i = 0; i < min(5, feet.count); i++)\n"
                             "    body.velocity += pull(body, feet[i]);";
}

void CodeJudgeTest::codeThatIgnoresAParameterIsNotRight()
{
    QFETCH(QString, code);
    const Assignment row = assignmentOfRow();
    const Verdict verdict = row.judged(code);
    QVERIFY2(verdict.kind == Verdict::Kind::wrong || verdict.kind == Verdict::Kind::nearMiss,
             qPrintable(described(verdict, row.task)));
}

void CodeJudgeTest::theTrialRunsMoveBodies()
{
    const auto [step, task] = assignmentOfRow();
    const std::vector<sim::Script> scripts = judgeScripts(step);
    QCOMPARE(scripts.size(), 3U);
    QVERIFY(!(scripts[0].values.all() == scripts[1].values.all()));
    for (sim::Script script : scripts) {
        const sim::Scene scene = sim::sceneOf(script, script.values);
        const listing::Compiled compiled =
            listing::Program::compile(step.listing.text.toStdString(), listing::vocabularyOf(scene));
        QVERIFY(compiled.program);
        script.method = std::make_shared<listing::ListingMethod>(compiled.program);
        sim::Track track(script, 1 << 20);
        double moved = 0.0; // px
        for (int frame = 1; frame <= judgedFrames; ++frame) {
            track.seek({frame, 0});
            QCOMPARE(track.cursor().frame, frame);
            moved = std::max(moved, largestDistance(track.state(), scene.start));
        }
        QVERIFY(moved > 5.0);
    }
}

void CodeJudgeTest::anotherMistakeIsWrongAtItsFrameAndBody()
{
    // The pull is doubled from the first frame on.
    const Assignment one = assignment("single_spring", "fixed_centre", "pull");
    const Verdict verdict = one.judged("foot.velocity += 2 * k * (centre - foot.position);");
    QVERIFY(verdict.kind == Verdict::Kind::wrong);
    QCOMPARE(verdict.frame, 1);
    QCOMPARE(verdict.body, std::string("foot"));
    QVERIFY(verdict.held.empty() && !verdict.isAngle);
    QVERIFY(!verdict.hasOtherValues);
    // After one frame: damp * k * distance is missing.
    const sim::Values values = one.step.defaultValues();
    const double distance = sim::length(sim::Vec2{420.0 - values["centre_x"], 120.0 - values["centre_y"]});
    QVERIFY(std::abs(verdict.distance - values["damp"] * values["k"] * distance) < 1e-9);
    QVERIFY(sentenceFor(verdict, one.task).contains("foot"));
}

void CodeJudgeTest::numberInsteadOfAParameterIsRecognised()
{
    const Assignment one = assignment("walking_gait", "bones", "target");
    Verdict verdict = one.judged("Vec2 target = body.position - 50 * Vec2(cos(angle), sin(angle));");
    QVERIFY(verdict.kind == Verdict::Kind::wrong);
    QVERIFY(verdict.hasOtherValues);
    const auto isSaid = [&] {
        return sentenceFor(verdict, one.task).contains("a trial run with other parameters,");
    };
    QVERIFY2(isSaid(), qPrintable(sentenceFor(verdict, one.task)));
    verdict.held = "foot0";
    QVERIFY2(isSaid(), qPrintable(sentenceFor(verdict, one.task)));
}

void CodeJudgeTest::mistakeDuringADragNamesTheHeldBody()
{
    const Assignment one = assignment("single_spring", "drag", "throw");
    const Verdict verdict = one.judged("foot.velocity = hand - foot.position;");
    QVERIFY(verdict.kind == Verdict::Kind::wrong);
    QCOMPARE(verdict.held, std::string("foot"));
    QVERIFY(sentenceFor(verdict, one.task).contains("hand"));
}

void CodeJudgeTest::aDifferenceBelowRoundingIsRight()
{
    const Assignment one = assignment("single_spring", "fixed_centre", "pull");
    const auto kindWith = [&](const char *much) {
        return one
            .judged(QStringLiteral("foot.velocity += k * (centre - foot.position) + Vec2(%1, 0);").arg(much))
            .kind;
    };
    QVERIFY(kindWith("1e-13") == Verdict::Kind::right);
    QVERIFY(kindWith("1e-8") == Verdict::Kind::wrong);
}

void CodeJudgeTest::compileErrorNamesItsLine()
{
    const Assignment one = assignment("single_spring", "fixed_centre", "pull");
    const Verdict verdict = one.judged("foot.velocty += k;");
    QVERIFY(verdict.kind == Verdict::Kind::doesNotCompile);
    QCOMPARE(verdict.compileError->line, one.step.listing.gap("pull")->firstLine);
    QVERIFY(sentenceFor(verdict, one.task).contains(QString::number(verdict.compileError->line)));
}

void CodeJudgeTest::runtimeErrorNamesItsLine()
{
    const Assignment one = assignment("multi_foot", "any_number", "loop");
    const Verdict verdict =
        one.judged("for (int i = 0; i <= feet.count; i++)\n    body.velocity += pull(body, feet[i]);");
    QVERIFY(verdict.kind == Verdict::Kind::stopped);
    QCOMPARE(verdict.frame, 1);
    QVERIFY(verdict.runError.has_value());
    QVERIFY(verdict.runError->kind == listing::RunErrorKind::noSuchBody);
    QVERIFY2(sentenceFor(verdict, one.task)
                 .contains(QString("Line %1 of your code: There is no feet[").arg(verdict.runError->line)),
             qPrintable(sentenceFor(verdict, one.task)));
}

void CodeJudgeTest::anEndlessLoopEnds()
{
    const Assignment one = assignment("multi_foot", "any_number", "loop");
    const Verdict verdict = one.judged("while (true)\n    body.velocity *= 1;");
    QVERIFY(verdict.kind == Verdict::Kind::stopped);
    QVERIFY(verdict.runError->kind == listing::RunErrorKind::endlessLoop);
}

void CodeJudgeTest::canBeCancelled()
{
    const Assignment one = assignment("multi_foot", "any_number", "loop");
    QVERIFY(!judge(one.step, one.task, one.step.listing.text, [] { return false; }));
}

SUITE(tst_code_judge, CodeJudgeTest)
#include "tst_code_judge.moc"
