// The values that the lines of a frame have computed: beside the lines, in conditions and in the scene.

#include "app/model/breakpoints/breakpoint_monitor.h"
#include "app/model/listing/vector_mark.h"
#include "app/model/text/user_error.h"
#include "sim/run/script/composed_interval.h"
#include "tests/app/listing/code_session.h"
#include "tests/suite.h"

#include <algorithm>
#include <cmath>

using namespace app;
using code_session::chipAt;
using code_session::Opened;
using code_session::published;
using code_session::valuesOf;

namespace {

std::optional<VectorMark> markAt(const Opened &opened, const QString &code, const QString &name)
{
    const LineStepper::Shown shown = opened.session.lines().shown();
    const int line = opened.lineOf(code);
    const QString text = opened.session.code().text();
    const int column = static_cast<int>(text.split('\n')[line - 1].indexOf(name)) + 1;
    return vectorMarkAt(text, line, column, *shown.frame, shown.index);
}

constexpr auto recursive = R"(
double depth(int n)
{
    double below = 0;
    if (n > 0)
        below = depth(n - 1);
    return below + 1;
}

double total = 0;

void frame()
{
    total += 1;
    double d = depth(2);
    foot.position += Vec2(d, 0);
}
)";

}

class LineValuesTest : public QObject
{
    Q_OBJECT

private slots:
    void valuesAreShownBesideTheLinesThatSetThem()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(5);
        const sim::Scene &scene = session.timeline().track().interval().scene;
        const sim::State state = session.timeline().state();
        const sim::Vec2 from = state.positionOf(scene.find("foot")) - state.positionOf(scene.find("body"));
        const double angle = std::atan2(from.y, from.x);
        session.lines().goTo(4); // the angle is known, the target is not
        const LineStepper::Shown shown = session.lines().shown();
        QVERIFY(shown.isInside);
        QCOMPARE(std::get<double>(*shown.frame->valueOf("angle", 4)), angle);
        QVERIFY(std::get<sim::Vec2>(*shown.frame->valueOf("from", 4)) == from);
        QCOMPARE(std::get<double>(*shown.frame->valueOf("from.y", 4)), from.y);
        QVERIFY(!shown.frame->valueOf("target_", 4));
        QCOMPARE(chipAt(opened, "double angle").text, "angle = " + shownText(angle));
        QVERIFY(chipAt(opened, "double angle").isChanged);
        QVERIFY(!chipAt(opened, "Vec2 from").isChanged);
        QVERIFY(chipAt(opened, "Vec2 target").text.isEmpty()); // not yet
        QVERIFY(chipAt(opened, "foot.velocity *= damp").text.isEmpty());

        session.lines().goTo(7);
        const sim::Vec2 damped =
            published(session.step(), session.timeline().script(), 6).velocityOf(scene.find("foot"));
        QVERIFY(std::get<sim::Vec2>(*session.lines().shown().frame->valueOf("foot.velocity", 7)) == damped);
        QCOMPARE(chipAt(opened, "foot.velocity *= damp").text, "foot.velocity = " + shownText(damped));
        QVERIFY(chipAt(opened, "foot.velocity *= damp").isChanged);
        QVERIFY(!chipAt(opened, "double angle").isChanged);
    }

    void aVariableInParenthesesHasAValueToo()
    {
        Opened opened("single_spring", "fixed_centre"); // Vec2 centre(centre_x, centre_y);
        Session &session = opened.session;
        QVERIFY(session.lines().runTo(opened.lineOf("foot.velocity += k")));
        const sim::Values &values = session.timeline().values();
        const sim::Vec2 centre = {values["centre_x"], values["centre_y"]};
        QCOMPARE(chipAt(opened, "Vec2 centre(").text, "centre = " + shownText(centre));
        const std::optional<VectorMark> mark = markAt(opened, "foot.velocity += k", "centre");
        QVERIFY(mark && mark->kind == VectorMark::Kind::place && mark->to == centre);
        QVERIFY(conditionNames(session.step(), session.timeline()).variables.count("centre") == 1);
    }

    void theLastLineOfAFunctionHasAValueToo()
    {
        Opened opened("swaying_tree", "trunk");
        opened.goTo(3);
        QCOMPARE(chipAt(opened, "Vec2 end").text, "end = " + shownText(sim::Vec2{275.0, 300.0}));
    }

    void variablesOfTheSceneHaveValuesToo()
    {
        Opened opened("walking_gait", "steering");
        Session &session = opened.session;
        opened.goTo(3);
        session.code().write(Opened::with(opened.listing(), "    gait += gait_speed;",
                                          "    gait_speed = 0.25;\n    gait += gait_speed;"));
        const double gait = session.timeline().state().gait[0];
        QVERIFY(session.lines().runTo(opened.lineOf("gait += gait_speed;")));
        QCOMPARE(chipAt(opened, "gait_speed = 0.25").text, QString("gait_speed = 0.25"));
        const LineStepper::Shown before = session.lines().shown();
        QVERIFY(before.frame->valueOf("gait", before.index) == listing::Value(gait));
        opened.goTo(4);
        QCOMPARE(chipAt(opened, "gait += gait_speed;").text,
                 "gait = " + shownText(session.timeline().state().gait[0]));
        QVERIFY(std::abs(session.timeline().state().gait[0] - gait - 0.25) < 1e-12);
    }

    void theGaitOfEachCreatureHasAValue()
    {
        Opened opened("walking_gait", "company");
        Session &session = opened.session;
        opened.goTo(5);
        const LineStepper::Shown shown = session.lines().shown();
        const Eigen::ArrayXd &gait = session.timeline().state().gait;
        QCOMPARE(gait.rows(), 2);
        for (int i = 0; i < 2; ++i) {
            QVERIFY(shown.frame->valueOf(QString("creatures[%1].gait").arg(i), shown.index) ==
                    listing::Value(gait[i]));
            QVERIFY(shown.frame->valueOf(QString("creatures[%1].gait_speed").arg(i), shown.index) ==
                    listing::Value(session.timeline().state().gaitSpeed[i]));
        }
        QVERIFY(chipAt(opened, "me.gait += me.gait_speed").text.startsWith("me.gait = "));
        QVERIFY(!shown.frame->valueOf("gait", shown.index)); // no such name here
    }

    void theGustHasValues()
    {
        Opened opened("swaying_tree", "real_sway");
        Session &session = opened.session;
        sim::Script script = session.step().script();
        script.input = {{2, sim::Pointer{{200, 200}, true}}, {5, sim::Pointer{{200, 200}, false}}};
        session.open({"swaying_tree", "real_sway", 20, script, {}, {}});
        opened.goTo(10);
        const LineStepper::Shown shown = session.lines().shown();
        const sim::GustExtent gust = session.timeline().state().gustExtent;
        QVERIFY(gust.front > gust.tail && gust.tail > 0.0);
        QVERIFY(shown.frame->valueOf("gust_front", shown.index) == listing::Value(gust.front));
        QVERIFY(shown.frame->valueOf("gust_tail", shown.index) == listing::Value(gust.tail));
        QCOMPARE(chipAt(opened, "gust_tail += gust_speed").text, "gust_tail = " + shownText(gust.tail));
        QCOMPARE(chipAt(opened, "gust_front += gust_speed").text, "gust_front = " + shownText(gust.front));
    }

    void theTurbulenceOfTheInputHasAValue()
    {
        Opened opened("swaying_tree", "turbulence");
        Session &session = opened.session;
        sim::Script script = session.step().script();
        script.input = {{5, sim::Gust{7.5}}}; // for the frame after the fourth
        session.open({"swaying_tree", "turbulence", 20, script, {}, {}});
        for (const int frame : {4, 5}) {
            opened.goTo(frame);
            const std::shared_ptr<const ListingFrame> next = session.lines().nextFrame();
            QVERIFY(next->valueOf("gust_known", 0) == listing::Value(frame == 4));
            QVERIFY(next->valueOf("gust", 0) == listing::Value(frame == 4 ? 7.5 : 0.0));
        }
    }

    void betweenTwoFramesTheValuesAreThoseOfTheLastOne()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(6);
        const LineStepper::Shown shown = session.lines().shown();
        QVERIFY(shown.frame && !shown.isInside);
        QCOMPARE(shown.frame->frame(), 5);
        QCOMPARE(shown.index, shown.frame->count());
        const int foot = session.timeline().track().interval().scene.find("foot");
        QCOMPARE(chipAt(opened, "foot.position +=").text,
                 "foot.position = " + shownText(session.timeline().state().positionOf(foot)));
        QVERIFY(!chipAt(opened, "foot.position +=").isChanged);
        QCOMPARE(valuesOf(opened).calls, QStringList{"frame"});
    }

    void loopsShowTheirIteration()
    {
        Opened opened("multi_foot", "any_number");
        Session &session = opened.session;
        session.editor().setParameter("feet", 5);
        QVERIFY(session.lines().runTo(opened.lineOf("move(foot);")));
        QVERIFY(session.lines().runTo(opened.lineOf("move(foot);")));
        QVERIFY(session.lines().runTo(opened.lineOf("move(foot);")));
        const LineValues values = valuesOf(opened);
        QCOMPARE(values.loops.size(), std::size_t(1));
        QCOMPARE(values.loops.front().line, opened.lineOf("for (int i"));
        QCOMPARE(values.loops.front().text, QString("i = 2 of 5"));
        QCOMPARE(chipAt(opened, "Body foot = feet[i]").text, QString("foot = feet[2]"));
        QCOMPARE(values.calls, QStringList{"frame"});
    }

    void functionsThatCallThemselvesShowTheirCalls()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        session.code().write(recursive);
        QVERIFY2(session.code().isRunning(),
                 qPrintable(session.code().mistakes().empty() ? QString()
                                                              : session.code().mistakes().front().sentence));
        QVERIFY(session.lines().runTo(opened.lineOf("below = depth(n - 1)")));
        QVERIFY(session.lines().runTo(opened.lineOf("below = depth(n - 1)")));
        QCOMPARE(valuesOf(opened).calls, (QStringList{"frame", "depth", "depth"}));
        const LineStepper::Shown inner = session.lines().shown();
        QCOMPARE(std::get<std::int64_t>(*inner.frame->valueOf("n", inner.index)), 1);
        // While the calls return, each call has its own values again.
        QVERIFY(session.lines().runTo(opened.lineOf("return below + 1")));
        QVERIFY(session.lines().runTo(opened.lineOf("return below + 1")));
        QVERIFY(session.lines().runTo(opened.lineOf("return below + 1")));
        QCOMPARE(valuesOf(opened).calls, (QStringList{"frame", "depth"}));
        QCOMPARE(chipAt(opened, "below = depth(n - 1)").text, QString("below = 2.00"));
        opened.goTo(3);
        QCOMPARE(chipAt(opened, "total += 1").text, QString("total = 3.00"));
        QCOMPARE(chipAt(opened, "double d =").text, QString("d = 3.00"));
        session.lines().back(); // into frame 3: total is known before and after it
        const LineStepper::Shown last = session.lines().shown();
        QCOMPARE(std::get<double>(*last.frame->valueOf("total", 0)), 2.0);
        QCOMPARE(std::get<double>(*last.frame->valueOf("total", last.index)), 3.0);
    }

    void conditionsKnowTheVariables()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        const int foot = session.timeline().track().interval().scene.find("foot");
        const int body = session.timeline().track().interval().scene.find("body");
        std::vector<double> values; // of from.x, by the compiled pipeline
        for (std::int64_t frame = 0; frame < 60; ++frame) {
            const sim::State state = published(session.step(), session.timeline().script(), frame);
            values.push_back(state.positionOf(foot).x - state.positionOf(body).x);
        }
        const auto farthest = std::max_element(values.begin(), values.end(), [&](double one, double other) {
            return std::abs(one - values.front()) < std::abs(other - values.front());
        });
        const double limit = (values.front() + *farthest) / 2;
        const bool falls = *farthest < values.front();
        const auto isBeyond = [&](double value) { return falls ? value < limit : value > limit; };
        const auto first = std::find_if(values.begin(), values.end(), isBeyond);
        QVERIFY(first != values.begin() && first != values.end());
        const QString condition =
            QStringLiteral("from.x %1 %2").arg(falls ? "<" : ">").arg(limit, 0, 'g', 17);
        session.playback().breakpoints().add(condition);
        const auto stop = [&] {
            session.playback().runTo({59, 0});
            opened.waitUntilThere();
            return session.timeline().cursor();
        };
        const std::int64_t frame = first - values.begin();
        QCOMPARE(stop(), (sim::Cursor{frame, 0}));
        QCOMPARE(session.lines().nextLine(),
                 opened.lineOf("double angle")); // `from` is known since the line before
        QVERIFY(session.playback().breakHit());
        QCOMPARE(session.playback().breakHit()->sentence,
                 QString("Stopped at frame %1 before line %2: %3.")
                     .arg(QString::number(frame), QString::number(opened.lineOf("double angle")), condition));
        // The condition becomes true again in the next frame, where `from` is another variable.
        const auto second = std::find_if(first + 1, values.end(), isBeyond);
        QCOMPARE(stop(), (sim::Cursor{second - values.begin(), 0}));
        session.lines().forward();
        QVERIFY(!session.playback().breakHit());
    }

    void conditionsOnUnknownVariablesSaySo_data()
    {
        QTest::addColumn<QString>("condition");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("a Vec2")
            << "from > 3"
            << "Character 1: from is a Vec2; ask for one of its numbers, from.x or from.y.";
        QTest::newRow("a number") << "angle.x > 3"
                                  << "Character 1: angle is a number, without members.";
        QTest::newRow("good") << "angle > 3 and from.y < 2 and foot.y > 1"
                              << "";
    }
    void conditionsOnUnknownVariablesSaySo()
    {
        QFETCH(QString, condition);
        QFETCH(QString, sentence);
        Opened opened("single_spring", "radial");
        QString said;
        try {
            Condition::parse(condition, conditionNames(opened.session.step(), opened.session.timeline()));
        } catch (const UserError &error) {
            said = error.sentence();
        }
        QCOMPARE(said, sentence);
    }

    void pointingAtAVec2DrawsIt()
    {
        Opened opened("single_spring", "radial");
        Session &session = opened.session;
        opened.goTo(5);
        const sim::Scene &scene = session.timeline().track().interval().scene;
        const sim::State state = session.timeline().state();
        const sim::Vec2 foot = state.positionOf(scene.find("foot")),
                        body = state.positionOf(scene.find("body"));
        session.lines().goTo(6);

        const std::optional<VectorMark> from = markAt(opened, "Vec2 from", "from");
        QVERIFY(from);
        QCOMPARE(from->kind, VectorMark::Kind::difference);
        QVERIFY(from->from == body);
        QVERIFY(length(from->to - foot) < 1e-9);
        QCOMPARE(from->name, QString("from"));

        const std::optional<VectorMark> target = markAt(opened, "Vec2 target", "target");
        QVERIFY(target);
        QCOMPARE(target->kind, VectorMark::Kind::place);
        const double radius = session.timeline().values()["radius"];
        QVERIFY(std::abs(length(target->to - body) - radius) < 1e-9); // on the ring

        const std::optional<VectorMark> place = markAt(opened, "Vec2 from", "position");
        QVERIFY(place);
        QCOMPARE(place->kind, VectorMark::Kind::place);
        QVERIFY(place->to == foot);
        QCOMPARE(place->range, (TextRange{opened.lineOf("Vec2 from"), 21, 13}));

        const std::optional<VectorMark> velocity = markAt(opened, "foot.velocity +=", "velocity");
        QVERIFY(velocity);
        QCOMPARE(velocity->kind, VectorMark::Kind::difference);
        QVERIFY(velocity->from == foot);

        QVERIFY(!markAt(opened, "double angle", "angle")); // a number
        QVERIFY(!markAt(opened, "double angle", "double"));
        QVERIFY(!markAt(opened, "// the nearest", "nearest"));
    }

    void pointingAtABodyFindsItsUses()
    {
        Opened opened("multi_foot", "any_number");
        Session &session = opened.session;
        QVERIFY(session.lines().runTo(opened.lineOf("move(foot);")));
        const LineStepper::Shown shown = session.lines().shown();
        const auto linesOf = [&](const QString &body) {
            std::vector<int> lines;
            for (const TextRange &range : usesOf(session.code().text(), body, session.code().vocabulary(),
                                                 shown.frame.get(), shown.index))
                lines.push_back(range.line);
            return lines;
        };
        const std::vector<int> body = linesOf("body"), first = linesOf("foot0"), second = linesOf("foot1");
        const auto has = [](const std::vector<int> &lines, int line) {
            return std::find(lines.begin(), lines.end(), line) != lines.end();
        };
        QVERIFY(has(body, opened.lineOf("if (body.held)")) && has(body, opened.lineOf("move(body);")));
        QVERIFY(!has(body, opened.lineOf("move(foot);")));
        QVERIFY(has(first, opened.lineOf("Body foot = feet[i];")) &&
                has(first, opened.lineOf("move(foot);")));
        QVERIFY(has(second, opened.lineOf("Body foot = feet[i];")));
        QVERIFY(!has(second, opened.lineOf("move(foot);"))); // `foot` is foot0 now
    }
};

SUITE(tst_line_values, LineValuesTest)
#include "tst_line_values.moc"
