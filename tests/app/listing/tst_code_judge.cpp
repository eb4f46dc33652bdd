// The judge of tasks in listings. Right formulations are written here in another way than in the lessons, so that
// agreement of text cannot make them pass.

#include "app/listing/listing_method.h"
#include "app/listing/program.h"
#include "app/model/listing/code_judge.h"
#include "sim/run/track.h"
#include "sim/scene/scene.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QSet>
#include <QTest>

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
    void lessonsEndWithTheEmptyPage();
    void theSolutionIsRight_data() { addTaskRows(); }
    void theSolutionIsRight();
    void theEmptyPlaceIsNotRight_data() { addTaskRows(); }
    void theEmptyPlaceIsNotRight();
    void eachNearMissIsToldApart_data() { addTaskRows(); }
    void eachNearMissIsToldApart();
    void anyRightFormulationPasses_data();
    void anyRightFormulationPasses();
    void theTrialRunsMoveEveryBody_data() { addTaskRows(); }
    void theTrialRunsMoveEveryBody();
    void anotherMistakeIsWrongAtItsFrameAndBody();
    void aMistakeThatNeedsTheHandNamesTheHeldBody();
    void aDifferenceBelowRoundingIsRight();
    void whatDoesNotCompileTellsItsLine();
    void aRuntimeMistakeTellsItsLine();
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
    for (const QString &text : texts)
        QVERIFY2(!text.isEmpty() && !text.contains('!'), qPrintable(text));
    for (const QString &line : task.comment.split('\n'))
        QVERIFY2(line.size() <= 90, qPrintable(line));
}

void CodeJudgeTest::lessonsEndWithTheEmptyPage()
{
    for (const QString &lesson : lessonIds()) {
        QStringList tasks;
        for (const lessons::Step &step : loadLesson(lesson).steps) {
            for (const lessons::CodeTask &task : step.codeTasks)
                tasks << task.id;
        }
        QVERIFY2(tasks.isEmpty() || (tasks.last() == "frame" && tasks.count("frame") == 1),
                 qPrintable(lesson));
    }
}

void CodeJudgeTest::theSolutionIsRight()
{
    const auto [step, task] = assignmentOfRow();
    const Verdict verdict = judge(step, task, step.listing.text).value();
    QVERIFY2(verdict.kind == Verdict::Kind::right, qPrintable(described(verdict, task)));
    QCOMPARE(step.listing.with(task.id, step.listing.solution(task.id)), step.listing.text);
}

void CodeJudgeTest::theEmptyPlaceIsNotRight()
{
    const auto [step, task] = assignmentOfRow();
    const Verdict verdict = judge(step, task, step.listing.emptied(task)).value();
    QVERIFY(verdict.kind != Verdict::Kind::right);
    QVERIFY(!sentenceFor(verdict, task).isEmpty());
}

void CodeJudgeTest::eachNearMissIsToldApart()
{
    const auto [step, task] = assignmentOfRow();
    for (int i = 0; i < static_cast<int>(task.nearMisses.size()); ++i) {
        const lessons::NearMiss &miss = task.nearMisses[static_cast<std::size_t>(i)];
        // With a comment: the text of a learner is not that of the task.
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
    const auto add = [](const char *lesson, const char *step, const char *task, const char *code) {
        QTest::addRow("%s/%s/%s", lesson, step, task) << lesson << step << task << code;
    };
    add("single_spring", "drag", "throw", R"(Vec2 way = pointer - foot.position;
foot.position += way;
foot.velocity = way;)");
    add("single_spring", "fixed_centre", "pull", R"(foot.velocity.x += k * (centre_x - foot.position.x);
foot.velocity.y -= k * (foot.position.y - centre_y);)");
    add("single_spring", "moving_body", "move", R"(foot.position += damp * foot.velocity;
foot.velocity -= (1 - damp) * foot.velocity;)");
    add("single_spring", "offset", "target",
        "Vec2 target = Vec2(offset + body.position.x, body.position.y);");
    add("single_spring", "radial", "target", R"(Vec2 way = foot.position - body.position;
double far = sqrt(way.x * way.x + way.y * way.y);
Vec2 target = body.position + Vec2(radius, 0);
if (far > 0)
    target = body.position + way / far * radius;)");
    add("single_spring", "radial", "frame", R"(Vec2 ring(Vec2 centre, Vec2 at)
{
    Vec2 way = at - centre;
    double far = length(way);
    return far == 0 ? centre + Vec2(radius, 0) : centre + radius / far * way;
}

void frame()
{
    if (body.held)
        body.position = pointer;
    if (foot.held)
    {
        foot.velocity = pointer - foot.position;
        foot.position += foot.velocity;
        return;
    }
    foot.velocity = damp * (foot.velocity + k * (ring(body.position, foot.position) - foot.position));
    foot.position += foot.velocity;
})");
    add("two_body", "mutual", "opposite", "body.velocity -= k * (nearest(foot, body) - foot.position);");
    add("two_body", "mutual", "nearest", R"(Vec2 way = me.position - anchor.position;
if (length(way) == 0)
    return anchor.position + Vec2(radius, 0);
return anchor.position + way * (radius / length(way));)");
    add("two_body", "leg_line", "frame", R"(void hold(Body me)
{
    me.velocity = pointer - me.position;
    me.position = pointer;
}

void go(Body me, Body other)
{
    double angle = atan2(me.position.y - other.position.y, me.position.x - other.position.x);
    me.velocity.x += k * (other.position.x + radius * cos(angle) - me.position.x);
    me.velocity.y += k * (other.position.y + radius * sin(angle) - me.position.y);
    me.velocity = me.velocity * damp;
    me.position = me.position + me.velocity;
}

void frame()
{
    if (body.held)
        hold(body);
    if (foot.held)
        hold(foot);
    else
        go(foot, body);
    if (!body.held)
        go(body, foot);
})");
    add("multi_foot", "two_feet", "both", "body.velocity += pull(body, feet[1]) + pull(body, feet[0]);");
    add("multi_foot", "any_number", "loop", R"(Vec2 all(0, 0);
int i = feet.count;
while (i > 0)
{
    i--;
    all += pull(body, feet[i]);
}
body.velocity += all;)");
    add("multi_foot", "any_number", "follow", R"(Vec2 before = me.position;
me.position = pointer;
me.velocity = me.position - before;)");
    add("multi_foot", "grown_feet", "frame", R"(Vec2 place(Vec2 me, Vec2 anchor)
{
    double angle = atan2(me.y - anchor.y, me.x - anchor.x);
    return anchor + Vec2(radius * cos(angle), radius * sin(angle));
}

bool isInHand(Body me)
{
    if (!me.held)
        return false;
    me.velocity = pointer - me.position;
    me.position = pointer;
    return true;
}

void frame()
{
    bool bodyHeld = isInHand(body);
    for (int i = 0; i < feet.count; i++)
    {
        if (isInHand(feet[i]))
            continue;
        feet[i].velocity += k * (place(feet[i].position, body.position) - feet[i].position);
        feet[i].velocity *= damp;
        feet[i].position += feet[i].velocity;
    }
    if (bodyHeld)
        return;
    Vec2 sum(0, 0);
    for (int i = feet.count - 1; i >= 0; i--)
        sum += place(body.position, feet[i].position) - body.position;
    body.velocity = (body.velocity + k * sum) * damp;
    body.position += body.velocity;
})");
}

void CodeJudgeTest::anyRightFormulationPasses()
{
    QFETCH(QString, code);
    const Assignment row = assignmentOfRow();
    QVERIFY(!row.task.id.isEmpty());
    const Verdict verdict = row.judged(code);
    QVERIFY2(verdict.kind == Verdict::Kind::right, qPrintable(described(verdict, row.task)));
}

void CodeJudgeTest::theTrialRunsMoveEveryBody()
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
        track.seek({judgedFrames, 0});
        QCOMPARE(track.cursor().frame, judgedFrames);
        QVERIFY(largestDistance(track.state(), scene.start) > 5.0);
    }
}

void CodeJudgeTest::anotherMistakeIsWrongAtItsFrameAndBody()
{
    // The foot rests at (420, 120), 140.9 px from the centre (270, 200)... the pull is doubled from the first frame on.
    const Assignment one = assignment("single_spring", "fixed_centre", "pull");
    const Verdict verdict = one.judged("foot.velocity += 2 * k * (centre - foot.position);");
    QVERIFY(verdict.kind == Verdict::Kind::wrong);
    QCOMPARE(verdict.frame, 1);
    QCOMPARE(verdict.body, std::string("foot"));
    QVERIFY(verdict.held.empty() && !verdict.isAngle);
    // After one frame: damp * k * distance is missing.
    const sim::Values values = one.step.defaultValues();
    const double distance = sim::length(sim::Vec2{420.0 - values["centre_x"], 120.0 - values["centre_y"]});
    QVERIFY(std::abs(verdict.distance - values["damp"] * values["k"] * distance) < 1e-9);
    QVERIFY(sentenceFor(verdict, one.task).contains("foot"));
}

void CodeJudgeTest::aMistakeThatNeedsTheHandNamesTheHeldBody()
{
    const Assignment one = assignment("single_spring", "drag", "throw");
    const Verdict verdict = one.judged("foot.velocity = pointer - foot.position;");
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

void CodeJudgeTest::whatDoesNotCompileTellsItsLine()
{
    const Assignment one = assignment("single_spring", "fixed_centre", "pull");
    const Verdict verdict = one.judged("foot.velocty += k;");
    QVERIFY(verdict.kind == Verdict::Kind::doesNotCompile);
    QCOMPARE(verdict.compileError->line, one.step.listing.gap("pull")->firstLine);
    QVERIFY(sentenceFor(verdict, one.task).contains(QString::number(verdict.compileError->line)));
}

void CodeJudgeTest::aRuntimeMistakeTellsItsLine()
{
    const Assignment one = assignment("multi_foot", "any_number", "loop");
    const Verdict verdict =
        one.judged("for (int i = 0; i <= feet.count; i++)\n    body.velocity += pull(body, feet[i]);");
    QVERIFY(verdict.kind == Verdict::Kind::stopped);
    QCOMPARE(verdict.frame, 1);
    QVERIFY(verdict.runError.has_value());
    QVERIFY(verdict.runError->kind == listing::RunErrorKind::noSuchBody);
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
