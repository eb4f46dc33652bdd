// The judge of tasks in listings. Right formulations are written here in another way than in the lessons, so that
// agreement of text cannot make them pass.

#include "app/listing/listing_method.h"
#include "app/listing/program.h"
#include "app/model/listing/code_judge.h"
#include "sim/run/track.h"
#include "sim/scene/scene.h"
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
    void eachLessonHasATaskFromTheEmptyPage();
    void theSolutionIsRight_data() { addTaskRows(); }
    void theSolutionIsRight();
    void theEmptyPlaceIsNotRight_data() { addTaskRows(); }
    void theEmptyPlaceIsNotRight();
    void eachNearMissIsToldApart_data() { addTaskRows(); }
    void eachNearMissIsToldApart();
    void anyRightFormulationPasses_data();
    void anyRightFormulationPasses();
    void theTrialRunsVaryChoicesAndWholeNumbers_data() { addTaskRows(); }
    void theTrialRunsVaryChoicesAndWholeNumbers();
    void codeThatIgnoresAParameterIsNotRight_data();
    void codeThatIgnoresAParameterIsNotRight();
    void theTrialRunsMoveBodies_data() { addTaskRows(); }
    void theTrialRunsMoveBodies();
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
    for (QString text : texts) {
        QVERIFY(!text.isEmpty());
        text.remove(QRegularExpression("`[^`]*`")); // code may have a !
        QVERIFY2(!text.contains('!'), qPrintable(text));
    }
    for (const QString &line : step.listing.emptied(task).split('\n'))
        QVERIFY2(line.size() <= 96, qPrintable(line));
}

void CodeJudgeTest::eachLessonHasATaskFromTheEmptyPage()
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
    add("single_spring", "drag", "throw", R"(Vec2 way = hand - foot.position;
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
        body.position = hand;
    if (foot.held)
    {
        foot.velocity = hand - foot.position;
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
    me.velocity = hand - me.position;
    me.position = hand;
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
me.position = hand;
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
    me.velocity = hand - me.position;
    me.position = hand;
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
    add("gravity_walls", "walls", "wall", R"(double edge = right - me.radius;
if (edge < me.position.x)
    me.velocity.x = -bounce * me.velocity.x;
me.position.x = min(edge, me.position.x);)");
    add("gravity_walls", "walls", "floor", R"(double deep = me.position.y + me.radius - floor;
if (deep > 0)
{
    me.velocity.y = -me.velocity.y * bounce;
    me.position.y -= deep;
})");
    add("gravity_walls", "gravity", "gravity", "me.velocity = me.velocity + Vec2(0, gravity);");
    add("gravity_walls", "gravity", "frame", R"(Vec2 spring(Vec2 me, Vec2 anchor)
{
    double angle = atan2(me.y - anchor.y, me.x - anchor.x);
    return k * (anchor - me + Vec2(radius * cos(angle), radius * sin(angle)));
}

bool isInHand(Body me)
{
    if (me.held)
        me.velocity = hand - me.position;
    if (me.held)
        me.position = hand;
    return me.held;
}

void go(Body me, Vec2 force)
{
    me.velocity = damp * (me.velocity + force + Vec2(0, gravity));
    me.position += me.velocity;
    double least = left + me.radius;
    double most = right - me.radius;
    if (me.position.x != clamp(me.position.x, least, most))
        me.velocity.x *= -bounce;
    me.position.x = clamp(me.position.x, least, most);
    if (me.position.y + me.radius > floor)
    {
        me.velocity.y *= -bounce;
        me.position.y = floor - me.radius;
    }
}

void frame()
{
    bool held = isInHand(body);
    Vec2 sum(0, 0);
    for (int i = 0; i < feet.count; i++)
    {
        if (!isInHand(feet[i]))
            go(feet[i], spring(feet[i].position, body.position));
        sum += spring(body.position, feet[i].position);
    }
    if (!held)
        go(body, sum);
})");
    add("walking_gait", "bones", "target",
        "Vec2 target = body.position + leg * Vec2(cos(angle + pi), sin(angle + pi));");
    add("walking_gait", "swing", "target", R"(double turned = gait + angle;
Vec2 target(body.position.x - leg * cos(turned), body.position.y + drop - leg * sin(turned));)");
    add("walking_gait", "body_pulled", "forces", R"(if (!body.held)
    body.velocity += -1 * force;
if (foot.held)
    return;
foot.velocity += force;)");
    add("walking_gait", "ground", "ground", R"(bool isFoot = me != body;
if (isFoot && ground < me.position.y)
{
    me.velocity = Vec2(traction == 0 ? 0.0 : me.velocity.x, -bounce * me.velocity.y);
    me.position = Vec2(me.position.x, ground);
})");
    add("walking_gait", "ground", "frame", R"(void hold(Body me)
{
    if (me.held)
    {
        me.velocity = hand - me.position;
        me.position = hand;
    }
}

void go(Body me)
{
    me.velocity = damp * (me.velocity + Vec2(0, gravity));
    me.position += me.velocity;
}

void frame()
{
    for (int i = 0; i < 2; i++)
        hold(feet[i]);
    hold(body);
    for (int i = 0; i < 2; i++)
    {
        double turned = i * pi + gait;
        Vec2 place(body.position.x - leg * cos(turned), body.position.y - leg * sin(turned) + drop);
        Vec2 force = (place - feet[i].position) * k;
        if (!feet[i].held)
            feet[i].velocity += force;
        if (!body.held)
            body.velocity -= force;
    }
    for (int i = 0; i < 2; i++)
    {
        Body foot = feet[i];
        if (foot.held)
            continue;
        go(foot);
        if (foot.position.y <= ground)
            continue;
        foot.position.y = ground;
        foot.velocity = Vec2(traction == 0 ? 0.0 : foot.velocity.x, -bounce * foot.velocity.y);
    }
    if (!body.held)
        go(body);
    gait = gait + speed;
})");
    add("swaying_tree", "branches", "place", R"(for (int i = branch.children.count - 1; i >= 0; i--)
    place(branch.children[i], reach(branch) * branch.scale + branch.position);)");
    add("swaying_tree", "towards_pointer", "turn", "branch.angle = 180 / pi * atan2(way.y, way.x);");
    add("swaying_tree", "towards_pointer", "frame", R"(void go(Body branch)
{
    if (branch.held)
        branch.position = hand;
    else if (pointer_down)
        branch.angle =
            atan2(pointer.y - branch.position.y, pointer.x - branch.position.x) * 180 / pi;
    double rad = branch.angle * pi / 180;
    for (int i = 0; i < branch.children.count; i++)
    {
        branch.children[i].position =
            branch.position + base_length * Vec2(cos(rad), sin(rad)) * branch.scale;
        go(branch.children[i]);
    }
}

void frame()
{
    go(branches[0]);
})");
    add("swaying_tree", "rest", "rest", R"(double past = branch.angle - branch.rest;
if (past > 1 || past < -1)
    branch.angle -= past / ease;)");
    add("rigid_constraint", "pair", "error", "double error = sqrt(dot(d, d)) - stick.length;");
    add("rigid_constraint", "shared_error", "parts", R"(double part_of_b = (1 - share_of_a) * error;
double part_of_a = error - part_of_b;)");
    add("rigid_constraint", "list", "loop", R"(int next = 0;
while (next < sticks.count)
{
    enforce(sticks[next]);
    next++;
})");
    add("rigid_constraint", "list", "frame", R"(void fix(Stick one)
{
    Vec2 way = one.b.position - one.a.position;
    double angle = atan2(way.y, way.x);
    Vec2 move = (length(way) - one.length) * Vec2(cos(angle), sin(angle));
    double share = one.share;
    if (one.b.held)
        share = 1;
    if (one.a.held)
        share = 0;
    one.a.position += share * move;
    one.b.position -= (1 - share) * move;
}

void frame()
{
    if (pointer_known)
        points[0].position = pointer;
    for (int i = 0; i < points.count; i++)
        if (points[i].held)
            points[i].position = hand;
    for (int i = 0; i < sticks.count; i++)
        fix(sticks[i]);
})");
    add("rigid_constraint", "verlet", "move", R"(point.velocity.y += gravity;
point.velocity *= damp;
point.position += point.velocity;)");
    add("rigid_constraint", "verlet", "came", R"(for (int i = points.count - 1; i >= 0; i--)
    points[i].velocity = -1 * (points[i].before - points[i].position);)");
    add("codeling", "motor", "pull", "Vec2 pull = (target - lead.position) * (k * pow(dt, 2));");
    add("codeling", "orientation", "tail", R"(Vec2 none(0, 0);
lead.position += tail.held ? correction : none;
tail.position -= tail.held ? none : correction;)");
    add("codeling", "anticipation", "shift", R"(Vec2 start = lead.position;
lead.position -= anticipation * (new_targets[i] - start);
lead.velocity += lead.position - start;)");
    add("codeling", "anticipation", "frame", R"(void frame()
{
    if (lead.held)
    {
        lead.velocity = hand - lead.position;
        lead.position = hand;
    }
    else
    {
        for (int i = 0; i < new_targets.count; i++)
        {
            Vec2 away = lead.position - new_targets[i];
            lead.position += away * anticipation;
            lead.velocity += away * anticipation;
        }
        lead.velocity = keep * lead.velocity + k * dt * dt * (target - lead.position);
        lead.position += lead.velocity;
    }
    if (tail.held)
        tail.position = hand;
    Vec2 way = lead.position - tail.position;
    double angle = atan2(way.y, way.x);
    Vec2 closer = (length(way) - rest_length) * Vec2(cos(angle), sin(angle));
    if (tail.held)
        lead.position -= closer;
    else
        tail.position += closer;
})");
    add("codeling", "volume", "width", R"(double spine = length(tail.position - lead.position);
if (spine < 10)
    spine = 10;
double wanted = 30 / spine * rest_length;)");
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
    // After one frame: damp * k * distance is missing.
    const sim::Values values = one.step.defaultValues();
    const double distance = sim::length(sim::Vec2{420.0 - values["centre_x"], 120.0 - values["centre_y"]});
    QVERIFY(std::abs(verdict.distance - values["damp"] * values["k"] * distance) < 1e-9);
    QVERIFY(sentenceFor(verdict, one.task).contains("foot"));
}

void CodeJudgeTest::aMistakeThatNeedsTheHandNamesTheHeldBody()
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
